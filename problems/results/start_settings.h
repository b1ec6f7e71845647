// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "problems/results/recorded_design.h"

namespace camlaw::problems {

/// What set_values takes so that a search for `problem` begins at a design that was found for this
/// or another problem: the numbers of the variables and the parts that both know, each moved onto
/// what this problem accepts. What the design does not know stays as it is. Throws
/// std::invalid_argument where the two have nothing in common.
std::vector<std::string> start_settings(const ProblemStatement& problem, const ReadDesign& design);

/// The same with the result of a file.
std::vector<std::string> start_settings(const ProblemStatement& problem, const std::string& path);

/// What set_values takes so that the problem, where it chooses among laws, has those of a design
/// that was found for it: "law=cycloidal", "rise.law=modified-sine",
/// "infeed.rise.law=modified-sine".
std::vector<std::string> law_settings(const ProblemStatement& problem,
                                      const ProblemStatement& design);

/// What set_values takes so that a design's problem, as it is read from its text, is at that
/// design: what was set, its law, its parts, and the numbers of its variables.
std::vector<std::string> restated_settings(const ProblemStatement& design);

}  // namespace camlaw::problems
