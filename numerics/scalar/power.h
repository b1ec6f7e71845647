// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

#include "numerics/scalar/series.h"

/// Powers with an exponent that is a plain number. Those with an integer exponent exist for every
/// base (0 with a negative exponent gives infinity), others for bases of 0 and above.
namespace camlaw {

/// Whether an exponent is an integer that powers are multiplied out for over intervals.
inline bool is_integer_exponent(double p) { return p == std::floor(p) && std::abs(p) <= 1000; }

template <class T>
T power(const T& x, double p) {
  return real_power(x, p);
}

inline Interval power(const Interval& x, double p) {
  if (boost::numeric::empty(x)) return x;
  if (p == 0) return Interval(1.0);
  if (!is_integer_exponent(p)) {
    return x.upper() < 0 ? number<Interval>(std::numeric_limits<double>::quiet_NaN())
                         : real_power(x, p);
  }
  const Interval result = boost::numeric::pow(x, static_cast<int>(std::abs(p)));
  return p < 0 ? quotient(Interval(1.0), result) : result;
}

/// Whether f^p may jump over a box, or have an edge there: at a pole, and where an exponent that is
/// not an integer meets bases below 0.
inline bool may_break(const Interval& base, double p) {
  if (p >= 0 && is_integer_exponent(p)) return false;
  return p < 0 ? base.lower() <= 0 && base.upper() >= 0 : base.lower() < 0;
}
/// x^(p - n), of the exponent itself: of an interval not that of the double beside p - n.
template <class T>
T power_less(const T& x, double p, int n) {
  if constexpr (std::is_same_v<T, Interval>) {
    const Interval exponent = Interval(p) - Interval(n);
    if (exponent.lower() != exponent.upper()) {
      return boost::numeric::hull(power(x, exponent.lower()), power(x, exponent.upper()));
    }
  }
  return power(x, p - n);
}

/// Adds the terms from the third on to a power that has those before: those are, of the k-th term
/// of f^p = sum_m binom(p, m) f(0)^(p-m) (f - f(0))^m, the summands of every m.
template <class T, std::size_t N>
void add_higher_terms(const Series<T, N>& f, double p, Series<T, N>& result) {
  Series<T, N> rest = f, power_of_rest;
  rest.c[0] = number<T>(0);
  power_of_rest.c[0] = number<T>(1);
  T binomial = number<T>(1);
  for (int m = 1; m < static_cast<int>(N); ++m) {
    const double left = p - (m - 1);
    if (left == 0) return;  // of p = m - 1, an integer, no more
    binomial = binomial * (number<T>(p) - number<T>(m - 1)) / number<T>(m);
    power_of_rest = power_of_rest * rest;
    const T factor = binomial * power_less(f.c[0], p, m);
    for (std::size_t k = 3; k < N; ++k) {
      result.c[k] = result.c[k] + factor * power_of_rest.c[k];
    }
  }
}

/// By the derivatives p f^(p-1), p (p-1) f^(p-2), ... of a power, which exist at 0 too where p
/// leaves them. Over a box in which the power may break nothing is known of the derivatives: a
/// slope of one sign would say that it runs through.
template <class T, std::size_t N>
Series<T, N> power(const Series<T, N>& f, double p) {
  Series<T, N> result(power(f.c[0], p));
  if (p == 0) return result;
  if constexpr (std::is_same_v<T, Interval>) {
    if (may_break(f.c[0], p)) {
      for (std::size_t k = 1; k < N; ++k) result.c[k] = Interval::whole();
      return result;
    }
  }
  const T slope = number<T>(p) * power_less(f.c[0], p, 1);
  if constexpr (N > 1) result.c[1] = slope * f.c[1];
  if constexpr (N > 2) {
    result.c[2] = slope * f.c[2];
    if (p != 1) {
      const T factor = number<T>(p) * (number<T>(p) - number<T>(1)) / number<T>(2);
      result.c[2] = result.c[2] + factor * power_less(f.c[0], p, 2) * f.c[1] * f.c[1];
    }
  }
  if constexpr (N > 3) add_higher_terms(f, p, result);
  return result;
}

}  // namespace camlaw
