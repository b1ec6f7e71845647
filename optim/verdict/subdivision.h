// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "optim/cycle/scales.h"

namespace camlaw::optim {

/// What dividing the box of the variables came to.
struct Subdivision {
  /// No design that meets every limit has a better objective than this, in the objective's unit;
  /// infinite where it was cut before there was a bound.
  double best_possible;
  /// A design that meets every limit, as far as it was looked at, and is better than the one asked
  /// about by more than the objective's default tolerance.
  std::optional<std::vector<double>> better = {};
  int boxes = 0;  ///< parts of the box that were looked at
  /// Whether it was stopped before it was done: the bound holds, as far as it had come.
  bool is_cut = false;
};

/// A design is called the global optimum where a lower bound is as near as this, over the
/// objective's measure.
inline constexpr double kBoundTolerance = 1e-6;

/// More free variables than this are not divided: the number of boxes grows as a power of theirs.
inline constexpr std::size_t kMostDivided = 3;
inline constexpr int kMostBoxes = 30000;

/// A lower bound over the whole box, whatever the shapes: the box is divided until no part can hold
/// a design that meets every limit (to a thousandth of its tolerance) and is better than x, by
/// ranges of the functions over boxes (Function::range; docs/optimisation.md, "Lower bounds"). Of
/// curves some places are enough, since a limit that is passed at one is passed. Ends at the first
/// better design, after `most_boxes`, or fewer if parts have no bound at all, where `stop` says so,
/// and where a function throws Interrupted: what it has shown by then still holds. Empty where more
/// than kMostDivided variables are free, one of them has no bounds, or nothing is known of the
/// objective's range.
std::optional<Subdivision> subdivided(
    const Problem& problem, const Scales& scales, Design x,
    const std::function<bool()>& stop = [] { return false; }, int most_boxes = kMostBoxes);

}  // namespace camlaw::optim
