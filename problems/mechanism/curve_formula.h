// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>

#include "kinematics/law.h"
#include "kinematics/series.h"

namespace camlaw::problems {

/// A motion as Taylor series along x.
template <class T, std::size_t N>
using MotionSeries = Motion<Series<T, N>>;

/// A curve's formula with the machine of one design worked in: from the follower's motion to the
/// response, in every scalar that a trace needs.
class CurveFormula {
 public:
  virtual ~CurveFormula() = default;
  virtual Series<double, 3> operator()(const MotionSeries<double, 3>& motion) const = 0;
  virtual Series<Interval, 1> operator()(const MotionSeries<Interval, 1>& motion) const = 0;
  virtual Series<Interval, 2> operator()(const MotionSeries<Interval, 2>& motion) const = 0;
  virtual Series<Interval, 3> operator()(const MotionSeries<Interval, 3>& motion) const = 0;
};

/// The same from two generic callables, one with the machine in double, one in Interval.
template <class Plain, class Enclosing>
class GenericCurveFormula final : public CurveFormula {
 public:
  GenericCurveFormula(Plain plain, Enclosing enclosing)
      : plain_(std::move(plain)), enclosing_(std::move(enclosing)) {}

  Series<double, 3> operator()(const MotionSeries<double, 3>& motion) const override {
    return plain_(motion);
  }
  Series<Interval, 1> operator()(const MotionSeries<Interval, 1>& motion) const override {
    return enclosing_(motion);
  }
  Series<Interval, 2> operator()(const MotionSeries<Interval, 2>& motion) const override {
    return enclosing_(motion);
  }
  Series<Interval, 3> operator()(const MotionSeries<Interval, 3>& motion) const override {
    return enclosing_(motion);
  }

 private:
  Plain plain_;
  Enclosing enclosing_;
};

/// Series of s, v, a, j from the derivatives of s by x.
template <std::size_t N, class T, std::size_t M>
MotionSeries<T, N> motion_series(const std::array<T, M>& d) {
  static_assert(N <= 3 && M >= N + 3);
  const auto series = [&](std::size_t k) {
    Series<T, N> result(d[k]);
    if constexpr (N > 1) result.c[1] = d[k + 1];
    if constexpr (N > 2) result.c[2] = 0.5 * d[k + 2];
    return result;
  };
  return {series(0), series(1), series(2), series(3)};
}

}  // namespace camlaw::problems
