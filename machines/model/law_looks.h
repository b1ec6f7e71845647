// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "machines/model/law_binding.h"

/// Looks at a law or a piece in any scalar: each takes it to the four numbers that are wanted of
/// it.
namespace camlaw::problems {

/// An x that rounding has set beside a break is at it: angles turned into x, and the breaks of laws
/// in other scalars, differ in the last places.
template <class S>
double at_break(const Law<S>& law, double x) {
  constexpr double kBeside = 1e-14;  // of the law's length: some fifty units of the last place
  const auto& pieces = law.pieces();
  const auto near = std::partition_point(pieces.begin(), pieces.end(), [&](const auto& piece) {
    return value_of(piece.end) < x - kBeside;
  });
  const bool beside = near != pieces.end() && std::abs(x - value_of(near->end)) <= kBeside;
  return beside ? value_of(near->end) : x;
}

/// Four derivatives of s at a place, from the first on: s, v, a, j from 0.
struct AtPlace {
  double x;
  Side side;
  std::size_t first = 0;

  template <class S>
  std::array<S, 4> operator()(const Law<S>& law) const {
    if (first == 0) return law.template derivatives<4>(at_break(law, x), side);
    const auto d = law.template derivatives<5>(at_break(law, x), side);
    return {d[1], d[2], d[3], d[4]};
  }
};

/// What a law says of a place that it does not have.
template <class S>
std::array<S, 4> nowhere() {
  std::array<S, 4> none;
  none.fill(number<S>(std::numeric_limits<double>::quiet_NaN()));
  return none;
}

/// s, v, a, j where a piece meets the next one.
struct AtJoint {
  std::size_t piece;
  Side side;

  template <class S>
  std::array<S, 4> operator()(const Law<S>& law) const {
    const auto& pieces = law.pieces();
    if (piece + 1 >= pieces.size()) return nowhere<S>();
    const auto& here = pieces[side == Side::Left ? piece : piece + 1];
    return derivatives<4>(here, pieces[piece].end);
  }
};

/// A derivative of s at an end of a piece, alone.
struct AtEnd {
  PieceEnd end;
  std::size_t order;

  template <class S>
  std::array<S, 4> operator()(const Piece<S>& piece) const {
    const auto d = derivatives<LawBinding::kEndOrders>(piece, end.is_end ? piece.end : piece.begin);
    const S zero = number<S>(0);
    return {d[order], zero, zero, zero};
  }
  template <class S>
  std::array<S, 4> operator()(const Law<S>& law) const {
    return end.piece < law.pieces().size() ? (*this)(law.pieces()[end.piece]) : nowhere<S>();
  }
};

/// The x of an end of a piece, alone.
struct AtEndPlace {
  PieceEnd end;

  template <class S>
  std::array<S, 4> operator()(const Law<S>& law) const {
    std::array<S, 4> result = nowhere<S>();
    if (end.piece >= law.pieces().size()) return result;
    const Piece<S>& piece = law.pieces()[end.piece];
    result[0] = end.is_end ? piece.end : piece.begin;
    return result;
  }
};

/// Four derivatives of s at a place of one piece, from the first on.
struct AtPiecePlace {
  double x;
  std::size_t first;

  template <class S>
  std::array<S, 4> operator()(const Piece<S>& piece) const {
    const auto d = derivatives<5>(piece, x);
    return {d[first], d[first + 1], d[first + 2], d[first + 3]};
  }
};

}  // namespace camlaw::problems
