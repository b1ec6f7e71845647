// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "numerics/scalar/scalar.h"

namespace camlaw {

/// Truncated Taylor series c[0] + c[1] h + ... + c[N-1] h^(N-1) about some point.
///
/// Arithmetic on series carries a function's derivatives through a formula: c[k] = f^(k) / k!.
/// With T = Interval and a box for the point, each coefficient encloses f^(k) / k! over the box.
/// Recurrences: docs/theory.md, "Taylor arithmetic".
template <class T, std::size_t N>
struct Series {
  std::array<T, N> c;

  Series() { c.fill(number<T>(0)); }
  explicit Series(const T& constant) : Series() { c[0] = constant; }
  /// The identity function: value + slope * h.
  static Series variable(const T& value, const T& slope) {
    Series x(value);
    if constexpr (N > 1) x.c[1] = slope;
    return x;
  }
};

template <class T>
inline constexpr bool is_interval_series = false;
template <std::size_t N>
inline constexpr bool is_interval_series<Series<Interval, N>> = true;

/// A series as a scalar of formulas: a constant has no other terms.
template <class T, std::size_t N>
struct ScalarTraits<Series<T, N>> {
  static Series<T, N> number(double x) { return Series<T, N>(ScalarTraits<T>::number(x)); }
  static double value(const Series<T, N>& x) { return ScalarTraits<T>::value(x.c[0]); }
  static Series<T, N> pi() { return Series<T, N>(ScalarTraits<T>::pi()); }
  static bool is_number(const Series<T, N>& x, double c) {
    bool constant = ScalarTraits<T>::is_number(x.c[0], c);
    for (std::size_t k = 1; k < N; ++k) {
      constant = constant && ScalarTraits<T>::is_number(x.c[k], 0.0);
    }
    return constant;
  }
};

template <class T, std::size_t N>
Series<T, N> operator+(Series<T, N> f, const Series<T, N>& g) {
  for (std::size_t k = 0; k < N; ++k) f.c[k] = f.c[k] + g.c[k];
  return f;
}

template <class T, std::size_t N>
Series<T, N> operator-(Series<T, N> f, const Series<T, N>& g) {
  for (std::size_t k = 0; k < N; ++k) f.c[k] = f.c[k] - g.c[k];
  return f;
}

template <class T, std::size_t N>
Series<T, N> operator*(const T& factor, Series<T, N> f) {
  for (T& coefficient : f.c) coefficient = factor * coefficient;
  return f;
}

template <class T, std::size_t N>
Series<T, N> operator*(const Series<T, N>& f, const T& factor) {
  return factor * f;
}

template <class T, std::size_t N>
Series<T, N> operator/(Series<T, N> f, const T& divisor) {
  for (T& coefficient : f.c) coefficient = quotient(coefficient, divisor);
  return f;
}

template <class T, std::size_t N>
Series<T, N> operator-(Series<T, N> f) {
  for (T& coefficient : f.c) coefficient = -coefficient;
  return f;
}

template <class T, std::size_t N>
Series<T, N> operator+(Series<T, N> f, const T& constant) {
  f.c[0] = f.c[0] + constant;
  return f;
}

template <class T, std::size_t N>
Series<T, N> operator+(const T& constant, const Series<T, N>& f) {
  return f + constant;
}

template <class T, std::size_t N>
Series<T, N> operator-(Series<T, N> f, const T& constant) {
  f.c[0] = f.c[0] - constant;
  return f;
}

template <class T, std::size_t N>
Series<T, N> operator-(const T& constant, const Series<T, N>& f) {
  return -f + constant;
}

template <class T, std::size_t N>
Series<T, N> operator*(const Series<T, N>& f, const Series<T, N>& g) {
  Series<T, N> product;
  for (std::size_t k = 0; k < N; ++k) {
    product.c[k] = f.c[0] * g.c[k];
    for (std::size_t i = 1; i <= k; ++i) product.c[k] = product.c[k] + f.c[i] * g.c[k - i];
  }
  return product;
}

template <class T, std::size_t N>
Series<T, N> operator/(const Series<T, N>& f, const Series<T, N>& g) {
  Series<T, N> ratio;
  for (std::size_t k = 0; k < N; ++k) {
    T rest = f.c[k];
    for (std::size_t i = 1; i <= k; ++i) rest = rest - g.c[i] * ratio.c[k - i];
    ratio.c[k] = quotient(rest, g.c[0]);
  }
  return ratio;
}

/// Square root; where f vanishes the derivatives come out infinite, with the sign of the limit.
template <class T, std::size_t N>
Series<T, N> sqrt(const Series<T, N>& f) {
  using std::sqrt;
  Series<T, N> root;
  root.c[0] = sqrt(f.c[0]);
  const T divisor = root.c[0] + root.c[0];
  for (std::size_t k = 1; k < N; ++k) {
    T rest = f.c[k];
    for (std::size_t i = 1; i < k; ++i) rest = rest - root.c[i] * root.c[k - i];
    root.c[k] = quotient(rest, divisor);
  }
  return root;
}

/// {sin f, cos f}.
template <class T, std::size_t N>
std::pair<Series<T, N>, Series<T, N>> sincos(const Series<T, N>& f) {
  using std::cos;
  using std::sin;
  Series<T, N> sine, cosine;
  sine.c[0] = sin(f.c[0]);
  cosine.c[0] = cos(f.c[0]);
  for (std::size_t k = 1; k < N; ++k) {
    for (std::size_t i = 1; i <= k; ++i) {
      const T weight = ratio<T>(static_cast<double>(i), static_cast<double>(k)) * f.c[i];
      sine.c[k] = sine.c[k] + weight * cosine.c[k - i];
      cosine.c[k] = cosine.c[k] - weight * sine.c[k - i];
    }
  }
  return {sine, cosine};
}

template <class T, std::size_t N>
Series<T, N> sin(const Series<T, N>& f) {
  return sincos(f).first;
}

template <class T, std::size_t N>
Series<T, N> cos(const Series<T, N>& f) {
  return sincos(f).second;
}

/// F(f), where F of the constant term is `value` and slope(result) gives the series of F'(f) as far
/// as the result is known (docs/theory.md, (T6)).
template <class T, std::size_t N, class Slope>
Series<T, N> chained(const Series<T, N>& f, const T& value, const Slope& slope) {
  Series<T, N> result(value);
  for (std::size_t k = 1; k < N; ++k) {
    const Series<T, N> rate = slope(result);
    T sum = number<T>(static_cast<double>(k)) * f.c[k] * rate.c[0];
    for (std::size_t i = 1; i < k; ++i) {
      sum = sum + number<T>(static_cast<double>(i)) * f.c[i] * rate.c[k - i];
    }
    result.c[k] = sum / number<T>(static_cast<double>(k));
  }
  return result;
}

template <class T, std::size_t N>
Series<T, N> tan(const Series<T, N>& f) {
  using std::tan;
  const T one = number<T>(1);
  return chained(f, tan(f.c[0]), [&](const auto& tangent) { return one + tangent * tangent; });
}

template <class T, std::size_t N>
Series<T, N> atan(const Series<T, N>& f) {
  using std::atan;
  const T one = number<T>(1);
  const Series<T, N> slope = Series<T, N>(one) / (one + f * f);
  return chained(f, atan(f.c[0]), [&](const auto&) { return slope; });
}

template <class T, std::size_t N>
Series<T, N> log(const Series<T, N>& f) {
  using std::log;
  const Series<T, N> slope = Series<T, N>(number<T>(1)) / f;
  return chained(f, log(f.c[0]), [&](const auto&) { return slope; });
}

template <class T, std::size_t N>
Series<T, N> exp(const Series<T, N>& f) {
  using std::exp;
  return chained(f, exp(f.c[0]), [](const auto& result) { return result; });
}

template <class T, std::size_t N>
Series<T, N> asin(const Series<T, N>& f) {
  using std::asin;
  const T one = number<T>(1);
  const Series<T, N> slope = Series<T, N>(one) / sqrt((one - f) * (one + f));
  return chained(f, asin(f.c[0]), [&](const auto&) { return slope; });
}

/// f', one term shorter.
template <class T, std::size_t N>
Series<T, N - 1> derivative(const Series<T, N>& f) {
  Series<T, N - 1> slope;
  for (std::size_t k = 1; k < N; ++k) {
    slope.c[k - 1] = number<T>(static_cast<double>(k)) * f.c[k];
  }
  return slope;
}

/// The primitive of f with the given value at the point; the last term of f is not used.
template <class T, std::size_t N>
Series<T, N> integral(const Series<T, N>& f, const T& value) {
  Series<T, N> primitive(value);
  for (std::size_t k = 1; k < N; ++k) {
    primitive.c[k] = f.c[k - 1] / number<T>(static_cast<double>(k));
  }
  return primitive;
}

/// The derivatives f, f', f'', ... themselves: k! c[k].
template <class T, std::size_t N>
std::array<T, N> derivatives(Series<T, N> f) {
  double factorial = 1;
  for (std::size_t k = 2; k < N; ++k) {
    factorial *= static_cast<double>(k);
    f.c[k] = number<T>(factorial) * f.c[k];
  }
  return f.c;
}

}  // namespace camlaw
