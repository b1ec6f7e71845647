// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/bearing_side.h"
#include "machines/index_drives/index_load.h"

namespace camlaw {

/// A turret whose N rollers run between the ribs of a cam across its axis (docs/theory.md, "Index
/// drives"): a roller drives and holds from half a pitch before the line of centres to half a pitch
/// beyond it. Fields in SI units.
template <class T>
struct RibTurret {
  T stations = number<T>(4);                      ///< S, 3 or more
  T rollers = number<T>(8);                       ///< N
  T angular_speed = number<T>(10.4719755119660);  ///< omega, rad/s, of the cam
  T inertia = number<T>(0.1);                     ///< J, kg m^2
  T friction = number<T>(0);                      ///< M_C, N m
  T load = number<T>(0);                          ///< M_L, N m
  T face_width = number<T>(0.015);                ///< b, m, along a roller
  T youngs_modulus = number<T>(2.1e11);           ///< E, Pa
  T poisson_ratio = number<T>(0.3);               ///< nu
  T bore_radius = number<T>(0.015);               ///< r_0, m, of the cam
  T train_stiffness = number<T>(0);               ///< c_t, N m/rad, from turret to table
  T train_damping = number<T>(0.05);              ///< zeta
  T end_share = number<T>(1);                     ///< kappa, of the inertia
  T crown_radius = number<T>(0.5);                ///< R_k, m, of a roller along its axis

  /// delta, rad: what the turret turns by while a roller drives.
  T step() const { return number<T>(2) * pi<T>() / rollers; }
  IndexLoad<T> follower() const { return {inertia, friction, load, angular_speed}; }

  template <class X>
  FollowerMotion<X> over_angle(const Motion<X>& motion) const {
    return follower_over_angle(station_angle(stations), motion);
  }
  /// (IX10) Angle of a driving roller to the line of centres, rad, after what the turret has gained
  /// since it took over.
  template <class X>
  X angle(const X& gain) const {
    return gain - step() / number<T>(2);
  }
};

}  // namespace camlaw
