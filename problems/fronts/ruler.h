// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "optim/pareto/measures.h"
#include "problems/statement/statement.h"

namespace camlaw::problems {

/// What no law passes (theory: "Analytic limits"), as the ruler of fronts each of whose objectives
/// is a multiple of the law's B, C or D, whatever else may vary.
struct FrontRuler {
  struct Measure {
    std::size_t objective;
    double factor;  ///< the objective's value over the constant
  };
  /// Of B, C and D: two of them at least.
  std::array<std::optional<Measure>, 3> of = {};

  /// lambda = least_time(B, C, D) with what the objectives say of them, at most 1; a constant that
  /// is not an objective is infinite. `values`: of the objectives.
  double limit_index(const std::vector<double>& values) const;

  /// Of two objectives: that of the lower derivative and that of the higher.
  std::pair<Measure, Measure> pair() const;
  /// Of two objectives: the least value of the higher derivative for one of the lower.
  double least(double lower_value) const;

  /// Measure of all values up to the reference that lambda <= 1 allows: no front has more.
  double hypervolume(const optim::Costs& reference) const;
};

/// The ruler of a problem's front; none where an objective is something else, or a law is not from
/// rest to rest over one stroke. What is a multiple is found by trying laws.
std::optional<FrontRuler> front_ruler(const ProblemStatement& statement);

}  // namespace camlaw::problems
