// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

#include "machines/model/possibility.h"
#include "numerics/scalar/by_side.h"
#include "numerics/scalar/scalar.h"
#include "numerics/scalar/where_positive.h"

namespace camlaw {

/// A cylindrical helical spring of round wire under compression, cold coiled, its ends closed and
/// ground (EN 13906-1; docs/theory.md, "Helical springs"). Fields in SI units.
template <class T>
struct HelicalSpring {
  T wire_diameter;                        ///< d, m
  T mean_diameter;                        ///< D, m
  T active_coils;                         ///< n
  T shear_modulus = number<T>(8.15e10);   ///< G, Pa
  T density = number<T>(7850);            ///< rho, kg/m^3
  T end_coils = number<T>(2);             ///< n_t - n, those that do not move
  T youngs_modulus = number<T>(2.06e11);  ///< E, Pa

  auto conditions() const {
    return std::to_array<Condition<T>>(
        {{wire_diameter, "wire_diameter must be above 0"},
         {mean_diameter - wire_diameter, "mean_diameter must be above wire_diameter"},
         {active_coils, "active_coils must be above 0"}});
  }
  /// Spring index w = D / d.
  T index() const { return mean_diameter / wire_diameter; }
  T outer_diameter() const { return mean_diameter + wire_diameter; }
  T inner_diameter() const { return mean_diameter - wire_diameter; }

  /// (W7) Rate, N/m: R = G d^4 / (8 D^3 n). Force R s, deflection F / R, work R s^2 / 2.
  T rate() const {
    return shear_modulus * integer_power(wire_diameter, 4) /
           (number<T>(8) * integer_power(mean_diameter, 3) * active_coils);
  }
  template <class X>
  X force(const X& deflection) const {
    return rate() * deflection;
  }
  template <class X>
  X deflection(const X& force) const {
    return force / rate();
  }
  template <class X>
  X work(const X& deflection) const {
    return number<T>(0.5) * rate() * (deflection * deflection);
  }

  /// (W8) Shear stress, Pa, at a force, corrected for the bend (Bergstraesser):
  /// tau_k = (w + 0.5) / (w - 0.75) 8 D F / (pi d^3). A load that varies is judged by it.
  template <class X>
  X shear_stress(const X& force) const {
    const T w = index();
    return (w + number<T>(0.5)) / (w - number<T>(0.75)) * uncorrected_stress(force);
  }
  /// (W18) tau = 8 D F / (pi d^3), for a static load.
  template <class X>
  X uncorrected_stress(const X& force) const {
    return number<T>(8) * mean_diameter / (pi<T>() * integer_power(wire_diameter, 3)) * force;
  }

  /// (W9) Mass of the active coils, kg: rho (pi d^2 / 4) (pi D n); and of all.
  T active_mass() const { return coil_mass() * active_coils; }
  T mass() const { return coil_mass() * total_coils(); }
  /// (W10) Lowest surge frequency, Hz, both ends held: f = 1/2 sqrt(R / m).
  T surge_frequency() const {
    using std::sqrt;
    return sqrt(rate() / active_mass()) / number<T>(2);
  }

  T total_coils() const { return active_coils + end_coils; }
  /// (W19) Length, m, with all coils touching: L_c = n_t d.
  T solid_length() const { return total_coils() * wire_diameter; }
  /// (W20) Sum of the least gaps between active coils in use, m: S_a = n (0.0015 D^2/d + 0.1 d).
  T least_gaps() const {
    return active_coils * (number<T>(0.0015) * mean_diameter * mean_diameter / wire_diameter +
                           number<T>(0.1) * wire_diameter);
  }

  /// (W21) Free length, m, of a spring that keeps `gap_factor` S_a at the given deflection:
  /// L_0 = L_c + gap_factor S_a + s.
  T free_length(const T& deflection, const T& gap_factor) const {
    return solid_length() + gap_factor * least_gaps() + deflection;
  }

  /// (W22) Deflection at which a spring of the free length L_0 buckles, infinite where none does:
  /// s_K = L_0 a (1 - sqrt(1 - q)), a = 0.5 / (1 - G/E), q = (1 - G/E) / (0.5 + G/E) (pi D / (nu
  /// L_0))^2. nu, how the ends are held: 0.5 where both keep their direction and place, 1 where
  /// both may turn, 2 where one is free. No number for G >= E, which no material has.
  T buckling_deflection(const T& free_length, const T& seating) const {
    using std::sqrt;
    const T left = number<T>(1) - critical(free_length, seating);
    return by_side(left, T(free_length * reach() * (number<T>(1) - sqrt(left))),
                   number<T>(std::numeric_limits<double>::infinity()));
  }
  /// (W23) (1 - max(0, 1 - s / (a L_0))^2) / q: 1 at s_K, below 1 where the spring does not buckle,
  /// and defined where no deflection buckles it.
  T buckling_fraction(const T& deflection, const T& free_length, const T& seating) const {
    const T ahead = number<T>(1) - deflection / (free_length * reach());
    const T positive = (ahead + absolute(ahead)) / number<T>(2);
    return (number<T>(1) - positive * positive) / critical(free_length, seating);
  }

 private:
  T coil_mass() const {
    return density * pi<T>() * wire_diameter * wire_diameter / number<T>(4) * pi<T>() *
           mean_diameter;
  }
  /// a of (W22).
  T reach() const { return number<T>(0.5) / (number<T>(1) - shear_modulus / youngs_modulus); }
  /// q of (W22).
  T critical(const T& free_length, const T& seating) const {
    const T moduli = shear_modulus / youngs_modulus;
    const T slender = pi<T>() * mean_diameter / (seating * free_length);
    return where_positive(number<T>(1) - moduli,
                          (number<T>(1) - moduli) / (number<T>(0.5) + moduli) * slender * slender);
  }
};

}  // namespace camlaw
