// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "machines/geneva/geneva.h"
#include "machines/model/given.h"
#include "numerics/formula/expression.h"

namespace camlaw {

/// A conveyor that a Geneva moves on by a slot in each turn of its driver. Fields in SI units. phi
/// is the driver's angle from the beginning of the engagement, 0 to 2 pi; the wheel moves up to 2
/// gamma, gamma half the engagement, and is locked from there on. Equations (Gn) are those of
/// docs/theory.md, "Balancing cam".
template <class Wheel>
struct GenevaDrive {
  Given given = {};
  Expression slots = given({"slots", "n", "1", "1", "slots of the wheel", 6, 3, 60, true});
  Expression angular_speed =
      given({"speed", "n_d", "rpm", "rad/s", "speed of the driver", 60, 1e-3, 1e6});
  Expression inertia =
      given({"inertia", "J", "kg m2", "kg m2",
             "moment of inertia of everything that moves, referred to the wheel", 0.8, 0, 1e6});
  Expression friction = given({"friction", "M_f", "N m", "N m",
                               "friction torque at the wheel while it moves", 40, 1e-6, 1e9});

  /// The wheel moves, the wheel is locked.
  enum Section : std::size_t { Moving, Locked };
  static constexpr std::size_t kSections = 2;
  std::array<Expression, 1> breaks() const { return {engagement()}; }
  bool moves(std::size_t section) const { return section == Moving; }

  /// The drive alone, without what machines that contain one add to it.
  const GenevaDrive& drive() const { return *this; }
  Wheel geneva() const { return {slots}; }
  auto conditions() const {
    return joined(geneva().conditions(),
                  std::to_array<Condition>({{friction, "friction must be above 0"}}));
  }
  /// 2 gamma, rad.
  Expression engagement() const { return 2 * geneva().half_engagement(); }
  /// The wheel's angle from the middle of its step.
  GenevaMotion wheel(bool moving, const Expression& phi) const {
    if (moving) return geneva().at(phi - geneva().half_engagement());
    const Expression none = 0;
    return {none + pi() / slots, none, none, none};
  }
  /// (BC1) Torque at the wheel, N m: M_sum = J omega^2 beta'' + M_f.
  Expression wheel_torque(const GenevaMotion& beta) const {
    return inertia_torque() * beta.second + friction;
  }
  /// (BC2) Torque on the driver, N m: M_d = M_sum beta'; 0 while the wheel is locked.
  Expression torque(const GenevaMotion& beta) const { return wheel_torque(beta) * beta.ratio; }
  /// M_d' = J omega^2 (beta''' beta' + beta''^2) + M_f beta''.
  Expression torque_slope(const GenevaMotion& beta) const {
    return inertia_torque() * (beta.third * beta.ratio + beta.second * beta.second) +
           friction * beta.second;
  }
  /// (BC3) Mean over the turn, N m: M_mean = M_f / n.
  Expression mean_torque() const { return friction / slots; }
  /// (BC4) Surplus work since the beginning of the engagement, J, the integral of M_d - M_mean:
  /// A = J omega^2 beta'^2 / 2 + M_f (beta + pi / n) - M_mean phi.
  Expression surplus_work(const GenevaMotion& beta, const Expression& phi) const {
    return Expression(0.5) * inertia_torque() * (beta.ratio * beta.ratio) +
           friction * (beta.angle + pi() / slots) - mean_torque() * phi;
  }

 private:
  Expression inertia_torque() const { return inertia * angular_speed * angular_speed; }
};

/// A conveyor with a planar Geneva, and what room its parts have. Fields in SI units.
struct PlanarGenevaDrive : GenevaDrive<PlanarGeneva> {
  Expression centre_distance = given(
      {"centre_distance", "a", "mm", "m", "centre distance of driver and wheel", 200, 1e-3, 1e5});
  Expression pin_radius =
      given({"pin_radius", "r_p", "mm", "m", "radius of the driver's pin", 10, 0, 1e5});

  /// (V3) Radius of the pin's circle, m: a sin(pi / n).
  Expression crank_radius() const { return centre_distance * geneva().crank(); }
  /// (V4) Radius of the wheel, m, where the pin's centre enters: a cos(pi / n).
  Expression wheel_radius() const { return centre_distance * cos(pi() / slots); }
  /// (V5) Room for the driver's shaft beside the wheel, m, a diameter: 2 (a - a cos(pi / n)). A
  /// thicker one, carried through, locks the drive.
  Expression driver_shaft_room() const { return 2 * (centre_distance - wheel_radius()); }
  /// (V7) Least thickness of the wheel between two slots, m, at their inner ends: 2 ((a - a sin(pi
  /// / n)) sin(pi / n) - r_p). Below 0 neighbouring slots run into one another.
  Expression web() const {
    return 2 * ((centre_distance - crank_radius()) * geneva().crank() - pin_radius);
  }
  /// (V6) Room for the wheel's shaft inside the slots, m, a diameter: 2 (a - a sin(pi / n) - r_p).
  Expression wheel_shaft_room() const {
    return 2 * (centre_distance - crank_radius() - pin_radius);
  }
};

using SphericalGenevaDrive = GenevaDrive<SphericalGeneva>;

}  // namespace camlaw
