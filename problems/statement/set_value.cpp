// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "numerics/text/names.h"
#include "numerics/text/units.h"
#include "problems/statement/advancing_cycle.h"
#include "problems/statement/buildable.h"
#include "problems/statement/choices.h"
#include "problems/statement/law_rooms.h"
#include "problems/statement/parameters.h"

namespace camlaw::problems {
namespace {

std::vector<std::string_view> parted(std::string_view text, char mark) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(mark);
    parts.push_back(trimmed(text.substr(0, end)));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

/// A number that the parameter accepts.
double read_number(std::string_view text, const NamedParameter& parameter,
                   const std::string& name) {
  const double value = onto_range(parse_quantity(text, parameter.unit, parameter.unit, name),
                                  parameter.low, parameter.high);
  if (const auto why = refusal(parameter, value)) {
    throw std::invalid_argument(fmt::format("{}: {}", name, *why));
  }
  return value;
}

/// Sets one number: the start of what varies, or what is fixed.
void set_number(ProblemStatement& problem, const NamedParameter& parameter, std::size_t index,
                std::string_view text) {
  const std::string name = parameter.element_name(index);
  if (!parameter.of_law && problem.told_by_motion.contains(parameter.parameter)) {
    throw std::invalid_argument(
        fmt::format("{}: the motion is stated in {}; change it in the file", name, parameter.unit));
  }
  double value = read_number(text, parameter, name);
  if (const auto i = find_variable(problem, parameter, index)) {
    VariableStatement& variable = problem.variables[*i];
    if (const auto why = why_not(variable, value)) {
      throw std::invalid_argument(fmt::format("{}: {}", name, *why));
    }
    value = variable.start = as_chosen(variable, value);
  }
  put_value(problem, parameter, index, value);
}

/// Sets a list. Its length is fixed where a number of it varies: each is a variable.
void set_list(ProblemStatement& problem, const NamedParameter& parameter, std::string_view text) {
  const auto parts = text.empty() ? std::vector<std::string_view>{} : parted(text, ',');
  std::vector<double> values = values_of(problem, parameter);
  bool varies = false;
  for (std::size_t i = 0; i < values.size(); ++i) {
    varies |= find_variable(problem, parameter, i).has_value();
  }
  if (varies && parts.size() != values.size()) {
    throw std::invalid_argument(fmt::format("{}: {} values are given; it varies, and has {}",
                                            parameter.name, parts.size(), values.size()));
  }
  put_values(problem, parameter, std::vector<double>(parts.size()));
  for (std::size_t i = 0; i < parts.size(); ++i) set_number(problem, parameter, i, parts[i]);
}

/// "blades=21", without a look at whether the laws are possible.
void assign(ProblemStatement& problem, std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  const std::string_view name = trimmed(assignment.substr(0, equals));
  if (equals == std::string_view::npos || name.empty()) {
    throw std::invalid_argument(
        fmt::format("'{}' sets nothing; write name=value, such as stroke=30 mm", assignment));
  }
  const std::string_view text = trimmed(assignment.substr(equals + 1));
  if (const BuildableInput* input = find_input(*problem.mechanism, name)) {
    const std::string& stated = input->name;
    problem.buildable.inputs[stated] =
        accepted_input(*input, parse_quantity(text, input->unit, input->unit, stated));
    return;
  }
  const NamedParameter parameter = find_parameter(problem, name);
  if (parameter.list && !parameter.element) {
    set_list(problem, parameter, text);
  } else {
    set_number(problem, parameter, parameter.element.value_or(0), text);
  }
}

}  // namespace

void set_values(ProblemStatement& problem, std::span<const std::string> assignments) {
  ProblemStatement changed = problem;  // which stays as it is where a value is refused
  for (const std::string& assignment : assignments) assign(changed, assignment);
  check_laws(changed);  // values that are possible together only come together
  check_advancing_cycle(changed);
  limit_to_checks(changed);
  limit_to_laws(changed);
  changed.settings.insert(changed.settings.end(), assignments.begin(), assignments.end());
  problem = std::move(changed);
}

void set_value(ProblemStatement& problem, const std::string& assignment) {
  set_values(problem, {&assignment, 1});
}

}  // namespace camlaw::problems
