// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

namespace camlaw::problems {

/// What a response is where it has no value.
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace camlaw::problems
