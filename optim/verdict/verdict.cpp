// SPDX-License-Identifier: MIT
#include "optim/verdict/verdict.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "optim/verdict/conditions.h"
#include "optim/verdict/dual_bound.h"
#include "optim/verdict/known_limit.h"
#include "optim/verdict/limits_in_haste.h"
#include "optim/verdict/none_possible.h"
#include "optim/verdict/unknown_prices.h"
#include "optim/verdict/unproved.h"

namespace camlaw::optim {
namespace {

std::vector<VariableReport> variable_reports(const Problem& problem, Design x) {
  std::vector<VariableReport> result;
  for (std::size_t i = 0; i < problem.variables.size(); ++i) {
    const Variable& v = problem.variables[i];
    result.push_back({v.name, v.unit, x[i], v.lower, v.upper, false, false, 0});
  }
  return result;
}

/// Names of the limits that a design stands at; where `least` is above 0 those alone whose share
/// of the push is at least that.
std::vector<std::string> active_names(const Problem& problem, const Scales& scales,
                                      const Kkt& conditions, double least) {
  std::vector<std::string> names;
  const auto add = [&](bool active, double multiplier, double size, const std::string& name) {
    if (active && !(std::abs(multiplier) * size < least)) names.push_back(name);
  };
  for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
    add(conditions.active_constraints[i], conditions.constraints[i], scales.constraints[i].scale,
        problem.constraints[i].response.name);
  }
  for (std::size_t i = 0; i < problem.variables.size(); ++i) {
    const std::string& name = problem.variables[i].name;
    const double size = scales.variables[i];
    add(conditions.active_lower[i], conditions.lower[i], size, "lower bound of " + name);
    add(conditions.active_upper[i], conditions.upper[i], size, "upper bound of " + name);
  }
  return names;
}

/// A row shows the side that pushes, which its price belongs to; where none does, the nearer one.
void show_pushing_sides(const Problem& problem, const Kkt& conditions, Design x,
                        Assessment& result) {
  for (std::size_t i = 0; i < result.limits.size(); ++i) {
    const Constraint& c = problem.constraints[i];
    const int side = conditions.pushing_sides[i];
    if (!c.lower || !c.upper || result.limits[i].is_equation || side == 0) continue;
    if (result.limits[i].is_upper != (side > 0)) show_side(c, x, side > 0, result.limits[i]);
  }
}

void take_conditions(const Problem& problem, const Scales& scales, const Kkt& conditions,
                     Assessment& result) {
  result.kkt_residual = conditions.residual;
  result.condition = conditions.condition;
  result.second_order = conditions.second_order;
  result.at_moving_break = conditions.at_moving_break;
  result.is_global = is_global_valley(problem, conditions.objective_slope);
  for (std::size_t i = 0; i < result.limits.size(); ++i) {
    result.limits[i].multiplier = conditions.constraints[i];
    result.limits[i].at_rest = conditions.at_rest[i];
  }
  for (std::size_t i = 0; i < result.variables.size(); ++i) {
    VariableReport& v = result.variables[i];
    v.at_lower = conditions.active_lower[i];
    v.at_upper = conditions.active_upper[i];
    v.multiplier = conditions.lower[i] + conditions.upper[i];
  }
  result.active = active_names(problem, scales, conditions, 0);
}

/// The lower bound, and whether the conditions of optimality look doubtful.
void take_bound(const Problem& problem, const Scales& scales, const Kkt& conditions, Design x,
                Assessment& result) {
  constexpr double kMuch = 1e-3;  // of the objective, for the limits' own tolerances
  result.objective_measure = scales.objective * objective_measure(problem, scales, x);
  if (conditions.largest_gain) {
    const double sense = problem.objective().sense == Sense::Minimize ? 1 : -1;
    result.best_possible = result.objective.value - sense * *conditions.largest_gain;
  }
  if (conditions.gain_of_tolerances > kMuch) {
    result.sign = fmt::format(
        "easing the limits by no more than their tolerances would change {} by {:.2g} of itself, "
        "so the conditions of optimality say nothing here",
        problem.objective().response.name, conditions.gain_of_tolerances);
  }
}

bool inside_bounds(const std::vector<VariableReport>& variables) {
  return std::all_of(variables.begin(), variables.end(), [](const VariableReport& v) {
    return v.value >= v.lower && v.value <= v.upper;
  });
}

/// Whether a lower bound leaves no better design, to the tolerance of the conditions of optimality.
bool is_bounded(const Assessment& a) {
  if (!a.best_possible) return false;
  return std::abs(a.objective.value - *a.best_possible) <= kBoundTolerance * a.objective_measure;
}

/// What keeps a design that meets every limit from being certified; empty where nothing does.
std::string doubt(const Problem& problem, const Scales& scales, const Assessment& a) {
  if (std::string why = unproved(problem, scales, a); !why.empty() || is_bounded(a)) return why;
  if (std::isinf(a.kkt_residual)) {
    return "the model has no derivatives at the answer, which may lie at the edge of the possible "
           "machines";
  }
  if (!(a.kkt_residual <= kKktTolerance)) {
    return fmt::format("the conditions of optimality hold only to {:.1e}", a.kkt_residual);
  }
  if (a.at_moving_break) {
    return "a peak lies at a joint of the law that moves with the design, so how it changes is not "
           "known";
  }
  if (!a.second_order)
    return "along the active limits the objective may still improve to second order";
  return a.sign;
}

/// A number rounded outwards for print: below where `sign` is above 0.
std::string outwards(double value, double sign) {
  constexpr int kPrinted = 8;        // digits
  constexpr double kOfZero = 1e-12;  // any step does: 0 is a multiple of all
  const double size = std::abs(value);
  const double step =
      size > 0 ? std::pow(10, std::floor(std::log10(size)) - (kPrinted - 1)) : kOfZero;
  const double rounded =
      sign > 0 ? std::floor(value / step) * step : std::ceil(value / step) * step;
  return fmt::format("{:.{}g}", rounded, kPrinted);
}

/// "; the bound is 2e-5 mm from it, more than the tolerance of 1e-6 mm that is stated for the
/// objective", where that asks for more than a bound has to show.
std::string wider_than_stated(const Problem& problem, const Assessment& a) {
  const Objective& objective = problem.objective();
  const double gap = std::abs(a.objective.value - *a.best_possible);
  if (!objective.tolerance || gap <= *objective.tolerance) return {};
  const std::string& unit = objective.response.unit;
  const std::string in_unit = unit == "1" ? "" : " " + unit;
  return fmt::format(
      "; the bound is {:.2g}{} from it, more than the tolerance of {:.2g}{} that is stated for the "
      "objective",
      gap, in_unit, *objective.tolerance, in_unit);
}

/// Why no better design exists anywhere, with the bound that shows it; `why` as a lower bound of
/// its own says, empty: as the shapes do.
std::string global_words(const Problem& problem, const Assessment& a, const std::string& why) {
  const Response& response = problem.objective().response;
  const bool least = problem.objective().sense == Sense::Minimize;
  const bool boxed = std::all_of(
      problem.variables.begin(), problem.variables.end(),
      [](const Variable& v) { return std::isfinite(v.lower) && std::isfinite(v.upper); });
  return fmt::format(
      "no design {} {}{}{}: {}{}", least ? "below" : "above",
      outwards(*a.best_possible, least ? 1 : -1), response.unit == "1" ? "" : " " + response.unit,
      boxed || !why.empty()
          ? ""
          : fmt::format(", as far as {:g} times the variables' own magnitudes", kFar),
      why.empty() ? *why_convex(problem) : why, wider_than_stated(problem, a));
}

/// The verdict of a design that meets every limit, with proofs; `why`: as of global_words.
void conclude(const Problem& problem, const Scales& scales, const std::string& why, Assessment& a) {
  a.reason = doubt(problem, scales, a);
  a.verdict = a.reason.empty() ? Verdict::Certified : Verdict::Feasible;
  if (a.verdict != Verdict::Certified) return;
  a.reason = a.kkt_residual <= kKktTolerance
                 ? "every limit is met and the conditions of optimality hold"
                 : "every limit is met and a lower bound excludes anything better";
  if (is_bounded(a)) {
    a.global = global_words(problem, a, why);
  } else if (is_near_limit(problem, a)) {
    a.global = near_limit_words(problem, a);
  }
}

std::string violated_names(const Assessment& a) {
  std::vector<std::string> names;
  for (const LimitReport& limit : a.limits) {
    if (!limit.met) names.push_back(limit.name);
  }
  for (const VariableReport& v : a.variables) {
    if (v.value < v.lower) names.push_back("the lower bound of " + v.name);
    if (v.value > v.upper) names.push_back("the upper bound of " + v.name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::Certified:
      return "certified optimum";
    case Verdict::Feasible:
      return "feasible";
    case Verdict::Infeasible:
      return "infeasible";
    case Verdict::Failed:
      return "failed";
  }
  return "?";
}

namespace {

enum class Closeness {
  Search,  ///< of a design on the way
  Haste,   ///< of an answer for whose proofs there is no time
  Proof
};

/// Where a design stands: Feasible, or Failed with the reason.
Assessment where_it_stands(const Problem& problem, const Scales& scales, Design x,
                           Closeness closeness) {
  const bool prove = closeness == Closeness::Proof;
  Assessment result;
  result.variables = variable_reports(problem, x);
  result.objective = objective_report(problem, scales, x, prove);
  result.limits = limit_reports(problem, scales, x, prove);
  if (closeness == Closeness::Haste) look_in_haste(problem, x, result.limits);
  if (!std::isfinite(result.objective.value) || std::isinf(worst_violation(result.limits))) {
    result.reason = undefined_at(problem, x, "the answer");
  } else if (!is_feasible(result)) {
    result.reason = fmt::format("the design does not meet {}", violated_names(result));
  } else {
    result.verdict = Verdict::Feasible;
    result.reason = "not proved yet";
  }
  return result;
}

}  // namespace

Assessment assess_in_haste(const Problem& problem, const Scales& about, Design x) {
  return where_it_stands(problem, judged_at(problem, about, x), x, Closeness::Haste);
}

Assessment assess_in_haste(const Problem& problem, Design x) {
  Scales scales;
  scales.variables = typical_scales(problem, x);
  scales.objective = scales.objective_typical = 1;
  scales.constraints.assign(problem.constraints.size(), {1, 0, 0});
  return assess_in_haste(problem, scales, x);
}

Assessment assess(const Problem& problem, const Scales& about, Design x, bool prove,
                  const Teller& told) {
  const Scales scales = judged_at(problem, about, x);
  Assessment result =
      where_it_stands(problem, scales, x, prove ? Closeness::Proof : Closeness::Search);
  if (result.verdict == Verdict::Failed) return result;
  const Kkt conditions = kkt(problem, scales, x, Optimality::Objective, told, prove);
  take_conditions(problem, scales, conditions, result);
  show_pushing_sides(problem, conditions, x, result);
  take_bound(problem, scales, conditions, x, result);
  drop_unknown_prices(result);
  if (prove) conclude(problem, scales, "", result);
  return result;
}

void take_subdivision(const Problem& problem, const Scales& about, const Subdivision& division,
                      Assessment& a) {
  const double sense = problem.objective().sense == Sense::Minimize ? 1 : -1;
  if (a.best_possible && sense * *a.best_possible >= sense * division.best_possible) return;
  a.best_possible = division.best_possible;
  if (!is_bounded(a)) return;
  std::vector<double> x;
  for (const VariableReport& v : a.variables) x.push_back(v.value);
  Assessment bounded = a;
  conclude(problem, judged_at(problem, about, x),
           division.boxes == 1
               ? "the ranges of objective and limits over the whole box exclude a better design"
               : fmt::format("the range of the variables was split into {} parts; none contains "
                             "a better design",
                             division.boxes),
           bounded);
  if (bounded.verdict == Verdict::Certified) a = std::move(bounded);
}

namespace {

/// Whether every limit that pushes is convex, and not quasiconvex only.
bool has_convex_pushes(const Problem& problem, const Kkt& conditions) {
  for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
    const int side = conditions.pushing_sides[i];
    const Shape shape = problem.constraints[i].response.shape();
    if (side != 0 && !(side > 0 ? is_convex(shape) : is_concave(shape))) return false;
  }
  return true;
}

}  // namespace

Assessment assess_least_violation(const Problem& problem, const Scales& about, Design x,
                                  const Teller& told) {
  const Scales scales = judged_at(problem, about, x);
  Assessment result;
  result.variables = variable_reports(problem, x);
  result.objective = objective_report(problem, scales, x, false);
  result.limits = limit_reports(problem, scales, x, false);
  if (std::isinf(worst_violation(result.limits))) {
    result.reason = undefined_at(problem, x, "the design of least violation");
    if (auto none = none_possible(problem)) {
      result.verdict = Verdict::Infeasible;
      result.reason = fmt::format("{}; {}", *none, result.reason);
      result.global = std::move(none);
    }
    return result;
  }
  if (meets_limits(result) && !std::isfinite(result.objective.value)) {
    result.reason = undefined_at(problem, x, "a design that meets the limits");
    return result;
  }
  const Kkt conditions = kkt(problem, scales, x, Optimality::LeastViolation, told);
  take_conditions(problem, scales, conditions, result);
  // Of all multipliers: solvers leave less to limits that have no part in it.
  constexpr double kBlamed = 1e-4;
  result.blamed = active_names(problem, scales, conditions, kBlamed);
  // Of convex limits less than all of the violation is enough. A quasiconvex one may be gentle here
  // and steep elsewhere: there nothing but a slope of zero tells.
  constexpr double kHalf = 0.5;
  const bool quasiconvex = convex_set(problem) && !conditions.flat;
  const bool convex = quasiconvex && has_convex_pushes(problem, conditions);
  if (conditions.at_moving_break) {
    result.reason = fmt::format(
        "no design was found that meets {}; a peak lies at a joint that moves with the design, so "
        "how it changes is not known",
        violated_names(result));
    return result;
  }
  if (!(result.kkt_residual <= (convex ? kHalf : kLeastViolationTolerance)) ||
      result.blamed.empty()) {
    result.reason = fmt::format("no design was found that meets {}", violated_names(result));
    return result;
  }
  result.verdict = Verdict::Infeasible;
  result.reason = fmt::format("{} contradict one another", fmt::join(result.blamed, " and "));
  if (result.blamed.size() == 1) {
    result.reason = fmt::format("{} cannot be met", result.blamed.front());
  }
  const bool boxed = std::all_of(
      problem.variables.begin(), problem.variables.end(),
      [](const Variable& v) { return std::isfinite(v.lower) && std::isfinite(v.upper); });
  // Without a box a slope that is left could lead far.
  constexpr double kNoSlope = 1e-8;
  if ((convex && boxed) || (quasiconvex && result.kkt_residual <= kNoSlope)) {
    result.global = "the feasible set is convex, and it is empty";
  }
  return result;
}

bool meets_limits(const Assessment& a) {
  return worst_violation(a.limits) <= 1 && inside_bounds(a.variables);
}

bool is_feasible(const Assessment& a) {
  return std::isfinite(a.objective.value) && meets_limits(a);
}

bool is_settled(const Assessment& a) {
  return is_feasible(a) && (is_bounded(a) || (a.kkt_residual <= kKktTolerance && a.second_order));
}

bool better(const Problem& problem, const Assessment& a, const Assessment& b) {
  const bool a_meets = is_feasible(a), b_meets = is_feasible(b);
  if (a_meets != b_meets) return a_meets;
  const auto badness = [](const Assessment& assessment) {
    const bool number = std::isfinite(assessment.objective.value);
    return number ? worst_violation(assessment.limits) : kInfinity;
  };
  if (!a_meets) return badness(a) < badness(b);
  const double sign = problem.objective().sense == Sense::Minimize ? 1 : -1;
  return sign * a.objective.value < sign * b.objective.value;
}

}  // namespace camlaw::optim
