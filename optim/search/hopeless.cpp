// SPDX-License-Identifier: MIT
#include "optim/search/hopeless.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "optim/cycle/extremes.h"
#include "optim/problem/inputs.h"

namespace camlaw::optim {
namespace {

bool is_constant(const Function& f, const Problem& problem) {
  return std::all_of(f.inputs().begin(), f.inputs().end(), [&](std::size_t i) {
    return problem.variables[i].lower == problem.variables[i].upper;
  });
}

/// A response at the start; of a curve, where it is highest or lowest. Not a number where something
/// that varies moves it there.
double settled_value(const Response& response, bool highest, const Problem& problem, Design start) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (!response.is_curve()) {
    const Function& f = response.function();
    return is_constant(f, problem) ? f.value(start) : kNone;
  }
  const Curve& curve = response.curve();
  const auto trace = curve.trace(start);
  if (!is_constant(curve.at({trace->breaks().front()}), problem)) return kNone;
  const Extreme worst = extreme_of(*trace, highest ? Part::Highest : Part::Lowest);
  return is_constant(curve.at(worst.place), problem) ? worst.value : kNone;
}

std::string number_with_unit(double value, const std::string& unit) {
  return fmt::format("{:.6g}{}", value, unit.empty() || unit == "1" ? "" : " " + unit);
}

/// "base_radius is fixed at 20 mm by its bounds", of those that the response depends on and whose
/// bounds are equal; else that none changes a limit. An integer is fixed by the search, one value
/// after the other.
std::string why_settled(const Response& response, const Problem& problem) {
  std::vector<std::string> fixed;
  for (const std::size_t i : inputs_of(response, problem)) {
    const Variable& v = problem.variables[i];
    if (v.integer || v.lower != v.upper) continue;
    fixed.push_back(
        fmt::format("{} is fixed at {} by its bounds", v.name, number_with_unit(v.lower, v.unit)));
  }
  if (fixed.empty()) return "no variable changes it";
  return fmt::format(
      "{}{}", fmt::join(fixed, ", "),
      fixed.size() < problem.variables.size() ? ", and no other variable changes it" : "");
}

/// The variables' bounds; empty where one is infinite.
std::vector<Bounds> whole_box(const Problem& problem) {
  std::vector<Bounds> box;
  for (const Variable& v : problem.variables) {
    if (!std::isfinite(v.lower) || !std::isfinite(v.upper)) return {};
    box.push_back({v.lower, v.upper});
  }
  return box;
}

/// Whether slopes within these bounds change nothing over the box but rounding.
bool is_still(const std::vector<Bounds>& slopes, const Function& f, const std::vector<Bounds>& box,
              double tolerance) {
  constexpr double kRounding = 1e-3;  // of a limit's tolerance
  double change = 0;
  for (std::size_t k = 0; k < slopes.size(); ++k) {
    const Bounds& range = box[f.inputs()[k]];
    change += std::max(std::abs(slopes[k].lower), std::abs(slopes[k].upper)) *
              (range.upper - range.lower);
  }
  return change <= kRounding * tolerance;
}

/// Looks for an end of a smooth stretch at which a curve violates its limit, of these bounds with
/// their tolerance, at the start, and the slopes by all variables are enclosed as zero over the
/// whole box: the pressure angle in a dwell. Of a curve whose stretches move, such as one over a
/// window, the ends of one design say nothing of another.
std::optional<Hopeless> violated_where_still(const Constraint& limit, const Problem& problem,
                                             Design start, const Bounds& within, double tolerance) {
  const Response& response = limit.response;
  if (!response.is_curve() || response.curve().breaks_move()) return {};
  const std::vector<Bounds> box = whole_box(problem);
  if (box.empty()) return {};
  const auto trace = response.curve().trace(start);
  const std::vector<double> breaks = trace->breaks();
  for (std::size_t k = 0; k < breaks.size(); ++k) {
    for (const bool from_left : {false, true}) {
      if (from_left ? k == 0 : k + 1 == breaks.size()) continue;  // beyond the curve
      const Place place{breaks[k], from_left};
      const double value = trace->at(place)[0];
      if (!(value < within.lower) && !(value > within.upper)) continue;
      const Function f = response.curve().at(place);
      const BoxRange range = f.range(box);
      const bool is_beyond = range.value.upper < within.lower || range.value.lower > within.upper;
      if (!is_beyond || !is_still(range.slopes, f, box, tolerance)) continue;
      const std::string there =
          fmt::format("at {:.6g} it is {}", breaks[k], number_with_unit(value, response.unit));
      return Hopeless{response.name, there + " whatever the variables",
                      fmt::format("{}: {} for every design", response.name, there)};
    }
  }
  return {};
}

/// Of a limit on a number that no variable changes, and that has no value.
std::optional<Hopeless> undefined_for_all(const Constraint& limit, const Problem& problem,
                                          Design start) {
  const Response& response = limit.response;
  if (response.is_curve() || !is_constant(response.function(), problem)) return {};
  if (!std::isnan(response.function().value(start))) return {};
  return Hopeless{response.name, "it has no value, and " + why_settled(response, problem),
                  fmt::format("{} has no value for any design", response.name)};
}

/// Whether an answer blames this limit and something else.
bool is_one_of_several(const Constraint& limit, const Assessment& answer) {
  return answer.blamed.size() > 1 &&
         std::count(answer.blamed.begin(), answer.blamed.end(), limit.response.name) > 0;
}

}  // namespace

std::optional<Hopeless> hopeless_limit(const Problem& problem, const Scales& scales) {
  const std::vector<double> start = problem.start();
  for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
    const Constraint& c = problem.constraints[i];
    if (auto found = undefined_for_all(c, problem, start)) return found;
    const double tolerance = scales.constraints[i].tolerance;
    const Bounds within{c.lower ? *c.lower - tolerance : -kInfinity,
                        c.upper ? *c.upper + tolerance : kInfinity};
    if ((c.upper && settled_value(c.response, true, problem, start) > within.upper) ||
        (c.lower && settled_value(c.response, false, problem, start) < within.lower)) {
      return Hopeless{c.response.name, why_settled(c.response, problem),
                      fmt::format("{} is the same for every design", c.response.name)};
    }
    if (auto found = violated_where_still(c, problem, start, within, tolerance)) return found;
  }
  return {};
}

void narrow_blame(Problem problem, const SearchAgain& search, Assessment& answer) {
  // A limit without which the rest can be met is needed with fewer limits too: each is left out
  // once.
  for (std::size_t i = 0; i < problem.constraints.size();) {
    if (!is_one_of_several(problem.constraints[i], answer)) {
      ++i;
      continue;
    }
    Problem others = problem;
    others.constraints.erase(others.constraints.begin() + static_cast<std::ptrdiff_t>(i));
    const Assessment without = search(others);
    const bool is_known_as_well = without.global || !answer.global;
    if (without.verdict != Verdict::Infeasible || without.blamed.empty() || !is_known_as_well) {
      ++i;
      continue;
    }
    answer.blamed = without.blamed;
    answer.reason = without.reason;
    answer.global = without.global;
    problem = std::move(others);
  }
}

}  // namespace camlaw::optim
