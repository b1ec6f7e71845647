// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>

#include "machines/cams/cam_motion.h"
#include "machines/cams/cam_parameters.h"
#include "machines/cams/roller_contact.h"
#include "machines/cams/roller_duty.h"
#include "machines/model/possibility.h"

namespace camlaw {

/// An end (face) or barrel cam with a roller on an arm that swings about an axis square to the
/// cam's (docs/theory.md, "Arm on an end cam"), developed at the mean radius R of the roller's
/// track. eta is the angle of the arm, of length l, to the track's circumference: beta - Psi / 2 at
/// the lowest place, beta - Psi / 2 + Psi s at displacement s. With the tilt beta = 0 the arm is
/// square to the cam's axis at mid-swing. Fields in SI units.
/// The cam turns so that its surface runs under the arm away from the pivot (a trailing arm).
///
/// Valid while eta stays between plus and minus a right angle. The developed track is exact for
/// a plate; on the cylinder it takes x / R for the angle asin(x / R) at the distance x from the
/// plane through the axis square to the arm's, and asks of the roller the depth x^2 / (2 R).
struct OscillatingEndCam {
  Given given = {};
  Expression swing = given(cams::kSwing);           ///< Psi, rad
  Expression radius = given(cams::kTrackRadius);    ///< R, m, of the middle of the roller's track
  Expression arm_length = given(cams::kArmLength);  ///< l, m
  Expression tilt =
      given({"tilt", "beta", "deg", "rad",
             "angle between the arm at mid-swing and the circumferential direction; at 0 the "
             "arm is square to the cam's axis",
             0, -89, 89});
  Expression roller_radius = given(cams::kRollerRadius);  ///< r_r, m
  Expression angular_speed = given(cams::kSpeed);         ///< omega, rad/s
  Expression inertia = given(cams::kInertia);             ///< J, kg m^2, of all that swings
  Expression spring_rate = given(cams::kArmSpringRate.by_default(0));        ///< c, N m/rad
  Expression spring_preload = given(cams::kArmSpringPreload.by_default(0));  ///< M_0, N m
  Expression load = given(cams::kArmLoad);                                   ///< M_L, N m
  Expression face_width = given(cams::kFaceWidth);                           ///< b, m
  Expression youngs_modulus = given(cams::kYoungsModulus);                   ///< E, Pa
  Expression poisson_ratio = given(cams::kPoissonRatio);                     ///< nu
  Expression cutter_radius = given(cams::kCutterRadius);                     ///< r_c, m
  Expression train_stiffness = given(cams::kArmTrainStiffness);              ///< c_t, N m/rad
  Expression train_damping = given(cams::kTrainDamping);                     ///< zeta
  Expression end_share = given(cams::kArmEndShare);  ///< kappa, of what moves
  RollerDuty duty = RollerDuty::given_by(given);

  auto conditions() const {
    const Expression half = swing / 2, right = pi() / 2;
    return std::to_array<Condition>(
        {{radius, "radius must be above 0"},
         {arm_length, "arm_length must be above 0"},
         {right + tilt - half, "tilt - swing / 2 must be above -90 deg"},
         {right - tilt - half, "tilt + swing / 2 must be below 90 deg"}});
  }
  Expression lowest_angle() const { return tilt - swing / 2; }
  /// What swings counts as what slides: J for m, torques for forces.
  FollowerLoad follower() const {
    return {inertia, spring_rate, spring_preload, load, angular_speed};
  }
  RollerContact roller() const {
    return {roller_radius, cutter_radius, face_width, {youngs_modulus, poisson_ratio}};
  }

  FollowerMotion over_angle(const Motion<Expression>& motion) const {
    return follower_over_angle(swing, motion);
  }
  /// (M23) The roller's centre from the pivot, x along the circumference: with
  /// E = l exp(-i eta), w = -E, w1 = R + i eta' E, w2 = (eta'^2 + i eta'') E.
  CamCurve pitch_curve(const FollowerMotion& f) const {
    const Expression eta = f.s + lowest_angle(), square = f.ds * f.ds;
    const Expression c = arm_length * cos(eta), s = arm_length * sin(eta);
    return {-c, s, f.ds * s + radius, f.ds * c, square * c + f.dds * s, f.dds * c - square * s};
  }
  /// A point of a curve on the cam, developed: x along the circumference.
  std::pair<Expression, Expression> placed(const CamPoint& p, const Expression& phi) const {
    return {p.x + radius * phi, p.y};
  }
  /// (M24) Pressure angle, rad: tan alpha = tan eta + l eta' / (R cos eta).
  Expression pressure_angle(const FollowerMotion& f) const {
    const Expression eta = f.s + lowest_angle();
    return atan((sin(eta) + arm_length / radius * f.ds) / cos(eta));
  }
  /// (M25) Force between roller and cam, N, signed as the torque: N = M / (l cos alpha).
  Expression contact_force(const FollowerMotion& f) const {
    return follower().force(f) / (arm_length * cos(pressure_angle(f)));
  }
  /// About the roller's axis the arm turns alone, by eta' (RB1).
  Expression turning(const FollowerMotion& f) const { return f.ds; }
};

}  // namespace camlaw
