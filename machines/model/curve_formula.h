// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "kinematics/law.h"
#include "numerics/scalar/series.h"

namespace camlaw::problems {

/// A motion as Taylor series along x.
template <class T, std::size_t N>
using MotionSeries = Motion<Series<T, N>>;

/// A follower's motion at a place of the law: what formulas of curves are given.
template <class X>
struct PlaceOf {
  Motion<X> motion;
  X x;  ///< the place in the whole cycle, from 0 to 1
};
template <class T, std::size_t N>
using PlaceSeries = PlaceOf<Series<T, N>>;

/// The same at many places, a row for each number.
struct PlaceRows {
  std::vector<double> s, v, a, j, x;
};

/// A curve's formula with the machine of one design worked in: from the follower's motion to the
/// response, in every scalar that a trace needs.
class CurveFormula {
 public:
  virtual ~CurveFormula() = default;
  /// Whether the curve goes to infinity with a pulse of the acceleration or the jerk. Of a formula
  /// that a file states nothing is known there.
  virtual bool follows_pulse() const = 0;
  virtual Series<double, 3> plain(const PlaceSeries<double, 3>& place) const = 0;
  /// The value alone at each of many places.
  virtual std::vector<double> values(const PlaceRows& places) const = 0;
  virtual Series<Interval, 1> enclosed(const PlaceSeries<Interval, 1>& place) const = 0;
  virtual Series<Interval, 2> enclosed(const PlaceSeries<Interval, 2>& place) const = 0;
  virtual Series<Interval, 3> enclosed(const PlaceSeries<Interval, 3>& place) const = 0;
};

/// Series of s, v, a, j from the derivatives of s by x.
template <std::size_t N, class T, std::size_t M>
MotionSeries<T, N> motion_series(const std::array<T, M>& d) {
  static_assert(M >= N + 3);
  const auto series = [&](std::size_t order) {
    Series<T, N> result(d[order]);
    double factorial = 1;
    for (std::size_t k = 1; k < N; ++k) {
      factorial *= static_cast<double>(k);
      result.c[k] = d[order + k] / number<T>(factorial);
    }
    return result;
  };
  return {series(0), series(1), series(2), series(3)};
}

}  // namespace camlaw::problems
