// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "optim/problem/problem.h"
#include "optim/verdict/variation.h"

/// Where manufacture is likeliest to break a limit: the first-order reliability method.
namespace camlaw::optim {

/// A point at which a limit breaks that is nearest to what is meant (docs/theory.md, TV4).
struct DesignPoint {
  std::vector<double> u;  ///< in normal numbers
  double index = 0;       ///< its distance, the reliability index; below 0 of a broken limit
};
/// A limit's room and its slopes by the variables of a design.
using RoomSlopes = std::function<double(Design x, std::span<double> slopes)>;
struct DesignPointSearch {
  std::vector<double> start = {};  ///< in normal numbers; none: the middle of the variations
  int most_steps = 100;            ///< the steps settle linearly
};
/// The one that the search reaches. None where no such point is found.
std::optional<DesignPoint> design_point(const RoomSlopes& room, Design x,
                                        const std::vector<Variation>& variations,
                                        const DesignPointSearch& search = {});

/// The room and its slopes of one limit of a problem, at its worst place; tolerances as above.
RoomSlopes room_slopes(const Problem& problem, std::size_t limit, Design x);

}  // namespace camlaw::optim
