// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/peaks.h"

namespace camlaw {

double least_acceleration(double B) {
  if (std::isnan(B)) return B;
  if (!(B > 1)) return std::numeric_limits<double>::infinity();
  return B < 2 ? B * B / (B - 1) : 4;
}

double least_time(double B, double C, double D) {
  if (std::isnan(B + C + D)) return std::numeric_limits<double>::quiet_NaN();
  if (std::isinf(C) && std::isinf(D)) return 1 / B;
  // Time to bring velocity from 0 to v, with acceleration and jerk bounded; in it the stroke v t /
  // 2 is covered.
  const auto ramp = [&](double v) { return v >= C * C / D ? v / C + C / D : 2 * std::sqrt(v / D); };
  if (B * ramp(B) <= 1) return 1 / B + ramp(B);  // both ramps fit, the rest at velocity B
  // The velocity stays below B: v ramp(v) = 1.
  if (C * C * C * 2 >= D * D) return 2 * std::cbrt(4 / D);  // nor is C reached: 2 v sqrt(v/D) = 1
  const double v = 0.5 * (std::sqrt(C * C * C * C / (D * D) + 4 * C) - C * C / D);
  return 2 * ramp(v);
}

double least_jerk(double B, double C) {
  if (std::isnan(B + C)) return std::numeric_limits<double>::quiet_NaN();
  if (!(C > least_acceleration(B))) return std::numeric_limits<double>::infinity();
  // Beyond these no law needs more: D4 and D5.
  const double b = std::min(B, 2.0);
  const double c = std::min(C, 2 * b * b / (b - 1));
  return b * c * c / (c * (b - 1) - b * b);
}

std::optional<double> limit_index(const Peaks<double>& peaks) {
  if (peaks.ends != Ends{End::Rest, End::Rest}) return std::nullopt;
  return least_time(peaks.max_velocity(), peaks.max_acceleration(), peaks.max_jerk());
}

}  // namespace camlaw
