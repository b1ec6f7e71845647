// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "numerics/scalar/series.h"

/// The few displacement shapes that are not polynomial plus harmonics, as functions of one
/// variable y with all derivatives. Equations: docs/theory.md, "Curves".
namespace camlaw {

/// Derivatives that a curve can give, its value included: as many of them as are asked for.
inline constexpr std::size_t kCurveOrders = 12;

/// The first N of a curve, N up to kCurveOrders.
template <class T, std::size_t N>
using CurveDerivatives = std::array<T, N>;

// ---------------------------------------------------------------------------------------------

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

/// The square root; of dual numbers that do not move, at 0 too, it does not move either.
template <class T>
T still_root(const T& x) {
  using std::sqrt;
  return sqrt(x);
}
template <class T, int N>
ceres::Jet<T, N> still_root(const ceres::Jet<T, N>& x) {
  ceres::Jet<T, N> result(still_root(x.a));
  const T slope = number<T>(0.5) / result.a;
  for (int i = 0; i < N; ++i) result.v[i] = is_number(x.v[i], 0) ? x.v[i] : slope * x.v[i];
  return result;
}

/// The half-ellipse's height sqrt(1 - y^2), as a product: no cancellation near the ends.
template <class T>
T ellipse_height(const T& y) {
  return still_root((number<T>(1) - y) * (number<T>(1) + y));
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

// ---------------------------------------------------------------------------------------------

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

// ---------------------------------------------------------------------------------------------

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

// ---------------------------------------------------------------------------------------------

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

// ---------------------------------------------------------------------------------------------

template <class T>
using PieceCurve = std::variant<HalfEllipse<T>, Ellipse<T>, InclinedSine<T>, Power<T>>;

/// The same curve in another scalar.
template <class R, class T>
PieceCurve<R> curve_as(const PieceCurve<T>& curve) {
  return std::visit([](const auto& shape) -> PieceCurve<R> { return shape.template as<R>(); },
                    curve);
}

}  // namespace camlaw
