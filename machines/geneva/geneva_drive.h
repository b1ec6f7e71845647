// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "machines/geneva/geneva.h"
#include "machines/model/given.h"
#include "numerics/scalar/series.h"

namespace camlaw {

/// A conveyor that a Geneva moves on by a slot in each turn of its driver. Fields in SI units; T is
/// double or Expression, X is T or a series over it. phi is the driver's angle from the
/// beginning of the engagement, 0 to 2 pi; the wheel moves up to 2 gamma, gamma half the
/// engagement, and is locked from there on. Equations (Gn) are those of docs/theory.md, "Balancing
/// cam".
template <class T, template <class> class Wheel>
struct GenevaDrive {
  Given<T> given = {};
  T slots = given({"slots", "n", "1", "1", "slots of the wheel", 6, 3, 60, true});
  T angular_speed = given({"speed", "n_d", "rpm", "rad/s", "speed of the driver", 60, 1e-3, 1e6});
  T inertia =
      given({"inertia", "J", "kg m2", "kg m2",
             "moment of inertia of everything that moves, referred to the wheel", 0.8, 0, 1e6});
  T friction = given({"friction", "M_f", "N m", "N m",
                      "friction torque at the wheel while it moves", 40, 1e-6, 1e9});

  /// The wheel moves, the wheel is locked.
  enum Section : std::size_t { Moving, Locked };
  static constexpr std::size_t kSections = 2;
  std::array<T, 1> breaks() const { return {engagement()}; }
  bool moves(std::size_t section) const { return section == Moving; }

  /// The drive alone, without what machines that contain one add to it.
  const GenevaDrive& drive() const { return *this; }
  Wheel<T> geneva() const { return {slots}; }
  auto conditions() const {
    return joined(geneva().conditions(),
                  std::to_array<Condition<T>>({{friction, "friction must be above 0"}}));
  }
  /// 2 gamma, rad.
  T engagement() const { return number<T>(2) * geneva().half_engagement(); }
  /// The wheel's angle from the middle of its step.
  template <class X>
  GenevaMotion<X> wheel(bool moving, const X& phi) const {
    if (moving) return geneva().at(phi - geneva().half_engagement());
    const X none = number<X>(0);
    return {none + pi<T>() / slots, none, none, none};
  }
  /// (BC1) Torque at the wheel, N m: M_sum = J omega^2 beta'' + M_f.
  template <class X>
  X wheel_torque(const GenevaMotion<X>& beta) const {
    return inertia_torque() * beta.second + friction;
  }
  /// (BC2) Torque on the driver, N m: M_d = M_sum beta'; 0 while the wheel is locked.
  template <class X>
  X torque(const GenevaMotion<X>& beta) const {
    return wheel_torque(beta) * beta.ratio;
  }
  /// M_d' = J omega^2 (beta''' beta' + beta''^2) + M_f beta''.
  template <class X>
  X torque_slope(const GenevaMotion<X>& beta) const {
    return inertia_torque() * (beta.third * beta.ratio + beta.second * beta.second) +
           friction * beta.second;
  }
  /// (BC3) Mean over the turn, N m: M_mean = M_f / n.
  T mean_torque() const { return friction / slots; }
  /// (BC4) Surplus work since the beginning of the engagement, J, the integral of M_d - M_mean:
  /// A = J omega^2 beta'^2 / 2 + M_f (beta + pi / n) - M_mean phi.
  template <class X>
  X surplus_work(const GenevaMotion<X>& beta, const X& phi) const {
    return number<T>(0.5) * inertia_torque() * (beta.ratio * beta.ratio) +
           friction * (beta.angle + pi<T>() / slots) - mean_torque() * phi;
  }

 private:
  T inertia_torque() const { return inertia * angular_speed * angular_speed; }
};

/// A conveyor with a planar Geneva, and what room its parts have. Fields in SI units.
template <class T>
struct PlanarGenevaDrive : GenevaDrive<T, PlanarGeneva> {
  T centre_distance = this->given(
      {"centre_distance", "a", "mm", "m", "centre distance of driver and wheel", 200, 1e-3, 1e5});
  T pin_radius =
      this->given({"pin_radius", "r_p", "mm", "m", "radius of the driver's pin", 10, 0, 1e5});

  /// (V3) Radius of the pin's circle, m: a sin(pi / n).
  T crank_radius() const { return centre_distance * this->geneva().crank(); }
  /// (V4) Radius of the wheel, m, where the pin's centre enters: a cos(pi / n).
  T wheel_radius() const {
    using std::cos;
    return centre_distance * cos(pi<T>() / this->slots);
  }
  /// (V5) Room for the driver's shaft beside the wheel, m, a diameter: 2 (a - a cos(pi / n)). A
  /// thicker one, carried through, locks the drive.
  T driver_shaft_room() const { return number<T>(2) * (centre_distance - wheel_radius()); }
  /// (V7) Least thickness of the wheel between two slots, m, at their inner ends: 2 ((a - a sin(pi
  /// / n)) sin(pi / n) - r_p). Below 0 neighbouring slots run into one another.
  T web() const {
    return number<T>(2) *
           ((centre_distance - crank_radius()) * this->geneva().crank() - pin_radius);
  }
  /// (V6) Room for the wheel's shaft inside the slots, m, a diameter: 2 (a - a sin(pi / n) - r_p).
  T wheel_shaft_room() const {
    return number<T>(2) * (centre_distance - crank_radius() - pin_radius);
  }
};

template <class T>
using SphericalGenevaDrive = GenevaDrive<T, SphericalGeneva>;

}  // namespace camlaw
