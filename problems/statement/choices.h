// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "problems/statement/statement.h"

/// What values a variable may take.
namespace camlaw::problems {

/// The value of a list that is meant: a change of units leaves rounding.
std::optional<double> find_choice(const std::vector<double>& values, double wanted);

/// Why a variable cannot have a value, in words; empty where it can.
std::optional<std::string> why_not(const VariableStatement& variable, double value);

/// The value that the variable takes where `value` is meant. Throws std::invalid_argument with
/// why_not.
double as_chosen(const VariableStatement& variable, double value);

}  // namespace camlaw::problems
