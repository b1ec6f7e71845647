// SPDX-License-Identifier: MIT
#pragma once

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "numerics/lanes/lanes.h"

/// Square root, arctangent, arcsine and logarithm of the numbers of a vector. Each is the same list
/// of operations in every width, without branches; NaN gives NaN. The polynomials are those of
/// FreeBSD's msun (s_atan.c, e_asin.c, e_log.c; Copyright 1993 Sun Microsystems, freely granted).
namespace camlaw::lanes {
inline namespace CAMLAW_LANES {

/// Rounded correctly; NaN below 0, and -0 of -0.
template <class V>
V square_root(const V& x) {
#if defined(__SSE2__)
  if constexpr (kWidth<V> == 2) return _mm_sqrt_pd(x);
#endif
#if defined(__AVX__)
  if constexpr (kWidth<V> == 4) return _mm256_sqrt_pd(x);
#endif
#if defined(__AVX512F__)
  if constexpr (kWidth<V> == 8) return _mm512_maskz_sqrt_pd(0xff, x);
#endif
  V result;
  for (std::size_t i = 0; i < kWidth<V>; ++i) result[i] = __builtin_sqrt(x[i]);
  return result;
}

/// The bit of the sign alone.
template <class V>
Integers<V> sign_of(const V& x) {
  constexpr std::int64_t kSign = -0x7fffffffffffffff - 1;
  return bits_as<Integers<V>>(x) & kSign;
}

template <class V>
V size_of(const V& x) {
  return bits_as<V>(bits_as<Integers<V>>(x) ^ sign_of(x));
}

template <class V>
V with_sign(const V& size, const Integers<V>& sign) {
  return bits_as<V>(bits_as<Integers<V>>(size) | sign);
}

/// Arctangent in radians, within 2.6 ulp (1.91 seen); -0 of -0.
///
/// atan |x| = c + atan t: c = 0 and t = x below 7/16; c = pi/4 and t = (x - 1) / (x + 1) up to
/// 16/7; above it c = pi/2 and t = -1/x. So |t| <= 7/16, where the polynomial holds.
template <class V>
V arctangent(const V& x) {
  // The nearest double to pi / 4, and what it leaves.
  constexpr double kQuarterPi = 7.85398163397448278999e-01, kRest = 3.06161699786838301793e-17;
  const V size = size_of(x), none = {}, one = none + 1.0;
  const auto low = size<0.4375, high = size> 16.0 / 7;

  const V t = (low ? size : (high ? -one : size - 1.0)) / (low ? one : (high ? size : size + 1.0));
  const V z = t * t, w = z * z;
  const V odd =
      z * (3.33333333333329318027e-01 +
           w * (1.42857142725034663711e-01 +
                w * (9.09088713343650656196e-02 +
                     w * (6.66107313738753120669e-02 +
                          w * (4.97687799461593236017e-02 + w * 1.62858201153657823623e-02)))));
  const V even =
      w * (-1.99999999998764832476e-01 +
           w * (-1.11111104054623557880e-01 +
                w * (-7.69187620504482999495e-02 +
                     w * (-5.83357013379057348645e-02 + w * -3.65315727442169155270e-02))));

  const V turn = low ? none : none + kQuarterPi, rest = low ? none : none + kRest;
  const V base = high ? turn + turn : turn, base_rest = high ? rest + rest : rest;
  return with_sign<V>(base - ((t * (odd + even) - base_rest) - t), sign_of(x));
}

/// Arcsine in radians, within 1.5 ulp (0.89 seen); NaN beyond 1, and -0 of -0.
///
/// Below 1/2 it is x + x R(x^2); above, asin |x| = pi/2 - 2 asin sqrt((1 - |x|) / 2), the root s in
/// two parts: its leading bits f, and c = (s^2 - f^2) / (s + f).
template <class V>
V arcsine(const V& x) {
  using I = Integers<V>;
  // What the nearest double to pi / 2 leaves.
  constexpr double kHalfPiRest = 6.12323399573676603587e-17;
  constexpr double kQuarterPi = 7.85398163397448278999e-01;
  const V size = size_of(x);
  const auto low = size < 0.5;

  const V t = low ? size * size : (1.0 - size) * 0.5;
  const V p =
      t * (1.66666666666666657415e-01 +
           t * (-3.25565818622400915405e-01 +
                t * (2.01212532134862925881e-01 +
                     t * (-4.00555345006794114027e-02 +
                          t * (7.91534994289814532176e-04 + t * 3.47933107596021167570e-05)))));
  const V q = 1.0 + t * (-2.40339491173441421878e+00 +
                         t * (2.02094576023350569471e+00 +
                              t * (-6.88283971605453293030e-01 + t * 7.70381505559019352791e-02)));
  const V ratio = p / q;

  const V s = square_root(t);
  const V f = bits_as<V>(bits_as<I>(s) & (I{} + ~0xffffffffLL));
  const V both = s + f;
  const V c = (t - f * f) / (both == 0.0 ? V{} + 1.0 : both);
  const V far = kQuarterPi - ((2.0 * s * ratio - (kHalfPiRest - 2.0 * c)) - (kQuarterPi - 2.0 * f));
  return with_sign<V>(low ? size + size * ratio : far, sign_of(x));
}

/// Natural logarithm, within 1 ulp (0.84 seen); -infinity of 0, NaN below it.
///
/// x = 2^k (1 + f) with sqrt(1/2) <= 1 + f < sqrt(2), and log(1 + f) by s = f / (2 + f).
template <class V>
V logarithm(const V& x) {
  using U = typename Unsigned<V>::Type;
  constexpr double kLog2 = 6.93147180369123816490e-01;      // its leading bits
  constexpr double kLog2Rest = 1.90821492927058770002e-10;  // what they leave
  // The leading bits of sqrt(1/2), and of 1: 1 + f begins at the first.
  constexpr std::uint64_t kRootOfHalf = 0x3fe6a09eULL << 32, kOne = 0x3ff00000ULL << 32;
  constexpr std::uint64_t kFraction = 0xfffffffffffffULL;  // the bits of a number's fraction
  constexpr double kInfinity = __builtin_inf();
  const V none = {};

  const auto tiny = x < 0x1p-1022;
  const U bits = bits_as<U>(tiny ? x * 0x1p54 : x) + (kOne - kRootOfHalf);
  const V k = bits_as<V>((bits >> 52) | 0x4330000000000000ULL) -
              (tiny ? none + (0x1p52 + 1023 + 54) : none + (0x1p52 + 1023));
  const V f = bits_as<V>((bits & kFraction) + kRootOfHalf) - 1.0;
  const V half_square = 0.5 * f * f, s = f / (2.0 + f), z = s * s, w = z * z;
  const V even = w * (3.999999999940941908e-01 +
                      w * (2.222219843214978396e-01 + w * 1.531383769920937332e-01));
  const V odd = z * (6.666666666666735130e-01 +
                     w * (2.857142874366239149e-01 +
                          w * (1.818357216161805012e-01 + w * 1.479819860511658591e-01)));
  const V result = s * (half_square + (odd + even)) + k * kLog2Rest - half_square + f + k * kLog2;
  const V outside = x == 0.0 ? none - kInfinity : none + __builtin_nan("");
  return x > 0.0 ? (x < kInfinity ? result : x) : outside;
}

}  // namespace CAMLAW_LANES
}  // namespace camlaw::lanes
