// SPDX-License-Identifier: MIT
#include "optim/verdict/unproved.h"

#include <fmt/format.h>

#include <cmath>

namespace camlaw::optim {
namespace {

/// Whether the enclosure of a number leaves more room about it than its tolerance.
bool is_wide(const Response& response, const ObjectiveReport& objective, double tolerance) {
  if (response.is_curve() || !response.function().is_enclosed()) return false;
  return !(objective.value - objective.proved.lower <= tolerance &&
           objective.proved.upper - objective.value <= tolerance);
}

}  // namespace

std::string unproved(const Problem& problem, const Scales& scales, const Assessment& a) {
  const auto needs_proof = [](const Response& response) {
    return response.is_curve() || response.function().is_searched() ||
           response.function().is_enclosed();
  };
  for (std::size_t i = 0; i < a.limits.size(); ++i) {
    const Response& response = problem.constraints[i].response;
    if (needs_proof(response) && !a.limits[i].proved) {
      if (!response.is_curve() && !response.function().is_searched()) {
        return fmt::format("{} is met, but intervals do not prove it", a.limits[i].name);
      }
      // Not even what a proof finds is more than a search: no cycle is proved of it.
      if (!response.is_curve() && response.function().proved().is_searched()) {
        return fmt::format(
            "{} is met, but not proved: its value is an estimate that intervals do not confirm",
            a.limits[i].name);
      }
      return fmt::format("{} is met wherever it was evaluated, but not proved over the whole cycle",
                         a.limits[i].name);
    }
  }
  const Bounds& peak = a.objective.proved;
  if (needs_proof(problem.objective().response) && !(std::isfinite(peak.lower + peak.upper))) {
    if (!problem.objective().response.is_curve()) {
      return fmt::format("{} is not proved", problem.objective().response.name);
    }
    const bool lowest = problem.objective().part == Part::Lowest;
    return fmt::format("it is not proved that {} is nowhere {}", problem.objective().response.name,
                       lowest ? "lower" : "higher");
  }
  if (is_wide(problem.objective().response, a.objective, scales.objective_tolerance)) {
    return fmt::format("{} is only proved to lie between {:.9g} and {:.9g}",
                       problem.objective().response.name, peak.lower, peak.upper);
  }
  return {};
}

}  // namespace camlaw::optim
