// SPDX-License-Identifier: MIT
#pragma once

#include "machines/geneva/geneva_drive.h"
#include "numerics/formula/expression.h"

namespace camlaw {

/// The extremes of what a Geneva drive asks of its driver (docs/theory.md, "Balancing cam").
struct Surplus {
  Expression peak_torque;   ///< N m, the greatest of M_d
  Expression highest_work;  ///< J, the greatest of A, where M_d falls through its mean
  Expression range;  ///< J, A_surplus,max: highest less lowest, where M_d rises through its mean
};

template <class Wheel>
Surplus surplus_of(const GenevaDrive<Wheel>& drive) {
  const auto torque = [&](const auto& phi) { return drive.torque(drive.wheel(true, phi)); };
  const auto slope = [&](const auto& phi) { return drive.torque_slope(drive.wheel(true, phi)); };
  const auto above = [&](const auto& phi) { return torque(phi) - drive.mean_torque(); };
  const auto work = [&](const auto& phi) {
    return drive.surplus_work(drive.wheel(true, phi), phi);
  };
  const Expression begin = 0, end = drive.engagement();
  const Expression highest = work(root_of(begin, end, above, work));
  const Expression lowest =
      work(root_of(begin, end, above, [&](const Expression& phi) { return -work(phi); }));
  return {torque(root_of(begin, end, slope, above)), highest, highest - lowest};
}

}  // namespace camlaw
