// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "machines/index_drives/index_load.h"
#include "numerics/scalar/extremes.h"

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
template <class T, class X>
X while_serving(const X& y, const T& step, int place, const X& gain) {
  const X none = number<X>(0);
  // The end of one place and the beginning of the next are the same formula, to the last bit.
  const auto beyond = [&](int k) { return X(y / step - number<T>(k - kPlaceRounding)); };
  const X until_next = by_side(beyond(place + 1), none, gain);
  return place == 0 ? until_next : by_side(beyond(place), until_next, none);
}

/// 0 or above where a whole number is a multiple of another one.
template <class T>
T divided_by(const T& whole, int divisor) {
  using std::cos;
  // The cosine is 1, or at most cos(2 pi / kServed) = 0.77.
  return cos(number<T>(2) * pi<T>() / number<T>(divisor) * whole) - number<T>(0.9);
}

/// (IX23) What the roller that bears most gains in a cycle of the cam, from what those of all
/// places gain together: the rollers of a turret serve in the same places after every g-th, where g
/// is the greatest common divisor of the hand-overs in a cycle and of all rollers.
template <class T>
T most_of_a_roller(std::span<const T> by_place, const T& handovers, const T& rollers) {
  T most = number<T>(0);
  for (int g = 1; g <= kMostHandovers; ++g) {
    std::vector<T> sums(static_cast<std::size_t>(g), number<T>(0));
    for (std::size_t place = 0; place < by_place.size(); ++place) {
      T& sum = sums[place % sums.size()];
      sum = sum + by_place[place];
    }
    T greatest = sums.front();
    for (const T& sum : sums) greatest = greater_of(greatest, sum);
    const T shared = number<T>(g) * greatest / rollers;
    const T divides = lesser_of(divided_by(handovers, g), divided_by(rollers, g));
    most = g == 1 ? shared : by_side(divides, shared, most);
  }
  return most;
}

}  // namespace camlaw
