// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "numerics/scalar/series.h"

namespace camlaw {

/// x where the condition is above 0, elsewhere not a number. Over intervals: what x is where the
/// condition may be above 0.
template <class T>
T where_positive(const T& condition, const T& x) {
  return value_of(condition) > 0 ? x : number<T>(std::numeric_limits<double>::quiet_NaN());
}

inline Interval where_positive(const Interval& condition, const Interval& x) {
  const bool nowhere = boost::numeric::empty(condition) || condition.upper() <= 0;
  return nowhere ? number<Interval>(std::numeric_limits<double>::quiet_NaN()) : x;
}

/// Where the condition may hold on a part of the box alone, nothing is known of the slopes.
template <std::size_t N>
Series<Interval, N> where_positive(const Series<Interval, N>& condition,
                                   const Series<Interval, N>& x) {
  if (condition.c[0].lower() > 0) return x;
  Series<Interval, N> result(where_positive(condition.c[0], x.c[0]));
  for (std::size_t k = 1; k < N; ++k) result.c[k] = Interval::whole();
  return result;
}

}  // namespace camlaw
