// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "optim/verdict/design_point.h"
#include "optim/verdict/drawn_parts.h"
#include "optim/verdict/failure_regions.h"

/// The share of all parts that meet every limit, by sampling (docs/theory.md, "Manufacturing
/// tolerances").
namespace camlaw::optim {

struct YieldOptions {
  std::size_t samples = 100000;
  std::uint64_t seed = 1;
  std::function<bool()> stopped = [] { return false; };
  CountParts count = {};  ///< who counts; nobody: the calling thread
};

struct Yield {
  double failing = 0;  ///< the share that breaks a limit: an estimate
  double error = 0;    ///< its standard error, from independent repetitions
  /// Above `failing` where the room is not known exactly: the share that may break a limit.
  double failing_at_most = 0;
  /// However few samples fail (TV8, TV9): `failing` of all parts, what the room leaves open
  /// included, at a confidence of 95 %.
  Bounds failing_between{0, 1};
  /// By importance: what may fail besides, at the same confidence, away from the design points in
  /// places where no sample fell (TV10).
  double unseen_at_most = 0;
  std::vector<double> by_limit;                ///< the share that breaks each
  std::vector<Bounds> by_limit_between;        ///< the same of each
  std::vector<std::optional<double>> indices;  ///< the reliability index of each
  std::size_t samples = 0;
  std::size_t failures = 0;    ///< samples that break a limit
  std::size_t impossible = 0;  ///< of them, for which the model gives no number
  bool by_importance = false;  ///< drawn about the design points, for failures are rare
  bool stopped = false;        ///< before its end; with no samples where no round was done
};

/// Sobol points with random shifts, so many for each of 32 repetitions (TV2); where few of the
/// first break a limit, drawn about the limits' design points (TV3). The drawer is of the same x
/// and variations. `slopes` are of each limit, or none where no design points are to be looked for.
/// Throws std::invalid_argument for no samples.
Yield yield(const PartsDrawer& drawer, const std::vector<RoomSlopes>& slopes, Design x,
            const std::vector<Variation>& variations, const YieldOptions& options = {});

}  // namespace camlaw::optim
