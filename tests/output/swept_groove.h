// SPDX-License-Identifier: MIT
#pragma once

// What a roller with a radial axis takes out of a barrel, found by trying places of the roller:
// nothing is known here of where it touches.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "output/export/plane_curve.h"

namespace camlaw::testing {

/// How high (side 1) or low (-1) the roller reaches at an angle, rad, and a distance q from the
/// barrel's axis: of s(phi) + side sqrt(r^2 - q^2 sin^2(angle - phi)) the farthest over phi.
inline double reach_of_roller(const problems::PlaneCurve& pitch, double radius, double angle,
                              double q, double side) {
  constexpr int kLooks = 160;
  const double most = std::asin(radius / q);
  const auto value = [&](double phi) {
    const double across = q * std::sin(angle - phi), degrees = phi * 180 / std::numbers::pi;
    const double turn = degrees - 360 * std::floor(degrees / 360);
    const double height = pitch.height({turn})[0];
    return side * height + std::sqrt(std::max(radius * radius - across * across, 0.0));
  };
  const auto place = [&](int i) { return angle - most + 2 * most * i / kLooks; };
  int best = 1;
  for (int i = 1; i < kLooks; ++i) {
    if (value(place(i)) > value(place(best))) best = i;
  }
  // Golden sections to a thousandth of the way, then the parabola's top.
  double low = place(best - 1), high = place(best + 1);
  for (int i = 0; i < 12; ++i) {
    constexpr double kGolden = 0.6180339887498949;
    const double left = high - kGolden * (high - low), right = low + kGolden * (high - low);
    (value(left) > value(right) ? high : low) = value(left) > value(right) ? right : left;
  }
  return side * value((low + high) / 2);
}

/// The volume that it sweeps between two distances from the axis: even angles, Simpson's rule over
/// the distance.
inline double swept_volume(const problems::PlaneCurve& pitch, double radius, double floor,
                           double outside) {
  constexpr int kAngles = 720, kAcross = 4;
  double volume = 0;
  for (int j = 0; j <= kAcross; ++j) {
    const double q = floor + (outside - floor) * j / kAcross;
    const double weight = (j == 0 || j == kAcross ? 1 : j % 2 == 1 ? 4 : 2) / (3.0 * kAcross);
    for (int i = 0; i < kAngles; ++i) {
      const double angle = 2 * std::numbers::pi * i / kAngles;
      const double height = reach_of_roller(pitch, radius, angle, q, 1) -
                            reach_of_roller(pitch, radius, angle, q, -1);
      volume += weight * q * height;
    }
  }
  return volume * (outside - floor) * 2 * std::numbers::pi / kAngles;
}

}  // namespace camlaw::testing
