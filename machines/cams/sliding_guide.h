// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "numerics/scalar/by_side.h"

namespace camlaw {

/// The guide of a translating follower and the friction in it, as a share q of the force along the
/// way, signed as the velocity (docs/theory.md, "Friction in the guide"). Fields in SI units.
template <class T>
struct SlidingGuide {
  T friction;  ///< mu
  T length;    ///< l_g, m

  /// (M37) From a force across the way, tan alpha times that along it, at so far before the guide:
  /// |tan alpha| mu (2 a + l_g) / l_g. Of tan alpha the size with the velocity's sign.
  template <class X>
  X share_across(const X& overhang, const X& tangent) const {
    return friction * (number<T>(2) * (overhang / length) + number<T>(1)) * tangent;
  }
  /// (M42) From a force along the way, at so far beside the guide's middle: 2 mu |x| / l_g. Of x
  /// the size with the velocity's sign.
  template <class X>
  X share_beside(const X& distance) const {
    return number<T>(2) * friction / length * distance;
  }
  /// (M38) The fraction of the force along the way that friction takes: q where F is 0 or above,
  /// and -q below, of what bears then. At 1 the follower jams; below 0 friction helps the cam.
  template <class X>
  static X taken(const X& force, const X& pushing, const X& pulling) {
    return by_side(force, pushing, X(-pulling));
  }
  /// (M38) The force along the way with friction that takes so much of it, N: F / (1 - taken). NaN
  /// where the follower jams.
  template <class X>
  static X driving_force(const X& force, const X& taken) {
    using std::sqrt;
    const X root = sqrt(number<X>(1) - taken);
    return force / (root * root);  // a root of what is below 0 is not a number
  }
};

}  // namespace camlaw
