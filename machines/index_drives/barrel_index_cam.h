// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/bearing_side.h"
#include "machines/cams/roller_duty.h"
#include "machines/index_drives/index_load.h"
#include "machines/index_drives/index_parameters.h"
#include "machines/index_drives/ruled_contact.h"
#include "numerics/scalar/extremes.h"

namespace camlaw {

/// A barrel index drive (docs/theory.md, "Barrel index cams"): a barrel cam turns a turret whose N
/// rollers are parallel to the turret's axis, which lies across the cam's at the distance a. A
/// roller drives and holds from half a pitch before the line of centres to half a pitch beyond it.
/// Fields in SI units. Valid while the roller's end does not reach the plane of the cam's axis, and
/// a roller's pitch is less than half a turn.
template <class T>
struct BarrelIndexCam {
  Given<T> given = {};
  T stations = given(turrets::kStations);           ///< S, 3 or more
  T rollers = given(turrets::kRollers);             ///< N
  T axis_distance = given(turrets::kAxisDistance);  ///< a, m
  T turret_radius = given(turrets::kTurretRadius);  ///< R_t, m, of the circle of the rollers' axes
  T cam_radius = given({"cam_radius", "R_c", "mm", "m",
                        "radius of the cam at the middle of a roller", 60, 1e-3, 1e5});
  T roller_radius = given(turrets::kRollerRadius);      ///< r_r, m
  T angular_speed = given(turrets::kSpeed);             ///< omega, rad/s, of the cam
  T inertia = given(turrets::kInertia);                 ///< J, kg m^2
  T friction = given(turrets::kFriction);               ///< M_C, N m
  T load = given(turrets::kLoad);                       ///< M_L, N m
  T face_width = given(turrets::kRollerLength);         ///< b, m, along a roller
  T youngs_modulus = given(cams::kYoungsModulus);       ///< E, Pa
  T poisson_ratio = given(cams::kPoissonRatio);         ///< nu
  T bore_radius = given(cams::kBoreRadius);             ///< r_0, m, of the cam
  T train_stiffness = given(turrets::kTrainStiffness);  ///< c_t, N m/rad, from turret to table
  T train_damping = given(cams::kTrainDamping);         ///< zeta
  T end_share = given(cams::kArmEndShare);              ///< kappa, of the inertia
  /// What each roller bears, and what lubricates it.
  RollerDuty<T> duty = RollerDuty<T>::given_by(given, turrets::kCrownRadius);

  auto conditions() const {
    return std::to_array<Condition<T>>(
        {{distance_at(RollerPlace::Tip), "cam_radius must be above face_width / 2"},
         {rollers - number<T>(2), "rollers must be 3 or more"}});
  }
  /// delta, rad: what the turret turns by while a roller drives.
  T step() const { return number<T>(2) * pi<T>() / rollers; }
  IndexLoad<T> follower() const { return {inertia, friction, load, angular_speed}; }
  /// Rollers that share a turn of the turret.
  const T& all_rollers() const { return rollers; }

  template <class X>
  FollowerMotion<X> over_angle(const Motion<X>& motion) const {
    return follower_over_angle(station_angle(stations), motion);
  }
  /// Lever of the force on a roller, m.
  T lever() const { return turret_radius; }
  /// x, m: height over the plane through the cam's axis that the rollers stand on.
  T distance_at(RollerPlace place) const {
    if (place == RollerPlace::Middle) return cam_radius;
    return cam_radius - number<T>(share_of(place)) * face_width;
  }

  /// (IX16) A = R_t psi' - x sin psi, B = x cos psi.
  template <class X>
  RuledContact<X> contact(RollerPlace place, const X& psi, const FollowerMotion<X>& f) const {
    using std::cos;
    using std::sin;
    const T x = distance_at(place);
    const X c = cos(psi), s = sin(psi);
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
  template <class X>
  SpacePoint<X> surface_point(RollerPlace place, const X& psi, const std::pair<X, X>& theta) const {
    using std::cos;
    using std::sin;
    const X c = cos(psi), s = sin(psi);
    const X along = theta.first * roller_radius, across = theta.second * roller_radius;
    return {X(distance_at(place)), s * turret_radius + along * c + across * s,
            c * turret_radius - axis_distance - along * s + across * c};
  }
  /// What is left between two neighbouring rollers, m: the rib between them.
  T roller_gap() const {
    using std::sin;
    return number<T>(2) * (turret_radius * sin(step() / number<T>(2)) - roller_radius);
  }
  /// (IX17) Radius of the cam's core below the rollers' ends, m.
  T throat_radius() const { return distance_at(RollerPlace::Tip); }
  /// (IX17) Greatest distance of a roller's other edge from the cam's axis, m: on the line of
  /// centres, or half a pitch before it.
  T outer_radius() const {
    using std::cos;
    using std::sqrt;
    const T height = distance_at(RollerPlace::Root);
    const T near = turret_radius - axis_distance + roller_radius;
    const T far = axis_distance - turret_radius * cos(step() / number<T>(2)) + roller_radius;
    const T side = greater_of(near, far);
    return sqrt(height * height + side * side);
  }
};

}  // namespace camlaw
