// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "optim/search/exchange.h"

namespace camlaw::optim {

/// What holds a design of a problem that a sharp method takes (Solver::is_sharp), from solving it
/// once more from there: multipliers that the verdict (verdict/kkt.h) might be long to find, for a
/// design that comes without the search that led to it. Empty for other problems, and where no
/// solve succeeds.
std::vector<Push> told_at(const Problem& problem, const Scales& scales, Design x,
                          Aim aim = Aim::Optimum);

/// The same for the verdict to ask for. Holds references.
Teller teller_at(const Problem& problem, const Scales& scales, Design x, Aim aim = Aim::Optimum);

/// Finds the functions of pushes that come from another process.
void find_functions(const Problem& problem, std::vector<Push>& pushes);

}  // namespace camlaw::optim
