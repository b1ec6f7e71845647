// SPDX-License-Identifier: MIT
#pragma once

#include "machines/index_drives/rib_turret.h"
#include "machines/index_drives/ruled_contact.h"
#include "numerics/scalar/extremes.h"

namespace camlaw {

/// A roller gear index drive (docs/theory.md, "Globoidal cams"): a globoidal cam turns a turret
/// whose N rollers stand out radially, its axis across the cam's at the distance a. A roller drives
/// and holds from half a pitch before the line of centres to half a pitch beyond it. Fields in SI
/// units. Valid while the roller's end does not reach the cam's axis.
template <class T>
struct GloboidalCam : RibTurret<T> {
  using RibTurret<T>::face_width, RibTurret<T>::step;

  T axis_distance = number<T>(0.120);  ///< a, m
  T turret_radius = number<T>(0.070);  ///< R_t, m, to the middle of a roller
  T roller_radius = number<T>(0.011);  ///< r_r, m

  auto conditions() const {
    return std::to_array<Condition<T>>(
        {{throat_radius(),
          "axis_distance must be above sqrt((turret_radius + face_width / 2)^2 + roller_radius^2)"},
         {distance_at(RollerPlace::Root), "turret_radius must be above face_width / 2"}});
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
