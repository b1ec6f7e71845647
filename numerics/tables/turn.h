// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

/// Angles that come round.
namespace camlaw::problems {

inline constexpr double kTurnDegrees = 360;
inline constexpr double kTurn = 2 * std::numbers::pi;
inline constexpr double kDegree = kTurn / kTurnDegrees;

/// The place from `low` to low + period at which a cycle is the same.
inline double in_period(double place, double low, double period) {
  const double within = std::fmod(place - low, period);
  return low + (within < 0 ? within + period : within);
}

/// An angle from 0 to a turn, below it: rad, or in the unit in which a turn is so much.
inline double in_turn(double angle, double turn = kTurn) {
  const double within = angle - turn * std::floor(angle / turn);
  return within < turn ? within : 0;
}

}  // namespace camlaw::problems
