// SPDX-License-Identifier: MIT
#include "problems/statement/choices.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "problems/statement/parameters.h"

namespace camlaw::problems {

std::optional<double> find_choice(const std::vector<double>& values, double wanted) {
  const auto found = std::find_if(values.begin(), values.end(), [&](double value) {
    return onto_range(wanted, value, value) == value;
  });
  return found == values.end() ? std::nullopt : std::optional(*found);
}

std::optional<std::string> why_not(const VariableStatement& variable, double value) {
  if (!variable.values.empty()) {
    if (find_choice(variable.values, value)) return {};
    return fmt::format("{} is not one of {}", with_unit(value, variable.unit),
                       values_text(variable.values, variable.unit));
  }
  const double meant = onto_range(value, variable.lower, variable.upper);
  if (!(meant >= variable.lower && meant <= variable.upper)) {
    return fmt::format("{} is outside the bounds {}", with_unit(value, variable.unit),
                       range_text(variable.lower, variable.upper, variable.unit));
  }
  if (variable.integer && meant != std::floor(meant)) {
    return fmt::format("{:.6g} is not an integer, as {} must be", value, variable.name);
  }
  return {};
}

double as_chosen(const VariableStatement& variable, double value) {
  if (const auto why = why_not(variable, value)) throw std::invalid_argument(*why);
  if (!variable.values.empty()) return *find_choice(variable.values, value);
  return onto_range(value, variable.lower, variable.upper);
}

}  // namespace camlaw::problems
