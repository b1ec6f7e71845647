// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>

#include "output/export/plane_curve.h"
#include "output/export/solid/flank_surface.h"

/// A barrel cam's groove: two flanks and a floor about the cam's axis (docs/theory.md, "Solids of
/// barrel cams"). Lengths are in mm, angles in rad about the axis, z runs along it.
namespace camlaw::problems {

/// How far a flank is from the surface that stands for it at most.
struct ExportedFlank {
  std::string name;  ///< "upper flank"
  FlankSurface surface;
  double worst = 0;
  bool proved = false;
};

struct BarrelSize {
  double roller_radius;
  double floor, outside;  ///< distances of the groove's floor and of the barrel from the axis
};

/// The lower and the upper flank of the groove of a roller whose centre runs along the pitch curve,
/// developed: each within a tolerance, mm. Throws std::invalid_argument where the curve does not
/// end as it begins, jumps, or makes a flank turn back, where the roller reaches the axis, and for
/// a tolerance that is too fine.
std::array<ExportedFlank, 2> barrel_flanks(const PlaneCurve& pitch, const BarrelSize& size,
                                           double tolerance);

}  // namespace camlaw::problems
