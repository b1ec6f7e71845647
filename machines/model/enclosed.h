// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

#include "numerics/scalar/series.h"
#include "optim/problem/function.h"

namespace camlaw::problems {

/// Both hold; what is not a number says nothing.
inline Interval both(const Interval& a, const Interval& b) {
  const auto higher = [](double p, double q) { return p >= q || std::isnan(q) ? p : q; };
  const auto lower = [](double p, double q) { return p <= q || std::isnan(q) ? p : q; };
  Interval result;
  result.assign(higher(a.lower(), b.lower()), lower(a.upper(), b.upper()));
  return result;
}

/// Bounds as an interval; infinite ones too.
inline Interval interval_of(const optim::Bounds& bounds) {
  Interval result;
  result.assign(bounds.lower, bounds.upper);
  return result;
}

/// What is known of a value that exists where a condition is 0 or above.
template <std::size_t N>
Series<Interval, N> known_where(const Interval& condition, Series<Interval, N> value) {
  // Rounding of the condition at its edge, where the formula still has its value.
  constexpr double kRounding = 1e-12;
  if (condition.lower() >= -kRounding * magnitude(condition)) return value;
  for (Interval& c : value.c) c = Interval::whole();
  return value;
}

/// What a series proves of a curve's value, slope and half its second derivative; its own argument
/// grows by 1 where the curve's place grows by `length`.
inline std::array<optim::Bounds, 3> by_place(const Series<Interval, 3>& series,
                                             const Interval& length) {
  std::array<optim::Bounds, 3> result;
  Interval divisor(1.0);
  for (std::size_t k = 0; k < 3; ++k) {
    const Interval own = both(Interval::whole(), series.c[k] / divisor);
    result[k] = {own.lower(), own.upper()};
    divisor *= length;
  }
  return result;
}

/// Bounds of a function f over a stretch (docs/theory.md, "Bounds of a law over an interval"): from
/// its series over the whole stretch, its values at the two ends where it is monotone and has both,
/// else from f(c) + f'(c) h + h^2 f'' / 2, all h within the radius of the middle c. low() and
/// high() -> Interval, middle() -> Series<Interval, 2>.
template <class Low, class High, class Middle>
optim::Bounds enclosed(const Series<Interval, 3>& over, double radius, const Low& low,
                       const High& high, const Middle& middle) {
  Interval range = both(Interval::whole(), over.c[0]);
  const bool has_value = !boost::numeric::empty(over.c[0]);  // else a slope of 0 says nothing
  if (has_value && (over.c[1].lower() >= 0 || over.c[1].upper() <= 0)) {
    const Interval first = low(), last = high();
    const bool has_ends = !boost::numeric::empty(first) && !boost::numeric::empty(last);
    if (has_ends) range = both(range, boost::numeric::hull(first, last));
  } else {
    const Series<Interval, 2> at = middle();
    const Interval bend = over.c[2] * Interval(0, step_up(radius * radius));
    range = both(range, at.c[0] + at.c[1] * Interval(-radius, radius) + bend);
  }
  return {range.lower(), range.upper()};
}

}  // namespace camlaw::problems
