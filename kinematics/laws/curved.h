// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/laws/build.h"

/// Laws that are not polynomial plus harmonics. Equations: docs/theory.md, "Curves".
namespace camlaw {

// Each arc is two pieces, which count from the arc's ends: there its derivatives have no bound, and
// an end that stays where it is must not seem to move by rounding.

/// Half-ellipse of velocity: s' = (4 / pi) sqrt(1 - (2x - 1)^2). The acceleration has no bound at
/// the ends.
template <class T>
Law<T> half_ellipse_velocity() {
  const T zero = number<T>(0), half = ratio<T>(1, 2), one = number<T>(1), two = number<T>(2);
  const T level = two / pi<T>();
  const HalfEllipse<T> arc{1};
  return Law<T>({{zero, half, zero, {}, {}, {{level, two, -one, arc}}},
                 {half, one, one, {}, {}, {{level, two, one, arc}}}},
                {});
}

/// Half-ellipses of acceleration: s'' = (16 / pi) sqrt(1 - (4x - 1)^2) up to 1/2, then mirrored.
template <class T>
Law<T> half_ellipse_acceleration() {
  const T zero = number<T>(0), half = ratio<T>(1, 2), one = number<T>(1), four = number<T>(4);
  const T first = ratio<T>(1, 4), second = ratio<T>(3, 4);
  const T level = one / pi<T>();
  const HalfEllipse<T> arc{2};
  return Law<T>({{zero, first, zero, {}, {}, {{level, four, -one, arc}}},
                 {first, half, half, {}, {}, {{level, four, one, arc}}},
                 {half, second, half, {one}, {}, {{-level, -four, one, arc}}},
                 {second, one, one, {one}, {}, {{-level, -four, -one, arc}}}},
                {});
}

/// The elliptic law: s = [1 - cos(pi x) / sqrt(1 - k sin^2(pi x))] / 2, k = (n^2 - 1) / n^2;
/// B = n pi / 2 from n = sqrt(2/3) on. n = 1 is the cosine law.
template <class T>
Law<T> elliptic(const T& n) {
  return curve_law<T>(Ellipse<T>{n});
}

/// The inclined sinusoid: a sine drawn along the chord from (0, 0) to (1, 1), its ordinates leaning
/// at `angle` (radians) from the x axis of the unit square; pi / 2 draws them upright, which is the
/// cycloid. B = 2 / (1 + cot(angle)). The angle must lie strictly between pi / 4 and 3 pi / 4.
template <class T>
Law<T> inclined_sinusoid(const T& angle) {
  using std::cos;
  using std::sin;
  return curve_law<T>(InclinedSine<T>{cos(angle) / sin(angle)});
}

}  // namespace camlaw
