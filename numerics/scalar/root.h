// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

#include "numerics/scalar/series.h"

/// Roots of formulas that depend on a machine: found in plain numbers, then carried into the scalar
/// of the machine (docs/theory.md, "Roots").
namespace camlaw {

/// The root of f between low and high, where it has opposite signs, by bisection and secants
/// (Illinois). NaN where it has not.
template <class F>
double root_between(const F& f, double low, double high) {
  double f_low = f(low), f_high = f(high);
  if (!(f_low * f_high <= 0)) return std::numeric_limits<double>::quiet_NaN();
  int side = 0;
  for (int i = 0; i < 200 && std::abs(high - low) > 1e-15 * (1 + std::abs(low)); ++i) {
    if (f_low == f_high) return low;
    const double secant = (low * f_high - high * f_low) / (f_high - f_low);
    // Every fourth step halves, so that the bracket shrinks whatever the secants do.
    const double x = i % 4 == 3 || !(secant > low && secant < high) ? (low + high) / 2 : secant;
    const double value = f(x);
    if (value == 0) return x;
    if (value * f_high > 0) {
      high = x, f_high = value;
      if (side == -1) f_low /= 2;
      side = -1;
    } else {
      low = x, f_low = value;
      if (side == 1) f_high /= 2;
      side = 1;
    }
    if (x == low && x == high) break;
  }
  return (low + high) / 2;
}

/// The root between low and high of f, which is continuous there; of several the one where level is
/// highest, the first of equals. The signs of f at the ends of equal cells tell where roots are:
/// two in one cell are not seen. NaN where there is none. f(x), level(x) -> double.
template <class F, class Level>
double root_of(double low, double high, const F& f, const Level& level) {
  constexpr int kCells = 96;  // each takes a value of f; two roots in one cell are not seen
  double root = std::numeric_limits<double>::quiet_NaN(), highest = root;
  const auto take = [&](double x) {
    const double its = level(x);
    if (std::isnan(root) || its > highest) root = x, highest = its;
  };
  double at = low, here = f(low);
  if (here == 0) take(low);
  for (int i = 1; i <= kCells; ++i) {
    const double next = i == kCells ? high : low + (high - low) * i / kCells, there = f(next);
    if ((here < 0 && there >= 0) || (here > 0 && there <= 0)) take(root_between(f, at, next));
    at = next, here = there;
  }
  return root;
}

/// A root of f near x0, which is one in plain numbers, in the scalar of f: with the derivatives by
/// whatever f depends on (two Newton steps with the slope at x0 carry the first two orders), or,
/// for intervals, a range that holds it, by the interval Newton step; NaN where none is found, and
/// for series of intervals. f(X) -> X; the slope is asked at the double x0, for intervals over a
/// range.
template <class T, class F, class Slope>
T root_near(double x0, const F& f, const Slope& slope) {
  if constexpr (std::is_same_v<T, double>) {
    return x0;
  } else if constexpr (std::is_same_v<T, Interval>) {
    const Interval middle(x0);
    for (double radius = 1e-15 * (1 + std::abs(x0)); radius < 1e-6; radius *= 8) {
      const Interval range = middle + Interval(-radius, radius);
      const Interval rate = slope(range);
      if (!(rate.lower() > 0 || rate.upper() < 0)) break;
      const Interval newton = middle - f(middle) / rate;
      if (newton.lower() >= range.lower() && newton.upper() <= range.upper()) return newton;
    }
    return number<Interval>(std::numeric_limits<double>::quiet_NaN());
  } else if constexpr (is_interval_series<T>) {
    return number<T>(std::numeric_limits<double>::quiet_NaN());
  } else {
    const T rate = number<T>(slope(x0));
    T x = number<T>(x0);
    for (int step = 0; step < 2; ++step) x = x - f(x) / rate;
    return x;
  }
}

}  // namespace camlaw
