// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "machines/index_drives/index_load.h"
#include "numerics/formula/expression.h"

/// How the rollers of a turret share what a cycle does to them (docs/theory.md, "Rollers of a
/// turret").
namespace camlaw {

/// Places in the order in which rollers serve in a cycle. The last one is the first of the cycle
/// that follows, in whose dwell the roller has already taken over.
inline constexpr int kServed = kMostHandovers + 1;

/// A roller takes over when its place is reached but for this part of a step: a dwell at a
/// hand-over is the taking roller's, in spite of rounding. A motion comes to rest with the cube of
/// the time, so this is the last half of a hundredth of it; with less, intervals would leave the
/// moment open by more than a limit's tolerance.
inline constexpr double kPlaceRounding = 1e-7;

/// What a roller gains, by the turret's gain y since the first one took over, while it serves as
/// the one of this place; 0 otherwise.
inline Expression while_serving(const Expression& y, const Expression& step, int place,
                                const Expression& gain) {
  const Expression none = 0;
  // The end of one place and the beginning of the next are the same formula, to the last bit.
  const auto beyond = [&](int k) { return y / step - Expression(k - kPlaceRounding); };
  const Expression until_next = by_side(beyond(place + 1), none, gain);
  return place == 0 ? until_next : by_side(beyond(place), until_next, none);
}

/// 0 or above where a whole number is a multiple of another one.
inline Expression divided_by(const Expression& whole, int divisor) {
  // The cosine is 1, or at most cos(2 pi / kServed) = 0.77.
  return cos(2 * pi() / divisor * whole) - Expression(0.9);
}

/// (IX23) What the roller that bears most gains in a cycle of the cam, from what those of all
/// places gain together: the rollers of a turret serve in the same places after every g-th, where g
/// is the greatest common divisor of the hand-overs in a cycle and of all rollers.
inline Expression most_of_a_roller(std::span<const Expression> by_place,
                                   const Expression& handovers, const Expression& rollers) {
  Expression most = 0;
  for (int g = 1; g <= kMostHandovers; ++g) {
    std::vector<Expression> sums(static_cast<std::size_t>(g), 0);
    for (std::size_t place = 0; place < by_place.size(); ++place) {
      Expression& sum = sums[place % sums.size()];
      sum = sum + by_place[place];
    }
    Expression greatest = sums.front();
    for (const Expression& sum : sums) greatest = greater_of(greatest, sum);
    const Expression shared = g * greatest / rollers;
    const Expression divides = lesser_of(divided_by(handovers, g), divided_by(rollers, g));
    most = g == 1 ? shared : by_side(divides, shared, most);
  }
  return most;
}

}  // namespace camlaw
