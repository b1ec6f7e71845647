// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <numbers>
#include <vector>

#include "numerics/scalar/interval.h"

/// The surface that stands for a flank of a barrel's groove (docs/theory.md, "Solids of barrel
/// cams"). Lengths are in mm, angles in rad about the cam's axis, z runs along it.
namespace camlaw::problems {

inline constexpr double kWholeTurn = 2 * std::numbers::pi;  ///< rad

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

/// Bounds of a patch's slopes over a rectangle of its shares, from 0 to 1, by those in its middle.
struct PatchSlopes {
  Interval by_first, by_second;
};
PatchSlopes slopes_over(const FlankSurface::Patch& patch, const Interval& first,
                        const Interval& second);

/// The volume between the two flanks, the floor and the outside, mm^3.
double groove_volume(const FlankSurface& lower, const FlankSurface& upper);

}  // namespace camlaw::problems
