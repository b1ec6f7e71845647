// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "numerics/formula/expression.h"

namespace camlaw {

/// The guide of a translating follower and the friction in it, as a share q of the force along the
/// way, signed as the velocity (docs/theory.md, "Friction in the guide"). Fields in SI units.
struct SlidingGuide {
  Expression friction;  ///< mu
  Expression length;    ///< l_g, m

  /// (M37) From a force across the way, tan alpha times that along it, at so far before the guide:
  /// |tan alpha| mu (2 a + l_g) / l_g. Of tan alpha the size with the velocity's sign.
  Expression share_across(const Expression& overhang, const Expression& tangent) const {
    return friction * (2 * (overhang / length) + 1) * tangent;
  }
  /// (M42) From a force along the way, at so far beside the guide's middle: 2 mu |x| / l_g. Of x
  /// the size with the velocity's sign.
  Expression share_beside(const Expression& distance) const {
    return 2 * friction / length * distance;
  }
  /// (M38) The fraction of the force along the way that friction takes: q where F is 0 or above,
  /// and -q below, of what bears then. At 1 the follower jams; below 0 friction helps the cam.
  static Expression taken(const Expression& force, const Expression& pushing,
                          const Expression& pulling) {
    return by_side(force, pushing, -pulling);
  }
  /// (M38) The force along the way with friction that takes so much of it, N: F / (1 - taken). NaN
  /// where the follower jams.
  static Expression driving_force(const Expression& force, const Expression& taken) {
    const Expression root = sqrt(1 - taken);
    return force / (root * root);  // a root of what is below 0 is not a number
  }
};

}  // namespace camlaw
