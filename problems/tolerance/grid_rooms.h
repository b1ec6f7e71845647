// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "optim/verdict/room_rows.h"
#include "problems/tolerance/varied_design.h"

/// The room of a design's limits at many parts, quickly (docs/theory.md, TV5): intervals first rule
/// out the angles at which no part breaks a limit; at the others a curve is computed on a grid
/// whose error the second derivative bounds.
namespace camlaw::problems {

/// How much of the work a grid saves.
struct GridReport {
  std::size_t places = 0;        ///< of all limits together at which curves are computed
  std::size_t without_grid = 0;  ///< limits that are searched at each part
  double left = 0;  ///< the share of the cycle that is not ruled out, of the fullest limit
};

struct GridRooms {
  std::unique_ptr<optim::RoomRows> rows;
  GridReport report;
};

/// Parts beyond six standard deviations of what is normal are searched one by one.
GridRooms grid_rooms(const VariedDesign& varied);

}  // namespace camlaw::problems
