// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/bearing_side.h"
#include "machines/cams/roller_duty.h"
#include "machines/index_drives/index_load.h"
#include "machines/index_drives/index_parameters.h"
#include "machines/index_drives/ruled_contact.h"
#include "numerics/scalar/extremes.h"

namespace camlaw {

/// A roller gear index drive (docs/theory.md, "Globoidal cams"): a globoidal cam turns a turret
/// whose N rollers stand out radially, its axis across the cam's at the distance a. A roller drives
/// and holds from half a pitch before the line of centres to half a pitch beyond it. Fields in SI
/// units. Valid while the roller's end does not reach the cam's axis.
template <class T>
struct GloboidalCam {
  Given<T> given = {};
  T stations = given(turrets::kStations);                           ///< S, 3 or more
  T rollers = given(turrets::kRollers);                             ///< N
  T axis_distance = given(turrets::kAxisDistance.by_default(120));  ///< a, m
  T turret_radius =
      given(turrets::kTurretRadius.by_default(70));  ///< R_t, m, to the middle of a roller
  T roller_radius = given(turrets::kRollerRadius.by_default(11));  ///< r_r, m
  T angular_speed = given(turrets::kSpeed);                        ///< omega, rad/s, of the cam
  T inertia = given(turrets::kInertia);                            ///< J, kg m^2
  T friction = given(turrets::kFriction);                          ///< M_C, N m
  T load = given(turrets::kLoad);                                  ///< M_L, N m
  T face_width = given(turrets::kRollerLength);                    ///< b, m, along a roller
  T youngs_modulus = given(cams::kYoungsModulus);                  ///< E, Pa
  T poisson_ratio = given(cams::kPoissonRatio);                    ///< nu
  T bore_radius = given(cams::kBoreRadius);                        ///< r_0, m, of the cam
  T train_stiffness = given(turrets::kTrainStiffness);  ///< c_t, N m/rad, from turret to table
  T train_damping = given(cams::kTrainDamping);         ///< zeta
  T end_share = given(cams::kArmEndShare);              ///< kappa, of the inertia
  /// What each roller bears, and what lubricates it.
  RollerDuty<T> duty = RollerDuty<T>::given_by(given, turrets::kCrownRadius);

  auto conditions() const {
    return std::to_array<Condition<T>>(
        {{throat_radius(),
          "axis_distance must be above sqrt((turret_radius + face_width / 2)^2 + roller_radius^2)"},
         {distance_at(RollerPlace::Root), "turret_radius must be above face_width / 2"}});
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
  /// u, m, from the turret's axis.
  T distance_at(RollerPlace place) const {
    if (place == RollerPlace::Middle) return turret_radius;
    return turret_radius + number<T>(share_of(place)) * face_width;
  }

  /// (IX14) A = u psi', B = a - u cos psi, the distance from the cam's axis.
  template <class X>
  RuledContact<X> contact(RollerPlace place, const X& psi, const FollowerMotion<X>& f) const {
    using std::cos;
    using std::sin;
    const T u = distance_at(place);
    const X c = cos(psi), s = sin(psi);
    return {u * f.ds,  -(u * c) + axis_distance, f.ds,         -c,
            u * f.dds, u * (s * f.ds),           number<X>(0), s};
  }
  /// A point of the surface of a roller at psi, in the direction cos theta, sin theta from its path
  /// round its axis.
  template <class X>
  SpacePoint<X> surface_point(RollerPlace place, const X& psi, const std::pair<X, X>& theta) const {
    using std::cos;
    using std::sin;
    const T u = distance_at(place);
    const X c = cos(psi), s = sin(psi), along = theta.first * roller_radius;
    return {-(u * c) + axis_distance + along * s, u * s + along * c, theta.second * roller_radius};
  }
  /// (IX20) What is left between two neighbouring rollers, m, which diverge: between the edges of
  /// their ends towards the turret's axis, the rib's top. Below 0 where they overlap.
  T roller_gap() const {
    using std::cos;
    using std::sin;
    const T half = step() / number<T>(2);
    return number<T>(2) * (distance_at(RollerPlace::Root) * sin(half) - roller_radius * cos(half));
  }
  /// (IX15) Least distance of the edge of a roller's end from the cam's axis, m.
  T throat_radius() const {
    using std::sqrt;
    const T tip = distance_at(RollerPlace::Tip);
    return axis_distance - sqrt(tip * tip + roller_radius * roller_radius);
  }
  /// (IX15) Greatest distance of a roller's other edge from the cam's axis, m, at the end of its
  /// path.
  T outer_radius() const {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const T half = step() / number<T>(2), c = cos(half), s = sin(half);
    const T axis = axis_distance - distance_at(RollerPlace::Root) * c;
    const T along = lesser_of(roller_radius, T(axis * s / (c * c)));
    const T height = axis + s * along;
    return sqrt(height * height + roller_radius * roller_radius - along * along);
  }
};

}  // namespace camlaw
