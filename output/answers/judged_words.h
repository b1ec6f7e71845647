// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "problems/results/recorded_design.h"

/// A design judged again before it is written to a file.
namespace camlaw::cli {

/// "judged again: feasible", and of each limit that is not met by how much, a sentence each; empty
/// where nothing is asked of the design.
std::vector<std::string> judged_words(const problems::ReadDesign& read);

}  // namespace camlaw::cli
