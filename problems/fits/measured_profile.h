// SPDX-License-Identifier: MIT
#pragma once

#include <complex>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "kinematics/law.h"
#include "optim/fit/smoothing_spline.h"

/// From a disc cam that was measured to what its follower does (docs/theory.md, "Measured cams"):
/// the inverse of kinematics/cams. Lengths in any one unit, angles in rad.
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
  /// ends. Throws std::invalid_argument: lengths that differ, values that are no numbers, radii
  /// that are not above 0, fewer than 12 points, gaps of more than 45 deg, a profile that does not
  /// go round the centre once or that a ray from there meets twice, and what smoothing_spline
  /// throws.
  static MeasuredProfile polar(std::span<const double> theta, std::span<const double> r,
                               const optim::SmoothingOptions& smoothing = {});
  /// From points x, y about the cam's centre.
  static MeasuredProfile points(std::span<const double> x, std::span<const double> y,
                                const optim::SmoothingOptions& smoothing = {});

  ProfilePoint at(double theta) const;
  /// r(theta), with errors, outliers and all that belongs to a fit.
  const optim::SmoothingSpline& spline() const { return spline_; }

 private:
  explicit MeasuredProfile(optim::SmoothingSpline spline) : spline_(std::move(spline)) {}
  optim::SmoothingSpline spline_;
};

/// Moves along y at x = offset, above the cam: RollerCam, and KnifeCam with a radius of 0.
struct TranslatingRoller {
  double roller_radius = 0;
  double offset = 0;  ///< e, in the frame; RollerCam's for a cam that turns counterclockwise
};
/// On an arm whose pivot stands at x = pivot_distance, the roller above the x axis:
/// SwingingRollerCam counterclockwise, LeadingRollerCam clockwise.
struct SwingingRoller {
  double roller_radius = 0;
  double arm_length = 0;
  double pivot_distance = 0;
};
/// A flat face above the cam, square to its way along y: FlatCam.
struct TranslatingFace {};
/// A flat face on an arm, pivot at x = pivot_distance: SwingingFlatCam counterclockwise.
struct SwingingFace {
  double pivot_distance = 0;
  double face_offset = 0;
};
using MeasuredFollower =
    std::variant<TranslatingRoller, SwingingRoller, TranslatingFace, SwingingFace>;

/// Which way the cam turns.
enum class Rotation { Counterclockwise, Clockwise };

/// The follower at a cam angle, derivatives by the angle. Standard errors are those of the spline
/// r, carried over to first order (I8); for the derivatives the leading term.
struct MeasuredMotion {
  double phi, theta;  ///< the cam's angle, the polar angle of the contact
  double s, ds, dds;  ///< a length, or rad for an arm
  double s_error, ds_error, dds_error;
};

/// What a follower does on a measured profile.
class MeasuredLift {
 public:
  /// s is 0 at the lowest place, or, where `base_radius` is given, where the profile has that
  /// radius. Throws std::invalid_argument where the follower cannot follow: a roller that does not
  /// fit into a hollow, a flat face over a hollow, an offset beyond the pitch curve, an arm that
  /// does not reach, a pressure angle of 90 deg; the sentence says at which polar angle.
  MeasuredLift(MeasuredProfile profile, const MeasuredFollower& follower,
               Rotation rotation = Rotation::Counterclockwise,
               std::optional<double> base_radius = {});

  /// At a cam angle phi, any number of turns; phi = 0 as the cam was measured.
  MeasuredMotion at(double phi) const;
  const MeasuredProfile& profile() const { return profile_; }
  /// From the lowest place to the highest, and s at the lowest.
  double stroke() const { return highest_ - lowest_; }
  double lowest() const { return lowest_ - zero_; }

  /// The program over the cycle x = phi / (2 pi), displacement from 0 to 1 in parts of the stroke:
  /// the spline (kinematics/laws/spline.h, `table`) with s and v at even angles. Throws
  /// std::invalid_argument for fewer than 12 angles.
  Law<double> law(int angles = 720) const;

 private:
  struct State;
  State state(double theta) const;
  State roller_state(const ProfilePoint& point, double theta) const;
  State face_state(const ProfilePoint& point, double theta) const;
  void follow();
  double extreme(std::size_t at, double sign) const;

  MeasuredProfile profile_;
  MeasuredFollower follower_;
  Rotation rotation_;
  std::vector<double> thetas_, phis_;  ///< around once, phis_ continuous
  double zero_ = 0, lowest_ = 0, highest_ = 0;
};

}  // namespace camlaw::problems
