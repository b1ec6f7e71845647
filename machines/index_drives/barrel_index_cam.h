// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/bearing_side.h"
#include "machines/cams/roller_duty.h"
#include "machines/index_drives/index_load.h"
#include "machines/index_drives/index_parameters.h"
#include "machines/index_drives/ruled_contact.h"
#include "numerics/formula/expression.h"

namespace camlaw {

/// A barrel index drive (docs/theory.md, "Barrel index cams"): a barrel cam turns a turret whose N
/// rollers are parallel to the turret's axis, which lies across the cam's at the distance a. A
/// roller drives and holds from half a pitch before the line of centres to half a pitch beyond it.
/// Fields in SI units. Valid while the roller's end does not reach the plane of the cam's axis, and
/// a roller's pitch is less than half a turn.
struct BarrelIndexCam {
  Given given = {};
  Expression stations = given(turrets::kStations);           ///< S, 3 or more
  Expression rollers = given(turrets::kRollers);             ///< N
  Expression axis_distance = given(turrets::kAxisDistance);  ///< a, m
  Expression turret_radius =
      given(turrets::kTurretRadius);  ///< R_t, m, of the circle of the rollers' axes
  Expression cam_radius = given({"cam_radius", "R_c", "mm", "m",
                                 "radius of the cam at the middle of a roller", 60, 1e-3, 1e5});
  Expression roller_radius = given(turrets::kRollerRadius);  ///< r_r, m
  Expression angular_speed = given(turrets::kSpeed);         ///< omega, rad/s, of the cam
  Expression inertia = given(turrets::kInertia);             ///< J, kg m^2
  Expression friction = given(turrets::kFriction);           ///< M_C, N m
  Expression load = given(turrets::kLoad);                   ///< M_L, N m
  Expression face_width = given(turrets::kRollerLength);     ///< b, m, along a roller
  Expression youngs_modulus = given(cams::kYoungsModulus);   ///< E, Pa
  Expression poisson_ratio = given(cams::kPoissonRatio);     ///< nu
  Expression bore_radius = given(cams::kBoreRadius);         ///< r_0, m, of the cam
  Expression train_stiffness =
      given(turrets::kTrainStiffness);                    ///< c_t, N m/rad, from turret to table
  Expression train_damping = given(cams::kTrainDamping);  ///< zeta
  Expression end_share = given(cams::kArmEndShare);       ///< kappa, of the inertia
  /// What each roller bears, and what lubricates it.
  RollerDuty duty = RollerDuty::given_by(given, turrets::kCrownRadius);

  auto conditions() const {
    return std::to_array<Condition>(
        {{distance_at(RollerPlace::Tip), "cam_radius must be above face_width / 2"},
         {rollers - 2, "rollers must be 3 or more"}});
  }
  /// delta, rad: what the turret turns by while a roller drives.
  Expression step() const { return 2 * pi() / rollers; }
  IndexLoad follower() const { return {inertia, friction, load, angular_speed}; }
  /// Rollers that share a turn of the turret.
  const Expression& all_rollers() const { return rollers; }

  FollowerMotion over_angle(const Motion<Expression>& motion) const {
    return follower_over_angle(station_angle(stations), motion);
  }
  /// Lever of the force on a roller, m.
  Expression lever() const { return turret_radius; }
  /// x, m: height over the plane through the cam's axis that the rollers stand on.
  Expression distance_at(RollerPlace place) const {
    if (place == RollerPlace::Middle) return cam_radius;
    return cam_radius - Expression(share_of(place)) * face_width;
  }

  /// (IX16) A = R_t psi' - x sin psi, B = x cos psi.
  RuledContact contact(RollerPlace place, const Expression& psi, const FollowerMotion& f) const {
    const Expression x = distance_at(place);
    const Expression c = cos(psi), s = sin(psi);
    return {turret_radius * f.ds - x * s,
            x * c,
            -s,
            c,
            turret_radius * f.dds - x * (c * f.ds),
            -(x * (s * f.ds)),
            -(turret_radius * c) + axis_distance,
            -f.ds};
  }
  /// A point of the surface of a roller at psi, in the direction cos theta, sin theta from its path
  /// round its axis.
  SpacePoint surface_point(RollerPlace place, const Expression& psi,
                           const std::pair<Expression, Expression>& theta) const {
    const Expression c = cos(psi), s = sin(psi);
    const Expression along = theta.first * roller_radius, across = theta.second * roller_radius;
    return {distance_at(place), s * turret_radius + along * c + across * s,
            c * turret_radius - axis_distance - along * s + across * c};
  }
  /// What is left between two neighbouring rollers, m: the rib between them.
  Expression roller_gap() const { return 2 * (turret_radius * sin(step() / 2) - roller_radius); }
  /// (IX17) Radius of the cam's core below the rollers' ends, m.
  Expression throat_radius() const { return distance_at(RollerPlace::Tip); }
  /// (IX17) Greatest distance of a roller's other edge from the cam's axis, m: on the line of
  /// centres, or half a pitch before it.
  Expression outer_radius() const {
    const Expression height = distance_at(RollerPlace::Root);
    const Expression near = turret_radius - axis_distance + roller_radius;
    const Expression far = axis_distance - turret_radius * cos(step() / 2) + roller_radius;
    const Expression side = greater_of(near, far);
    return sqrt(height * height + side * side);
  }
};

}  // namespace camlaw
