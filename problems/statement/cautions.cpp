// SPDX-License-Identifier: MIT
#include "problems/statement/cautions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"

namespace camlaw::problems {
namespace {

bool speaks_of_jerk(const ResponseName& name) {
  return name.response != nullptr && name.response->name.find("jerk") != std::string::npos;
}

/// Where the jerk of a law is sought or limited: what stands beside its ends is not part of the
/// law, so a jump of the acceleration there is in none of its responses.
void add_of_ends(const ProblemStatement& design, std::vector<Caution>& found) {
  const auto& sought = design.objectives;
  const auto& limits = design.constraints;
  const bool jerk = std::any_of(sought.begin(), sought.end(),
                                [](const auto& o) { return speaks_of_jerk(o.response); }) ||
                    std::any_of(limits.begin(), limits.end(),
                                [](const auto& c) { return speaks_of_jerk(c.response); });
  if (!jerk || design.mechanism->moved_by != MovedBy::Law || design.laws.empty()) return;
  constexpr double kNoJump = 1e-6;  // beside s'' of 4, the least peak that there is
  const Law<double> law = design.laws.front().law<double>();
  const double begin = law.derivatives<3>(0.0, Side::Right)[2];
  const double end = law.derivatives<3>(1.0, Side::Left)[2];
  if (std::abs(begin) <= kNoJump && std::abs(end) <= kNoJump) return;
  found.push_back({"the acceleration jumps at an end of the law",
                   fmt::format("s'' begins with {:.4g} and ends with {:.4g}; beside a dwell the "
                               "jerk is infinite there, and the jerk that is limited or sought is "
                               "that between the ends",
                               begin, end)});
}

}  // namespace

std::vector<Caution> cautions(const ProblemStatement& design) {
  std::vector<Caution> found;
  add_of_ends(design, found);
  return found;
}

}  // namespace camlaw::problems
