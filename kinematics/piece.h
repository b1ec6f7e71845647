// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "kinematics/curve.h"

/// The data that a law is made of.
namespace camlaw {

/// sine * sin(frequency t) + cosine * cos(frequency t).
template <class T>
struct Harmonic {
  T sine, cosine, frequency;
};

/// amplitude * curve(rate t + shift): a shape that no polynomial or harmonic gives.
template <class T>
struct CurveTerm {
  T amplitude, rate, shift;
  PieceCurve<T> curve;
};

/// One stretch [begin, end] of a law: with t = x - origin,
///   s(x) = sum_k polynomial[k] t^k + sum of harmonics + sum of curves.
/// The origin is the family's choice: 0 keeps a printed formula's coefficients, the middle keeps
/// rounding small.
template <class T>
struct Piece {
  T begin, end;
  T origin;
  std::vector<T> polynomial;
  std::vector<Harmonic<T>> harmonics;
  std::vector<CurveTerm<T>> curves;

  /// Whether the piece is polynomial plus harmonics alone.
  bool is_data() const { return curves.empty(); }
};

/// The same piece in the scalar R (a double made a constant, or the plain number taken out).
template <class R, class T>
Piece<R> piece_as(const Piece<T>& piece) {
  Piece<R> result{
      convert<R>(piece.begin), convert<R>(piece.end), convert<R>(piece.origin), {}, {}, {}};
  for (const T& c : piece.polynomial) result.polynomial.push_back(convert<R>(c));
  for (const auto& h : piece.harmonics) {
    result.harmonics.push_back({convert<R>(h.sine), convert<R>(h.cosine), convert<R>(h.frequency)});
  }
  for (const auto& c : piece.curves) {
    result.curves.push_back(
        {convert<R>(c.amplitude), convert<R>(c.rate), convert<R>(c.shift), curve_as<R>(c.curve)});
  }
  return result;
}

namespace detail {

/// Adds sum_k c[k] t^k and its derivatives to d (Horner on all derivatives at once).
template <class R, std::size_t N, class T>
void add_polynomial(const std::vector<T>& coefficients, const R& t, std::array<R, N>& d) {
  if (coefficients.empty()) return;
  std::array<R, N> taylor;
  taylor.fill(number<R>(0));
  for (std::size_t i = coefficients.size(); i-- > 0;) {
    for (std::size_t k = N - 1; k > 0; --k) taylor[k] = taylor[k] * t + taylor[k - 1];
    taylor[0] = taylor[0] * t + convert<R>(coefficients[i]);
  }
  double factorial = 1;
  for (std::size_t k = 0; k < N; ++k) {
    d[k] = d[k] + number<R>(factorial) * taylor[k];
    factorial *= static_cast<double>(k + 1);
  }
}

template <class R, std::size_t N, class T>
void add_harmonic(const Harmonic<T>& harmonic, const R& t, std::array<R, N>& d) {
  using std::cos;
  using std::sin;
  const R frequency = convert<R>(harmonic.frequency);
  const R angle = frequency * t;
  const R sine = sin(angle);
  const R cosine = cos(angle);
  R a = convert<R>(harmonic.sine);
  R b = convert<R>(harmonic.cosine);
  for (std::size_t k = 0; k < N; ++k) {
    d[k] = d[k] + a * sine + b * cosine;
    const R a_next = -(frequency * b);  // d/dt turns (a, b) into (-w b, w a)
    b = frequency * a;
    a = a_next;
  }
}

template <class R, std::size_t N, class T>
void add_curve(const CurveTerm<T>& term, const R& t, std::array<R, N>& d) {
  static_assert(N <= kCurveOrders, "a curve gives kCurveOrders derivatives at most");
  const R rate = convert<R>(term.rate);
  const R y = rate * t + convert<R>(term.shift);
  const auto values = std::visit(
      [&](const auto& shape) { return shape.template as<R>().template derivatives<N>(y); },
      term.curve);
  R factor = convert<R>(term.amplitude);
  for (std::size_t k = 0; k < N; ++k) {
    // Where powers grow without bound together the lowest, which comes first, has the last word.
    if (!std::is_same_v<R, double> || !std::isinf(value_of(d[k]))) d[k] = d[k] + factor * values[k];
    factor = factor * rate;
  }
}

}  // namespace detail

/// {s, s', s'', ...}: the first N derivatives of the piece's formula at x, which need not lie in
/// [begin, end]. R is the scalar of the result; coefficients or x are made constants as needed.
template <std::size_t N, class T, class X, class R = Joined<T, X>>
std::array<R, N> derivatives(const Piece<T>& piece, const X& x) {
  std::array<R, N> d;
  d.fill(number<R>(0));
  const R t = convert<R>(x) - convert<R>(piece.origin);
  detail::add_polynomial(piece.polynomial, t, d);
  for (const auto& harmonic : piece.harmonics) detail::add_harmonic(harmonic, t, d);
  if constexpr (N <= kCurveOrders) {
    for (const auto& term : piece.curves) detail::add_curve(term, t, d);
  } else if (!piece.curves.empty()) {
    d.fill(number<R>(std::numeric_limits<double>::quiet_NaN()));  // curves do not give so many
  }
  return d;
}

}  // namespace camlaw
