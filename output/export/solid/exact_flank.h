// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <numbers>

#include "output/export/plane_curve.h"
#include "output/export/solid/barrel_flank.h"
#include "output/export/solid/flank_surface.h"

namespace camlaw::problems {

/// One flank of the groove that a roller cuts whose centre runs along the pitch curve, developed;
/// by the roller's angle, which places of the curve, in deg, are counted from its begin.
class ExactFlank {
 public:
  /// `side` is 1 for the upper flank and -1 for the lower one. Keeps the curve.
  ExactFlank(const PlaneCurve& pitch, double roller_radius, double side)
      : pitch_(pitch), roller_radius_(roller_radius), side_(side) {}

  const PlaneCurve& pitch() const { return pitch_; }

  FlankContact<double> contact(double rise, double distance) const {
    return {roller_radius_, side_, rise, distance};
  }
  FlankContact<Interval> contact(const Interval& rise, const Interval& distance) const {
    return {roller_radius_, side_, rise, distance};
  }

  /// Height of the roller's centre, its derivative and its second by the angle, rad, of any turn.
  std::array<double, 3> centre(double angle) const;
  /// The roller's angle when it touches the flank at an angle and a distance.
  double roller_angle(double angle, double distance) const;
  /// What a surface has in common with the flank there.
  FlankSurface::Corner corner(double angle, double distance) const;

  static constexpr double kPerRad = 180 / std::numbers::pi;  ///< of the pitch curve's places

 private:
  const PlaneCurve& pitch_;
  double roller_radius_, side_;
};

}  // namespace camlaw::problems
