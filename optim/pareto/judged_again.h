// SPDX-License-Identifier: MIT
#pragma once

#include "optim/pareto/task.h"

/// A design of a front that was found before, looked at again: nothing that was stated of it is
/// believed.
namespace camlaw::optim {

/// In words, with both numbers, where a point does not state what its design is when it is
/// evaluated again: a variable outside its bounds, objectives and margins that differ by more than
/// their tolerances (and 1e-9 of themselves), a limit that is met or not. Peaks are searched, and
/// proved only where a margin would differ else. Empty where all agrees.
std::vector<std::string> differences(const Problem& problem, const FrontPoint& point);

/// The verdict of a design as the least of the cost `sought`, no other cost greater, with proofs.
/// The limits on the other costs come after the problem's own.
Assessment assessed_on_front(const Problem& problem, Design x, std::size_t sought);

/// The point with its verdict, margins and prices worked out again, with proofs: as the least of
/// the cost that its weights count most, no other cost greater. What was certified so is certified
/// again.
FrontPoint judged_again(const Problem& problem, const FrontPoint& point);

}  // namespace camlaw::optim
