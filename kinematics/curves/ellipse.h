// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/curves/derivatives.h"
#include "numerics/scalar/series.h"

namespace camlaw {

/// [1 - cos(pi y) / sqrt(1 - k sin^2(pi y))] / 2, k = (n^2 - 1) / n^2, for y in [0, 1], n > 0.
template <class T>
struct Ellipse {
  T n;

  template <class R>
  Ellipse<R> as() const {
    return {convert<R>(n)};
  }
  template <std::size_t N>
  CurveDerivatives<T, N> derivatives(const T& y) const;
};

template <class T>
template <std::size_t N>
CurveDerivatives<T, N> Ellipse<T>::derivatives(const T& y) const {
  using S = Series<T, N>;
  const T one = number<T>(1);
  const T k = one - one / (n * n);
  const auto [sine, cosine] = sincos(S::variable(pi<T>() * y, pi<T>()));
  const S shape = cosine / sqrt(S(one) - k * (sine * sine));
  return camlaw::derivatives(ratio<T>(1, 2) * (S(one) - shape));
}

}  // namespace camlaw
