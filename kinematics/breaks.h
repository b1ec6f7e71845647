// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/law.h"

/// Where pieces meet, and what rounding may set them apart by. Used by all that asks whether a
/// derivative jumps.
namespace camlaw::detail {

using PlainDerivatives = std::array<double, kCurveOrders>;

/// One side of a break: derivatives, and how far rounding may have moved each.
struct BreakSide {
  PlainDerivatives value;
  PlainDerivatives rounding;
};

/// The piece's derivatives at x. Rounding: a few thousand units in the last place of the terms that
/// are added up, and what a rounding of the break's own place changes, which is the next
/// derivative.
BreakSide break_side(const Piece<double>& piece, double x);

/// The same side with the derivatives that an end of this kind has beyond it: rest 0, constant
/// velocity 0 but for v, reversal 0 for the odd ones, motion the same.
BreakSide beyond(End kind, BreakSide side);

/// Whether derivative k differs by more than rounding; an infinite one always does.
bool differs(const BreakSide& left, const BreakSide& right, std::size_t k);

/// A place where two sides meet; ends of the law included.
struct Break {
  double x;
  BreakSide left, right;
};
std::vector<Break> breaks(const Law<double>& law);

}  // namespace camlaw::detail
