// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "kinematics/law.h"
#include "machines/model/cycle.h"

namespace camlaw::problems {

/// Where along the cycle a curve of the follower's motion has a pulse, the first such place: the
/// velocity jumps and the curve depends on the acceleration or the jerk, or the acceleration jumps
/// and it depends on the jerk (docs/theory.md, "Class and jumps"). `uses` tells which of s, v, a, j
/// the curve depends on.
///
/// Jumps count between pieces of the law, between stretches, and where a whole turn begins again.
/// At the two ends of a cycle that does not begin again a jump of velocity counts against what the
/// law declares there, and one of acceleration does not: what was before is not known.
std::optional<double> pulse_place(const Cycle& cycle, const Law<double>& law,
                                  const std::array<bool, 4>& uses);

/// Whether the velocity jumps, so that the acceleration has a pulse: no mean over the cycle holds
/// it.
template <class T>
bool has_pulse(const Cycle& cycle, const Law<T>& law) {
  return pulse_place(cycle, law.template as<double>(), {false, false, true, false}).has_value();
}

}  // namespace camlaw::problems
