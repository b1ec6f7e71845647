// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "problems/statement/statement.h"

/// What is doubtful about a design though no limit of its problem forbids it: said beside the
/// verdict. Whether its machine can be built is asked elsewhere (buildable.h).
namespace camlaw::problems {

struct Caution {
  std::string what;    ///< "the acceleration jumps": of many designs the same words
  std::string detail;  ///< "s'' begins with 3"

  std::string text() const { return what + ": " + detail; }
};

/// Of what a file says, before any design is evaluated. Of angles: plain numbers that are hardly
/// degrees. Of a machine with a program: a main size that a limit or the objective depends on and
/// the file does not state.
std::vector<Caution> cautions_of_file(const ProblemStatement& problem);

/// The same, and those of the design. Of a law whose jerk is sought or limited: an acceleration
/// that jumps at its ends. Of a crowned roller: a contact beyond what its formulas are checked for.
/// Of variations: those of the motion, which searches and judged limits leave out.
std::vector<Caution> cautions(const ProblemStatement& design);

}  // namespace camlaw::problems
