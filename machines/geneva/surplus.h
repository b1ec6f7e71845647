// SPDX-License-Identifier: MIT
#pragma once

#include "machines/geneva/geneva_drive.h"
#include "numerics/scalar/root.h"

namespace camlaw {

/// The extremes of what a Geneva drive asks of its driver, from the scalar of the drive
/// (docs/theory.md, "Balancing cam").
template <class T>
struct Surplus {
  T peak_torque;   ///< N m, the greatest of M_d
  T highest_work;  ///< J, the greatest of A, where M_d falls through its mean
  T range;         ///< J, A_surplus,max: highest less lowest, where M_d rises through its mean
};

namespace detail {

/// Places of the extremes, in plain numbers.
struct SurplusPlaces {
  double peak, lowest, highest;
};

template <template <class> class Wheel>
SurplusPlaces surplus_places(const GenevaDrive<double, Wheel>& drive) {
  constexpr int kCells = 96;
  const double end = drive.engagement();
  const auto wheel = [&](double phi) { return drive.wheel(true, phi); };
  const auto above = [&](double phi) { return drive.torque(wheel(phi)) - drive.mean_torque(); };
  const auto slope = [&](double phi) { return drive.torque_slope(wheel(phi)); };
  const auto work = [&](double phi) { return drive.surplus_work(wheel(phi), phi); };
  SurplusPlaces places{0, 0, end};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  double peak = -1e300, lowest = 1e300, highest = -1e300;
  double at = 0, here = above(0), rate = slope(0);
  if (!std::isfinite(here)) return {nan, nan, nan};
  for (int i = 1; i <= kCells; ++i) {
    const double next = end * i / kCells, there = above(next), next_rate = slope(next);
    if (here < 0 && there >= 0) {
      const double root = root_between(above, at, next);
      if (work(root) < lowest) lowest = work(root), places.lowest = root;
    } else if (here > 0 && there <= 0) {
      const double root = root_between(above, at, next);
      if (work(root) > highest) highest = work(root), places.highest = root;
    }
    if (rate > 0 && next_rate <= 0) {
      const double root = root_between(slope, at, next);
      if (above(root) > peak) peak = above(root), places.peak = root;
    }
    at = next, here = there, rate = next_rate;
  }
  return places;
}

}  // namespace detail

template <class T, template <class> class Wheel>
Surplus<T> surplus_of(const GenevaDrive<T, Wheel>& drive) {
  const detail::SurplusPlaces places = detail::surplus_places(drive.plain());
  const auto torque = [&](const auto& phi) { return drive.torque(drive.wheel(true, phi)); };
  const auto slope = [&](const T& phi) { return drive.torque_slope(drive.wheel(true, phi)); };
  const auto bend = [&](const T& phi) {
    return number<T>(2) * torque(Series<T, 3>::variable(phi, number<T>(1))).c[2];
  };
  const auto above = [&](const T& phi) { return torque(phi) - drive.mean_torque(); };
  const auto work = [&](const T& phi) { return drive.surplus_work(drive.wheel(true, phi), phi); };
  const T peak = root_near<T>(places.peak, slope, bend);
  const T low = root_near<T>(places.lowest, above, slope);
  const T high = root_near<T>(places.highest, above, slope);
  const T highest = work(high);
  return {torque(peak), highest, highest - work(low)};
}

}  // namespace camlaw
