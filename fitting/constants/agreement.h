// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "fitting/constants/agreement_steps.h"
#include "fitting/constants/printed_model.h"

namespace camlaw::problems {

/// Values with which constants agree, and the least and the greatest of each unknown that a search
/// from there reaches.
struct AgreeingValues {
  std::vector<double> x;
  std::vector<double> low, high;
  /// Others on the paths to these.
  std::vector<std::vector<double>> about;
};

/// The question with which values of the unknowns some of the constants agree with their prints:
/// |f_k(q) - m_k| <= w_k (docs/optimisation.md, (FS2)). The model must outlive it.
class Agreement {
 public:
  Agreement(const PrintedModel& model, std::vector<std::size_t> constants);

  /// Values with which all of them agree, of each region that was found apart from the others; that
  /// of the default values first where they do.
  std::vector<AgreeingValues> solutions() const;
  bool all_agree(std::span<const double> x) const;
  /// The solution with what is held, from one that met all.
  AgreeingValues within(const std::vector<double>& x) const;
  /// From now on an unknown has this value.
  void hold(std::size_t unknown, double value);
  /// A solution with what is held, near others: from between those on either side of the value.
  std::optional<std::vector<double>> near(const AgreeingValues& solution,
                                          std::size_t unknown) const;
  /// Whether the constants determine each unknown here, to first order.
  std::vector<bool> determined(const std::vector<double>& at) const;

 private:
  AgreementSteps steps() const { return {*model_, finite_, lower_, upper_}; }
  std::vector<std::vector<double>> starts() const;
  std::vector<std::vector<double>> found() const;
  std::vector<AgreeingValues> of_one_unknown() const;
  AgreeingValues ranged(const std::vector<double>& x,
                        std::span<const std::vector<double>> others) const;

  const PrintedModel* model_;
  std::vector<std::size_t> constants_;
  std::vector<std::size_t> finite_;  ///< those of them that are printed as finite numbers
  std::vector<double> lower_, upper_;
};

}  // namespace camlaw::problems
