// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/expansion.h"
#include "kinematics/law.h"

namespace camlaw {

/// Goes through a law in 64 boxes of x for each piece: visit(begin, length, over) with what s and
/// its derivatives lie within over the box.
template <class Visit>
void visit_boxes(const Law<Interval>& law, Visit visit) {
  constexpr int kBoxes = 64;  // each bound is wider than the range by the square of a box's length
  for (const Piece<Interval>& piece : law.pieces()) {
    const PieceExpander expander(piece);
    const Interval length = (piece.end - piece.begin) / Interval(kBoxes);
    for (int i = 0; i < kBoxes; ++i) {
      const Interval begin = piece.begin + length * Interval(i), end = begin + length;
      visit(begin, length, expander(boost::numeric::hull(begin, end)).over);
    }
  }
}

}  // namespace camlaw
