// SPDX-License-Identifier: MIT
#include "kinematics/curve.h"

namespace camlaw::detail {

double kepler_root(double e, double y) {
  const double turn = 2 * std::numbers::pi;
  const auto residual = [&](double t) { return t - e * std::sin(turn * t) / turn - y; };
  double low = y - 1.0 / 6.0;  // |t - y| <= |e| / (2 pi) < 1/6
  double high = y + 1.0 / 6.0;
  double t = y;
  // Each pass halves the bracket or takes a Newton step inside it; 100 is never reached.
  for (int pass = 0; pass < 100; ++pass) {
    const double value = residual(t);
    if (value == 0) return t;
    (value < 0 ? low : high) = t;
    double next = t - value / (1 - e * std::cos(turn * t));
    if (!(next > low && next < high)) next = std::midpoint(low, high);
    if (std::abs(next - t) <= 1e-16 * (1 + std::abs(t))) return next;
    t = next;
  }
  return t;
}

Interval kepler_root(const Interval& e, const Interval& y) {
  // t grows with y for fixed e; for fixed y it grows with e where sin(2 pi t) > 0. A bound is
  // taken at every corner and moved out until the interval residual proves it.
  const Interval turn = number<Interval>(2) * pi<Interval>();
  const auto residual = [&](double t, double target) {
    return Interval(t) - e * sin(turn * Interval(t)) / turn - Interval(target);
  };
  const double corners[] = {kepler_root(e.lower(), y.lower()), kepler_root(e.upper(), y.lower()),
                            kepler_root(e.lower(), y.upper()), kepler_root(e.upper(), y.upper())};
  double low = std::min(corners[0], corners[1]);
  double high = std::max(corners[2], corners[3]);
  double margin = 1e-15;
  while (residual(low, y.lower()).upper() > 0) low -= margin, margin *= 2;
  margin = 1e-15;
  while (residual(high, y.upper()).lower() < 0) high += margin, margin *= 2;
  return {low, high};
}

}  // namespace camlaw::detail
