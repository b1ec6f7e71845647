// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "numerics/formula/formula.h"

namespace camlaw {

/// Why a formula has no value at u, in words: "it takes the logarithm of -2", of the first step on
/// the way to its value that is not a number although what it takes is; numbers are in units of the
/// SI. Empty where it has a value, and of a formula that searches for roots.
std::string why_undefined(const Formula& formula, std::span<const double> u);

}  // namespace camlaw
