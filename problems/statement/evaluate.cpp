// SPDX-License-Identifier: MIT
#include <algorithm>

#include "optim/cycle/extremes.h"
#include "problems/statement/bind.h"

namespace camlaw::problems {
namespace {

/// The binding in which nothing varies.
Binding fixed(const ProblemStatement& statement) {
  Binding binding;
  binding.constants = statement.constants;
  binding.law = std::make_shared<LawBinding>(statement.laws.front(), std::vector<LawVariable>{});
  return binding;
}

EvaluatedResponse evaluated(const ProblemStatement& statement, const MechanismResponse& declared,
                            const Binding& binding) {
  const auto name = find_response(*statement.mechanism, declared.name);
  const optim::Response response = make_response(*statement.mechanism, name, binding);
  EvaluatedResponse result;
  result.name = declared.name;
  result.unit = declared.unit;
  result.meaning = declared.meaning;
  result.along = declared.along;
  result.is_curve = response.is_curve();
  if (!result.is_curve) {
    result.value = response.function().value({});
    return result;
  }
  const auto trace = response.curve().trace({});
  const auto up = optim::highest(*trace, 1), down = optim::highest(*trace, -1);
  result.highest = up.value;
  result.highest_at = up.place.angle;
  result.lowest = down.value;
  result.lowest_at = down.place.angle;
  return result;
}

}  // namespace

std::vector<EvaluatedResponse> evaluate(const ProblemStatement& statement) {
  const Binding binding = fixed(statement);
  std::vector<EvaluatedResponse> result;
  for (const MechanismResponse& declared : statement.mechanism->responses) {
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
    named.value = peak.part == optim::Part::Lowest    ? curve->lowest
                  : peak.part == optim::Part::Highest ? curve->highest
                                                      : std::max(curve->highest, -curve->lowest);
    result.push_back(std::move(named));
  }
  return result;
}

std::vector<optim::Response> curves_of(const ProblemStatement& statement) {
  const Binding binding = fixed(statement);
  std::vector<optim::Response> curves;
  for (const MechanismResponse& declared : statement.mechanism->responses) {
    if (!declared.curve) continue;
    const auto name = find_response(*statement.mechanism, declared.name);
    curves.push_back(make_response(*statement.mechanism, name, binding));
  }
  return curves;
}

std::string place_name(const ProblemStatement& statement) {
  const bool cam = statement.mechanism->moved_by != MovedBy::Nothing;
  for (const MechanismResponse& declared : statement.mechanism->responses) {
    if (!declared.curve || declared.along == "1") continue;
    return (cam ? "cam_angle [" : "angle [") + declared.along + "]";
  }
  return "x";
}

std::vector<optim::LimitReport> standing(const ProblemStatement& statement) {
  optim::Problem problem;
  problem.name = statement.title;
  problem.constraints = constraints_of(statement, fixed(statement));
  problem.check();
  return as_stated(statement, optim::limit_reports(problem, optim::sizes(problem, {}), {}, true));
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

}  // namespace camlaw::problems
