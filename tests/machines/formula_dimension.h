// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "numerics/formula/formula.h"
#include "numerics/text/dimension.h"

namespace camlaw {

/// What a recorded formula measures, of inputs that measure this. Its constants are plain numbers,
/// but for 0, infinity and what is not a number, which measure anything. Throws
/// std::invalid_argument where it adds or compares quantities of different kinds, or takes a
/// function of one that is not a plain number.
Dimension dimension_of(const Formula& formula, std::span<const Dimension> inputs);

}  // namespace camlaw
