// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/roller_cam.h"
#include "machines/geneva/surplus.h"
#include "machines/springs/disc_spring_stack.h"

namespace camlaw {

/// A cam on the driver of a Geneva-driven conveyor that presses on a stack of disc springs and so
/// stores and returns the surplus work of the drive (docs/theory.md, "Balancing cam").
///
/// Fields in SI units. Source: K. V. Tir, A. S. Glavatskii, A. I. Petruk, "The balancing of the
/// surplus forces of the main conveyors' drive of the book-processing units", Polihrafiia i
/// vydavnycha sprava, UDC 621.835. It prints neither loads nor springs: those here are ours.
template <class Wheel>
struct BalancingCam : GenevaDrive<Wheel> {
  using Drive = GenevaDrive<Wheel>;

  Expression design_speed = this->given(
      {"design_speed", "n_c", "rpm", "rad/s", "speed that the cam is designed for", 60, 1e-3, 1e6});
  Expression preload_ratio = this->given(
      {"preload_ratio", "psi", "1", "1", "preload over working stroke of the stack", 1, 0.02, 100});
  Expression springs = this->given(
      {"springs", "i", "1", "1", "packets of disc springs in series", 44, 1, 10000, true});
  Expression nested =
      this->given({"nested", "n_s", "1", "1", "springs in a packet, nested", 1, 1, 10, true});
  Expression outer_diameter = this->given(
      {"outer_diameter", "D_e", "mm", "m", "outer diameter of a spring", 31.5, 1, 1000});
  Expression inner_diameter = this->given(
      {"inner_diameter", "D_i", "mm", "m", "inner diameter of a spring", 16.3, 0.5, 1000});
  Expression thickness =
      this->given({"thickness", "t", "mm", "m", "thickness of a spring", 1.75, 0.05, 100});
  Expression cone_height = this->given(
      {"cone_height", "h_0", "mm", "m",
       "cone height of the free spring, which is its deflection to flat", 0.7, 0.01, 100});
  Expression youngs_modulus =
      this->given({"youngs_modulus", "E", "GPa", "Pa", "Young's modulus of springs, cam and roller",
                   206, 1e-3, 1e4});
  Expression poisson_ratio = this->given(
      {"poisson_ratio", "mu", "1", "1", "Poisson's ratio of springs, cam and roller", 0.3, 0, 0.5});
  Expression cams = this->given({"cams", "k", "1", "1",
                                 "number of cams: 1, or 2 equal ones, one at each end of the stack",
                                 1, 1, 2, true});
  Expression base_radius = this->given(
      {"base_radius", "r_b", "mm", "m", "least radius of the cam's profile", 60, 0.1, 1e5});
  Expression roller_radius =
      this->given({"roller_radius", "r_r", "mm", "m", "radius of the roller", 25, 0.1, 1e5});
  Expression face_width = this->given(
      {"face_width", "b", "mm", "m", "width of roller and cam in contact", 25, 0.1, 1e4});
  Expression moved_mass =
      this->given({"moved_mass", "m", "kg", "kg", "mass that moves with each roller", 1, 0, 1e6});
  Expression lift_off = this->given(
      {"lift_off", "delta", "deg", "rad",
       "angle, from the engagement of the pin, over which the rollers are off the cam", 0, 0, 60});

  static constexpr double kRounding = 1e-9;  ///< rad, of angles that are meant to be equal

  /// The rollers are off the cam, the wheel moves, the wheel is locked.
  enum Section : std::size_t { Lifted, Moving, Locked };
  static constexpr std::size_t kSections = 3;
  std::array<Expression, 2> breaks() const { return {lift_off, this->engagement()}; }
  bool moves(std::size_t section) const { return section != Locked; }

  auto conditions() const {
    const Expression latest = this->engagement() + Expression(kRounding);
    return joined(
        joined(Drive::conditions(), spring().conditions()),
        std::to_array<Condition>({{preload_ratio, "preload_ratio must be above 0"},
                                  {springs, "springs must be above 0"},
                                  {latest - lift_off, lift_off_words(this->geneva()), true}}));
  }
  static const char* lift_off_words(const PlanarGeneva&) {
    return "lift_off must be at most 180 deg - 360 deg / slots";
  }
  static const char* lift_off_words(const SphericalGeneva&) {
    return "lift_off must be at most 180 deg";
  }
  /// The drive at the speed that the cam is cut for.
  Drive designed() const {
    return {Given::unset(), this->slots, design_speed, this->inertia, this->friction};
  }
  DiscSpring spring() const {
    return {outer_diameter, inner_diameter, thickness, cone_height, youngs_modulus, poisson_ratio};
  }
  DiscSpringStack stack() const { return {spring(), nested, springs}; }

  /// Deflection of a spring that catalogues count with, m: f_n = 0.75 h_0.
  Expression nominal_deflection() const { return ratio(3, 4) * cone_height; }
  /// (BC9) Rate that the law of displacement takes for a packet's, N/m: c = P(f_n) / f_n.
  Expression packet_rate() const {
    return nested * spring().force(nominal_deflection()) / nominal_deflection();
  }
  /// (BC10) Working stroke of the stack's end that stores the surplus work, m, from A =
  /// (c / i) S_sp^2 (1/2 + psi).
  Expression stroke(const Expression& surplus) const {
    return sqrt(surplus * springs / (packet_rate() * (ratio(1, 2) + preload_ratio)));
  }
  /// Greatest deflection of each spring, m: f_w = (1 + psi) S_sp / i.
  Expression deflection(const Expression& surplus) const {
    return (1 + preload_ratio) * stroke(surplus) / springs;
  }
  /// (BC11) Springs in a row whose greatest deflection is f_n, not rounded:
  /// i = A f_n / (P_1 (f_n - f_min)^2 (1/2 + psi)), P_1 = P(f_n), f_min = psi f_n / (1 + psi).
  Expression springs_needed(const Expression& surplus) const {
    const Expression f = nominal_deflection();
    const Expression travel = f / (1 + preload_ratio);
    return surplus / (packet_rate() * travel * travel * (ratio(1, 2) + preload_ratio));
  }
  /// The cam with its roller, whose follower is one end of the stack.
  RollerCam cam() const {
    RollerCam result{Given::unset()};
    result.base_radius = base_radius;
    result.roller_radius = roller_radius;
    result.face_width = face_width;
    result.youngs_modulus = youngs_modulus;
    result.poisson_ratio = poisson_ratio;
    return result;
  }
};

/// A balancing cam with its surplus work worked out, over the driver's angle.
template <class Wheel>
class BalancedTurn {
 public:
  explicit BalancedTurn(const BalancingCam<Wheel>& machine)
      : machine_(machine),
        designed_(machine.designed()),
        surplus_(surplus_of(designed_)),
        running_peak_(surplus_of(machine.drive()).peak_torque),
        stroke_(machine.stroke(surplus_.range)) {}

  const BalancingCam<Wheel>& machine() const { return machine_; }
  const Surplus& surplus() const { return surplus_; }
  /// Greatest torque of the drive at the speed that it runs at, N m.
  const Expression& peak_torque() const { return running_peak_; }

  GenevaMotion wheel(std::size_t section, const Expression& phi) const {
    return machine_.wheel(machine_.moves(section), phi);
  }
  /// (BC5) Energy in the springs above the least, over its range: (A_max - A) / A_surplus,max, and
  /// its derivatives by phi.
  FollowerMotion stored(std::size_t section, const Expression& phi) const {
    const GenevaMotion beta = wheel(section, phi);
    const Expression level = surplus_.highest_work - designed_.surplus_work(beta, phi);
    const Expression rate = designed_.mean_torque() - designed_.torque(beta);
    return {level / surplus_.range, rate / surplus_.range,
            -designed_.torque_slope(beta) / surplus_.range, 0};
  }
  /// (BC7) The law of displacement, 0 to 1: a = -psi + sqrt(psi^2 + (1 + 2 psi) e), e the stored
  /// energy; a' = (1/2 + psi) e' / (a + psi), a'' = ((1/2 + psi) e'' - a'^2) / (a + psi).
  FollowerMotion displacement(std::size_t section, const Expression& phi) const {
    const Expression psi = machine_.preload_ratio, half = ratio(1, 2) + psi;
    const FollowerMotion e = stored(section, phi);
    const Expression root = sqrt(2 * half * e.s + psi * psi);
    const Expression first = half * e.ds / root;
    return {root - psi, first, (half * e.dds - first * first) / root, 0};
  }
  /// Motion of each roller, m.
  FollowerMotion roller(std::size_t section, const Expression& phi) const {
    const FollowerMotion a = displacement(section, phi);
    const Expression each = stroke_ / machine_.cams;
    return {each * a.s, each * a.ds, each * a.dds, 0};
  }
  /// Force of the stack, N, by the springs' own characteristic, from the displacement. It holds
  /// while no spring is pressed further than flat.
  Expression spring_force(const FollowerMotion& a) const {
    return machine_.stack().force(stroke_ * (a.s + machine_.preload_ratio));
  }
  /// (BC12) Force along a roller's way, N: that of the stack and m omega^2 y''. Below 0 the roller
  /// leaves the cam.
  Expression roller_force(const FollowerMotion& a) const {
    const Expression inertia =
        machine_.moved_mass * machine_.angular_speed * machine_.angular_speed;
    return spring_force(a) + inertia * stroke_ / machine_.cams * a.dds;
  }
  /// (BC13) What the rollers ask of the driver, N m: F y' of each, together F S_sp a'.
  Expression balancing_torque(const FollowerMotion& a) const {
    return roller_force(a) * (stroke_ * a.ds);
  }
  /// What the driver sees with every roller on the cam, N m: M_d + M_bal.
  Expression touching_torque(std::size_t section, const Expression& phi) const {
    return machine_.torque(wheel(section, phi)) + balancing_torque(displacement(section, phi));
  }
  /// The same, but M_d alone while the rollers are off the cam.
  Expression residual_torque(std::size_t section, const Expression& phi) const {
    if (section == BalancingCam<Wheel>::Lifted) return machine_.torque(wheel(section, phi));
    return touching_torque(section, phi);
  }

 private:
  BalancingCam<Wheel> machine_;
  GenevaDrive<Wheel> designed_;
  Surplus surplus_;
  Expression running_peak_, stroke_;
};

using PlanarBalancingCam = BalancingCam<PlanarGeneva>;
using SphericalBalancingCam = BalancingCam<SphericalGeneva>;

}  // namespace camlaw
