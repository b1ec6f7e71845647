// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "machines/model/mechanism.h"
#include "optim/problem/curve.h"

/// A curve's value at one place of its cycle for many machines at a time.
namespace camlaw::problems {

class DesignRows {
 public:
  virtual ~DesignRows() = default;
  /// s, v, a, j of the follower and the place in the whole cycle: what the formula is given.
  using Motion = std::array<double, 5>;
  virtual Motion motion_at(optim::Place place) const = 0;
  /// The value there of each machine, by a row of values for each parameter that varies of the
  /// binding; as many rows as it has, in its order.
  virtual void values(const Motion& motion, std::span<const std::span<const double>> parameters,
                      std::span<double> result) const = 0;
};

/// Null where the curve is not a formula that a law or a program drives, and where the law varies.
std::unique_ptr<DesignRows> design_rows(const MechanismResponse& response, const Binding& binding);

}  // namespace camlaw::problems
