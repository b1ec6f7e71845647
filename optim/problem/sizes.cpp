// SPDX-License-Identifier: MIT
#include "optim/problem/sizes.h"

#include <algorithm>
#include <cmath>

#include "optim/cycle/extremes.h"

namespace camlaw::optim {
namespace {

double or_one(double size) { return size > 0 && std::isfinite(size) ? size : 1; }

ConstraintSize constraint_size(const Constraint& c, Design x, const std::vector<double>& scales) {
  const double bound = std::max(std::abs(c.lower.value_or(0)), std::abs(c.upper.value_or(0)));
  const double size =
      c.scale ? *c.scale : or_one(std::max(typical_change(c.response, x, scales), 1e-3 * bound));
  return {size, c.tolerance.value_or(1e-6 * (bound > 0 ? bound : size))};
}

}  // namespace

double typical_change(const Function& function, Design x, const std::vector<double>& scales) {
  std::vector<double> g(function.inputs().size());
  function.gradient(x, g);
  double largest = 0;
  for (std::size_t k = 0; k < g.size(); ++k) {
    const double change = std::abs(g[k]) * scales[function.inputs()[k]];
    if (std::isfinite(change)) largest = std::max(largest, change);
  }
  return largest;
}

double typical_change(const Response& response, Design x, const std::vector<double>& scales) {
  if (!response.is_curve()) return typical_change(response.function(), x, scales);
  constexpr int kPlaces = 5;  // in each smooth stretch
  const auto breaks = response.curve().trace(x)->breaks();
  double largest = 0;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    for (int i = 0; i < kPlaces; ++i) {
      const double angle = breaks[k] + (breaks[k + 1] - breaks[k]) * (i + 0.5) / kPlaces;
      largest = std::max(largest, typical_change(response.curve().at({angle}), x, scales));
    }
  }
  return largest;
}

double objective_value(const Objective& objective, Design x) {
  if (!objective.response.is_curve()) return objective.response.function().value(x);
  const auto trace = objective.response.curve().trace(x);
  const double up = highest(*trace, 1).value, down = highest(*trace, -1).value;
  switch (objective.part) {
    case Part::Lowest:
      return down;
    case Part::Magnitude:
      return std::max(up, -down);
    case Part::Value:
    case Part::Highest:
      break;
  }
  return up;
}

Sizes sizes(const Problem& problem, Design about) {
  Sizes result;
  result.variables = variable_scales(problem);
  result.objective = or_one(typical_change(problem.objective.response, about, result.variables));
  result.objective_value = objective_value(problem.objective, about);
  result.objective_tolerance = problem.objective.tolerance.value_or(1e-7 * result.objective);
  for (const Constraint& c : problem.constraints) {
    result.constraints.push_back(constraint_size(c, about, result.variables));
  }
  return result;
}

}  // namespace camlaw::optim
