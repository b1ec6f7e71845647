// SPDX-License-Identifier: MIT
#include "kinematics/laws/build.h"

#include <fmt/format.h>

#include "kinematics/laws/phases.h"

namespace camlaw {

std::optional<Impossible> bad_sum(const char* what, double sum) {
  if (std::abs(sum - 1) <= kPrintedSum) return {};
  return Impossible{fmt::format(
      "{} must be 1 (within 0.1 %, as printed constants are), but is {:.6g}", what, sum)};
}

namespace detail {

std::optional<Impossible> bad_durations(std::span<const double> durations) {
  double sum = 0;
  for (const double d : durations) {
    // A rest that is computed as 1 minus the others may fall a rounding below zero, and a search
    // keeps it above only to its own tolerance.
    if (!(d >= -kLeastRoom)) {
      return Impossible{
          fmt::format("a phase has the duration {:.6g}: durations must not be negative, so the "
                      "fractions must add up to no more than 1",
                      d)};
    }
    sum += d;
  }
  if (!(std::abs(sum - 1) <= 1e-9)) {
    return Impossible{fmt::format("durations must add up to 1, but give {:.9g}", sum)};
  }
  const bool accelerates = durations[0] + durations[1] + durations[2] > 0;
  const bool decelerates = durations[4] + durations[5] + durations[6] > 0;
  if (!accelerates || !decelerates) {
    return Impossible{"an accelerating and a decelerating phase must last longer than 0"};
  }
  return {};
}

}  // namespace detail
}  // namespace camlaw
