// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "problems/statement/statement.h"

namespace camlaw::problems {

struct FreeInstead {
  ProblemStatement problem;
  bool has_these_knots;  ///< else those of the file's own [free]
};

/// The same problem with a free law wherever the file leaves a law to be chosen; laws that it
/// states stay. The free law has so many even knots inside (0, 1); it is as smooth inside, and
/// rests at its ends as far, as all laws of `designs` in its place do (of the problem's laws where
/// there are none), so that each of them is near one of its splines; where the free law is among
/// the laws to choose from, it is as the file's [free] says. Parameters that only the other laws
/// have no longer vary. Throws std::invalid_argument where no law is chosen, and where the file
/// cannot be read with a free law.
FreeInstead with_free_law(const ProblemStatement& problem, std::span<const Member> designs,
                          int knots);

}  // namespace camlaw::problems
