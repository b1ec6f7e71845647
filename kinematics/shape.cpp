// SPDX-License-Identifier: MIT
#include "kinematics/shape.h"

#include <cmath>

#include "kinematics/breaks.h"

namespace camlaw {

int continuity(const Law<double>& law) {
  int first_jump = kSmooth + 1;
  for (const detail::Break& at : detail::breaks(law)) {
    for (int k = 0; k < first_jump && k < kSmooth; ++k) {
      if (detail::differs(at.left, at.right, static_cast<std::size_t>(k))) first_jump = k;
    }
  }
  return first_jump > kSmooth ? kSmooth : first_jump - 1;
}

std::string class_name(int continuity) {
  return continuity == kSmooth ? "smooth" : "C" + std::to_string(continuity);
}

bool is_symmetric(const Law<double>& law) {
  // Two analytic functions that agree at more points than they have terms are the same; pieces
  // meet the same test through points in every piece and its mirror image.
  for (const auto& piece : law.pieces()) {
    const int points = 9 + static_cast<int>(piece.polynomial.size() + 4 * piece.harmonics.size());
    for (int i = 0; i <= points; ++i) {
      const double x = std::lerp(piece.begin, piece.end, (i + 0.37) / (points + 1.0));
      const double mirrored = law.derivatives<1>(1 - x)[0];
      if (!(std::abs(law.derivatives<1>(x)[0] + mirrored - 1) <= 1e-12)) return false;
    }
  }
  return true;
}

Ends natural_ends(const Law<double>& law) {
  return natural_ends(law.pieces().front(), law.pieces().back());
}

Ends natural_ends(const Piece<double>& first, const Piece<double>& last) {
  const auto kind = [](const Piece<double>& piece, double x) {
    const auto here = detail::break_side(piece, x);
    const auto at_rest = detail::beyond(End::Rest, here);
    const bool still = !detail::differs(here, at_rest, 1);
    const bool steady = !detail::differs(here, at_rest, 2);
    if (still) return steady ? End::Rest : End::Reversal;
    return steady ? End::Velocity : End::Motion;
  };
  return {kind(first, 0), kind(last, 1)};
}

bool vanishes(const Law<double>& law, bool at_end, std::size_t order) {
  // Splines of high degree cancel to seven or eight digits of their derivatives.
  constexpr double kRounding = 1e-7;
  const auto d = law.derivatives<3>(at_end ? 1.0 : 0.0, at_end ? Side::Left : Side::Right);
  return std::abs(d[order]) <= kRounding;
}

}  // namespace camlaw
