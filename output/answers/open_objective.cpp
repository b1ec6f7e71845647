// SPDX-License-Identifier: MIT
#include "output/answers/open_objective.h"

#include <algorithm>
#include <cmath>

#include "optim/cycle/extremes.h"

namespace camlaw::cli {

using optim::Bounds, optim::ObjectiveReport, optim::Part;

namespace {

bool has_proof(const ObjectiveReport& objective, const optim::Response& response) {
  const Bounds& proved = objective.proved;
  if (response.is_curve()) return std::isfinite(proved.lower + proved.upper);
  return objective.value - proved.lower <= objective.tolerance &&
         proved.upper - objective.value <= objective.tolerance;
}

/// Where a curve is not proved to stay below its peak, to what the assessment allows.
std::optional<Bounds> left_of_peak(const optim::Trace& trace, Part part,
                                   const ObjectiveReport& objective) {
  const double allowed = std::max(1e-9 * std::abs(objective.value), 0.1 * objective.tolerance);
  for (const double sign : {1.0, -1.0}) {
    if (part != Part::Magnitude && sign != objective.sign) continue;
    const double peak = part == Part::Magnitude ? objective.value : sign * objective.value;
    const optim::CycleProof proof = optim::prove_below(trace, sign, peak + allowed);
    if (proof.left) return proof.left;
  }
  return {};
}

/// The stretch at which the proof is given up, of a number an infinite one.
std::optional<Bounds> left_of(const optim::Objective& objective, const optim::Found& found) {
  if (objective.response.is_curve()) {
    return left_of_peak(*objective.response.curve().trace(found.x), objective.part,
                        found.assessment.objective);
  }
  if (!objective.response.function().is_enclosed()) return {};
  return Bounds{};
}

}  // namespace

OpenObjective open_objective(const Answer& answer, const problems::ProblemStatement& design) {
  const optim::Found& found = answer.optimum.found;
  const optim::Objective& objective = answer.optimum.problem.objective();
  const bool is_over_ranges = design.objectives.front().of_ranges != nullptr;
  if (!is_over_ranges || !optim::is_feasible(found.assessment)) return {};
  if (has_proof(found.assessment.objective, objective.response)) return {};
  return objective_left_open(design, left_of(objective, found));
}

}  // namespace camlaw::cli
