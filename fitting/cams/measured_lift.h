// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "fitting/cams/measured_profile.h"
#include "kinematics/law.h"

/// What a follower does on a measured cam (docs/theory.md, "Measured cams"). Lengths in the
/// profile's unit, angles in rad.
namespace camlaw::problems {

/// Moves along y at x = offset, above the cam: RollerCam, and KnifeEdgeCam with a radius of 0.
struct TranslatingRoller {
  double roller_radius = 0;
  double offset = 0;  ///< e, in the frame; RollerCam's for a cam that turns counterclockwise
};
/// On an arm whose pivot stands at x = pivot_distance, the roller above the x axis:
/// OscillatingRollerCam counterclockwise, LeadingRollerCam clockwise.
struct OscillatingRoller {
  double roller_radius = 0;
  double arm_length = 0;
  double pivot_distance = 0;
};
/// A flat face above the cam, square to its way along y: FlatCam.
struct TranslatingFace {};
/// A flat face on an arm, pivot at x = pivot_distance: OscillatingFlatCam counterclockwise.
struct OscillatingFace {
  double pivot_distance = 0;
  double face_offset = 0;
};
using MeasuredFollower =
    std::variant<TranslatingRoller, OscillatingRoller, TranslatingFace, OscillatingFace>;

/// Which way the cam turns.
enum class Rotation { Counterclockwise, Clockwise };

/// The follower at a cam angle, derivatives by the angle. Standard errors are those of the spline
/// r, carried over to first order (I8); for the derivatives the leading term.
struct MeasuredMotion {
  double phi, theta;  ///< the cam's angle, the polar angle of the contact
  double s, ds, dds;  ///< a length, or rad for an arm
  double s_error, ds_error, dds_error;
};

/// A measured point as the follower shows it.
struct LiftSample {
  double phi;       ///< the cam's angle while the follower touches there, 0 to 2 pi
  double s;         ///< the lift, with the point's own distance from the smooth profile
  double distance;  ///< of the point from the smooth profile, outwards
  bool outlying;    ///< beyond what chance explains (docs/theory.md, (O8))
  double share;     ///< of an error of the point's radius that the lift has (I8)
  double follows;   ///< of a shift of the profile along its normal that the follower makes
  std::complex<double> normal;  ///< of the profile there, as it lies on the cam at angle 0
};

/// What a follower does on a measured profile.
class MeasuredLift {
 public:
  /// s is 0 at the lowest place, or, where `base_radius` is given, where the profile has that
  /// radius. Impossible where the follower cannot follow: a roller that does not fit into a hollow,
  /// a flat face over a hollow, an offset beyond the pitch curve, an arm that does not reach, a
  /// pressure angle of 90 deg; the sentence says at which polar angle.
  static Possible<MeasuredLift> possible(MeasuredProfile profile, const MeasuredFollower& follower,
                                         Rotation rotation = Rotation::Counterclockwise,
                                         std::optional<double> base_radius = {});
  /// The same; throws std::invalid_argument where it is impossible.
  MeasuredLift(MeasuredProfile profile, const MeasuredFollower& follower,
               Rotation rotation = Rotation::Counterclockwise,
               std::optional<double> base_radius = {});

  /// At a cam angle phi, any number of turns; phi = 0 as the cam was measured.
  MeasuredMotion at(double phi) const;
  /// What each point says of the lift: to first order in its distance from the smooth profile, so
  /// that errors that are independent in the points are so in the lift. Impossible where the
  /// follower cannot follow at a point.
  Possible<std::vector<LiftSample>> possible_samples() const;
  /// The same; throws std::invalid_argument where it is impossible.
  std::vector<LiftSample> samples() const;
  /// The radius of the circle about the cam's centre on which the follower stands at the lift s.
  double base_radius(double s) const;
  /// The follower's own coordinate at the lift s: of an arm the angle psi of (I3).
  double coordinate(double s) const { return zero_ + s; }
  const MeasuredProfile& profile() const { return profile_; }
  const MeasuredFollower& follower() const { return follower_; }
  Rotation rotation() const { return rotation_; }
  /// From the lowest place to the highest, and s at the lowest.
  double stroke() const { return highest_ - lowest_; }
  double lowest() const { return lowest_ - zero_; }

  /// The program over the cycle x = phi / (2 pi), displacement from 0 to 1 in parts of the stroke:
  /// the spline (kinematics/laws/spline.h, `table`) with s and v at even angles. Throws
  /// std::invalid_argument for fewer than 12 angles.
  Law<double> law(int angles = 720) const;

 private:
  struct Unfollowed {};
  MeasuredLift(Unfollowed, MeasuredProfile profile, const MeasuredFollower& follower,
               Rotation rotation)
      : profile_(std::move(profile)), follower_(follower), rotation_(rotation) {}
  /// Goes round once; says why where the follower cannot.
  std::optional<Impossible> follow(std::optional<double> base_radius);

  MeasuredProfile profile_;
  MeasuredFollower follower_;
  Rotation rotation_;
  std::vector<double> thetas_, phis_;  ///< around once, phis_ continuous
  double zero_ = 0, lowest_ = 0, highest_ = 0;
};

}  // namespace camlaw::problems
