// SPDX-License-Identifier: MIT
#include "optim/pareto/judged_again.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "optim/pareto/costs.h"
#include "optim/search/told.h"
#include "optim/verdict/verdict.h"

namespace camlaw::optim {
namespace {

/// What remains of a number between two machines, or two ways of adding.
constexpr double kSaidRounding = 1e-9;

bool agree(double stated, double found, double tolerance) {
  if (std::isnan(stated) || std::isnan(found)) return std::isnan(stated) == std::isnan(found);
  return stated == found || std::abs(stated - found) <= tolerance;
}

std::string with_unit(double value, const std::string& unit) {
  return fmt::format("{:.9g}{}", value, unit.empty() || unit == "1" ? "" : " " + unit);
}

/// Both numbers; what is rounding beside `size`, that of the numbers they are worked out from, is
/// 0.
std::string both(const std::string& name, double stated, double found, double size,
                 const std::string& unit) {
  const auto shown = [&](double value) {
    const bool is_rounding = std::isfinite(size) && std::abs(value) <= kSaidRounding * size;
    return with_unit(is_rounding ? 0 : value, unit);
  };
  return fmt::format("{} is stated as {}, but evaluates to {}", name, shown(stated), shown(found));
}

/// Scales that hold no tolerance: they are worked out only where numbers differ.
Scales without_tolerances(const Problem& problem) {
  Scales scales{};
  scales.constraints.resize(problem.constraints.size());
  return scales;
}

void compare_variables(const Problem& multi, Design x, std::vector<std::string>& found) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Variable& v = multi.variables[i];
    if (x[i] >= v.lower && x[i] <= v.upper) continue;
    found.push_back(fmt::format("{} = {} is outside its bounds {:.9g} to {}", v.name,
                                with_unit(x[i], v.unit), v.lower, with_unit(v.upper, v.unit)));
  }
}

void compare_objectives(const Problem& multi, const FrontPoint& point,
                        std::vector<std::string>& found) {
  for (std::size_t i = 0; i < multi.objectives.size(); ++i) {
    const Objective& o = multi.objectives[i];
    const double value = objective_value(o, point.x), cost = as_cost(o, value);
    const auto same = [&](double tolerance) {
      return agree(point.objectives[i], value, tolerance) && agree(point.costs[i], cost, tolerance);
    };
    if (same(kSaidRounding * std::abs(value))) continue;
    const double tolerance = scales(multi.alone(i), point.x).objective_tolerance;
    if (same(std::max(tolerance, kSaidRounding * std::abs(value)))) continue;
    const bool of_cost = agree(point.objectives[i], value, tolerance);
    const double stated = of_cost ? as_cost(o, point.costs[i]) : point.objectives[i];
    found.push_back(both(o.response.name, stated, value,
                         std::max(std::abs(stated), std::abs(value)), o.response.unit));
  }
}

/// Of the numbers whose difference a margin is.
double size_of(const LimitReport& report) {
  return std::max(std::abs(report.value), std::abs(report.bound));
}

/// Whether a limit stands as it is stated to, on the nearer side or, of two that push alike, on the
/// other one.
bool stands_so(const Standing& stated, const Constraint& constraint, Design x, LimitReport report,
               double tolerance) {
  const auto rounding = [&] { return kSaidRounding * size_of(report); };
  const bool met = report.margin >= -std::max(tolerance, rounding());
  if (stated.met != met) return false;
  if (agree(stated.margin, report.margin, std::max(tolerance, rounding()))) return true;
  if (!constraint.lower || !constraint.upper) return false;
  show_side(constraint, x, !report.is_upper, report);
  return agree(stated.margin, report.margin, std::max(tolerance, rounding()));
}

void compare_limits(const Problem& multi, const FrontPoint& point,
                    std::vector<std::string>& found) {
  const Problem problem = multi.alone(0);
  const std::size_t count = problem.constraints.size();
  if (point.limits.size() != count) {
    found.push_back(
        fmt::format("{} limits are stated, but the problem has {}", point.limits.size(), count));
    return;
  }
  const auto differing = [&](const Scales& scales, bool prove) {
    std::vector<std::string> words;
    const std::vector<LimitReport> reports = limit_reports(problem, scales, point.x, prove);
    for (std::size_t i = 0; i < count; ++i) {
      const Standing& stated = point.limits[i];
      if (stated.name == reports[i].name &&
          stands_so(stated, problem.constraints[i], point.x, reports[i],
                    scales.constraints[i].tolerance)) {
        continue;
      }
      const double size = size_of(reports[i]);
      words.push_back(stated.name == reports[i].name &&
                              agree(stated.margin, reports[i].margin, kSaidRounding * size)
                          ? fmt::format("the limit on {} is stated to be {}, but it is not",
                                        stated.name, stated.met ? "met" : "passed")
                          : both("the margin of " + stated.name, stated.margin, reports[i].margin,
                                 size, reports[i].unit));
    }
    return words;
  };
  if (differing(without_tolerances(problem), false).empty()) return;
  const Scales own = judged_at(problem, scales(problem, point.x), point.x);
  if (differing(own, false).empty()) return;
  const std::vector<std::string> words = differing(own, true);
  found.insert(found.end(), words.begin(), words.end());
}

}  // namespace

std::vector<std::string> differences(const Problem& multi, const FrontPoint& point) {
  std::vector<std::string> found;
  const std::size_t objectives = multi.objectives.size();
  if (point.x.size() != multi.variables.size() || point.objectives.size() != objectives ||
      point.costs.size() != objectives) {
    return {"the design does not have the values that its problem requires"};
  }
  compare_variables(multi, point.x, found);
  if (!found.empty()) return found;  // of a design beyond its bounds the model may know nothing
  compare_objectives(multi, point, found);
  compare_limits(multi, point, found);
  return found;
}

Assessment assessed_on_front(const Problem& multi, Design x, std::size_t sought) {
  Problem problem = multi.alone(sought);
  const std::vector<double> own = costs(multi, x);
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (i != sought) problem.constraints.push_back(at_most(multi.objectives[i], own[i]));
  }
  const Scales own_scales = scales(problem, x);
  return assess(problem, own_scales, x, true, teller_at(problem, own_scales, x));
}

FrontPoint judged_again(const Problem& multi, const FrontPoint& point) {
  FrontPoint judged = point;
  judged.costs = costs(multi, point.x);
  std::size_t sought = 0;
  double most = -1;
  for (std::size_t i = 0; i < multi.objectives.size(); ++i) {
    judged.objectives[i] = as_cost(multi.objectives[i], judged.costs[i]);
    const double share =
        i < point.weights.size() ? point.weights[i] * std::abs(judged.costs[i]) : 0;
    if (share > most) most = share, sought = i;
  }
  const Assessment found = assessed_on_front(multi, point.x, sought);
  judged.verdict = found.verdict;
  judged.reason = found.reason;
  judged.is_global = found.global.has_value();
  judged.limits.clear();
  judged.weights.assign(multi.objectives.size(), 0.0);
  judged.weights[sought] = 1;
  const std::size_t own = multi.constraints.size();
  for (std::size_t i = 0; i < found.limits.size(); ++i) {
    const LimitReport& limit = found.limits[i];
    if (i < own) {
      judged.limits.push_back({limit.name, limit.unit, limit.margin, limit.worst_angle, limit.met,
                               limit.proved, limit.multiplier});
    } else {  // the other objectives, in order
      judged.weights[i - own + (i - own >= sought)] += limit.multiplier;
    }
  }
  return judged;
}

}  // namespace camlaw::optim
