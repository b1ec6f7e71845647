// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "numerics/spline/smoothing_spline.h"

/// From a disc cam that was measured to what its follower does (docs/theory.md, "Measured cams"):
/// the inverse of machines/cams. Lengths in any one unit, angles in rad.
namespace camlaw::problems {

/// A point of the profile, as it lies on the cam at angle 0, by its polar angle.
struct ProfilePoint {
  std::complex<double> place;    ///< p = r exp(i theta)
  std::complex<double> tangent;  ///< unit, counterclockwise round the cam
  std::complex<double> normal;   ///< unit, outwards
  double curvature;              ///< (I2), positive where the cam is convex
  double speed;                  ///< |dp / dtheta|
};

/// A closed profile: the periodic smoothing spline r(theta) through measured points.
class MeasuredProfile {
 public:
  /// From polar coordinates about the cam's centre, either way round, in order, at any spacing; the
  /// first point may come again at the end. `smoothing` is taken but for its range, period and
  /// ends. Throws std::invalid_argument: lengths that differ, values that are not numbers, radii
  /// that are not above 0, fewer than 12 points, gaps of more than 45 deg, a profile that does not
  /// go round the centre once or that a ray from there meets twice, and what smoothing_spline
  /// throws.
  static MeasuredProfile polar(std::span<const double> theta, std::span<const double> r,
                               const optim::SmoothingOptions& smoothing = {});

  ProfilePoint at(double theta) const;
  /// r(theta), with errors, outliers and all that belongs to a fit.
  const optim::SmoothingSpline& spline() const { return spline_; }
  /// Where the points were measured, in the order given, 0 to 2 pi.
  const std::vector<double>& polar_angles() const { return thetas_; }

 private:
  MeasuredProfile(std::vector<double> thetas, optim::SmoothingSpline spline)
      : thetas_(std::move(thetas)), spline_(std::move(spline)) {}
  std::vector<double> thetas_;
  optim::SmoothingSpline spline_;
};

}  // namespace camlaw::problems
