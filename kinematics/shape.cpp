// SPDX-License-Identifier: MIT
#include "kinematics/shape.h"

#include <cmath>

namespace camlaw {
namespace {

/// Differences below this part of the derivative's own size are rounding; derivatives grow from one
/// to the next, and splines through many points lose digits in them.
constexpr double kTolerance = 1e-9;

using Derivatives = std::array<double, kCurveOrders>;

Derivatives at(const Piece<double>& piece, double x) { return derivatives<kCurveOrders>(piece, x); }

/// Largest size of each derivative at the breaks and middles of the pieces.
Derivatives sizes(const Law<double>& law) {
  Derivatives result;
  result.fill(1);
  for (const auto& piece : law.pieces()) {
    for (const double x : {piece.begin, std::midpoint(piece.begin, piece.end), piece.end}) {
      const Derivatives d = at(piece, x);
      for (std::size_t k = 0; k < d.size(); ++k) {
        if (std::isfinite(d[k])) result[k] = std::max(result[k], std::abs(d[k]));
      }
    }
  }
  return result;
}

/// The first derivative in which left and right differ, or kCurveOrders.
int first_difference(const Derivatives& left, const Derivatives& right, const Derivatives& size) {
  for (std::size_t k = 0; k < left.size(); ++k) {
    if (!(std::abs(left[k] - right[k]) <= kTolerance * size[k])) return static_cast<int>(k);
  }
  return static_cast<int>(kCurveOrders);
}

/// The derivatives on the far side of an end of this kind.
Derivatives beyond(End kind, Derivatives d) {
  for (std::size_t k = 1; k < d.size(); ++k) {
    const bool kept = kind == End::Motion || (kind == End::Velocity && k == 1) ||
                      (kind == End::Reversal && k % 2 == 0);
    if (!kept) d[k] = 0;
  }
  return d;
}

}  // namespace

int continuity(const Law<double>& law) {
  const Derivatives size = sizes(law);
  const auto& pieces = law.pieces();
  const Derivatives first = at(pieces.front(), 0), last = at(pieces.back(), 1);
  int breaks_at = std::min(first_difference(beyond(law.ends().begin, first), first, size),
                           first_difference(last, beyond(law.ends().end, last), size));
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    const Derivatives left = at(pieces[i], pieces[i].end);
    const Derivatives right = at(pieces[i + 1], pieces[i + 1].begin);
    breaks_at = std::min(breaks_at, first_difference(left, right, size));
  }
  return breaks_at == static_cast<int>(kCurveOrders) ? kSmooth : breaks_at - 1;
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
  const auto kind = [&](double x, Side side) {
    const auto d = law.derivatives<3>(x, side);
    const bool still = std::abs(d[1]) <= kTolerance;
    const bool steady = std::abs(d[2]) <= kTolerance;
    if (still) return steady ? End::Rest : End::Reversal;
    return steady ? End::Velocity : End::Motion;
  };
  return {kind(0, Side::Right), kind(1, Side::Left)};
}

}  // namespace camlaw
