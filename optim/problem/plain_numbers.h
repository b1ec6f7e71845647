// SPDX-License-Identifier: MIT
#pragma once

#include <ceres/jet.h>

#include <type_traits>

/// Lets formulas mix plain numbers with second-order dual numbers, as ceres::Jet does for
/// first-order ones: 2.0 * u[0] + 1.0. The operators stand in ceres, where they are found by the
/// argument.
namespace ceres {

template <class T, int M, int N>
using SecondOrder = Jet<Jet<T, M>, N>;

template <class T, int M, int N>
SecondOrder<T, M, N> operator+(const SecondOrder<T, M, N>& f, double c) {
  return f + Jet<T, M>(T(c));
}
template <class T, int M, int N>
SecondOrder<T, M, N> operator+(double c, const SecondOrder<T, M, N>& f) {
  return f + Jet<T, M>(T(c));
}
template <class T, int M, int N>
SecondOrder<T, M, N> operator-(const SecondOrder<T, M, N>& f, double c) {
  return f - Jet<T, M>(T(c));
}
template <class T, int M, int N>
SecondOrder<T, M, N> operator-(double c, const SecondOrder<T, M, N>& f) {
  return Jet<T, M>(T(c)) - f;
}
template <class T, int M, int N>
SecondOrder<T, M, N> operator*(const SecondOrder<T, M, N>& f, double c) {
  return f * Jet<T, M>(T(c));
}
template <class T, int M, int N>
SecondOrder<T, M, N> operator*(double c, const SecondOrder<T, M, N>& f) {
  return f * Jet<T, M>(T(c));
}
template <class T, int M, int N>
SecondOrder<T, M, N> operator/(const SecondOrder<T, M, N>& f, double c) {
  return f / Jet<T, M>(T(c));
}
template <class T, int M, int N>
SecondOrder<T, M, N> operator/(double c, const SecondOrder<T, M, N>& f) {
  return Jet<T, M>(T(c)) / f;
}

}  // namespace ceres

namespace camlaw::optim {

/// A plain number as the scalar of a formula, for where an operator will not do.
template <class T>
T constant(double c) {
  if constexpr (std::is_constructible_v<T, double>) {
    return T(c);
  } else {
    return T(constant<typename T::Scalar>(c));
  }
}

}  // namespace camlaw::optim
