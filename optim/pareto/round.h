// SPDX-License-Identifier: MIT
#pragma once

#include "optim/pareto/part_front.h"

/// Which searches come next. It follows from the points that are known alone, not from the number
/// of workers.
namespace camlaw::optim {

using PartFronts = std::vector<std::unique_ptr<PartFront>>;

/// Searches that a front of `wanted` points lacks most, none where it lacks nothing.
std::vector<Task> next_round(const PartFronts& parts, FrontSoFar front, std::size_t wanted);

/// How even a front is. Gaps of two objectives are its steps, and those that no search has shown to
/// be empty are the boxes between neighbours.
struct Evenness {
  double largest = 0;  ///< of the gaps that no search has shown to be empty
  double mean = 0;     ///< of all gaps
  double mean_to_nearest = 0;

  /// Largest over mean; 1 where there is no gap.
  double ratio() const;
};

Evenness evenness(const PartFronts& parts, const FrontSoFar& front);

/// A front of `wanted` points, evenly spread, where there are more; the best of each cost stays.
FrontSoFar spread(FrontSoFar front, std::size_t wanted);

}  // namespace camlaw::optim
