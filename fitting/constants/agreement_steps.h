// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "fitting/constants/printed_model.h"

namespace camlaw::problems {

/// Half of what is printed alike, and no less than what agrees by rounding.
double half_of(const PrintedConstant& printed);

/// Steps over which constants and rooms of a model are taken for linear, each as far as that is
/// borne out: linear programs within a box that grows and shrinks (docs/optimisation.md, (FS9)).
/// Keeps references to the model.
class AgreementSteps {
 public:
  AgreementSteps(const PrintedModel& model, std::vector<std::size_t> constants,
                 std::vector<double> lower, std::vector<double> upper);

  /// Where the constants agree, from a place that makes a law; none where the largest misfit
  /// cannot be made less on the path. A misfit of `enough` is aimed at.
  std::optional<std::vector<double>> to_agreement(std::vector<double> x, int steps,
                                                  double enough = 0.5) const;
  /// From values that agree to others that do, of which the last have the greatest value of an
  /// unknown, or with sign -1 the least: all on the path, those they begin with first.
  std::vector<std::vector<double>> to_extreme(std::size_t unknown, double sign,
                                              std::vector<double> x) const;

  bool agrees(std::span<const double> x) const;
  /// The largest of (f - m) / w in size; NaN where there is no law.
  double misfit(std::span<const double> x) const;

 private:
  struct Row;
  /// An unknown at its greatest, times the sign, or a misfit no larger than `enough`.
  struct Aim {
    std::optional<std::size_t> unknown = {};
    double sign = 1, enough = 0;
  };
  struct Step {
    std::vector<double> to;
    double gain;
  };
  std::vector<Row> rows_at(std::span<const double> x) const;
  std::vector<Row> rooms_at(std::span<const double> x, bool is_inside) const;
  static bool is_of_peak(const Row& row);
  void add_cuts(const std::vector<double>& beyond, std::vector<Row>& cuts) const;
  std::vector<Row> rows_with(const std::vector<double>& x, const std::vector<Row>& cuts) const;
  std::optional<Step> step(const std::vector<double>& x, double reach, std::vector<Row> rows,
                           const Aim& aim) const;
  double share_of(const std::vector<double>& from, const std::vector<double>& to) const;

  const PrintedModel* model_;
  std::vector<std::size_t> constants_;
  std::vector<double> lower_, upper_;
};

}  // namespace camlaw::problems
