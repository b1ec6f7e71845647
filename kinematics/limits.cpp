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

namespace {

/// (D7) What is covered in half the time by the velocity that grows as fast as C, the moment M and
/// then B let it. C is finite.
double half_stroke(double M, double B, double C) {
  const double from = M / (C * C);  // up to here C holds
  const double v = M / C;
  const auto held = [&](double place) { return place < 0.5 ? B * (0.5 - place) : 0; };
  if (v >= B || from >= 0.5) {  // the moment never holds
    const double reached = std::min(0.5, B / C);
    return C * reached * reached / 2 + held(reached);
  }
  const double to = std::min(0.5, from + (B * B - v * v) / (2 * M));
  const double end = std::sqrt(v * v + 2 * M * (to - from));
  return v * from / 2 + (end * end * end - v * v * v) / (3 * M) + held(to);
}

}  // namespace

double least_dynamic_moment(double B, double C) {
  if (std::isnan(B + C)) return std::numeric_limits<double>::quiet_NaN();
  constexpr double kRounding = 1e-12;  // of peaks, which may be those of a law that is at the limit
  if (!(B > 1) || !(C >= (1 - kRounding) * least_acceleration(B)))
    return std::numeric_limits<double>::infinity();
  if (std::isinf(C)) return B < 1.5 ? B * B * B / (3 * (B - 1)) : 2.25;
  double low = 2.25 * (1 - 1e-15), high = std::max(std::min(B * C, C * C / 2), low);
  for (int i = 0; i < 200 && high - low > 1e-15 * high; ++i) {
    const double middle = std::sqrt(low * high);
    if (!(middle > low && middle < high)) break;
    (half_stroke(middle, B, C) >= 0.5 ? high : low) = middle;
  }
  return high;
}

double* limit_among(PeakLimits& limits, Quantity quantity) {
  switch (quantity) {
    case Quantity::Velocity:
      return &limits.velocity;
    case Quantity::Acceleration:
      return &limits.acceleration;
    case Quantity::Jerk:
      return &limits.jerk;
    case Quantity::Moment:
      return nullptr;
  }
  return nullptr;
}

double least_peak(Quantity quantity, PeakLimits limits) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  // The least time rounds by some units of the last place; a limit must not be above.
  constexpr double kRounding = 1e-13;
  double* peak = limit_among(limits, quantity);
  if (peak == nullptr)
    return (1 - kRounding) * least_dynamic_moment(limits.velocity, limits.acceleration);
  const auto is_enough = [&](double value) {
    *peak = value;
    return least_time(limits.velocity, limits.acceleration, limits.jerk) <= 1;
  };
  if (!is_enough(kInfinity)) return kInfinity;
  double low = 1, high = 2;          // a mean velocity of 1 is the least of all peaks
  constexpr double kEndless = 1e12;  // where another peak is at the edge of what laws have
  while (!is_enough(high)) {
    if (high > kEndless) return kInfinity;
    low = high;
    high *= 2;
  }
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    if (!(middle > low && middle < high)) break;
    (is_enough(middle) ? high : low) = middle;
  }
  return (1 - kRounding) * low;
}

std::optional<double> limit_index(const Peaks<double>& peaks) {
  if (peaks.ends != Ends{End::Rest, End::Rest}) return std::nullopt;
  return least_time(peaks.max_velocity(), peaks.max_acceleration(), peaks.max_jerk());
}

}  // namespace camlaw
