// SPDX-License-Identifier: MIT
#pragma once

#include "optim/pareto/pareto.h"
#include "optim/pareto/round.h"

namespace camlaw::optim {

/// Holds the fronts of all combinations, and carries out tasks for them.
class Sweep {
 public:
  /// Throws std::invalid_argument for a problem that is not well posed.
  Sweep(const ProblemSpace& space, const ParetoOptions& options, Executor& executor);

  /// Carries tasks out, all with the study's seed, and counts them. Where some are not carried out
  /// the front is stopped, and the others stay in `tasks`, in their order.
  std::vector<Outcome> carry_out(std::vector<Task>& tasks);
  /// Carries tasks out, and gives the outcomes to their parts.
  void carry_on(std::vector<Task> tasks);
  FrontSoFar so_far() const;
  /// Gives the hypervolume's reference: as stated, else chosen.
  Costs reference(const std::vector<Costs>& costs) const;
  /// Tells how far the front is.
  void report();

  const ProblemSpace& space;
  const ParetoOptions& options;
  PartFronts parts;
  Front front;

 private:
  Executor& executor_;
  StudyProgress progress_;
};

/// Finds the point that costs least of an objective; nullptr where there is none.
const FrontPoint* cheapest(const std::vector<FrontPoint>& points, std::size_t objective);

}  // namespace camlaw::optim
