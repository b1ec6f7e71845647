// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "optim/verdict/design_point.h"

/// The share of all parts that meet every limit, by sampling (docs/theory.md, "What manufacture
/// does").
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

struct YieldOptions {
  std::size_t samples = 100000;
  std::uint64_t seed = 1;
  std::function<bool()> stopped = [] { return false; };
};

struct Yield {
  double failing = 0;  ///< the share that breaks a limit: an estimate
  double error = 0;    ///< its standard error, from independent repetitions
  /// Above `failing` where the room is not known exactly: the share that may break a limit.
  double failing_at_most = 0;
  /// However few samples fail (TV8): `failing` of all parts, what the room leaves open included. At
  /// a confidence of 95 %, or by importance of 80 % or more.
  Bounds failing_between{0, 1};
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
/// first break a limit, drawn about the limits' design points (TV3). `slopes` are of each limit, or
/// none where no design points are to be looked for. Throws std::invalid_argument where there are
/// not as many variations as variables, or none varies.
Yield yield(const RoomRows& rows, const std::vector<RoomSlopes>& slopes, Design x,
            const std::vector<Variation>& variations, const YieldOptions& options = {});

}  // namespace camlaw::optim
