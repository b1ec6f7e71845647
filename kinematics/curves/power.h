// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/curves/derivatives.h"

namespace camlaw {

/// y^p for y >= 0 and a real exponent p >= 2.
template <class T>
struct Power {
  double exponent = 2;

  template <class R>
  Power<R> as() const {
    return {exponent};
  }
  template <std::size_t N>
  CurveDerivatives<T, N> derivatives(const T& y) const;
};

template <class T>
template <std::size_t N>
CurveDerivatives<T, N> Power<T>::derivatives(const T& y) const {
  CurveDerivatives<T, N> result;
  T factor = number<T>(1);
  for (std::size_t k = 0; k < N; ++k) {
    const double rest = exponent - static_cast<double>(k);
    result[k] = is_number(factor, 0) ? factor : factor * real_power(y, rest);
    factor = rest == 0 ? number<T>(0) : factor * number<T>(rest);
  }
  return result;
}

}  // namespace camlaw
