// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <boost/numeric/interval.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

/// Intervals that enclose: every operation returns bounds that hold for every real number in its
/// arguments. Boost.Interval does the case analysis; this file gives it outward rounding by
/// stepping to the neighbouring double, so that the processor's rounding mode is never touched and
/// the same bits come out of every build.
namespace camlaw {

/// The next double above x; +inf and NaN stay.
inline double step_up(double x) {
  if (!(x < std::numeric_limits<double>::infinity())) return x;
  const auto bits = std::bit_cast<std::int64_t>(x + 0.0);  // + 0.0 turns -0 into +0
  if (bits == 0) return std::numeric_limits<double>::denorm_min();
  return std::bit_cast<double>(bits + (bits > 0 ? 1 : -1));
}

/// The next double below x; -inf and NaN stay.
inline double step_down(double x) { return -step_up(-x); }

namespace detail {

/// Rounding policy of Boost.Interval. Sums round exactly (the error of a sum is itself a double,
/// Knuth's TwoSum); products, quotients and roots move one step outwards unless they are exactly
/// zero; library functions move two steps, since glibc states errors of at most one unit in the
/// last place for those that formulas use (sqrt, sin, cos, tan, asin, atan, exp, log, pow).
struct OutwardRounding {
  using unprotected_rounding = OutwardRounding;

  static double sum_error(double a, double b, double sum) {
    const double b_part = sum - a;
    return (a - (sum - b_part)) + (b - b_part);
  }
  static double up(double value, bool exact) { return exact ? value : step_up(value); }
  static double down(double value, bool exact) { return exact ? value : step_down(value); }
  static double up2(double value) { return step_up(step_up(value)); }
  static double down2(double value) { return step_down(step_down(value)); }

  double add_up(double a, double b) { return up(a + b, sum_error(a, b, a + b) <= 0); }
  double add_down(double a, double b) { return down(a + b, sum_error(a, b, a + b) >= 0); }
  double sub_up(double a, double b) { return add_up(a, -b); }
  double sub_down(double a, double b) { return add_down(a, -b); }
  double mul_up(double a, double b) { return up(a * b, a == 0 || b == 0); }
  double mul_down(double a, double b) { return down(a * b, a == 0 || b == 0); }
  double div_up(double a, double b) { return up(a / b, a == 0); }
  double div_down(double a, double b) { return down(a / b, a == 0); }
  double sqrt_up(double a) { return up(std::sqrt(a), a == 0); }
  double sqrt_down(double a) { return down(std::sqrt(a), a == 0); }
  double sin_up(double a) { return std::min(1.0, up2(std::sin(a))); }
  double sin_down(double a) { return std::max(-1.0, down2(std::sin(a))); }
  double cos_up(double a) { return std::min(1.0, up2(std::cos(a))); }
  double cos_down(double a) { return std::max(-1.0, down2(std::cos(a))); }
  double tan_up(double a) { return up2(std::tan(a)); }
  double tan_down(double a) { return down2(std::tan(a)); }
  double asin_up(double a) { return up2(std::asin(a)); }
  double asin_down(double a) { return down2(std::asin(a)); }
  double acos_up(double a) { return up2(std::acos(a)); }
  double acos_down(double a) { return down2(std::acos(a)); }
  double atan_up(double a) { return up2(std::atan(a)); }
  double atan_down(double a) { return down2(std::atan(a)); }
  double exp_up(double a) { return up2(std::exp(a)); }
  double exp_down(double a) { return std::max(0.0, down2(std::exp(a))); }
  double log_up(double a) { return up2(std::log(a)); }
  double log_down(double a) { return down2(std::log(a)); }
  double sinh_up(double a) { return up2(std::sinh(a)); }
  double sinh_down(double a) { return down2(std::sinh(a)); }
  double cosh_up(double a) { return up2(std::cosh(a)); }
  double cosh_down(double a) { return std::max(1.0, down2(std::cosh(a))); }
  double tanh_up(double a) { return up2(std::tanh(a)); }
  double tanh_down(double a) { return down2(std::tanh(a)); }
  double median(double a, double b) { return std::midpoint(a, b); }
  double int_up(double a) { return std::ceil(a); }
  double int_down(double a) { return std::floor(a); }
  template <class U>
  double conv_up(const U& value) {
    return static_cast<double>(value);
  }
  template <class U>
  double conv_down(const U& value) {
    return static_cast<double>(value);
  }
};

}  // namespace detail

/// A closed interval of doubles with outward rounding.
using Interval = boost::numeric::interval<
    double, boost::numeric::interval_lib::policies<
                detail::OutwardRounding, boost::numeric::interval_lib::checking_base<double>>>;

/// Largest absolute value in the interval.
inline double magnitude(const Interval& x) {
  return std::max(std::abs(x.lower()), std::abs(x.upper()));
}

/// a / b where b may be the point 0: there nothing is known of the quotient.
inline Interval quotient(const Interval& a, const Interval& b) {
  return b.lower() == 0 && b.upper() == 0 ? Interval::whole() : a / b;
}

/// x^p for x >= 0 and a real exponent; p < 0 at x = 0 gives an infinite upper bound.
inline Interval real_power(const Interval& x, double p) {
  if (boost::numeric::empty(x)) return x;
  const double low = std::max(0.0, x.lower());
  const double high = std::max(0.0, x.upper());
  using Rounding = detail::OutwardRounding;
  if (p == 0) return Interval(1.0);
  const auto below = [&](double base) { return std::max(0.0, Rounding::down2(std::pow(base, p))); };
  const auto above = [&](double base) {
    return base == 0 && p > 0 ? 0 : Rounding::up2(std::pow(base, p));
  };
  return p > 0 ? Interval(below(low), above(high)) : Interval(below(high), above(low));
}

}  // namespace camlaw
