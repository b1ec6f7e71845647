// SPDX-License-Identifier: MIT
#include "problems/results/start_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "numerics/text/units.h"
#include "problems/statement/parts.h"

namespace camlaw::problems {
namespace {

struct Number {
  double value;
  std::string unit;
};

/// The number that a design has for a variable of another problem: of its own variable of that
/// name, or of the machine's constant.
std::optional<Number> known_number(const ProblemStatement& design,
                                   const VariableStatement& variable) {
  for (const VariableStatement& own : design.variables) {
    if (own.name == variable.name) return Number{own.start, own.unit};
  }
  if (variable.of_law) return {};
  const auto& parameters = design.mechanism->parameters;
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const auto& p) { return p.name == variable.name; });
  if (found == parameters.end()) return {};
  const auto index = static_cast<std::size_t>(found - parameters.begin());
  if (!design.stated.contains(index)) return {};
  return Number{design.constants[index], found->unit};
}

/// The value that the variable accepts which is nearest.
double accepted(const VariableStatement& variable, double value) {
  if (!variable.values.empty()) {
    return *std::min_element(
        variable.values.begin(), variable.values.end(),
        [&](double a, double b) { return std::abs(a - value) < std::abs(b - value); });
  }
  const double within = std::clamp(value, variable.lower, variable.upper);
  return variable.integer ? std::round(within) : within;
}

}  // namespace

std::vector<std::string> start_settings(const ProblemStatement& problem, const ReadDesign& design) {
  std::vector<std::string> settings;
  for (const PartStatement& part : problem.parts) {
    const PartStatement* own = find_part(design.statement, part.name);
    if (!part.is_chosen() || own == nullptr || own->is_chosen()) continue;
    const std::string& name = own->items.front().name;
    const bool is_there = std::any_of(part.items.begin(), part.items.end(),
                                      [&](const PartItem& item) { return item.name == name; });
    if (is_there) settings.push_back(fmt::format("{}={}", part.name, name));
  }
  for (const VariableStatement& variable : problem.variables) {
    const auto number = known_number(design.statement, variable);
    if (!number || !std::isfinite(number->value)) continue;
    const double value = number->unit == variable.unit
                             ? number->value
                             : convert_unit(number->value, number->unit, variable.unit);
    settings.push_back(fmt::format("{}={}{}", variable.name, accepted(variable, value),
                                   variable.unit == "1" ? "" : " " + variable.unit));
  }
  if (settings.empty()) {
    throw std::invalid_argument("none of what varies in the problem is in its design");
  }
  return settings;
}

std::vector<std::string> start_settings(const ProblemStatement& problem, const std::string& path) {
  const ReadDesign design = read_design_file(path);
  if (!design.verdict) {
    throw std::invalid_argument(fmt::format(
        "{}: this is a problem file; --start needs a result of 'camlaw optimize'", path));
  }
  try {
    return start_settings(problem, design);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("{}: {}", path, error.what()));
  }
}

}  // namespace camlaw::problems
