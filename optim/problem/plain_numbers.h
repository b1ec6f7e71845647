// SPDX-License-Identifier: MIT
#pragma once

#include <ceres/jet.h>

#include <type_traits>

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

/// Lets formulas mix plain numbers with dual numbers over something else than plain numbers (dual
/// numbers of second order, of intervals), as ceres::Jet does for Jet<double, N>: 2.0 * u[0] + 1.0.
/// The operators stand in ceres, where they are found by the argument.
namespace ceres {

template <class T>
concept NotPlain = !std::is_arithmetic_v<T>;

template <NotPlain T, int N>
Jet<T, N> operator+(const Jet<T, N>& f, double c) {
  return f + camlaw::optim::constant<T>(c);
}
template <NotPlain T, int N>
Jet<T, N> operator+(double c, const Jet<T, N>& f) {
  return camlaw::optim::constant<T>(c) + f;
}
template <NotPlain T, int N>
Jet<T, N> operator-(const Jet<T, N>& f, double c) {
  return f - camlaw::optim::constant<T>(c);
}
template <NotPlain T, int N>
Jet<T, N> operator-(double c, const Jet<T, N>& f) {
  return camlaw::optim::constant<T>(c) - f;
}
template <NotPlain T, int N>
Jet<T, N> operator*(const Jet<T, N>& f, double c) {
  return f * camlaw::optim::constant<T>(c);
}
template <NotPlain T, int N>
Jet<T, N> operator*(double c, const Jet<T, N>& f) {
  return camlaw::optim::constant<T>(c) * f;
}
template <NotPlain T, int N>
Jet<T, N> operator/(const Jet<T, N>& f, double c) {
  return f / camlaw::optim::constant<T>(c);
}
template <NotPlain T, int N>
Jet<T, N> operator/(double c, const Jet<T, N>& f) {
  return camlaw::optim::constant<T>(c) / f;
}

}  // namespace ceres
