// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "numerics/scalar/scalar.h"

namespace camlaw {

/// Derivatives that a curve can give, its value included: as many of them as are asked for.
inline constexpr std::size_t kCurveOrders = 12;

/// The first N of a curve, N up to kCurveOrders.
template <class T, std::size_t N>
using CurveDerivatives = std::array<T, N>;

}  // namespace camlaw
