// SPDX-License-Identifier: MIT
#include "output/answers/variable_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "optim/cycle/scales.h"

namespace camlaw::cli {
namespace {

/// Whether objective and limits that are numbers stay as they are with another value of a variable.
bool is_as_good(const optim::Optimum& optimum, std::size_t variable, double value) {
  std::vector<double> x = optimum.found.x;
  if (x.size() != optimum.problem.variables.size()) return true;
  x[variable] = value;
  const optim::ObjectiveReport& found = optimum.found.assessment.objective;
  const double there = optim::objective_value(optimum.problem.objective(), x);
  return std::abs(there - found.value) <= found.tolerance &&
         std::ranges::none_of(optimum.problem.constraints, [&](const optim::Constraint& c) {
           return !c.response.is_curve() && std::isnan(c.response.function().value(x));
         });
}

}  // namespace

std::string variable_in_words(const optim::Optimum& optimum, std::size_t variable) {
  const optim::VariableReport& v = optimum.found.assessment.variables[variable];
  const double size = std::max({std::abs(v.value), std::abs(v.lower), std::abs(v.upper)});
  const bool is_noise = std::abs(v.value) < 1e-12 * size;
  const std::string words = fmt::format("{:.10g}", is_noise ? 0 : v.value);
  const double told = std::strtod(words.c_str(), nullptr);
  const bool is_special = told == 0 || told == v.lower || told == v.upper;
  if (!is_special || told == v.value || is_as_good(optimum, variable, told)) return words;
  return fmt::format("{:.17g}", v.value);
}

}  // namespace camlaw::cli
