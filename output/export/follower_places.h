// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "problems/statement/statement.h"

/// Where followers stand that have no pitch curve, in the axes of docs/theory.md, "Cams": the cam's
/// centre at the origin. Lengths in mm; a displacement in its listed unit.
namespace camlaw::problems {

/// The rollers of a conjugate pair: the main one at (e, sqrt((r_b + r_r)^2 - e^2) + s), the second
/// one the roller distance D below it.
struct RollerPair {
  Eigen::Vector2d main, second;
};
RollerPair conjugate_rollers(const ProblemStatement& design, double displacement);

/// A straight face: its points are foot + t along, the unit vector.
struct FaceLine {
  Eigen::Vector2d foot, along;
};
/// The face of a follower that slides: y = r_b + s; t is the contact offset (M11).
FaceLine sliding_face(const ProblemStatement& design, double displacement);
/// The face on an arm: its foot is d - i f exp(-i psi), with the pivot at (d, 0) and
/// sin psi_0 = (r_b + f) / d; t is the contact lever (M20).
FaceLine swinging_face(const ProblemStatement& design, double displacement);

/// The middle of a balancing cam's roller: (0, r_b + r_r + s).
Eigen::Vector2d balancing_roller(const ProblemStatement& design, double displacement);

}  // namespace camlaw::problems
