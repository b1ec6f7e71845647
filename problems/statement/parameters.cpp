// SPDX-License-Identifier: MIT
#include "problems/statement/parameters.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "machines/model/given_law.h"

namespace camlaw::problems {
namespace {

/// Rounding that a change of units may leave, of the value's size.
constexpr double kRounding = 1e-12;

}  // namespace

std::string NamedParameter::element_name(std::size_t index) const {
  return list ? fmt::format("{}[{}]", name, index + 1) : name;
}

std::optional<std::size_t> index_in(const Family& law, std::string_view parameter) {
  for (std::size_t i = 0; i < law.parameters.size(); ++i) {
    if (law.parameters[i].is_called(parameter)) return i;
  }
  return {};
}

std::optional<std::size_t> law_place(const Family& law, const VariableStatement& variable) {
  return variable.of_law ? index_in(law, variable.law_parameter)
                         : given_parameter(law, variable.parameter);
}

std::vector<double> values_of(const ProblemStatement& problem, const NamedParameter& parameter) {
  if (!parameter.of_law) return {problem.constants[parameter.parameter]};
  for (const Member& law : problem.laws) {
    if (const auto i = index_in(*law.family, parameter.law_parameter)) {
      return law.arguments.list(*i);
    }
  }
  return {};
}

std::string measure_of(const VariableStatement& variable, double value) {
  if (!variable.measure) return "";
  return fmt::format("{:.6g} {}", value * variable.measure->one, variable.measure->unit);
}

std::string measure_of(const ProblemStatement& problem, std::string_view variable, double value) {
  for (const VariableStatement& v : problem.variables) {
    if (v.name == variable) return measure_of(v, value);
  }
  return "";
}

std::string measured_bounds(const VariableStatement& variable) {
  if (!variable.measure) return "";
  return fmt::format(" ({:.6g} to {})", variable.lower * variable.measure->one,
                     measure_of(variable, variable.upper));
}

void put_value(ProblemStatement& problem, const NamedParameter& parameter, std::size_t index,
               double value) {
  if (!parameter.of_law) {
    problem.constants[parameter.parameter] = value;
    problem.stated.insert(parameter.parameter);
    for (Member& law : problem.laws) give(problem.constants, law);
    return;
  }
  for (Member& law : problem.laws) {
    if (const auto i = index_in(*law.family, parameter.law_parameter)) {
      law.arguments.values()[*i].at(index) = value;
    }
  }
}

void put_values(ProblemStatement& problem, const NamedParameter& parameter,
                const std::vector<double>& values) {
  for (Member& law : problem.laws) {
    if (const auto i = index_in(*law.family, parameter.law_parameter)) {
      law.arguments.values()[*i] = values;
    }
  }
}

double constant_of(const ProblemStatement& problem, std::string_view name) {
  return problem.constants[problem.mechanism->parameter(name)];
}

std::optional<std::size_t> find_variable(const ProblemStatement& problem,
                                         const NamedParameter& parameter, std::size_t index) {
  for (std::size_t i = 0; i < problem.variables.size(); ++i) {
    const VariableStatement& variable = problem.variables[i];
    const bool same =
        variable.of_law == parameter.of_law && variable.parameter == parameter.parameter &&
        variable.law_parameter == parameter.law_parameter && variable.element == index;
    if (same) return i;
  }
  return {};
}

VariableStatement new_variable(const NamedParameter& parameter, std::size_t index) {
  VariableStatement variable;
  variable.name = parameter.element_name(index);
  variable.unit = parameter.unit;
  variable.of_law = parameter.of_law;
  variable.parameter = parameter.parameter;
  variable.law_parameter = parameter.law_parameter;
  variable.element = index;
  return variable;
}

double onto_range(double value, double low, double high) {
  for (const double end : {low, high}) {
    if (std::abs(value - end) <= kRounding * std::abs(end)) return end;
  }
  return value;
}

std::optional<std::string> refusal(const NamedParameter& parameter, double value) {
  if (!(value >= parameter.low && value <= parameter.high)) {
    return fmt::format("{} is outside {}, which {} accepts", with_unit(value, parameter.unit),
                       range_text(parameter.low, parameter.high, parameter.unit), parameter.name);
  }
  if (parameter.integer && value != std::floor(value)) {
    return fmt::format("{:.6g} is not an integer, as {} must be", value, parameter.name);
  }
  return {};
}

void check_laws(const ProblemStatement& problem) {
  for (const Member& law : problem.laws) law.law();
  for (const LoadCase& load : problem.cases) check_laws_in(problem, load);
  for (const ParameterRange& range : problem.ranges) check_laws_over(problem, range);
}

void check_laws_over(const ProblemStatement& problem, const ParameterRange& range) {
  for (const Member& law : problem.laws) {
    if (!given_parameter(*law.family, range.parameter)) continue;
    // Times leave least of a turn at the highest speed.
    const LoadCase fastest{.name = {}, .parameters = {{range.parameter, range.upper}}};
    if (const auto made = law_in_case(law, problem, fastest).possible_law(); !made) {
      const MechanismParameter& p = problem.mechanism->parameters[range.parameter];
      throw std::invalid_argument(
          fmt::format("at {} = {}: {}", p.name, with_unit(range.upper, p.unit), made.reason().why));
    }
  }
}

Member law_in_case(Member law, const ProblemStatement& problem, const LoadCase& load) {
  std::vector<double> constants = problem.constants;
  for (const auto& [parameter, value] : load.parameters) constants[parameter] = value;
  give(constants, law);
  return law;
}

void check_laws_in(const ProblemStatement& problem, const LoadCase& load) {
  for (const Member& law : problem.laws) {
    if (const auto made = law_in_case(law, problem, load).possible_law(); !made) {
      throw std::invalid_argument(fmt::format("in case {}: {}", load.name, made.reason().why));
    }
  }
}

bool are_possible(const std::vector<Member>& laws) {
  return std::all_of(laws.begin(), laws.end(),
                     [](const Member& law) { return bool(law.possible_law()); });
}

std::string law_names(const ProblemStatement& problem) {
  std::vector<std::string> names;
  for (const Member& law : problem.laws) names.push_back(law.family->name);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string with_unit(double value, const std::string& unit) {
  return unit == "1" ? fmt::format("{:.6g}", value) : fmt::format("{:.6g} {}", value, unit);
}

std::string listed(const std::vector<std::string>& parts) {
  if (parts.size() < 2) return parts.empty() ? "" : parts.front();
  return fmt::format("{} and {}", fmt::join(parts.begin(), parts.end() - 1, ", "), parts.back());
}

std::string values_text(const std::vector<double>& values, const std::string& unit) {
  constexpr std::size_t kShown = 12;
  if (values.size() > kShown) {
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    return fmt::format("{} values from {:.6g} to {}", values.size(), *least,
                       with_unit(*most, unit));
  }
  std::vector<std::string> parts;
  for (const double value : values) parts.push_back(fmt::format("{:.6g}", value));
  return listed(parts) + (unit == "1" ? "" : " " + unit);
}

std::string range_text(double low, double high, const std::string& unit) {
  return fmt::format("{:.6g} .. {}", low, with_unit(high, unit));
}

}  // namespace camlaw::problems
