// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

/// The loops over many points of one piece, once for each instruction set. This header and those
/// that the loops are compiled with name no other part of camlaw and no container: a function that
/// is shared with other files would be compiled for a processor that may not be there.
namespace camlaw {

/// Where s, v, a, j of points go.
struct MotionRows {
  double *s, *v, *a, *j;

  [[gnu::always_inline]] MotionRows from(std::size_t i) const {
    return {s + i, v + i, a + i, j + i};
  }
};

/// Polynomial plus harmonics in t = x - origin, as Piece has them.
struct PieceNumbers {
  double low = 0, high = 1;  ///< it has the points [low, high)
  double origin = 0;
  const double* polynomial = nullptr;  ///< coefficients of t^0, t^1, ...
  std::size_t terms = 0;
  const double* harmonics = nullptr;  ///< sine, cosine and frequency of each
  std::size_t waves = 0;
};

/// A law of several pieces, each of which is a row of eight numbers: c_0 to c_6 and the origin of a
/// polynomial; or c_0 to c_3, origin, sine, cosine and frequency of a polynomial with one harmonic.
struct PieceRows {
  /// A row fills a cache line of 64 bytes, and a vector of the widest set.
  static constexpr std::size_t kNumbers = 8;

  const double* ends = nullptr;  ///< what each piece's points lie below; the pieces begin at 0
  std::size_t count = 0;         ///< pieces
  /// One more row than pieces: the last one, NaN, is that of points outside.
  const double* rows = nullptr;
  std::size_t degree = 0;  ///< the highest, 6 at most; with a harmonic 3
  bool wave = false;       ///< whether rows have a harmonic
};

struct SpanKernels {
  const char* instruction_set;
  std::size_t width;  ///< points at a time

  /// s, v, a, j of the points from the first on that lie in the piece, and how many of n these are;
  /// the results of others may be overwritten. The harmonics' angles are at most
  /// lanes::kLargestAngle.
  std::size_t (*motion)(const PieceNumbers& piece, const double* x, std::size_t n, MotionRows out);
  /// s, v, a, j of n points in any order; NaN of points that no piece has.
  void (*motion_by_rows)(const PieceRows& law, const double* x, std::size_t n, MotionRows out);
};

/// Those that this processor can run, the quickest first; the last one runs everywhere.
std::span<const SpanKernels* const> span_kernels();

}  // namespace camlaw
