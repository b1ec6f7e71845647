// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "output/answers/claim_output.h"
#include "output/answers/design_review.h"
#include "output/document/document.h"
#include "problems/results/recorded_design.h"

/// Designs side by side, each judged again as it is when it stands alone.
namespace camlaw::cli {

/// More than this are not told apart in a chart.
inline constexpr std::size_t kMostCompared = 4;

struct ComparedDesign {
  std::string letter;  ///< "A"
  std::string file;    ///< as it was named
  problems::ReadDesign read;
  ClaimReview claim;
  DesignReview review;
};

/// What was found of each, what varies, how the limits stand, whether it can be built, the
/// machines' numbers and parameters, and what only some of them have. A column for each design, and
/// of a row that has a better and a worse the best marked: of objectives that ask for the same, of
/// verdicts, of margins, of checks.
Document comparison_document(const std::vector<ComparedDesign>& designs);

}  // namespace camlaw::cli
