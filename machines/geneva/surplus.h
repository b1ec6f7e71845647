// SPDX-License-Identifier: MIT
#pragma once

#include "machines/geneva/geneva_drive.h"
#include "numerics/scalar/root.h"

namespace camlaw {

/// The extremes of what a Geneva drive asks of its driver (docs/theory.md, "Balancing cam").
template <class T>
struct Surplus {
  T peak_torque;   ///< N m, the greatest of M_d
  T highest_work;  ///< J, the greatest of A, where M_d falls through its mean
  T range;         ///< J, A_surplus,max: highest less lowest, where M_d rises through its mean
};

/// T is double or Expression.
template <class T, template <class> class Wheel>
Surplus<T> surplus_of(const GenevaDrive<T, Wheel>& drive) {
  const auto torque = [&](const auto& phi) { return drive.torque(drive.wheel(true, phi)); };
  const auto slope = [&](const auto& phi) { return drive.torque_slope(drive.wheel(true, phi)); };
  const auto above = [&](const auto& phi) { return torque(phi) - drive.mean_torque(); };
  const auto work = [&](const auto& phi) {
    return drive.surplus_work(drive.wheel(true, phi), phi);
  };
  const T begin = number<T>(0), end = drive.engagement();
  const T highest = work(root_of(begin, end, above, work));
  const T lowest = work(root_of(begin, end, above, [&](const T& phi) { return -work(phi); }));
  return {torque(root_of(begin, end, slope, above)), highest, highest - lowest};
}

}  // namespace camlaw
