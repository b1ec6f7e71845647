// SPDX-License-Identifier: MIT
#include "problems/statement/known_limit.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <string>
#include <vector>

#include "kinematics/peaks.h"
#include "kinematics/shape.h"

namespace camlaw::problems {
namespace {

/// Whether what is asked for is the peak of one of a law's own curves, over the whole law.
bool is_law_peak(const ResponseName& name) {
  return name.part == optim::Part::Magnitude && name.response != nullptr && name.response->of_law &&
         !name.window;
}

}  // namespace

std::optional<optim::KnownLimit> known_limit(const ProblemStatement& statement,
                                             const ObjectiveStatement& objective,
                                             const Member& member) {
  if (!member.family->moving_as || !is_law_peak(objective.response)) return {};
  const Law<double> law = member.law();
  if (!vanishes(law, false, 1) || !vanishes(law, true, 1)) return {};
  PeakLimits limits;
  std::vector<std::string> words;
  for (const ConstraintStatement& c : statement.constraints) {
    if (!is_law_peak(c.response) || !c.upper) continue;
    double* limit = limit_among(limits, *c.response.response->of_law);
    if (limit == nullptr || !(*c.upper < *limit)) continue;
    *limit = *c.upper;
    words.push_back(fmt::format("{} of at most {:.6g}", c.response.name, *c.upper));
  }
  const double value = least_peak(*objective.response.response->of_law, limits);
  if (!std::isfinite(value)) return {};
  return optim::KnownLimit{
      value, fmt::format("no law from rest to rest{}{} has less", words.empty() ? "" : " with a ",
                         fmt::join(words, " and a "))};
}

}  // namespace camlaw::problems
