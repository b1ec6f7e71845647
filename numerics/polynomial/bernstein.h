// SPDX-License-Identifier: MIT
#pragma once

#include <utility>
#include <vector>

#include "numerics/scalar/bounds.h"

/// Polynomials sum c[k] u^k on [-1, 1], as the peak search sees them (docs/theory.md, "Peaks"). T
/// is double or Interval.
namespace camlaw::detail {

/// Bernstein coefficients on [-1, 1] of sum c[k] u^k: they bound the polynomial, the outer two are
/// its end values, and their differences have the signs of its slope. Returns how far rounding has
/// moved them, at most: in intervals nothing, for those contain the coefficients.
template <class T>
double to_bernstein(std::vector<T>& c);

/// The course of a polynomial as its Bernstein coefficients tell it; PeakInside: a single one.
enum class Course { PeakAtEnd, PeakInside, Unknown };

/// The course of sign times the polynomial.
template <class T>
Course course(const std::vector<T>& bernstein, double sign);

/// The root in [-1, 1] of the slope of sum c[k] u^k, which falls through zero once (sign +1) or
/// rises (sign -1): Newton, bisection where Newton leaves the bracket.
double turning_point(const std::vector<double>& c, double sign);

/// Value and slope of sum c[k] u^k.
template <class T>
std::pair<T, T> value_and_slope(const std::vector<T>& c, const T& u) {
  T value(0.0), slope(0.0);
  for (std::size_t k = c.size(); k-- > 0;) {
    slope = slope * u + value;
    value = value * u + c[k];
  }
  return {value, slope};
}

}  // namespace camlaw::detail
