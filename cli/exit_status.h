// SPDX-License-Identifier: MIT
#pragma once

#include "output/answers/claim_output.h"
#include "output/answers/front_answer.h"

namespace camlaw::cli {

/// The exit status of the program.
enum ExitStatus : int {
  kDone = 0,
  kFailed = 1,
  kBadInput = 2,
  kInfeasible = 3,  ///< no design meets every limit
  kNotSolved = 4,   ///< no answer, or only a part of one
};

/// The status for a record that was looked at: kNotSolved where its numbers are not the design's.
int status_of(const ClaimReview& review);
/// The status for a front.
int status_of(const optim::Front& front);
/// The status for a front that is read from its record: kNotSolved too where a task of that is
/// lost, damaged or wrong.
int status_of(const problems::StoredFront& stored);

}  // namespace camlaw::cli
