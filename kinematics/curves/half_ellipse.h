// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "kinematics/curves/derivatives.h"

namespace camlaw {

/// The half-ellipse sqrt(1 - y^2) integrated `integrations` times (1 or 2) from y = -1,
/// for y in [-1, 1]. Derivatives grow without bound at y = -1 and y = 1.
template <class T>
struct HalfEllipse {
  int integrations = 1;

  template <class R>
  HalfEllipse<R> as() const {
    return {integrations};
  }
  template <std::size_t N>
  CurveDerivatives<T, N> derivatives(T y) const;
};

// ---------------------------------------------------------------------------------------------

namespace detail {

/// y held in [-1, 1]: rounding in the map from x to y may step over the end of the ellipse.
inline double on_ellipse(double y) { return std::isnan(y) ? y : std::clamp(y, -1.0, 1.0); }
inline Interval on_ellipse(const Interval& y) {
  if (boost::numeric::empty(y)) return y;
  return {on_ellipse(y.lower()), on_ellipse(y.upper())};
}
template <class T>
T on_ellipse(const T& y) {
  const double excess = value_of(y) - on_ellipse(value_of(y));
  return excess == 0 ? y : y - number<T>(excess);
}

/// A rising function with a known slope, in any scalar: intervals by their ends, dual numbers by
/// the chain rule, which keeps derivatives finite where the parts of the formula have none.
template <class F>
double rising(const F& f, double y) {
  return f.value(y);
}
template <class F>
Interval rising(const F& f, const Interval& y) {
  return boost::numeric::hull(f.value(Interval(y.lower())), f.value(Interval(y.upper())));
}
template <class F, class T, int N>
ceres::Jet<T, N> rising(const F& f, const ceres::Jet<T, N>& y) {
  ceres::Jet<T, N> result(rising(f, y.a));
  const T slope = f.slope(y.a);
  for (int i = 0; i < N; ++i) result.v[i] = slope * y.v[i];
  return result;
}
template <class F, class T>
T rising(const F& f, const T& y) {
  return f.value(y);
}

/// The half-ellipse's height sqrt(1 - y^2), as a product: no cancellation near the ends.
template <class T>
T ellipse_height(const T& y) {
  using std::sqrt;
  return sqrt((number<T>(1) - y) * (number<T>(1) + y));
}

/// All derivatives of the height h: with w = 1 - y^2, h^(k) = -P_k(y) w^(1/2 - k), where P_1 = y
/// and P_(k+1) = w P_k' + (2 k - 1) y P_k has no negative coefficient: bounds stay sharp near the
/// ends.
template <std::size_t N, class T>
CurveDerivatives<T, N> ellipse_height_derivatives(const T& y) {
  const T w = (number<T>(1) - y) * (number<T>(1) + y);
  CurveDerivatives<T, N> result;
  result[0] = ellipse_height(y);
  std::array<double, N + 1> p{};  // coefficients of P_k
  p[1] = 1;
  for (std::size_t k = 1; k < N; ++k) {
    T sum = number<T>(0);
    for (std::size_t i = k + 1; i-- > 0;) sum = sum * y + number<T>(p[i]);
    result[k] = -(sum * real_power(w, 0.5 - static_cast<double>(k)));
    std::array<double, N + 1> next{};
    for (std::size_t i = 0; i + 1 < N; ++i) {
      const double power = static_cast<double>(i);
      if (i > 0) next[i - 1] += power * p[i];
      next[i + 1] += (2 * static_cast<double>(k) - 1 - power) * p[i];
    }
    p = next;
  }
  return result;
}

/// The area under it from -1 on.
struct EllipseArea {
  template <class T>
  T value(const T& y) const {
    using std::asin;
    const T half_pi = pi<T>() / number<T>(2);
    return (y * ellipse_height(y) + asin(y) + half_pi) / number<T>(2);
  }
  template <class T>
  T slope(const T& y) const {
    return ellipse_height(y);
  }
};

/// The area's own integral from -1 on.
struct EllipseMoment {
  template <class T>
  T value(const T& y) const {
    using std::asin;
    const T r = ellipse_height(y);
    const T half_pi = pi<T>() / number<T>(2);
    return (r - r * r * r / number<T>(3) + y * (asin(y) + half_pi)) / number<T>(2);
  }
  template <class T>
  T slope(const T& y) const {
    return rising(EllipseArea{}, y);
  }
};

}  // namespace detail

template <class T>
template <std::size_t N>
CurveDerivatives<T, N> HalfEllipse<T>::derivatives(T y) const {
  y = detail::on_ellipse(y);
  CurveDerivatives<T, N> result;
  result[0] = detail::rising(detail::EllipseArea{}, y);
  std::size_t filled = 1;
  if (integrations == 2) {
    if constexpr (N > 1) result[1] = result[0];
    result[0] = detail::rising(detail::EllipseMoment{}, y);
    filled = 2;
  }
  const auto height = detail::ellipse_height_derivatives<N>(y);
  for (std::size_t k = filled; k < N; ++k) result[k] = height[k - filled];
  return result;
}

}  // namespace camlaw
