// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "problems/statement/statement.h"

/// What a design's machine does not bear though no limit of its problem forbids it: said beside the
/// verdict.
namespace camlaw::problems {

struct Caution {
  std::string what;    ///< "the profile is undercut": of many designs the same words
  std::string detail;  ///< "undercut reaches 1.11 at 53 deg, where a cusp begins at 1"

  std::string text() const { return what + ": " + detail; }
};

/// Of a cam at a statement's constants and starts, as far as its mechanism has the responses: an
/// undercut of 1 or more, a tool that does not fit a hollow, a follower that leaves the cam below
/// its speed, a base circle inside the bore. Of a law whose jerk is sought or limited: an
/// acceleration that jumps at its ends.
std::vector<Caution> cautions(const ProblemStatement& design);

}  // namespace camlaw::problems
