// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "numerics/scalar/absolute.h"

/// Formulas that depend on the sign of something, in any scalar.
namespace camlaw {

/// `pushing` where the force is 0 or above, `pulling` where it is below; not a number where the
/// force is not one.
template <class X>
X by_side(const X& force, const X& pushing, const X& pulling) {
  const double side = value_of(force);
  if (std::isnan(side)) return number<X>(side);
  return side < 0 ? pulling : pushing;
}

inline Interval by_side(const Interval& force, const Interval& pushing, const Interval& pulling) {
  if (boost::numeric::empty(force)) return Interval::whole();
  if (force.lower() >= 0) return pushing;
  if (force.upper() < 0) return pulling;
  const bool known = !boost::numeric::empty(pushing) && !boost::numeric::empty(pulling);
  return known ? boost::numeric::hull(pushing, pulling) : Interval::whole();
}

/// Over a box in which the force may change its sign nothing is known of the derivatives.
template <std::size_t N>
Series<Interval, N> by_side(const Series<Interval, N>& force, const Series<Interval, N>& pushing,
                            const Series<Interval, N>& pulling) {
  if (force.c[0].lower() >= 0) return pushing;
  if (force.c[0].upper() < 0) return pulling;
  if (is_number(pushing, value_of(pushing)) && is_number(pulling, value_of(pushing))) {
    return pushing;  // one number on both sides
  }
  Series<Interval, N> result(by_side(force.c[0], pushing.c[0], pulling.c[0]));
  for (std::size_t k = 1; k < N; ++k) result.c[k] = Interval::whole();
  return result;
}

/// |x| with the sign of a direction: 0 where there is none, not a number where that is not one.
template <class X>
X along(const X& direction, const X& x) {
  const double way = value_of(direction);
  if (std::isnan(way)) return number<X>(way);
  return way == 0 ? number<X>(0) : way < 0 ? -absolute(x) : absolute(x);
}

inline Interval along(const Interval& direction, const Interval& x) {
  if (boost::numeric::empty(direction)) return Interval::whole();
  const Interval size = absolute(x);
  if (direction.lower() > 0) return size;
  if (direction.upper() < 0) return -size;
  if (direction.lower() == 0 && direction.upper() == 0) return Interval(0.0);
  return boost::numeric::hull(size, -size);
}

/// Over a box in which the direction may change nothing is known of the derivatives, unless x is 0.
template <std::size_t N>
Series<Interval, N> along(const Series<Interval, N>& direction, const Series<Interval, N>& x) {
  const Interval& way = direction.c[0];
  if (is_number(x, 0.0) && !boost::numeric::empty(way)) return x;
  if (way.lower() > 0) return absolute(x);
  if (way.upper() < 0) return -absolute(x);
  Series<Interval, N> result(along(way, x.c[0]));
  const bool resting = way.lower() == 0 && way.upper() == 0;
  for (std::size_t k = 1; k < N; ++k) result.c[k] = resting ? Interval(0.0) : Interval::whole();
  return result;
}

/// x, but the constant 0 where the force is 0: nothing bears there, as in a dwell without a load,
/// and the root of the force has no derivatives.
template <class X>
X unless_zero(const X& force, const X& x) {
  if (std::isnan(value_of(force))) return number<X>(value_of(force));
  return value_of(force) == 0 ? number<X>(0) : x;
}

inline Interval unless_zero(const Interval& force, const Interval& x) {
  if (boost::numeric::empty(x)) return Interval::whole();
  return boost::numeric::zero_in(force) ? boost::numeric::hull(x, Interval(0.0)) : x;
}

/// Over a box in which the force may be 0 nothing is known of the derivatives, unless x is 0: x may
/// jump there.
template <std::size_t N>
Series<Interval, N> unless_zero(const Series<Interval, N>& force, Series<Interval, N> x) {
  if (is_number(x, 0.0) && !boost::numeric::empty(force.c[0])) return x;
  if (!boost::numeric::empty(force.c[0]) && !boost::numeric::zero_in(force.c[0])) return x;
  if (is_number(force, 0.0)) return Series<Interval, N>(Interval(0.0));
  x.c[0] = unless_zero(force.c[0], x.c[0]);
  for (std::size_t k = 1; k < N; ++k) x.c[k] = Interval::whole();
  return x;
}

/// The root of a sum or mean of squares, whose derivatives are given as 0 where it is 0: the root
/// is least there, so that 0 is among its slopes, as at the tip of a cone.
template <class X>
X root_of_squares(const X& sum) {
  using std::sqrt;
  return unless_zero(sum, X(sqrt(sum)));
}

}  // namespace camlaw
