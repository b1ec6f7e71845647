// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include "output/export/plane_curve.h"

/// A barrel cam's groove: two flanks and a floor about the cam's axis (docs/theory.md, "Barrels as
/// solids"). Lengths are in mm, angles in rad about the axis, z runs along it.
namespace camlaw::problems {

/// The height z of a flank over the angle and the distance from the axis: bicubic patches with one
/// tangent plane where they meet, even in angle from 0 to a whole turn, and even in distance.
class FlankSurface {
 public:
  /// What a patch has at its corner.
  struct Corner {
    double height, by_angle, by_distance, by_both;
  };
  using Patch = std::array<std::array<double, 4>, 4>;  ///< Bernstein, the angle first

  /// Corners for each distance from the floor outwards, at each angle of a turn, the last included.
  FlankSurface(double floor, double outside, std::vector<std::vector<Corner>> corners);

  std::size_t angles() const { return corners_.front().size() - 1; }
  std::size_t distances() const { return corners_.size() - 1; }
  double angle_step() const;
  double distance_step() const;
  double floor() const { return floor_; }
  double outside() const { return outside_; }
  Patch patch(std::size_t i, std::size_t j) const;
  /// At an angle of the turn and a distance between floor and outside.
  double height(double angle, double distance) const;

 private:
  double floor_, outside_;
  std::vector<std::vector<Corner>> corners_;
};

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

/// The volume between the two flanks, the floor and the outside, mm^3.
double groove_volume(const FlankSurface& lower, const FlankSurface& upper);

}  // namespace camlaw::problems
