// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "output/export/motion.h"
#include "output/export/plane_curve.h"

/// Where a cam stands on the shaft that it shares with others (docs/theory.md, "Several cams on one
/// shaft"). Angles in deg, lengths in mm.
namespace camlaw::problems {

struct ShaftPlace {
  std::string cam;
  double phase = 0;  ///< the shaft's angle at which the cam's own zero stands
  /// What is placed by the shaft - a keyway, the master of a table - begins at the shaft's zero, so
  /// that the cams of the shaft work together; else at the cam's own.
  bool from_shaft = true;
};

/// Where the frame's y axis, along which the followers of all discs move at their cams' zeros,
/// stands in a cam's own axes when the shaft is at its zero: 90 deg - phase of a profile that runs
/// counterclockwise, else 90 deg + phase (SH9); counterclockwise from x, 0 .. 360 deg.
double shaft_zero_direction(const PlaneCurve& profile, double phase);
/// The same as a vector of length 1.
Eigen::Vector2d shaft_zero_axis(const PlaneCurve& profile, double phase);
/// Of a cam that is developed, x of the place under the frame's x = 0 when the shaft is at its
/// zero, within the cycle that is drawn.
double shaft_zero_along(const PlaneCurve& profile, double phase);

/// "the cam's zero lies at shaft angle 4.574 deg".
std::string phase_words(const ShaftPlace& place);

/// Whether a motion runs over the turn of the cam, so that it can be told by the shaft's angle.
bool turns_with_shaft(const ExportedMotion& motion);
/// The motion by the shaft's angle theta, s(theta - phase), from 0 to 360 deg (SH1). One that goes
/// on after the cycle from where it ends (`advances`) does so here: it begins with the rest of the
/// cycle before. Nothing but the name of its master changes where it does not run over the turn.
ExportedMotion by_shaft(const ExportedMotion& motion, double phase, bool advances);

}  // namespace camlaw::problems
