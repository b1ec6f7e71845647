// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "fitting/constants/printed_model.h"
#include "optim/problem/problem.h"

namespace camlaw::problems {

/// The question with which values of the unknowns some of the constants agree with their prints:
/// |f_k(q) - m_k| <= w_k (docs/optimisation.md, (FS2)). The model must outlive it.
class Agreement {
 public:
  Agreement(const PrintedModel& model, std::vector<std::size_t> constants);

  /// Values with which all of them agree, no two alike; the default values alone where they do.
  std::vector<std::vector<double>> solutions() const;
  bool all_agree(std::span<const double> x) const;
  /// The least and the greatest of an unknown about a solution.
  std::pair<double, double> range(std::size_t unknown, const std::vector<double>& about) const;
  /// From now on an unknown has this value.
  void hold(std::size_t unknown, double value);
  /// A solution with what is held, near another.
  std::optional<std::vector<double>> near(std::vector<double> about) const;
  /// Whether the constants determine each unknown here, to first order.
  std::vector<bool> determined(const std::vector<double>& at) const;

 private:
  double misfit(const PrintedModel::Place& place) const;
  std::vector<std::vector<double>> starts() const;
  std::vector<std::vector<double>> crossings() const;
  bool may_cross(const PrintedModel::Place& a, const PrintedModel::Place& b) const;
  std::optional<std::vector<double>> solved_from(const std::vector<double>& start) const;
  std::optional<std::vector<double>> balanced(const std::vector<double>& about) const;
  std::optional<double> typical_change(std::size_t unknown, const std::vector<double>& about) const;
  optim::Problem stated(const std::vector<double>& about) const;

  const PrintedModel* model_;
  std::vector<std::size_t> constants_;
  std::vector<std::size_t> finite_;  ///< those of them that are printed as finite numbers
  std::vector<double> lower_, upper_;
};

}  // namespace camlaw::problems
