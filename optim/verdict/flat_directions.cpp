// SPDX-License-Identifier: MIT
#include "optim/verdict/flat_directions.h"

#include <algorithm>
#include <cmath>

#include "optim/verdict/verdict.h"

namespace camlaw::optim {
namespace {

std::vector<double> stepped(const SecondOrderPoint& point, const Eigen::VectorXd& direction,
                            double step) {
  std::vector<double> x(point.x.begin(), point.x.end());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const int row = point.layout.row[i];
    const Variable& v = point.problem.variables[i];
    if (row < 0) continue;
    x[i] = std::clamp(x[i] + step * direction[row] * point.scales.variables[i], v.lower, v.upper);
  }
  return x;
}

/// The least gain that counts.
double threshold(const SecondOrderPoint& point, const Weighed& weighed, double value) {
  double violations = 0;
  for (std::size_t j = 0; j < weighed.limits.size(); ++j) {
    const ActiveLimit& limit = weighed.limits[j];
    if (!limit.constraint) continue;
    const double tolerance = point.scales.constraints[*limit.constraint].tolerance;
    violations += std::abs(weighed.multipliers[j]) * tolerance / limit.size;
  }
  const double measure = std::max(std::abs(value), point.scales.objective);
  return 10 * violations * point.scales.objective + kKktTolerance * measure;
}

}  // namespace

bool improves_along(const SecondOrderPoint& point, const Weighed& weighed,
                    const std::vector<Eigen::VectorXd>& flat) {
  // Each takes some twenty designs, with a search for peaks. The level ground may be as wide as a
  // few typical changes, and what lies lower behind it narrow.
  constexpr std::size_t kMostDirections = 20;
  constexpr double kSteps[] = {1e-3, 1e-2, 1e-1, 0.2, 0.3, 0.45, 0.6, 0.8, 1, 1.5, 2.5, 4};
  if (flat.empty()) return false;
  const Objective& objective = point.problem.objective();
  const double sign = objective.sense == Sense::Minimize ? 1 : -1;
  const double here = objective_value(objective, point.x);
  const double least = threshold(point, weighed, here);
  const auto better_at = [&](const Eigen::VectorXd& direction, double step) {
    const auto x = stepped(point, direction, step);
    if (!(sign * objective_value(objective, x) < sign * here - least)) return false;
    return worst_violation(limit_reports(point.problem, point.scales, x, false)) <= 1;
  };
  const std::size_t count = std::min(flat.size(), kMostDirections);
  return std::any_of(flat.begin(), flat.begin() + static_cast<std::ptrdiff_t>(count),
                     [&](const Eigen::VectorXd& direction) {
                       return std::any_of(std::begin(kSteps), std::end(kSteps), [&](double step) {
                         return better_at(direction, step) || better_at(direction, -step);
                       });
                     });
}

}  // namespace camlaw::optim
