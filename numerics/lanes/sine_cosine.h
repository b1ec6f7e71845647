// SPDX-License-Identifier: MIT
#pragma once

#include "numerics/lanes/lanes.h"

namespace camlaw::lanes {
inline namespace CAMLAW_LANES {

template <class V>
struct SineCosine {
  V sine, cosine;
};

/// Angles that sine_cosine takes, to either side of 0: n times 33 bits is exact up to n = 2^20.
inline constexpr double kLargestAngle = 1.6e6;

/// Sine and cosine of an angle in radians, |x| <= kLargestAngle, within 1.5 ulp and 1e-26 |x|; NaN
/// of NaN.
///
/// x = n pi/2 + y with |y| <= pi/4, n times the first 33 bits of pi/2 is subtracted exactly, then n
/// times the remainder; the polynomials are those of FreeBSD's msun (k_sin.c, k_cos.c;
/// Copyright 1993 Sun Microsystems, freely granted), without branches.
template <class V>
SineCosine<V> sine_cosine(const V& x) {
  using I = Integers<V>;
  constexpr double kTwoOverPi = 6.36619772367581382433e-01;
  constexpr double kHalfPi = 1.57079632673412561417e+00;    // 33 bits of pi / 2
  constexpr double kRestOfIt = 6.07710050650619224932e-11;  // what they leave
  constexpr double kRounds = 0x1.8p52;                      // x + kRounds has no bits below 1

  const V rounded = x * kTwoOverPi + kRounds;
  const I quadrant = bits_as<I>(rounded);
  const V n = rounded - kRounds;
  const V nearly = x - n * kHalfPi, rest = n * kRestOfIt;
  const V y = nearly - rest;

  const V z = y * y;
  const V s = 8.33333333332248946124e-03 +
              z * (-1.98412698298579493134e-04 +
                   z * (2.75573137070700676789e-06 +
                        z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)));
  const V sine = y + (z * y) * (-1.66666666666666324348e-01 + z * s);

  const V c = z * (4.16666666666666019037e-02 +
                   z * (-1.38888888888741095749e-03 + z * 2.48015872894767294178e-05)) +
              (z * z) * (z * z) *
                  (-2.75573143513906633035e-07 +
                   z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11));
  const V cosine = 1.0 - (0.5 * z - z * c);

  const I odd = (quadrant & 1) != 0;
  const I sign_of_sine = (quadrant & 2) << 62, sign_of_cosine = ((quadrant + 1) & 2) << 62;
  return {bits_as<V>(bits_as<I>(odd ? cosine : sine) ^ sign_of_sine),
          bits_as<V>(bits_as<I>(odd ? sine : cosine) ^ sign_of_cosine)};
}

}  // namespace CAMLAW_LANES
}  // namespace camlaw::lanes
