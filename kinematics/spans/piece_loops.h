// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/spans/span_kernels.h"
#include "numerics/lanes/sine_cosine.h"

/// The loops over points of one piece, for vectors V. Included by span_loops.h alone.
namespace camlaw::span_loops {

using lanes::kWidth, lanes::load, lanes::store;

template <class V>
struct Lanes {
  V s, v, a, j;
};

/// The points [low, high) of a piece, 0 <= low. Doubles from 0 up stand in the order of their bits
/// read as integers, so the sign bit of a difference tells a point outside, a negative one and a
/// NaN too: comparisons of doubles would wait for the arithmetic's units.
template <class V>
struct PieceStretch {
  using Bits = typename lanes::Unsigned<V>::Type;

  std::uint64_t first, last;
  bool from_zero;

  PieceStretch(double low, double high)
      : first(lanes::bits_as<std::uint64_t>(low)),
        last(lanes::bits_as<std::uint64_t>(high) - 1),
        from_zero(low == 0) {}

  /// The highest bit is set in the lanes that are outside.
  template <bool FromZero>
  Bits outside(const V& at) const {
    const auto bits = lanes::bits_as<Bits>(at);
    if constexpr (FromZero) return bits | (last - bits);
    return bits | (last - bits) | (bits - first);
  }
};

/// Adds p sin(wt) + q cos(wt) and its derivatives.
template <class V, class Number>
void add_harmonic(const Number& p, const Number& q, const Number& w, const V& t, Lanes<V>& m) {
  const Number w2 = w * w;
  const auto [sine, cosine] = lanes::sine_cosine<V>(w * t);
  const V wave = p * sine + q * cosine, slope = w * (p * cosine - q * sine);
  m.s += wave;
  m.v += slope;
  m.a -= w2 * wave;
  m.j -= w2 * slope;
}

/// The first `count` points, and the first of them in the lanes that are left.
template <class V>
V load_some(const double* from, std::size_t count) {
  V result = V{} + from[0];
  for (std::size_t k = 0; k < count; ++k) result[k] = from[k];
  return result;
}

template <class V>
void put(const Lanes<V>& m, MotionRows out, std::size_t i) {
  store(m.s, out.s + i);
  store(m.v, out.v + i);
  store(m.a, out.a + i);
  store(m.j, out.j + i);
}

template <class V>
void put_some(const Lanes<V>& m, MotionRows out, std::size_t i, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k, ++i) {
    out.s[i] = m.s[k];
    out.v[i] = m.v[k];
    out.a[i] = m.a[k];
    out.j[i] = m.j[k];
  }
}

/// Whole blocks from the first point on while all of a block is inside; how many points these are.
/// What is computed of the block that is not is to be overwritten.
template <class V, bool FromZero, class Body>
std::size_t run_blocks(const PieceStretch<V>& stretch, const double* x, std::size_t n,
                       MotionRows out, const Body& body) {
  // Four vectors side by side hide each other's latency.
  constexpr std::size_t kBlock = 4 * kWidth<V>;
  std::size_t i = 0;
  for (; i + kBlock <= n; i += kBlock) {
    typename PieceStretch<V>::Bits outside = {};
    for (std::size_t k = i; k < i + kBlock; k += kWidth<V>) {
      const V at = load<V>(x + k);
      outside |= stretch.template outside<FromZero>(at);
      put(body(at), out, k);
    }
    if (lanes::any_high_bit(outside)) break;
  }
  return i;
}

/// Body gives the motion at a vector of points. The points that are left over fill up one vector,
/// so that each lane is computed as any other.
template <class V, class Body>
std::size_t run(const PieceNumbers& piece, const double* x, std::size_t n, MotionRows out,
                const Body& body) {
  const PieceStretch<V> stretch(piece.low, piece.high);
  std::size_t i = stretch.from_zero ? run_blocks<V, true>(stretch, x, n, out, body)
                                    : run_blocks<V, false>(stretch, x, n, out, body);
  const auto inside = [&](std::size_t k) { return x[k] >= piece.low && x[k] < piece.high; };
  while (i < n && inside(i)) {
    std::size_t count = 1;
    while (count < kWidth<V> && i + count < n && inside(i + count)) ++count;
    put_some(body(load_some<V>(x + i, count)), out, i, count);
    i += count;
  }
  return i;
}

/// t to a power known to the compiler; 1 for none.
template <int Exponent, class V>
V power(const V& t) {
  V result = V{} + 1.0;
  for (int i = 0; i < Exponent; ++i) result *= t;
  return result;
}

/// The derivative of order m of a polynomial whose coefficients below Low are zero, as at rest:
/// what becomes of term k is c[k] t^(k - m). Drawing out t^(Low - m) spares the work of the zeros.
template <int Degree, int Low, int m, class V>
V derivative(const V* c, const V& t) {
  V sum = c[Degree];
  for (int k = Degree - 1; k >= (Low > m ? Low : m); --k) sum = sum * t + c[k];
  if constexpr (Low > m) sum *= power<Low - m>(t);
  return sum;
}

/// Polynomial of a degree known to the compiler, its coefficients below Low zero; its origin is 0
/// where Low is not.
template <class V, int Degree, int Low>
std::size_t polynomial(const PieceNumbers& piece, const double* x, std::size_t n, MotionRows out) {
  V c[4][Degree + 1] = {};
  for (int k = 0; k <= Degree; ++k) c[0][k] += piece.polynomial[k];
  for (int m = 1; m < 4; ++m) {
    for (int k = m; k <= Degree; ++k) c[m][k] = (k - m + 1.0) * c[m - 1][k];
  }
  const double origin = piece.origin;
  return run<V>(piece, x, n, out, [=](const V& at) -> Lanes<V> {
    const V t = Low > 0 ? at : at - origin;
    return {derivative<Degree, Low, 0>(c[0], t), derivative<Degree, Low, 1>(c[1], t),
            derivative<Degree, Low, 2>(c[2], t), derivative<Degree, Low, 3>(c[3], t)};
  });
}

template <class V, int Degree>
std::size_t degree(const PieceNumbers& piece, const double* x, std::size_t n, MotionRows out) {
  if constexpr (Degree >= 5) {  // the least that can rest at both ends without a jump of s''
    const double* c = piece.polynomial;
    if (piece.origin == 0 && c[0] == 0 && c[1] == 0 && c[2] == 0) {
      return c[3] == 0 ? polynomial<V, Degree, 4>(piece, x, n, out)
                       : polynomial<V, Degree, 3>(piece, x, n, out);
    }
  }
  return polynomial<V, Degree, 0>(piece, x, n, out);
}

/// A linear part and one harmonic: the cycloid and every phase of the modified laws.
template <class V>
std::size_t harmonic(const PieceNumbers& piece, const double* x, std::size_t n, MotionRows out) {
  const double c0 = piece.terms > 0 ? piece.polynomial[0] : 0;
  const double c1 = piece.terms > 1 ? piece.polynomial[1] : 0;
  const double p = piece.harmonics[0], q = piece.harmonics[1], w = piece.harmonics[2];
  const double origin = piece.origin, w2 = w * w;
  if (q == 0) {
    const double pw = p * w, pw2 = -(p * w2), pw3 = -(pw * w2);
    return run<V>(piece, x, n, out, [=](const V& at) -> Lanes<V> {
      const V t = at - origin;
      const auto [sine, cosine] = lanes::sine_cosine<V>(w * t);
      return {(c0 + c1 * t) + p * sine, c1 + pw * cosine, pw2 * sine, pw3 * cosine};
    });
  }
  return run<V>(piece, x, n, out, [=](const V& at) -> Lanes<V> {
    const V t = at - origin;
    const auto [sine, cosine] = lanes::sine_cosine<V>(w * t);
    const V wave = p * sine + q * cosine, slope = w * (p * cosine - q * sine);
    return {c0 + c1 * t + wave, c1 + slope, -w2 * wave, -w2 * slope};
  });
}

/// Any number of terms and harmonics.
template <class V>
std::size_t any_data(const PieceNumbers& piece, const double* x, std::size_t n, MotionRows out) {
  return run<V>(piece, x, n, out, [&](const V& at) -> Lanes<V> {
    const V t = at - piece.origin;
    V b0 = {}, b1 = {}, b2 = {}, b3 = {};  // s, v, a / 2, j / 6
    for (std::size_t k = piece.terms; k-- > 0;) {
      b3 = b3 * t + b2;
      b2 = b2 * t + b1;
      b1 = b1 * t + b0;
      b0 = b0 * t + piece.polynomial[k];
    }
    Lanes<V> m{b0, b1, 2.0 * b2, 6.0 * b3};
    for (std::size_t k = 0; k < piece.waves; ++k) {
      const double* h = piece.harmonics + 3 * k;
      add_harmonic(h[0], h[1], h[2], t, m);
    }
    return m;
  });
}

template <class V>
std::size_t motion(const PieceNumbers& piece, const double* x, std::size_t n, MotionRows out) {
  if (piece.waves == 1 && piece.terms <= 2) return harmonic<V>(piece, x, n, out);
  if (piece.waves > 0) return any_data<V>(piece, x, n, out);
  switch (piece.terms) {
    case 2:
      return degree<V, 1>(piece, x, n, out);
    case 3:
      return degree<V, 2>(piece, x, n, out);
    case 4:
      return degree<V, 3>(piece, x, n, out);
    case 5:
      return degree<V, 4>(piece, x, n, out);
    case 6:
      return degree<V, 5>(piece, x, n, out);
    case 7:
      return degree<V, 6>(piece, x, n, out);
    case 8:
      return degree<V, 7>(piece, x, n, out);
    case 9:
      return degree<V, 8>(piece, x, n, out);
    case 10:
      return degree<V, 9>(piece, x, n, out);
    default:
      return any_data<V>(piece, x, n, out);
  }
}

}  // namespace camlaw::span_loops
