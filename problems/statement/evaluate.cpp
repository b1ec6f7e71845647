// SPDX-License-Identifier: MIT
#include "problems/statement/evaluate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "machines/model/fixed_binding.h"
#include "optim/cycle/extremes.h"
#include "optim/cycle/remembered.h"
#include "optim/cycle/scales.h"
#include "optim/verdict/limits.h"
#include "problems/statement/added_part.h"
#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"
#include "problems/statement/speed_curves.h"
#include "problems/statement/why_undefined.h"

namespace camlaw::problems {
namespace {

/// The binding in which nothing varies.
Binding fixed(const ProblemStatement& statement) {
  return fixed_binding(statement.constants, statement.laws.front());
}

/// A value in the unit that it is shown in; 0 where its enclosure holds 0 and is so narrow that
/// nothing but the rounding of the formula is left, as of integrals that cancel.
double without_rounding(const optim::Function& function, double value) {
  constexpr double kNone = 1e-9;  // of one unit: answers show no such digits
  if (value == 0 || !(std::abs(value) < kNone)) return value;
  const optim::Bounds proved = function.enclose({});
  const bool holds_zero = proved.lower <= 0 && proved.upper >= 0;
  return holds_zero && proved.upper - proved.lower < kNone ? 0 : value;
}

EvaluatedResponse evaluated(const ProblemStatement& statement, const MechanismResponse& declared,
                            const Binding& binding) {
  const auto name = find_response(*statement.mechanism, declared.name);
  const optim::Response response = response_of(statement, name, binding);
  EvaluatedResponse result;
  result.name = declared.name;
  result.unit = declared.unit;
  result.meaning = declared.meaning;
  result.along = declared.along;
  result.is_curve = response.is_curve();
  if (!result.is_curve) {
    result.value = without_rounding(response.function(), response.function().proved().value({}));
    if (response.function().is_searched()) {
      const optim::Bounds proved = response.function().enclose({});
      result.proved = std::isfinite(proved.upper - proved.lower) || !std::isfinite(result.value);
    }
    return result;
  }
  const auto trace = response.curve().trace({});
  const double size = std::abs(optim::extreme_of(*trace, optim::Part::Magnitude).value);
  const auto up = optim::proved_highest(*trace, 1, size);
  const auto down = optim::proved_highest(*trace, -1, size);
  result.highest = up.peak.value;
  result.highest_at = up.peak.place.angle;
  result.lowest = down.peak.value;
  result.lowest_at = down.peak.place.angle;
  result.proved = up.proved && down.proved;
  return result;
}

}  // namespace

EvaluatedResponse evaluate_response(const ProblemStatement& statement,
                                    const MechanismResponse& declared) {
  return evaluated(statement, declared, fixed(statement));
}

namespace {

/// Why a curve has no numbers by its own account; empty where it has, or nothing is known.
std::string why_without_numbers(const ProblemStatement& statement, const std::string& curve) {
  const auto name = find_response(*statement.mechanism, curve);
  return response_of(statement, name, fixed(statement)).curve().trace({})->why_unbounded();
}

/// The same without what is of a part that the machine has only where it is stated, as an elastic
/// train, which goes without saying.
std::string why_curve(const ProblemStatement& statement, const EvaluatedResponse& response) {
  std::string why = why_without_numbers(statement, response.name);
  if (why.empty()) return why;
  ProblemStatement plain = statement;
  for (std::size_t i = 0; i < plain.constants.size(); ++i)
    plain.constants[i] = statement.mechanism->parameters[i].default_value;
  return why_without_numbers(plain, response.name) == why ? std::string() : why;
}

bool is_undefined(const EvaluatedResponse& response) {
  return std::isnan(response.is_curve ? response.highest : response.value);
}

/// The condition that the machine of a response does not meet.
std::string why_no_machine(const ProblemStatement& statement, const MechanismResponse& response) {
  const Mechanism& mechanism = *statement.mechanism;
  if (!response.is_possible || response.is_possible(statement.constants)) return {};
  std::string why = mechanism.why_impossible ? mechanism.why_impossible(statement.constants) : "";
  if (!response.cam) return why;
  const std::string of_cam = mechanism.cams[*response.cam].name + ".";
  return why.find(of_cam) == std::string::npos ? "" : why;  // that of another cam comes first
}

/// "friction in the guide jams the follower, guide_fraction 1.41 at 38 deg", where a response is a
/// number without what a check is about, and that check fails.
std::string why_by_check(const ProblemStatement& statement, const MechanismResponse& response) {
  const Mechanism& mechanism = *statement.mechanism;
  for (const BuildableCheck& check : mechanism.checks) {
    if (!is_of_added_part(mechanism, check)) continue;
    ProblemStatement without = statement;
    for (const std::string& name : check.needs) without.constants[mechanism.parameter(name)] = 0;
    if (without.constants == statement.constants) continue;
    if (is_undefined(evaluate_response(without, response))) continue;
    const auto share =
        evaluate_response(statement, *find_response(mechanism, check.response).response);
    const double bound = check.bound([](std::string_view) { return std::optional<double>(); });
    if (!(check.is_upper ? share.highest > bound : share.lowest < bound)) continue;
    return fmt::format("{}, {} {:.4g} at {:.4g} {}", check.fault, check.response,
                       check.is_upper ? share.highest : share.lowest,
                       check.is_upper ? share.highest_at : share.lowest_at, share.along);
  }
  return {};
}

}  // namespace

std::string why_undefined(const ProblemStatement& statement, const EvaluatedResponse& response) {
  if (!is_undefined(response)) return {};
  const MechanismResponse* const own = find_response(*statement.mechanism, response.name).response;
  if (own == nullptr) return {};
  if (std::string why = why_no_machine(statement, *own); !why.empty()) return why;
  if (response.is_curve) {
    if (std::string why = why_curve(statement, response); !why.empty()) return why;
  }
  std::string why = why_by_check(statement, *own);
  const bool is_stated = static_cast<bool>(own->domain);  // by a formula of the file
  if (!why.empty() || response.is_curve || !is_stated) return why;
  const auto name = find_response(*statement.mechanism, response.name);
  const optim::Response number = response_of(statement, name, fixed(statement));
  return number.is_curve() ? std::string() : number.function().why_undefined({});
}

std::string why_infinite(const ProblemStatement& statement, const EvaluatedResponse& response) {
  if (!response.is_curve || !(std::isinf(response.highest) || std::isinf(response.lowest)))
    return {};
  const Mechanism& mechanism = *statement.mechanism;
  const MechanismResponse* const own = find_response(mechanism, response.name).response;
  for (const ValidityLimit& limit : own->defined_while) {
    const auto by =
        evaluate_response(statement, *find_response(mechanism, limit.response).response);
    const bool is_low = by.lowest == limit.lower;
    if (!is_low && by.highest != limit.upper) continue;
    return fmt::format("{} is {} at {:.4g} {}", limit.response,
                       with_unit(is_low ? by.lowest : by.highest, by.unit),
                       is_low ? by.lowest_at : by.highest_at, by.along);
  }
  return why_curve(statement, response);
}

std::vector<EvaluatedResponse> evaluate(const ProblemStatement& statement) {
  return evaluate(statement, {});
}

std::vector<EvaluatedResponse> evaluate(const ProblemStatement& statement,
                                        const EvaluationProgress& progress) {
  const Binding binding = fixed(statement);
  const std::vector<MechanismResponse>& all = statement.mechanism->responses;
  std::vector<EvaluatedResponse> result;
  for (const MechanismResponse& declared : all) {
    if (progress) progress(result.size(), all.size());
    result.push_back(evaluated(statement, declared, binding));
  }
  for (const NamedPeak& peak : statement.mechanism->peaks) {
    const auto curve = std::find_if(result.begin(), result.end(), [&](const auto& response) {
      return response.name == peak.curve;
    });
    EvaluatedResponse named;
    named.name = peak.name;
    named.unit = curve->unit;
    named.meaning = peak.meaning;
    named.proved = curve->proved;
    named.value = peak.part == optim::Part::Lowest    ? curve->lowest
                  : peak.part == optim::Part::Highest ? curve->highest
                                                      : std::max(curve->highest, -curve->lowest);
    result.push_back(std::move(named));
  }
  return result;
}

namespace {

std::vector<optim::Response> curves_along(const ProblemStatement& statement, bool speed) {
  const Binding binding = fixed(statement);
  std::vector<optim::Response> curves;
  for (const MechanismResponse& declared : statement.mechanism->responses) {
    if (!declared.curve || is_over_speed(declared) != speed) continue;
    const auto name = find_response(*statement.mechanism, declared.name);
    curves.push_back(response_of(statement, name, binding));
  }
  return curves;
}

}  // namespace

std::vector<optim::Response> curves_of(const ProblemStatement& statement) {
  return curves_along(statement, false);
}

std::vector<optim::Response> curves_over_speed(const ProblemStatement& statement) {
  return curves_along(statement, true);
}

std::string place_name(const ProblemStatement& statement) {
  const bool cam = statement.mechanism->moved_by != MovedBy::Nothing && statement.cams.empty();
  for (const MechanismResponse& declared : statement.mechanism->responses) {
    if (!declared.curve || declared.along == "1" || is_over_speed(declared)) continue;
    return (cam ? "cam_angle [" : "angle [") + declared.along + "]";
  }
  return "x";
}

std::vector<optim::LimitReport> standing(const ProblemStatement& statement) {
  optim::Problem problem;
  problem.name = statement.title;
  problem.objectives = {optim::no_objective()};
  problem.constraints = constraints_of(statement, fixed(statement));
  problem.check();
  problem = optim::remembered(std::move(problem));  // a search over ranges takes long
  return as_stated(statement, optim::limit_reports(problem, optim::scales(problem, {}), {}, true));
}

std::vector<optim::LimitReport> as_stated(const ProblemStatement& statement,
                                          std::vector<optim::LimitReport> limits) {
  for (std::size_t i = 0; i < limits.size(); ++i) {
    optim::LimitReport& limit = limits[i];
    if (statement.constraints[i].response.part != optim::Part::Magnitude || limit.is_upper)
      continue;
    limit.value = -limit.value;
    limit.bound = -limit.bound;
    limit.is_upper = true;
  }
  return limits;
}

namespace {

std::optional<optim::LimitReport> other_side(const ProblemStatement& statement, std::size_t i,
                                             const optim::LimitReport& shown) {
  ProblemStatement alone = statement;
  alone.constraints = {statement.constraints[i]};
  ConstraintStatement& c = alone.constraints.front();
  if (shown.is_equation || !c.lower || !c.upper) return {};
  (shown.is_upper ? c.upper : c.lower).reset();
  optim::LimitReport other = standing(alone).front();
  other.name = shown.name;
  return other;
}

}  // namespace

std::vector<std::optional<optim::LimitReport>> other_sides(
    const ProblemStatement& statement, const std::vector<optim::LimitReport>& limits) {
  std::vector<std::optional<optim::LimitReport>> sides;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    sides.push_back(other_side(statement, i, limits[i]));
  }
  return sides;
}

}  // namespace camlaw::problems
