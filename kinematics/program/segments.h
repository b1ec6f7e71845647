// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "kinematics/laws/polynomial.h"
#include "kinematics/transform.h"

/// The law of a motion program, generic in the scalar, from segments that have laws already.
namespace camlaw {

/// A stretch of the cycle.
template <class T>
struct Segment {
  T share;     ///< of the cycle
  T from, to;  ///< displacement at its ends, in parts of the stroke
  /// How it moves; none: it rests where from = to, else it joins its neighbours in velocity and
  /// acceleration by a polynomial of degree 5.
  std::optional<Law<T>> law;
};

namespace detail {

/// The pieces of a segment that has a law or rests, from cycle place `begin` on.
template <class T>
std::vector<Piece<T>> segment_pieces(const Segment<T>& segment, const T& begin) {
  const T zero = number<T>(0), one = number<T>(1);
  if (!segment.law) return {{begin, begin + segment.share, begin, {segment.from}, {}, {}}};
  std::vector<Piece<T>> pieces;
  const T slope = one / segment.share;
  for (const Piece<T>& piece : segment.law->pieces()) {
    pieces.push_back(
        map_piece(piece, slope, zero - begin * slope, segment.to - segment.from, segment.from));
  }
  return pieces;
}

template <class T>
bool joins(const Segment<T>& segment) {
  return !segment.law && value_of(segment.from) != value_of(segment.to);
}

}  // namespace detail

/// The program of segments that fill the cycle one after another; the last ends at 1 whatever its
/// share. Throws std::invalid_argument where two segments that join follow one another, and what
/// Law's constructor throws.
template <class T>
Law<T> program_law(const std::vector<Segment<T>>& segments) {
  std::vector<std::vector<Piece<T>>> parts(segments.size());
  std::vector<T> begins;
  T begin = number<T>(0);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    begins.push_back(begin);
    if (!detail::joins(segments[i])) parts[i] = detail::segment_pieces(segments[i], begin);
    begin = begin + segments[i].share;
  }
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (!detail::joins(segments[i])) continue;
    const auto& before = parts[(i + segments.size() - 1) % segments.size()];
    const auto& after = parts[(i + 1) % segments.size()];
    if (before.empty() || after.empty()) {
      throw std::invalid_argument("a segment that joins its neighbours needs laws or rests there");
    }
    const auto from = derivatives<3>(before.back(), before.back().end);
    const auto to = derivatives<3>(after.front(), after.front().begin);
    // In the segment's own x: a derivative by it is one by the cycle's, times the share.
    const T& d = segments[i].share;
    const Law<T> joining = boundary_polynomial<T>({from[0], d * from[1], d * d * from[2]},
                                                  {to[0], d * to[1], d * d * to[2]});
    parts[i] = detail::segment_pieces<T>({d, number<T>(0), number<T>(1), joining}, begins[i]);
  }
  std::vector<Piece<T>> pieces;
  for (auto& part : parts) {
    for (auto& piece : part) pieces.push_back(std::move(piece));
  }
  if (!pieces.empty()) pieces.back().end = number<T>(1);
  return Law<T>(std::move(pieces), {End::Motion, End::Motion});
}

}  // namespace camlaw
