// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "problems/results/recorded_design.h"

/// A design judged again before it is written to a file.
namespace camlaw::cli {

/// "judged again: feasible", or that the design does not meet its limits; empty where there is
/// nothing to judge.
std::vector<std::string> judged_words(const problems::ReadDesign& read);

/// Of each limit of its problem that a design does not meet its value and its bound, a sentence
/// each: "limit not met: pressure_angle is 32.8 deg and must be at most 30 deg".
std::vector<std::string> unmet_words(const problems::ProblemStatement& design);

}  // namespace camlaw::cli
