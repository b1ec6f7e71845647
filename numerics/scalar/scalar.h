// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>

#include "numerics/scalar/interval.h"

namespace ceres {
template <typename T, int N>
struct Jet;
}

/// The scalars that laws and mechanisms are generic in.
///
///   double     speed
///   Dual       value and gradient (ceres::Jet), Dual2 value, gradient and Hessian (nested):
///              include numerics/scalar/dual.h to make one; a law by itself needs no Ceres
///   Interval   enclosure (numerics/scalar/interval.h)
///
/// Any other type with + - * / and sqrt, sin, cos found by argument-dependent lookup joins by
/// specialising ScalarTraits; it must be default-constructible, and need not convert to double by
/// itself.
namespace camlaw {

/// Directions carried by one pass of Dual.
inline constexpr int kDualWidth = 4;
using Dual = ceres::Jet<double, kDualWidth>;
using Dual2 = ceres::Jet<Dual, kDualWidth>;

template <class T>
struct ScalarTraits;

template <>
struct ScalarTraits<double> {
  static double number(double x) { return x; }
  static double value(double x) { return x; }
  static double pi() { return std::numbers::pi; }
  static bool is_number(double x, double c) { return x == c; }
};

template <>
struct ScalarTraits<Interval> {
  static Interval number(double x) { return Interval(x); }
  static double value(const Interval& x) { return boost::numeric::median(x); }
  /// The double nearest to pi lies below it.
  static Interval pi() { return Interval(std::numbers::pi, step_up(std::numbers::pi)); }
  static bool is_number(const Interval& x, double c) { return x.lower() == c && x.upper() == c; }
};

template <class T, int N>
struct ScalarTraits<ceres::Jet<T, N>> {
  using Jet = ceres::Jet<T, N>;
  static Jet number(double x) { return Jet(ScalarTraits<T>::number(x)); }
  static double value(const Jet& x) { return ScalarTraits<T>::value(x.a); }
  static Jet pi() { return Jet(ScalarTraits<T>::pi()); }
  static bool is_number(const Jet& x, double c) {
    bool constant = ScalarTraits<T>::is_number(x.a, c);
    for (int i = 0; i < N; ++i) constant = constant && ScalarTraits<T>::is_number(x.v[i], 0.0);
    return constant;
  }
};

/// A constant as a T.
template <class T>
T number(double x) {
  return ScalarTraits<T>::number(x);
}

/// p / q as a T; encloses the fraction when T is Interval.
template <class T>
T ratio(double p, double q) {
  return number<T>(p) / number<T>(q);
}

template <class T>
T pi() {
  return ScalarTraits<T>::pi();
}

/// The plain number behind a scalar (the midpoint of an interval), for decisions only.
template <class T>
double value_of(const T& x) {
  return ScalarTraits<T>::value(x);
}

/// Whether x is exactly the constant c, with no derivative part and no width.
template <class T>
bool is_number(const T& x, double c) {
  return ScalarTraits<T>::is_number(x, c);
}

/// x carried into the scalar R: the same type, or a double made a constant.
template <class R, class T>
R convert(const T& x) {
  if constexpr (std::is_same_v<R, T>) {
    return x;
  } else if constexpr (std::is_same_v<T, double>) {
    return number<R>(x);
  } else {
    static_assert(std::is_same_v<R, double>, "only the plain number can be taken out of a scalar");
    return value_of(x);
  }
}

/// The scalar of an expression that joins T and X, of which one is double or both are the same.
template <class T, class X>
using Joined = std::conditional_t<std::is_same_v<T, double>, X, T>;

/// a / b; for intervals defined at b = 0 too (numerics/scalar/interval.h).
template <class T>
T quotient(const T& a, const T& b) {
  return a / b;
}

/// What a function makes of a number that does not move does not move either, where its slope has
/// no bound: 0 times that would not be a number.
template <class T>
T unmoved(const T& /*of*/, const T& result) {
  return result;
}
template <class T, int N>
ceres::Jet<T, N> unmoved(const ceres::Jet<T, N>& of, ceres::Jet<T, N> result) {
  result.a = unmoved(of.a, result.a);
  for (int i = 0; i < N; ++i) {
    if (is_number(of.v[i], 0)) result.v[i] = of.v[i];
  }
  return result;
}

/// x^p for x >= 0 and a plain exponent.
inline double real_power(double x, double p) { return std::pow(x, p); }

template <class T, int N>
ceres::Jet<T, N> real_power(const ceres::Jet<T, N>& x, double p) {
  ceres::Jet<T, N> result(real_power(x.a, p));
  if (p == 0) return result;
  const T slope = number<T>(p) * real_power(x.a, p - 1);
  for (int i = 0; i < N; ++i) result.v[i] = slope * x.v[i];
  return unmoved(x, std::move(result));
}

/// x to a whole power by multiplication.
template <class T>
T integer_power(const T& x, int exponent) {
  T result = number<T>(1);
  for (int i = 0; i < exponent; ++i) result = result * x;
  return result;
}

}  // namespace camlaw
