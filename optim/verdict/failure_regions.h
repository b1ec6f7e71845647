// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "optim/verdict/design_point.h"
#include "optim/verdict/drawn_parts.h"

/// Where parts fail if failures are rare: a limit may break in several places, on both sides of
/// what is meant or all around it (docs/theory.md, "Rare failures").
namespace camlaw::optim {

/// Of one limit the points to draw parts about, nearest first, in all numbers: its design point,
/// the one on the opposite side where the limit breaks there too, and one for each of the `failing`
/// parts that no point before it covers (TV13). `failing` are in normal numbers, nearest first.
/// Empty where no such point is found.
std::vector<DesignPoint> failing_points(const RoomSlopes& room, Design x,
                                        const std::vector<Variation>& variations,
                                        const std::vector<std::vector<double>>& failing);

struct FailureRegions {
  std::vector<std::vector<DesignPoint>> of_limit;  ///< as above, of each limit
  /// What the normal numbers of failing parts have as root mean square (TV14), within bounds.
  double spread = 1;
};

struct RegionsOptions {
  std::size_t samples = 3072;  ///< parts that are drawn to find the regions
  std::uint64_t seed = 1;
  std::function<bool()> stopped = [] { return false; };
};

/// Looks among parts that are drawn with several times the spread of what is made. The slopes are
/// of each limit of the drawer, which is of the same x and variations. Throws Interrupted where it
/// is stopped.
FailureRegions failure_regions(const PartsDrawer& drawer, const std::vector<RoomSlopes>& slopes,
                               Design x, const std::vector<Variation>& variations,
                               const RegionsOptions& options);

}  // namespace camlaw::optim
