// SPDX-License-Identifier: MIT
#include "kinematics/program/segment_merits.h"

#include <algorithm>
#include <cmath>

#include "kinematics/peaks.h"
#include "kinematics/transform.h"

namespace camlaw {
namespace {

/// The pieces of a law between two of its breaks.
std::vector<Piece<double>> pieces_in(const Law<double>& law, const NamedSpan& span) {
  std::vector<Piece<double>> pieces;
  for (const Piece<double>& piece : law.pieces()) {
    const double middle = 0.5 * (piece.begin + piece.end);
    if (middle >= span.begin && middle <= span.end) pieces.push_back(piece);
  }
  return pieces;
}

/// These pieces as a law of their own, over [0, 1].
Law<double> law_of(std::vector<Piece<double>> pieces, const NamedSpan& span, double from,
                   double stroke) {
  for (Piece<double>& piece : pieces) {
    piece = detail::map_piece(piece, span.end - span.begin, span.begin, 1 / stroke, -from / stroke);
  }
  // Of ends that were counted from shares the rounding is taken off.
  pieces.front().begin = 0;
  pieces.back().end = 1;
  const Law<double> part(std::move(pieces), {End::Motion, End::Motion});
  return part.with_ends(natural_ends(part));
}

bool moves(const Piece<double>& piece) {
  return piece.polynomial.size() > 1 || !piece.harmonics.empty() || !piece.curves.empty();
}

}  // namespace

std::vector<SegmentMerits> segment_merits(const Member& member) {
  std::vector<SegmentMerits> result;
  if (!member.family->spans) return result;
  const Law<double> law = member.law();
  for (const NamedSpan& span : member.family->spans(member.arguments)) {
    const double from = law(span.begin).s, to = law(span.end, Side::Left).s;
    SegmentMerits merits{span.name, span.begin, span.end, from, to};
    merits.stated = span.law;
    std::vector<Piece<double>> pieces = pieces_in(law, span);
    if (std::any_of(pieces.begin(), pieces.end(), moves)) {
      constexpr double kNone = 1e-9;  // of the stroke: what rounding leaves
      const double stroke = std::abs(to - from) < kNone ? 1 : to - from;
      merits.law = law_of(std::move(pieces), span, from, stroke);
      const auto own = peaks(*merits.law);
      merits.max_velocity = own.max_velocity();
      merits.max_acceleration = own.max_acceleration();
      merits.max_jerk = own.max_jerk();
      merits.max_dynamic_moment = own.max_dynamic_moment();
    }
    result.push_back(std::move(merits));
  }
  return result;
}

}  // namespace camlaw
