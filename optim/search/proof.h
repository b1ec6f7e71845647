// SPDX-License-Identifier: MIT
#pragma once

#include "optim/search/trail.h"

namespace camlaw::optim {

/// Holds a problem whose curves are remembered, and looked at more closely where proofs found
/// something.
class WatchedProblem {
 public:
  explicit WatchedProblem(Problem plain);

  const Problem& problem() const { return problem_; }
  /// Learns angles at which a proof found a limit passed, or the peak higher, that no search had
  /// seen: from now on every search looks there. A number for which a proof found more than its own
  /// search is worked out with proofs from now on. Tells whether there was
  /// anything new.
  bool learn(Design x, const Assessment& proved);

 private:
  bool watch(std::size_t index, double angle, const Response& plain, Response& response);

  Problem plain_, problem_;
  std::vector<std::vector<double>> angles_;  ///< of the objective and of each constraint
};

/// Proves the best design, in its own scales; where the proof finds an angle that breaks a limit,
/// searches again.
void prove_best(WatchedProblem& watched, const Setting& setting, Trail& trail);

}  // namespace camlaw::optim
