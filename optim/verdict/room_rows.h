// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "optim/problem/problem.h"

namespace camlaw::optim {

/// How much room each limit leaves at many designs.
class RoomRows {
 public:
  virtual ~RoomRows() = default;
  virtual std::size_t limits() const = 0;
  /// Of design k, designs[k * n ..), its variables one behind the other, at room[limit * count +
  /// k]: margin and tolerance together, below 0 where the limit is broken, not a number where the
  /// model gives none.
  virtual void room(std::span<const double> designs, std::size_t count,
                    std::span<double> room) const = 0;
  /// By how much the room may be less than what is told, for each limit; 0 where that is searched
  /// for at each design.
  virtual std::vector<double> slack() const = 0;
};

/// Room by a search at each design, whatever the problem. Tolerances are those about x.
std::unique_ptr<RoomRows> searched_rooms(const Problem& problem, Design x);

}  // namespace camlaw::optim
