// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "numerics/scalar/series.h"

/// The greater and the lesser of two numbers, in any scalar; not a number where one of them is not.
namespace camlaw {

template <class X>
X greater_of(const X& a, const X& b) {
  if (std::isnan(value_of(b))) return b;
  return value_of(a) < value_of(b) ? b : a;
}

inline Interval greater_of(const Interval& a, const Interval& b) {
  if (boost::numeric::empty(a) || boost::numeric::empty(b)) return Interval::whole();
  return {std::max(a.lower(), b.lower()), std::max(a.upper(), b.upper())};
}

/// Over a box in which either may be the greater the first derivative is within those of both,
/// which holds for difference quotients too; of the further ones nothing is known.
template <std::size_t N>
Series<Interval, N> greater_of(const Series<Interval, N>& a, const Series<Interval, N>& b) {
  if (a.c[0].lower() >= b.c[0].upper()) return a;
  if (b.c[0].lower() >= a.c[0].upper()) return b;
  Series<Interval, N> result(greater_of(a.c[0], b.c[0]));
  if constexpr (N > 1) {
    const bool known = !boost::numeric::empty(a.c[1]) && !boost::numeric::empty(b.c[1]);
    result.c[1] = known ? boost::numeric::hull(a.c[1], b.c[1]) : Interval::whole();
  }
  for (std::size_t k = 2; k < N; ++k) result.c[k] = Interval::whole();
  return result;
}

template <class X>
X lesser_of(const X& a, const X& b) {
  return -greater_of(X(-a), X(-b));
}

}  // namespace camlaw
