// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "kinematics/curves/derivatives.h"
#include "numerics/scalar/series.h"

namespace camlaw {

/// A sine drawn along the chord from (0, 0) to (1, 1), its ordinates leaning by the cotangent e:
/// y = t - e sin(2 pi t) / (2 pi), value t - sin(2 pi t) / (2 pi), |e| < 1. Finding t is Kepler's
/// equation.
template <class T>
struct InclinedSine {
  T e;

  template <class R>
  InclinedSine<R> as() const {
    return {convert<R>(e)};
  }
  template <std::size_t N>
  CurveDerivatives<T, N> derivatives(const T& y) const;
};

// ---------------------------------------------------------------------------------------------

namespace detail {

/// Root t of y = t - e sin(2 pi t) / (2 pi) as a plain number: Newton held in a bracket that
/// halves when a step leaves it.
double kepler_root(double e, double y);

/// The same in the scalar T: Newton steps from the plain root, each doubling the order of the
/// derivatives that are right.
template <class T>
T kepler_root(const T& e, const T& y) {
  using std::cos;
  using std::sin;
  T t = number<T>(kepler_root(value_of(e), value_of(y)));
  const T turn = number<T>(2) * pi<T>();
  for (int step = 0; step < 2; ++step) {
    const T residual = t - e * sin(turn * t) / turn - y;
    t = t - residual / (number<T>(1) - e * cos(turn * t));
  }
  return t;
}

/// Encloses the root for every e and y of the intervals.
Interval kepler_root(const Interval& e, const Interval& y);

}  // namespace detail

template <class T>
template <std::size_t N>
CurveDerivatives<T, N> InclinedSine<T>::derivatives(const T& y) const {
  const T t = detail::kepler_root(e, y);
  const T one = number<T>(1);
  const T turn = number<T>(2) * pi<T>();
  const auto [sine, cosine] = sincos(Series<T, N>::variable(turn * t, turn));
  const auto base = Series<T, N>::variable(t, one) - (e / turn) * sine;
  const auto height = Series<T, N>::variable(t, one) - (one / turn) * sine;
  CurveDerivatives<T, N> result;
  result[0] = height.c[0];
  // d/dy = (d/dt) / (dy/dt), one order lost with each derivative.
  const auto next = [&]<std::size_t M>(const auto& self, const Series<T, M>& f) -> void {
    if constexpr (M > 1) {
      Series<T, M - 1> rate;
      for (std::size_t k = 0; k + 1 < M; ++k) {
        rate.c[k] = number<T>(static_cast<double>(k + 1)) * base.c[k + 1];
      }
      const Series<T, M - 1> slope = derivative(f) / rate;
      result[N - (M - 1)] = slope.c[0];
      self(self, slope);
    }
  };
  next(next, height);
  return result;
}

}  // namespace camlaw
