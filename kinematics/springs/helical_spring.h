// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "kinematics/scalar.h"

namespace camlaw {

/// A cylindrical helical spring of round wire under compression (EN 13906-1; docs/theory.md,
/// "Helical springs"). Fields in SI units.
template <class T>
struct HelicalSpring {
  T wire_diameter;                       ///< d, m
  T mean_diameter;                       ///< D, m
  T active_coils;                        ///< n
  T shear_modulus = number<T>(8.15e10);  ///< G, Pa
  T density = number<T>(7850);           ///< rho, kg/m^3

  /// Spring index w = D / d.
  T index() const { return mean_diameter / wire_diameter; }
  /// (W7) Rate, N/m: R = G d^4 / (8 D^3 n).
  T rate() const {
    const T d2 = wire_diameter * wire_diameter;
    const T D3 = mean_diameter * mean_diameter * mean_diameter;
    return shear_modulus * d2 * d2 / (number<T>(8) * D3 * active_coils);
  }
  /// (W8) Shear stress, Pa, at a force, corrected for the bend (Bergstraesser):
  /// tau = (w + 0.5) / (w - 0.75) 8 D F / (pi d^3).
  template <class X>
  X shear_stress(const X& force) const {
    const T w = index();
    const T correction = (w + number<T>(0.5)) / (w - number<T>(0.75));
    const T cube = wire_diameter * wire_diameter * wire_diameter;
    return correction * number<T>(8) * mean_diameter / (pi<T>() * cube) * force;
  }
  /// (W9) Mass of the active coils, kg: rho (pi d^2 / 4) (pi D n).
  T active_mass() const {
    return density * pi<T>() * wire_diameter * wire_diameter / number<T>(4) * pi<T>() *
           mean_diameter * active_coils;
  }
  /// (W10) Lowest surge frequency, Hz, both ends held: f = 1/2 sqrt(R / m).
  T surge_frequency() const {
    using std::sqrt;
    return sqrt(rate() / active_mass()) / number<T>(2);
  }
};

}  // namespace camlaw
