// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "optim/problem/curve.h"

namespace camlaw::optim {

/// A curve that can tell how the places at which its formula jumps move with the design.
class MovingJumps {
 public:
  virtual ~MovingJumps() = default;
  /// Of a break of trace(x) at which the formula jumps: the derivative of its angle by each
  /// variable. Empty of any other place, and where it is not known. What Curve::at() gives stays at
  /// the angle.
  virtual std::vector<double> jump_motion(Place place, Design x) const = 0;
};

/// The same of any curve.
inline std::vector<double> jump_motion(const Curve& curve, Place place, Design x) {
  const auto* moving = dynamic_cast<const MovingJumps*>(&curve);
  return moving == nullptr ? std::vector<double>() : moving->jump_motion(place, x);
}

}  // namespace camlaw::optim
