// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "machines/springs/disc_spring.h"

namespace camlaw {

/// Disc springs in a stack: `parallel` of them nested, `series` such packets in a row
/// (docs/theory.md, "Disc springs"). Deflections are the stack's, m.
struct DiscSpringStack {
  DiscSpring spring;
  Expression parallel = 1;          ///< n
  Expression series = 1;            ///< i
  Expression surface_friction = 0;  ///< w_M, between nested springs
  Expression edge_friction = 0;     ///< w_R, where the force enters

  auto conditions() const {
    return joined(spring.conditions(),
                  std::to_array<Condition>(
                      {{parallel, "parallel must be above 0"},
                       {series, "series must be above 0"},
                       {1 - friction(),
                        "surface_friction * (parallel - 1) + edge_friction must be below 1"}}));
  }
  /// n i.
  Expression springs() const { return parallel * series; }

  /// (W15) Without friction: n F(s/i), N.
  Expression force(const Expression& deflection) const {
    return parallel * spring.force(deflection / series);
  }
  /// N/m.
  Expression rate(const Expression& deflection) const {
    return parallel / series * spring.rate(deflection / series);
  }
  /// Stored up to the deflection, J.
  Expression work(const Expression& deflection) const {
    return parallel * series * spring.work(deflection / series);
  }
  /// (W16) With friction, N: n F / (1 - w_M (n - 1) - w_R) while the stack is pressed together, and
  /// with plus while it comes back.
  Expression loading_force(const Expression& deflection) const {
    return force(deflection) / (1 - friction());
  }
  Expression return_force(const Expression& deflection) const {
    return force(deflection) / (1 + friction());
  }

  /// Deflection in parts of that to flat: above 1 the formulas do not hold.
  Expression flattening(const Expression& deflection) const {
    return deflection / (series * spring.flat_deflection());
  }
  /// (W17) L_0 = i (l_0 + (n - 1) t'), m. Flat: i n t'.
  Expression free_length() const {
    return series *
           (spring.cone_height + spring.thickness + (parallel - 1) * spring.reduced_thickness());
  }
  Expression flat_length() const { return springs() * spring.reduced_thickness(); }
  Expression mass(const Expression& density) const { return springs() * spring.mass(density); }

 private:
  Expression friction() const { return surface_friction * (parallel - 1) + edge_friction; }
};

/// The fewest packets in a row that take the stack's deflection with none deflected by more than
/// the share of its way to flat, from a spring's deflection to flat.
inline int least_series(double flat_deflection, double deflection, double share) {
  constexpr double kRounding = 1e-12;  // of a quotient that is meant to be an integer
  return static_cast<int>(std::ceil(deflection / (share * flat_deflection) * (1 - kRounding)));
}

/// The fewest nested springs that carry the force, each of which carries so much.
inline int least_parallel(double force_of_one, double force) {
  constexpr double kRounding = 1e-12;  // of a quotient that is meant to be an integer
  return static_cast<int>(std::ceil(force / force_of_one * (1 - kRounding)));
}

}  // namespace camlaw
