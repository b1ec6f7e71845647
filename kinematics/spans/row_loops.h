// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/spans/piece_loops.h"

/// The loops over points of a law of several pieces, for vectors V. Included by span_loops.h alone.
namespace camlaw::span_loops {

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
    add_harmonic(c[5], c[6], c[7], t, m);
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
  const PieceStretch<V> stretch(low, high);
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
  // Four vectors side by side hide each other's latency.
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
    const std::size_t count = n - i < kWidth<V> ? n - i : kWidth<V>;
    put_some(motion(load_some<V>(x + i, count)), out, i, count);
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

}  // namespace camlaw::span_loops
