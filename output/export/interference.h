// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "output/export/chords.h"

/// Whether a circle that runs along one curve cuts into another: a tool into the profile that it is
/// to leave, a roller into the profile that other places of the roller need. turns_back finds what
/// happens where a circle touches; this finds what it does elsewhere.
namespace camlaw::problems {

struct Interference {
  double depth = 0;                            ///< how far the circle cuts in at most, mm
  double circle_angle = 0, profile_angle = 0;  ///< where its centre is, and what it cuts, deg
  double certain = 0;   ///< the depth is known to this, mm: no cut is deeper than depth + certain
  bool proved = false;  ///< that `certain` holds
};

/// A curve as lines that are near enough for what is told here, 5e-4 mm; made once for all that is
/// asked of it.
Chords followed(const PlaneCurve& curve);

/// A circle of a radius whose centre runs along a curve; both curves over the same angle.
Interference interference(const Chords& centre, const Chords& profile, double radius);

/// A place of a circle's centre, mm, and the angle of the cam at which it is there, deg.
struct CirclePlace {
  Eigen::Vector2d at;
  double angle;
};

/// The same of the circle that cuts deepest among several, each of whose centres runs along
/// straight lines between places: nothing is proved.
Interference interference(const std::vector<std::vector<CirclePlace>>& centres,
                          const Chords& profile, double radius);

/// How near some points come to a profile, mm, to 5e-4.
double clearance_of(const std::vector<Eigen::Vector2d>& points, const Chords& profile);

/// The distance of two curves at the same angle, mm, where that is the same all over the cycle, as
/// between a roller's centre and the profile under it; none: it is not.
std::optional<double> even_distance(const PlaneCurve& a, const PlaneCurve& b);

}  // namespace camlaw::problems
