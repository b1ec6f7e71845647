// SPDX-License-Identifier: MIT
#pragma once

#include <variant>

#include "kinematics/curves/ellipse.h"
#include "kinematics/curves/half_ellipse.h"
#include "kinematics/curves/inclined_sine.h"
#include "kinematics/curves/power.h"

/// The few displacement shapes that are not polynomial plus harmonics, as functions of one
/// variable y with all derivatives. Equations: docs/theory.md, "Curves".
namespace camlaw {

template <class T>
using Curve = std::variant<HalfEllipse<T>, Ellipse<T>, InclinedSine<T>, Power<T>>;

/// The same curve in another scalar.
template <class R, class T>
Curve<R> curve_as(const Curve<T>& curve) {
  return std::visit([](const auto& shape) -> Curve<R> { return shape.template as<R>(); }, curve);
}

}  // namespace camlaw
