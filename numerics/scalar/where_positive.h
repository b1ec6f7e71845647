// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "numerics/scalar/scalar.h"

namespace camlaw {

/// x where the condition is above 0, elsewhere not a number.
template <class T>
T where_positive(const T& condition, const T& x) {
  return value_of(condition) > 0 ? x : number<T>(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace camlaw
