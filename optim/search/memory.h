// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

#include "optim/problem/problem.h"

/// What a search takes, told before it is taken.
namespace camlaw::optim {

/// A search that would take more memory than is allowed.
struct MemoryRefusal : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

struct MemoryNeed {
  double bytes = 0;
  std::string of;  ///< "998 variables (500 knots, 498 coefficients) and 5010 rows of limits"
};

/// What the searches for one problem take about, at most: rows of the limits at the places that the
/// first exchange looks at, with their slopes, second derivatives and the factors of both
/// (docs/optimisation.md, "Memory"). Beside the program's own.
MemoryNeed memory_need(const Problem& problem);

/// The same. Throws MemoryRefusal where that is more than is allowed, in bytes.
MemoryNeed check_memory(const Problem& problem, double allowed);

/// "6.2 GB"
std::string memory_text(double bytes);

}  // namespace camlaw::optim
