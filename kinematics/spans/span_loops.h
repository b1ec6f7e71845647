// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/spans/span_kernels.h"
#include "numerics/lanes/sine_cosine.h"

/// The loops of SpanKernels for vectors V. Included by the files that are compiled for one
/// instruction set each, and by nothing else.
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
struct Stretch {
  using Bits = typename lanes::Unsigned<V>::Type;

  std::uint64_t first, last;
  bool from_zero;

  Stretch(double low, double high)
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
std::size_t run_blocks(const Stretch<V>& stretch, const double* x, std::size_t n, MotionRows out,
                       const Body& body) {
  constexpr std::size_t kBlock = 4 * kWidth<V>;
  std::size_t i = 0;
  for (; i + kBlock <= n; i += kBlock) {
    typename Stretch<V>::Bits outside = {};
    for (std::size_t k = i; k < i + kBlock; k += kWidth<V>) {
      const V at = load<V>(x + k);
      outside |= stretch.template outside<FromZero>(at);
      put(body(at), out, k);
    }
    if (lanes::any_high_bit(outside)) break;
  }
  return i;
}

/// Body gives the motion at a vector of points. The points that are left over fill up one vector
/// with the first of them, so that each lane is computed as any other.
template <class V, class Body>
std::size_t run(const PieceNumbers& piece, const double* x, std::size_t n, MotionRows out,
                const Body& body) {
  const Stretch<V> stretch(piece.low, piece.high);
  std::size_t i = stretch.from_zero ? run_blocks<V, true>(stretch, x, n, out, body)
                                    : run_blocks<V, false>(stretch, x, n, out, body);
  const auto inside = [&](std::size_t k) { return x[k] >= piece.low && x[k] < piece.high; };
  while (i < n && inside(i)) {
    V some = V{} + x[i];
    std::size_t count = 0;
    for (; count < kWidth<V> && i + count < n && inside(i + count); ++count) {
      some[count] = x[i + count];
    }
    const Lanes<V> m = body(some);
    put_some(m, out, i, count);
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
      const double w = h[2], w2 = w * w;
      const auto [sine, cosine] = lanes::sine_cosine<V>(w * t);
      const V wave = h[0] * sine + h[1] * cosine, slope = w * (h[0] * cosine - h[1] * sine);
      m.s += wave;
      m.v += slope;
      m.a -= w2 * wave;
      m.j -= w2 * slope;
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

// ---------------------------------------------------------------------------------------------

/// The numbers of a row, in each lane those of its own piece.
template <class V>
struct RowNumbers {
  V at[PieceRows::kNumbers];
};

template <class V>
RowNumbers<V> same_row(const double* row) {
  RowNumbers<V> numbers{};
  for (std::size_t k = 0; k < PieceRows::kNumbers; ++k) numbers.at[k] += row[k];
  return numbers;
}

/// Gives the rows of the lanes' pieces, from memory.
template <class V>
class RowsInMemory {
 public:
  explicit RowsInMemory(const PieceRows& law) : rows_(law.rows) {}

  RowNumbers<V> operator()(const lanes::Integers<V>& piece) const {
    constexpr std::size_t kLanes = kWidth<V>;
    std::int64_t number[kLanes];
    __builtin_memcpy(number, &piece, sizeof piece);
    RowNumbers<V> numbers;
#pragma GCC unroll 4
    for (std::size_t first = 0; first < PieceRows::kNumbers; first += kLanes) {
      V part[kLanes];
#pragma GCC unroll 8
      for (std::size_t l = 0; l < kLanes; ++l) {
        part[l] = load<V>(rows_ + number[l] * PieceRows::kNumbers + first);
      }
      lanes::transpose<V>(part);
#pragma GCC unroll 8
      for (std::size_t k = 0; k < kLanes; ++k) numbers.at[first + k] = part[k];
    }
    return numbers;
  }

 private:
  const double* rows_;
};

/// The same from registers, for laws with fewer than two pieces per lane: each number of all rows
/// is a table.
template <class V>
class RowsInRegisters {
 public:
  static bool holds(const PieceRows& law) { return law.count < 2 * kWidth<V>; }

  explicit RowsInRegisters(const PieceRows& law) {
    for (std::size_t k = 0; k < PieceRows::kNumbers; ++k) {
      double column[2 * kWidth<V>] = {};
      for (std::size_t row = 0; row <= law.count; ++row) {
        column[row] = law.rows[row * PieceRows::kNumbers + k];
      }
      first_[k] = load<V>(column);
      second_[k] = load<V>(column + kWidth<V>);
    }
  }

  RowNumbers<V> operator()(const lanes::Integers<V>& piece) const {
    RowNumbers<V> numbers;
#pragma GCC unroll 8
    for (std::size_t k = 0; k < PieceRows::kNumbers; ++k) {
      numbers.at[k] = __builtin_shuffle(first_[k], second_[k], piece);
    }
    return numbers;
  }

 private:
  V first_[PieceRows::kNumbers], second_[PieceRows::kNumbers];
};

/// The motion at x; `Waves`: whether any of the rows has a harmonic.
template <class V, int Degree, bool Wave, bool Waves>
Lanes<V> row_motion(const RowNumbers<V>& row, const V& x) {
  const V* c = row.at;
  const V t = x - c[Wave ? 4 : 7];
  V b0 = c[Degree], b1 = {}, b2 = {}, b3 = {};  // s, v, a / 2, j / 6
  for (int k = Degree - 1; k >= 0; --k) {
    const int order = Degree - k;  // of the highest derivative that is not 0 so far
    if (order > 3) b3 = b3 * t + b2;
    if (order == 3) b3 = b2;
    if (order > 2) b2 = b2 * t + b1;
    if (order == 2) b2 = b1;
    b1 = order > 1 ? b1 * t + b0 : b0;
    b0 = b0 * t + c[k];
  }
  Lanes<V> m{b0, b1, 2.0 * b2, 6.0 * b3};
  if constexpr (Waves) {
    const V p = c[5], q = c[6], w = c[7], w2 = w * w;
    const auto [sine, cosine] = lanes::sine_cosine<V>(w * t);
    const V wave = p * sine + q * cosine, slope = w * (p * cosine - q * sine);
    m.s += wave;
    m.v += slope;
    m.a -= w2 * wave;
    m.j -= w2 * slope;
  } else if constexpr (Wave) {
    m.s += 0.0;  // as what is left out would: -0 becomes 0
    m.v += 0.0;
    m.a -= 0.0;
    m.j -= 0.0;
  }
  return m;
}

/// Finds each point's piece; law.count stands for points outside and for NaN.
template <class V>
lanes::Integers<V> find_pieces(const PieceRows& law, const V& x) {
  constexpr std::size_t kMany = 32;  // are searched for by halves
  lanes::Integers<V> piece = {};
  if (law.count <= kMany) {
    for (std::size_t k = 0; k < law.count; ++k) piece -= ~(x < law.ends[k]);
  } else {
    for (std::size_t l = 0; l < kWidth<V>; ++l) {
      std::size_t first = 0;
      for (std::size_t left = law.count; left > 0;) {
        const std::size_t half = left / 2;
        const bool above = !(x[l] < law.ends[first + half]);
        first = above ? first + half + 1 : first;
        left = above ? left - half - 1 : half;
      }
      piece[l] = static_cast<std::int64_t>(first);
    }
  }
  return (x < 0.0) ? lanes::Integers<V>{} + static_cast<std::int64_t>(law.count) : piece;
}

/// The points from the first on that lie in its piece, where a block of them does; how many.
template <class V, int Degree, bool Wave>
std::size_t run_of_rows(const PieceRows& law, const double* x, std::size_t n, MotionRows out) {
  const auto piece = static_cast<std::size_t>(find_pieces<V>(law, V{} + x[0])[0]);
  if (piece >= law.count) return 0;
  const double low = piece == 0 ? 0 : law.ends[piece - 1], high = law.ends[piece];
  const auto inside = [&](std::size_t k) { return x[k] >= low && x[k] < high; };
  if (!inside(1) || !inside(2) || !inside(4 * kWidth<V> - 1)) return 0;
  const double* numbers = law.rows + piece * PieceRows::kNumbers;
  const auto row = same_row<V>(numbers);
  const Stretch<V> stretch(low, high);
  if (Wave && numbers[5] == 0 && numbers[6] == 0) {  // no harmonic: its terms would be zeros
    return run_blocks<V, false>(stretch, x, n, out, [&](const V& at) {
      return row_motion<V, Degree, Wave, false>(row, at);
    });
  }
  return run_blocks<V, false>(
      stretch, x, n, out, [&](const V& at) { return row_motion<V, Degree, Wave, Wave>(row, at); });
}

template <class V, int Degree, bool Wave, class Table>
void motion_of_rows(const PieceRows& law, const Table& table, const double* x, std::size_t n,
                    MotionRows out) {
  constexpr std::size_t kBlock = 4 * kWidth<V>;
  const auto motion = [&](const V& at) {
    return row_motion<V, Degree, Wave, Wave>(table(find_pieces<V>(law, at)), at);
  };
  std::size_t i = 0;
  while (i + kBlock <= n) {
    i += run_of_rows<V, Degree, Wave>(law, x + i, n - i, out.from(i));
    for (std::size_t k = 0; k < 2 * kBlock && i + kWidth<V> <= n; k += kWidth<V>, i += kWidth<V>) {
      put(motion(load<V>(x + i)), out, i);
    }
  }
  while (i < n) {
    V some = V{} + x[i];
    const std::size_t count = n - i < kWidth<V> ? n - i : kWidth<V>;
    for (std::size_t k = 0; k < count; ++k) some[k] = x[i + k];
    put_some(motion(some), out, i, count);
    i += count;
  }
}

template <class V, int Degree, bool Wave>
void motion_of_rows(const PieceRows& law, const double* x, std::size_t n, MotionRows out) {
#if defined(__AVX512F__) && !defined(__clang__)  // which lacks __builtin_shuffle
  if (RowsInRegisters<V>::holds(law)) {
    return motion_of_rows<V, Degree, Wave>(law, RowsInRegisters<V>(law), x, n, out);
  }
#endif
  motion_of_rows<V, Degree, Wave>(law, RowsInMemory<V>(law), x, n, out);
}

template <class V>
void motion_by_rows(const PieceRows& law, const double* x, std::size_t n, MotionRows out) {
  if (law.wave) {
    return law.degree <= 1 ? motion_of_rows<V, 1, true>(law, x, n, out)
                           : motion_of_rows<V, 3, true>(law, x, n, out);
  }
  return law.degree <= 3   ? motion_of_rows<V, 3, false>(law, x, n, out)
         : law.degree <= 5 ? motion_of_rows<V, 5, false>(law, x, n, out)
                           : motion_of_rows<V, 6, false>(law, x, n, out);
}

template <int Width>
constexpr SpanKernels kernels(const char* instruction_set) {
  using V = typename lanes::Vector<Width>::Type;
  return {instruction_set, Width, motion<V>, motion_by_rows<V>};
}

}  // namespace camlaw::span_loops
