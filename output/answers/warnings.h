// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "output/answers/front_answer.h"
#include "output/answers/optimum_output.h"
#include "output/document/json.h"
#include "output/figure/chart.h"

/// What stands in amber beside a verdict: what the design's machine does not bear though no limit
/// forbids it, and limits whose unit is most likely wrong.
namespace camlaw::cli {

using Warnings = std::vector<std::string>;

/// The word that stands before each.
inline constexpr const char* kWarningWord = "caution";

/// Of a problem file, before a design is judged: what it leaves open, and doubtful limits.
Warnings warnings_of_file(const problems::ProblemStatement& problem);
/// Of a design that nobody searched for.
Warnings warnings_of(const problems::ProblemStatement& design);
/// Of an answer; of one without a design, what concerns its limits.
Warnings warnings_of(const Answer& answer);
/// Of what --set says of parts that the search chooses: it is where the search begins.
Warnings begins_with_parts(const problems::ProblemStatement& problem,
                           const std::vector<std::string>& set);
/// Of a front: what holds of some of its points, with their numbers.
Warnings warnings_of(const FrontAnswer& answer);

/// Each on a line of its own; empty where there are none.
std::string warnings_text(const Warnings& warnings);

}  // namespace camlaw::cli
