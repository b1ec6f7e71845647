// SPDX-License-Identifier: MIT
#pragma once

#include "numerics/scalar/series.h"

namespace camlaw {

/// |x| in any scalar, of -0 too +0: a reciprocal of it is then not -infinity. At 0 it has the
/// derivatives of x itself.
template <class T>
T absolute(const T& x) {
  return value_of(x) < 0 ? -x : x + number<T>(0);
}

inline Interval absolute(const Interval& x) { return boost::numeric::abs(x); }

template <class T, std::size_t N>
Series<T, N> absolute(const Series<T, N>& f) {
  return value_of(f) < 0 ? -f : f + number<Series<T, N>>(0);
}

/// Over a box in which f may change its sign the first derivative is within plus and minus that of
/// f, which holds for difference quotients too; of the further ones, which the kink has not,
/// nothing is known.
template <std::size_t N>
Series<Interval, N> absolute(const Series<Interval, N>& f) {
  if (f.c[0].lower() >= 0) return f;
  if (f.c[0].upper() <= 0) return -f;
  Series<Interval, N> result(absolute(f.c[0]));
  if constexpr (N > 1) result.c[1] = boost::numeric::hull(f.c[1], -f.c[1]);
  for (std::size_t k = 2; k < N; ++k) result.c[k] = Interval::whole();
  return result;
}

}  // namespace camlaw
