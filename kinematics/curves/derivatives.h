// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "kinematics/scalar.h"

namespace camlaw {

/// Derivatives that a curve can give, its value included.
inline constexpr std::size_t kCurveOrders = 12;

template <class T>
using CurveDerivatives = std::array<T, kCurveOrders>;

}  // namespace camlaw
