// SPDX-License-Identifier: MIT
#pragma once

#include "numerics/text/file_format.h"

/// What an answer states in `format` where it is kept as a file, or may be. A design alone is read
/// back (kResultFormat, problems/results/seal.h); what reads designs refuses these by name.
namespace camlaw::cli {

inline constexpr FileFormat kEvaluationFormat{"camlaw evaluation", 1};
inline constexpr FileFormat kFitFormat{"camlaw fit", 1};
inline constexpr FileFormat kFrontFormat{"camlaw front", 1};
inline constexpr FileFormat kSweepFormat{"camlaw sweep", 1};
inline constexpr FileFormat kTradeOffFormat{"camlaw trade-off", 1};

}  // namespace camlaw::cli
