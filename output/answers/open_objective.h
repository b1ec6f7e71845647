// SPDX-License-Identifier: MIT
#pragma once

#include "output/answers/limit_text.h"
#include "output/answers/optimum_output.h"

namespace camlaw::cli {

/// What the proof of an answer's objective over ranges leaves open, for the statement of its
/// design; nothing where it is proved, or a limit is not met. The proof of a curve's peak is made
/// again.
OpenObjective open_objective(const Answer& answer, const problems::ProblemStatement& design);

}  // namespace camlaw::cli
