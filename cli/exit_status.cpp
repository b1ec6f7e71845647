// SPDX-License-Identifier: MIT
#include "cli/exit_status.h"

namespace camlaw::cli {

int status_of(const ClaimReview& review) { return review.differences.empty() ? kDone : kNotSolved; }

int status_of(const problems::StoredFront& stored) {
  return stored.faults.empty() ? status_of(stored.front) : kNotSolved;
}

int status_of(const optim::Front& front) {
  if (front.stopped) return kNotSolved;
  if (!front.points.empty()) return kDone;
  return front.failures.empty() ? kInfeasible : kNotSolved;
}

}  // namespace camlaw::cli
