// SPDX-License-Identifier: MIT
#include "optim/verdict/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "optim/cycle/maxima_at.h"

namespace camlaw::optim {
namespace {

/// One side at a design: how much room is left, and where on the cycle.
struct SideOfLimit {
  double value, margin;
  std::optional<Place> place;
  std::optional<Bounds> left = {};  ///< LimitReport::left
};

SideOfLimit side_of(const Response& response, MaximaAt& maxima, Design x, double sign,
                    double bound) {
  if (!response.is_curve()) {
    const double value = response.function().value(x);
    return {value, sign * (bound - value), {}};
  }
  const Extreme worst = maxima.highest(response.curve(), sign);
  return {worst.value, sign * (bound - worst.value), worst.place};
}

/// With less room than this share of its bound a limit's value is as good as the limit.
constexpr double kToldMargin = 1e-6;

/// `side` takes a worse value that a proof has come upon; what is not a number is worst of all, and
/// stays.
void take_worse(double value, const std::optional<Place>& place, double sign, double bound,
                SideOfLimit& side) {
  const double margin = sign * (bound - value);
  if (!std::isnan(side.margin) && !(margin >= side.margin)) side = {value, margin, place};
}

/// Whether intervals prove one side, with its tolerance. Where they come upon a worse place than
/// the search did, `side` becomes that.
bool prove_side(const Response& response, MaximaAt& maxima, Design x, double sign, double bound,
                const ConstraintScale& own, SideOfLimit& side) {
  const double tolerance = own.tolerance;
  if (!response.is_curve()) {
    const Function& f = response.function();
    if (f.is_searched()) {
      take_worse(f.proved().value(x), {}, sign, bound, side);
    }
    const Bounds exact = f.enclose(x);
    const bool within =
        sign > 0 ? exact.upper <= bound + tolerance : exact.lower >= bound - tolerance;
    const bool proved = within && !std::isnan(side.margin);
    if (!proved && f.is_enclosed()) side.left = Bounds{};
    return proved;
  }
  const Trace& trace = maxima.trace(response.curve());
  const auto take = [&](const Extreme& worst) {
    take_worse(worst.value, worst.place, sign, bound, side);
  };
  take(looked_closely(trace, sign, {*side.place, side.value}));
  if (!(side.margin >= -tolerance)) return false;  // one place that breaks it is enough
  // A number that is told is proved as well, where that is not the same question.
  const double highest = sign * bound + tolerance;
  if (side.margin > std::max(kToldMargin * std::abs(bound), tolerance)) {
    const ProvedExtreme found = proved_highest(trace, sign, std::max(std::abs(bound), own.scale));
    take(found.peak);
    if (std::isnan(side.margin)) return false;
    if (found.proved && sign * found.peak.value + found.slack <= highest) return true;
  }
  const CycleProof proof = prove_below(trace, sign, highest);
  take(proof.worst);
  if (!proof.proved) take(looked_closely(trace, sign, {*side.place, side.value}));
  side.left = proof.left;
  return proof.proved;
}

void show(const SideOfLimit& side, double sign, double bound, LimitReport& report) {
  report.value = side.value;
  report.bound = bound;
  report.is_upper = sign > 0;
  report.margin = side.margin;
  if (!side.place) return;
  report.worst_angle = side.place->angle;
  report.from_left = side.place->from_left;
}

LimitReport report(const Constraint& c, const ConstraintScale& own, MaximaAt& maxima, Design x,
                   bool prove) {
  LimitReport result;
  result.name = c.response.name;
  result.unit = c.response.unit;
  result.is_equation = c.is_equation();
  result.tolerance = own.tolerance;
  result.margin = kInfinity;
  result.proved = prove;
  const auto look = [&](double sign, double bound) {
    SideOfLimit side = side_of(c.response, maxima, x, sign, bound);
    if (prove) {
      result.proved = prove_side(c.response, maxima, x, sign, bound, own, side) && result.proved;
      if (side.left) result.left = side.left;
    }
    // A value at minus infinity is as far from its bound as can be, but no value of a design.
    if (std::isinf(side.margin) && side.margin > 0) {
      side.margin = std::numeric_limits<double>::quiet_NaN();
    }
    // What is not a number is worst of all, and stays.
    if (side.margin >= result.margin || std::isnan(result.margin)) return;
    show(side, sign, bound, result);
  };
  if (c.upper) look(1, *c.upper);
  if (c.lower) look(-1, *c.lower);
  result.met = result.margin >= -own.tolerance;
  return result;
}

/// A little more than a peak that the search has found; `least` where that is near zero.
double above(double value, double least) {
  constexpr double kLittle = 1e-9;  // more than a search leaves below a peak by rounding
  return value + std::max(kLittle * std::abs(value), least);
}

/// Proves one side of the objective's peak, `value` times `sign` the highest that the search found.
/// Where the proof finds more, the report takes it.
double prove_peak(const Trace& trace, double sign, ObjectiveReport& report, double value,
                  double least) {
  const double limit = above(sign * value, least);
  const CycleProof proof = prove_below(trace, sign, limit);
  if (proof.proved) return limit;
  if (proof.broken) {
    report.value = proof.worst.value;
    report.angle = proof.worst.place.angle;
    report.from_left = proof.worst.place.from_left;
    report.sign = sign;
  }
  return kInfinity;
}

/// What sign * curve reaches at the place of its peak, rounding included: the value that was found
/// there, less `least`, or what encloses it.
double attained(const Trace& trace, const ObjectiveReport& report, double least) {
  const double angle = *report.angle;
  double from = angle;  // beside a break the piece on the left is told by what lies in it
  for (int i = 0; i < 4 && report.from_left; ++i) from = std::nextafter(from, -kInfinity);
  const Bounds there = trace.enclose(from, angle);
  const double lower = report.sign > 0 ? there.lower : -there.upper;
  return std::min(-above(-report.sign * report.value, least), lower);
}

}  // namespace

std::vector<LimitReport> limit_reports(const Problem& problem, const Scales& scales, Design x,
                                       bool prove) {
  MaximaAt maxima(x);
  std::vector<LimitReport> result;
  for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
    result.push_back(report(problem.constraints[i], scales.constraints[i], maxima, x, prove));
  }
  return result;
}

void show_side(const Constraint& c, Design x, bool upper, LimitReport& report) {
  MaximaAt maxima(x);
  const double sign = upper ? 1 : -1, bound = upper ? *c.upper : *c.lower;
  SideOfLimit side = side_of(c.response, maxima, x, sign, bound);
  if (side.place) {
    const Trace& trace = maxima.trace(c.response.curve());
    const Extreme worst = looked_closely(trace, sign, {*side.place, side.value});
    side = {worst.value, sign * (bound - worst.value), worst.place};
  } else if (c.response.function().is_searched()) {
    const double value = c.response.function().proved().value(x);
    side = {value, sign * (bound - value), {}};
  }
  show(side, sign, bound, report);
}

ObjectiveReport objective_report(const Problem& problem, const Scales& scales, Design x,
                                 bool prove) {
  const Objective& objective = problem.objective();
  ObjectiveReport result;
  result.tolerance = scales.objective_tolerance;
  if (!objective.response.is_curve()) {
    const Function& f = objective.response.function();
    result.value = prove ? f.proved().value(x) : f.value(x);
    if (prove) result.proved = f.enclose(x);
    return result;
  }
  const auto trace = objective.response.curve().trace(x);
  const bool lowest = objective.part == Part::Lowest;
  const bool magnitude = objective.part == Part::Magnitude;
  Extreme peak = extreme_of(*trace, objective.part);
  result.sign = lowest || (magnitude && peak.value < 0) ? -1 : 1;
  if (prove) peak = looked_closely(*trace, result.sign, peak);
  result.value = peak.value;
  result.angle = peak.place.angle;
  result.from_left = peak.place.from_left;
  if (prove) {
    const double found = result.value;
    constexpr double kUnnoticed = 0.1;  // of the tolerance
    const double least = kUnnoticed * scales.objective_tolerance;
    const double one = prove_peak(*trace, result.sign, result, found, least);
    const double other = magnitude ? prove_peak(*trace, -result.sign, result, -found, least) : one;
    const double most = std::max(one, other);
    const double reached = attained(*trace, result, least);
    result.proved = lowest ? Bounds{-most, -reached} : Bounds{reached, most};
  }
  if (magnitude) result.value = std::abs(result.value);
  return result;
}

namespace {

/// "mean_square_jerk: why"; empty where the response is a finite number.
std::string undefined_response(const Response& response, Part part, Design x) {
  std::string why;
  double value;
  if (response.is_curve()) {
    const auto trace = response.curve().trace(x);
    value = extreme_of(*trace, part).value;
    why = trace->why_unbounded();
  } else {
    value = response.function().value(x);
    why = response.function().why_undefined(x);
  }
  if (std::isfinite(value)) return {};
  return why.empty() ? response.name : response.name + ": " + why;
}

}  // namespace

std::string undefined_at(const Problem& problem, Design x, const std::string& where) {
  std::string result =
      undefined_response(problem.objective().response, problem.objective().part, x);
  for (const Constraint& c : problem.constraints) {
    if (!result.empty()) break;
    result = undefined_response(c.response, Part::Magnitude, x);
  }
  const std::string what = "the model is undefined at " + where;
  return result.empty() ? what : fmt::format("{} ({})", what, result);
}

double worst_violation(const std::vector<LimitReport>& limits) {
  double worst = 0;
  for (const LimitReport& limit : limits) {
    const double violation = -limit.margin / limit.tolerance;
    if (std::isnan(violation)) return kInfinity;
    worst = std::max(worst, violation);
  }
  return worst;
}

}  // namespace camlaw::optim
