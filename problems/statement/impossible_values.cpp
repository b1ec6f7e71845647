// SPDX-License-Identifier: MIT
#include "problems/statement/impossible_values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "problems/statement/parameters.h"

namespace camlaw::problems {
namespace {

/// Whether a text has a name as a word.
bool has_name(const std::string& text, const std::string& name) {
  const auto is_part = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  };
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    const bool begins = at == 0 || !is_part(text[at - 1]);
    if (begins && (end == text.size() || !is_part(text[end]))) return true;
  }
  return false;
}

}  // namespace

std::string why_impossible(const ProblemStatement& statement) {
  const Mechanism& mechanism = *statement.mechanism;
  const std::string why =
      mechanism.why_impossible ? mechanism.why_impossible(statement.constants) : "";
  if (why.empty()) return why;
  std::vector<std::string> values;
  for (std::size_t i = 0; i < mechanism.parameters.size(); ++i) {
    const MechanismParameter& parameter = mechanism.parameters[i];
    if (!has_name(why, parameter.name)) continue;
    values.push_back(
        fmt::format("{} = {}", parameter.name, with_unit(statement.constants[i], parameter.unit)));
  }
  return fmt::format("{} is not possible with these values: {}; {}", mechanism.name,
                     fmt::join(values, ", "), why);
}

namespace {

/// The condition that fails at a design, or with one of its ranges at an end; empty where none
/// does.
std::string broken_condition_at(ProblemStatement design) {
  const auto& why_impossible = design.mechanism->why_impossible;
  if (!why_impossible) return "";
  if (std::string why = why_impossible(design.constants); !why.empty()) return why;
  for (const ParameterRange& range : design.ranges) {
    double& value = design.constants[range.parameter];
    const double stated = value;
    for (const double end : {range.lower, range.upper}) {
      value = end;
      if (std::string why = why_impossible(design.constants); !why.empty()) return why;
    }
    value = stated;
  }
  return "";
}

/// The condition that fails a millionth of a variable's box beside a design; empty where none does.
std::string condition_beside(const BoundProblem& bound, const optim::Optimum& optimum) {
  constexpr double kBeside = 1e-6;  // of the box: a search that ran into an edge ends nearer to it
  for (std::size_t i = 0; i < optimum.found.x.size(); ++i) {
    const optim::Variable& v = optimum.problem.variables[i];
    if (v.integer || !std::isfinite(v.upper - v.lower)) continue;
    for (const double side : {-kBeside, kBeside}) {
      std::vector<double> x = optimum.found.x;
      x[i] = std::clamp(x[i] + side * (v.upper - v.lower), v.lower, v.upper);
      if (std::string why = broken_condition_at(bound.at(optimum.options, x)); !why.empty())
        return why;
    }
  }
  return "";
}

}  // namespace

void say_impossible(const BoundProblem& bound, optim::Optimum& optimum) {
  optim::Assessment& assessment = optimum.found.assessment;
  if (optimum.found.x.size() != optimum.problem.variables.size()) return;
  const bool has_no_design = assessment.verdict == optim::Verdict::Failed ||
                             assessment.verdict == optim::Verdict::Infeasible;
  if (has_no_design) {
    const std::string why = why_impossible(bound.at(optimum.options, optimum.found.x));
    if (!why.empty()) assessment.reason += ": " + why;
  } else if (assessment.verdict == optim::Verdict::Feasible) {
    const std::string why = condition_beside(bound, optimum);
    if (!why.empty())
      assessment.reason +=
          "; it ended next to designs for which the machine is not possible: " + why;
  }
}

}  // namespace camlaw::problems
