// SPDX-License-Identifier: MIT
#include "kinematics/breaks.h"

#include <cmath>

namespace camlaw::detail {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// Sizes of the terms that each derivative adds up.
PlainDerivatives term_sizes(const Piece<double>& piece, double x) {
  Piece<double> sizes;
  sizes.polynomial = piece.polynomial;
  for (double& c : sizes.polynomial) c = std::abs(c);
  PlainDerivatives result{};
  add_polynomial(sizes.polynomial, std::abs(x - piece.origin), result);
  for (const auto& h : piece.harmonics) {
    double amplitude = std::abs(h.sine) + std::abs(h.cosine);
    for (double& size : result) {
      size += amplitude;
      amplitude *= std::abs(h.frequency);
    }
  }
  for (const auto& term : piece.curves) {
    PlainDerivatives curve{};
    add_curve(term, x - piece.origin, curve);
    for (std::size_t k = 0; k < curve.size(); ++k) {
      if (std::isfinite(curve[k])) result[k] += std::abs(curve[k]);
    }
  }
  return result;
}

}  // namespace

BreakSide break_side(const Piece<double>& piece, double x) {
  BreakSide side{derivatives<kCurveOrders>(piece, x), term_sizes(piece, x)};
  // Coefficients that were fitted or read lose up to twelve bits of their terms.
  constexpr double kRoundings = 4096;
  for (std::size_t k = 0; k < kCurveOrders; ++k) {
    const double slope = k + 1 < kCurveOrders ? std::abs(side.value[k + 1]) : 0;
    side.rounding[k] = kRoundings * kEpsilon * side.rounding[k] +
                       (std::isfinite(slope) ? 16 * kEpsilon * slope : 0);
  }
  return side;
}

BreakSide beyond(End kind, BreakSide side) {
  for (std::size_t k = 1; k < kCurveOrders; ++k) {
    const bool kept = kind == End::Motion || (kind == End::Velocity && k == 1) ||
                      (kind == End::Reversal && k % 2 == 0);
    if (!kept) side.value[k] = 0;
  }
  return side;
}

bool differs(const BreakSide& left, const BreakSide& right, std::size_t k) {
  if (std::isinf(left.value[k]) && left.value[k] == right.value[k]) return false;
  const double step = std::abs(left.value[k] - right.value[k]);
  // 1e-13: a unit law's derivatives are of the order of 1 or more.
  return !(step <= left.rounding[k] + right.rounding[k] + 1e-13) || !std::isfinite(step);
}

std::vector<Break> breaks(const Law<double>& law) {
  const auto& pieces = law.pieces();
  std::vector<Break> result;
  const BreakSide first = break_side(pieces.front(), 0);
  result.push_back({0, beyond(law.ends().begin, first), first});
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    result.push_back({pieces[i].end, break_side(pieces[i], pieces[i].end),
                      break_side(pieces[i + 1], pieces[i + 1].begin)});
  }
  const BreakSide last = break_side(pieces.back(), 1);
  result.push_back({1, last, beyond(law.ends().end, last)});
  return result;
}

}  // namespace camlaw::detail
