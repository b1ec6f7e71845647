// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

#include "machines/model/possibility.h"
#include "numerics/formula/expression.h"

namespace camlaw {

/// A cylindrical helical spring of round wire under compression, cold coiled, its ends closed and
/// ground (EN 13906-1; docs/theory.md, "Helical springs"). Fields in SI units.
struct HelicalSpring {
  Expression wire_diameter;                         ///< d, m
  Expression mean_diameter;                         ///< D, m
  Expression active_coils;                          ///< n
  Expression shear_modulus = Expression(8.15e10);   ///< G, Pa
  Expression density = 7850;                        ///< rho, kg/m^3
  Expression end_coils = 2;                         ///< n_t - n, those that do not move
  Expression youngs_modulus = Expression(2.06e11);  ///< E, Pa

  auto conditions() const {
    return std::to_array<Condition>(
        {{wire_diameter, "wire_diameter must be above 0"},
         {mean_diameter - wire_diameter, "mean_diameter must be above wire_diameter"},
         {active_coils, "active_coils must be above 0"}});
  }
  /// Spring index w = D / d.
  Expression index() const { return mean_diameter / wire_diameter; }
  Expression outer_diameter() const { return mean_diameter + wire_diameter; }
  Expression inner_diameter() const { return mean_diameter - wire_diameter; }

  /// (W7) Rate, N/m: R = G d^4 / (8 D^3 n). Force R s, deflection F / R, work R s^2 / 2.
  Expression rate() const {
    return shear_modulus * integer_power(wire_diameter, 4) /
           (8 * integer_power(mean_diameter, 3) * active_coils);
  }
  Expression force(const Expression& deflection) const { return rate() * deflection; }
  Expression deflection(const Expression& force) const { return force / rate(); }
  Expression work(const Expression& deflection) const {
    return Expression(0.5) * rate() * (deflection * deflection);
  }

  /// (W8) Shear stress, Pa, at a force, corrected for the bend (Bergstraesser):
  /// tau_k = (w + 0.5) / (w - 0.75) 8 D F / (pi d^3). A load that varies is judged by it.
  Expression shear_stress(const Expression& force) const {
    const Expression w = index();
    return (w + Expression(0.5)) / (w - Expression(0.75)) * uncorrected_stress(force);
  }
  /// (W18) tau = 8 D F / (pi d^3), for a static load.
  Expression uncorrected_stress(const Expression& force) const {
    return 8 * mean_diameter / (pi() * integer_power(wire_diameter, 3)) * force;
  }

  /// (W9) Mass of the active coils, kg: rho (pi d^2 / 4) (pi D n); and of all.
  Expression active_mass() const { return coil_mass() * active_coils; }
  Expression mass() const { return coil_mass() * total_coils(); }
  /// (W10) Lowest surge frequency, Hz, both ends held: f = 1/2 sqrt(R / m).
  Expression surge_frequency() const { return sqrt(rate() / active_mass()) / 2; }

  Expression total_coils() const { return active_coils + end_coils; }
  /// (W19) Length, m, with all coils touching: L_c = n_t d.
  Expression solid_length() const { return total_coils() * wire_diameter; }
  /// (W20) Sum of the least gaps between active coils in use, m: S_a = n (0.0015 D^2/d + 0.1 d).
  Expression least_gaps() const {
    return active_coils * (ratio(15, 10000) * mean_diameter * mean_diameter / wire_diameter +
                           ratio(1, 10) * wire_diameter);
  }

  /// (W21) Free length, m, of a spring that keeps `gap_factor` S_a at the given deflection:
  /// L_0 = L_c + gap_factor S_a + s.
  Expression free_length(const Expression& deflection, const Expression& gap_factor) const {
    return solid_length() + gap_factor * least_gaps() + deflection;
  }

  /// (W22) Deflection at which a spring of the free length L_0 buckles, infinite where none does:
  /// s_K = L_0 a (1 - sqrt(1 - q)), a = 0.5 / (1 - G/E), q = (1 - G/E) / (0.5 + G/E) (pi D / (nu
  /// L_0))^2. nu, how the ends are held: 0.5 where both keep their direction and place, 1 where
  /// both may turn, 2 where one is free. No number for G >= E, which no material has.
  Expression buckling_deflection(const Expression& free_length, const Expression& seating) const {
    const Expression left = 1 - critical(free_length, seating);
    return by_side(left, free_length * reach() * (1 - sqrt(left)),
                   Expression(std::numeric_limits<double>::infinity()));
  }
  /// (W23) (1 - max(0, 1 - s / (a L_0))^2) / q: 1 at s_K, below 1 where the spring does not buckle,
  /// and defined where no deflection buckles it.
  Expression buckling_fraction(const Expression& deflection, const Expression& free_length,
                               const Expression& seating) const {
    const Expression ahead = 1 - deflection / (free_length * reach());
    const Expression positive = (ahead + absolute(ahead)) / 2;
    return (1 - positive * positive) / critical(free_length, seating);
  }

 private:
  Expression coil_mass() const {
    return density * pi() * wire_diameter * wire_diameter / 4 * pi() * mean_diameter;
  }
  /// a of (W22).
  Expression reach() const { return Expression(0.5) / (1 - shear_modulus / youngs_modulus); }
  /// q of (W22).
  Expression critical(const Expression& free_length, const Expression& seating) const {
    const Expression moduli = shear_modulus / youngs_modulus;
    const Expression slender = pi() * mean_diameter / (seating * free_length);
    return where_positive(1 - moduli,
                          (1 - moduli) / (Expression(0.5) + moduli) * slender * slender);
  }
};

}  // namespace camlaw
