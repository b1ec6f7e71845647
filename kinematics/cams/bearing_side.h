// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/absolute.h"
#include "kinematics/cams/roller_contact.h"

/// Of two flanks or cams the one that bears the force between them (docs/theory.md, "Form
/// closure").
namespace camlaw {

/// `pushing` where the force is 0 or above, `pulling` where it is below.
template <class X>
X by_side(const X& force, const X& pushing, const X& pulling) {
  return value_of(force) < 0 ? pulling : pushing;
}

inline Interval by_side(const Interval& force, const Interval& pushing, const Interval& pulling) {
  if (force.lower() >= 0) return pushing;
  if (force.upper() < 0) return pulling;
  return boost::numeric::hull(pushing, pulling);
}

/// Over a box in which the force may change its sign nothing is known of the derivatives.
template <std::size_t N>
Series<Interval, N> by_side(const Series<Interval, N>& force, const Series<Interval, N>& pushing,
                            const Series<Interval, N>& pulling) {
  if (force.c[0].lower() >= 0) return pushing;
  if (force.c[0].upper() < 0) return pulling;
  Series<Interval, N> result(by_side(force.c[0], pushing.c[0], pulling.c[0]));
  for (std::size_t k = 1; k < N; ++k) result.c[k] = Interval::whole();
  return result;
}

/// The stress under a force, without slope where the force is 0: nothing bears there, as in a dwell
/// without a load, and the root of the force has no derivatives.
template <class X>
X loaded(const X& force, const X& stress) {
  return value_of(force) == 0 ? number<X>(0) : stress;
}

inline Interval loaded(const Interval&, const Interval& stress) { return stress; }

template <std::size_t N>
Series<Interval, N> loaded(const Series<Interval, N>&, const Series<Interval, N>& stress) {
  return stress;
}

/// (M27) What (M7) is for the outer flank of a groove, -r_r k: it is undercut where this reaches 1.
template <class T, class X>
X outer_undercut(const RollerContact<T>& roller, const X& k) {
  return roller.undercut(-k);
}

/// (M28) Greatest pressure, Pa, in a groove, on the flank that bears the force N, N: with the pitch
/// curve's curvature k, 1/m, the inner one where N is above 0 and the outer one, whose pitch curve
/// bends the other way, below. NaN where that flank is undercut.
template <class T, class X>
X groove_stress(const RollerContact<T>& roller, const X& force, const X& k) {
  return loaded(force, roller.stress(absolute(force), by_side(force, k, X(-k))));
}

}  // namespace camlaw
