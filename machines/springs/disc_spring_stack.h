// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "machines/springs/disc_spring.h"

namespace camlaw {

/// Disc springs in a stack: `parallel` of them nested, `series` such packets in a row
/// (docs/theory.md, "Disc springs"). Deflections are the stack's, m.
template <class T>
struct DiscSpringStack {
  DiscSpring<T> spring;
  T parallel = number<T>(1);          ///< n
  T series = number<T>(1);            ///< i
  T surface_friction = number<T>(0);  ///< w_M, between nested springs
  T edge_friction = number<T>(0);     ///< w_R, where the force enters

  auto conditions() const {
    return joined(spring.conditions(),
                  std::to_array<Condition<T>>(
                      {{parallel, "parallel must be above 0"},
                       {series, "series must be above 0"},
                       {number<T>(1) - friction(),
                        "surface_friction * (parallel - 1) + edge_friction must be below 1"}}));
  }
  /// n i.
  T springs() const { return parallel * series; }

  /// (W15) Without friction: n F(s/i), N.
  template <class X>
  X force(const X& deflection) const {
    return parallel * spring.force(deflection / series);
  }
  /// N/m.
  template <class X>
  X rate(const X& deflection) const {
    return parallel / series * spring.rate(deflection / series);
  }
  /// Stored up to the deflection, J.
  template <class X>
  X work(const X& deflection) const {
    return parallel * series * spring.work(deflection / series);
  }
  /// (W16) With friction, N: n F / (1 - w_M (n - 1) - w_R) while the stack is pressed together, and
  /// with plus while it comes back.
  template <class X>
  X loading_force(const X& deflection) const {
    return force(deflection) / (number<T>(1) - friction());
  }
  template <class X>
  X return_force(const X& deflection) const {
    return force(deflection) / (number<T>(1) + friction());
  }

  /// Deflection in parts of that to flat: above 1 the formulas do not hold.
  template <class X>
  X flattening(const X& deflection) const {
    return deflection / (series * spring.flat_deflection());
  }
  /// (W17) L_0 = i (l_0 + (n - 1) t'), m. Flat: i n t'.
  T free_length() const {
    return series * (spring.cone_height + spring.thickness +
                     (parallel - number<T>(1)) * spring.reduced_thickness());
  }
  T flat_length() const { return springs() * spring.reduced_thickness(); }
  T mass(const T& density) const { return springs() * spring.mass(density); }

 private:
  T friction() const { return surface_friction * (parallel - number<T>(1)) + edge_friction; }
};

/// The fewest packets in a row that take the stack's deflection with none deflected by more than
/// the share of its way to flat.
inline int least_series(const DiscSpring<double>& spring, double deflection, double share) {
  constexpr double kRounding = 1e-12;  // of a quotient that is meant to be an integer
  return static_cast<int>(
      std::ceil(deflection / (share * spring.flat_deflection()) * (1 - kRounding)));
}

/// The fewest nested springs that carry the force with each deflected by s.
inline int least_parallel(const DiscSpring<double>& spring, double force, double s) {
  constexpr double kRounding = 1e-12;  // of a quotient that is meant to be an integer
  return static_cast<int>(std::ceil(force / spring.force(s) * (1 - kRounding)));
}

}  // namespace camlaw
