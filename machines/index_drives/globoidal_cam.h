// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/bearing_side.h"
#include "machines/cams/roller_duty.h"
#include "machines/index_drives/index_load.h"
#include "machines/index_drives/index_parameters.h"
#include "machines/index_drives/ruled_contact.h"
#include "numerics/formula/expression.h"

namespace camlaw {

/// A roller gear index drive (docs/theory.md, "Globoidal cams"): a globoidal cam turns a turret
/// whose N rollers stand out radially, its axis across the cam's at the distance a. A roller drives
/// and holds from half a pitch before the line of centres to half a pitch beyond it. Fields in SI
/// units. Valid while the roller's end does not reach the cam's axis.
struct GloboidalCam {
  Given given = {};
  Expression stations = given(turrets::kStations);                           ///< S, 3 or more
  Expression rollers = given(turrets::kRollers);                             ///< N
  Expression axis_distance = given(turrets::kAxisDistance.by_default(120));  ///< a, m
  Expression turret_radius =
      given(turrets::kTurretRadius.by_default(70));  ///< R_t, m, to the middle of a roller
  Expression roller_radius = given(turrets::kRollerRadius.by_default(11));  ///< r_r, m
  Expression angular_speed = given(turrets::kSpeed);        ///< omega, rad/s, of the cam
  Expression inertia = given(turrets::kInertia);            ///< J, kg m^2
  Expression friction = given(turrets::kFriction);          ///< M_C, N m
  Expression load = given(turrets::kLoad);                  ///< M_L, N m
  Expression face_width = given(turrets::kRollerLength);    ///< b, m, along a roller
  Expression youngs_modulus = given(cams::kYoungsModulus);  ///< E, Pa
  Expression poisson_ratio = given(cams::kPoissonRatio);    ///< nu
  Expression bore_radius = given(cams::kBoreRadius);        ///< r_0, m, of the cam
  Expression train_stiffness =
      given(turrets::kTrainStiffness);                    ///< c_t, N m/rad, from turret to table
  Expression train_damping = given(cams::kTrainDamping);  ///< zeta
  Expression end_share = given(cams::kArmEndShare);       ///< kappa, of the inertia
  /// What each roller bears, and what lubricates it.
  RollerDuty duty = RollerDuty::given_by(given, turrets::kCrownRadius);

  auto conditions() const {
    return std::to_array<Condition>(
        {{throat_radius(),
          "axis_distance must be above sqrt((turret_radius + face_width / 2)^2 + roller_radius^2)"},
         {distance_at(RollerPlace::Root), "turret_radius must be above face_width / 2"}});
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
  /// u, m, from the turret's axis.
  Expression distance_at(RollerPlace place) const {
    if (place == RollerPlace::Middle) return turret_radius;
    return turret_radius + Expression(share_of(place)) * face_width;
  }

  /// (IX14) A = u psi', B = a - u cos psi, the distance from the cam's axis.
  RuledContact contact(RollerPlace place, const Expression& psi, const FollowerMotion& f) const {
    const Expression u = distance_at(place);
    const Expression c = cos(psi), s = sin(psi);
    return {u * f.ds, -(u * c) + axis_distance, f.ds, -c, u * f.dds, u * (s * f.ds), 0, s};
  }
  /// A point of the surface of a roller at psi, in the direction cos theta, sin theta from its path
  /// round its axis.
  SpacePoint surface_point(RollerPlace place, const Expression& psi,
                           const std::pair<Expression, Expression>& theta) const {
    const Expression u = distance_at(place);
    const Expression c = cos(psi), s = sin(psi), along = theta.first * roller_radius;
    return {-(u * c) + axis_distance + along * s, u * s + along * c, theta.second * roller_radius};
  }
  /// (IX20) What is left between two neighbouring rollers, m, which diverge: between the edges of
  /// their ends towards the turret's axis, the rib's top. Below 0 where they overlap.
  Expression roller_gap() const {
    const Expression half = step() / 2;
    return 2 * (distance_at(RollerPlace::Root) * sin(half) - roller_radius * cos(half));
  }
  /// (IX15) Least distance of the edge of a roller's end from the cam's axis, m.
  Expression throat_radius() const {
    const Expression tip = distance_at(RollerPlace::Tip);
    return axis_distance - sqrt(tip * tip + roller_radius * roller_radius);
  }
  /// (IX15) Greatest distance of a roller's other edge from the cam's axis, m, at the end of its
  /// path.
  Expression outer_radius() const {
    const Expression half = step() / 2, c = cos(half), s = sin(half);
    const Expression axis = axis_distance - distance_at(RollerPlace::Root) * c;
    const Expression along = lesser_of(roller_radius, axis * s / (c * c));
    const Expression height = axis + s * along;
    return sqrt(height * height + roller_radius * roller_radius - along * along);
  }
};

}  // namespace camlaw
