// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/law.h"

/// What a law's curve is like, found from the law itself.
namespace camlaw {

/// Continuity class k of the motion: s .. s^(k) are continuous through the stretch and into what
/// its ends declare (rest: every derivative 0; constant velocity: all beyond the first; reversal:
/// the mirrored motion, so odd derivatives 0; motion: no condition). -1 where s itself jumps.
/// kSmooth where every derivative that is known is continuous.
inline constexpr int kSmooth = static_cast<int>(kCurveOrders);
int continuity(const Law<double>& law);
/// "C2", or "smooth".
std::string class_name(int continuity);

/// Whether s(x) + s(1 - x) = 1 throughout, to rounding.
bool is_symmetric(const Law<double>& law);

/// The ends that a law's own values at 0 and 1 fit: v = 0 and a = 0 rest, a = 0 constant velocity,
/// v = 0 reversal, else motion.
Ends natural_ends(const Law<double>& law);
/// The same of the first and the last piece.
Ends natural_ends(const Piece<double>& first, const Piece<double>& last);

/// Whether s^(order), of order 1 to 3, is 0 where the law begins, or ends; to rounding.
bool vanishes(const Law<double>& law, bool at_end, std::size_t order);

}  // namespace camlaw
