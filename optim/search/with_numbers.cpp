// SPDX-License-Identifier: MIT
#include "optim/search/with_numbers.h"

#include <algorithm>
#include <cmath>

#include "optim/cycle/sizes.h"

namespace camlaw::optim {
namespace {}  // namespace

std::optional<Problem> with_numbers_only(const Problem& problem, Design x, double share) {
  Problem result = problem;
  result.objectives = {no_objective()};
  result.constraints.clear();
  for (Constraint c : problem.constraints) {
    const double value = objective_value(
        {c.response, Sense::Minimize, c.response.is_curve() ? Part::Magnitude : Part::Value}, x);
    if (!std::isfinite(value)) continue;
    const double room =
        share * std::max(std::abs(c.lower.value_or(0)), std::abs(c.upper.value_or(0)));
    const bool has_room = !(c.lower && c.upper) || *c.upper - *c.lower > 2 * room;
    if (has_room && c.upper) *c.upper -= room;
    if (has_room && c.lower) *c.lower += room;
    result.constraints.push_back(std::move(c));
  }
  if (result.constraints.empty()) return {};
  return result;
}

}  // namespace camlaw::optim
