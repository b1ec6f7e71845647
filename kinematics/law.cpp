// SPDX-License-Identifier: MIT
#include "kinematics/law.h"

#include <fmt/format.h>

namespace camlaw {

std::string to_string(Ends ends) {
  const auto letter = [](End end) {
    switch (end) {
      case End::Rest:
        return 'R';
      case End::Velocity:
        return 'G';
      case End::Reversal:
        return 'U';
      case End::Motion:
        return 'B';
    }
    return '?';
  };
  return {letter(ends.begin), '-', letter(ends.end)};
}

namespace detail {

Impossible bad_pieces(const std::string& why) {
  return {"law: " + why + "; pieces must cover [0, 1] in order"};
}

std::optional<Impossible> gap_between(double end, double next) {
  // Breaks computed as sums of fractions differ from their neighbours by a few roundings.
  if (std::abs(end - next) <= 1e-12) return {};
  return bad_pieces(fmt::format("the break at {} does not meet {}", end, next));
}

}  // namespace detail
}  // namespace camlaw
