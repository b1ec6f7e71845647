// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "kinematics/laws/polynomial.h"
#include "kinematics/program/joined_run.h"
#include "kinematics/transform.h"

/// The law of a motion program, generic in the scalar, from segments that have laws already.
namespace camlaw {

/// A place that a segment passes, with what is stated of the motion there, by the cycle's x.
template <class T>
struct SegmentPoint {
  T share;  ///< of the cycle, since the segment began
  T s;      ///< in parts of the stroke
  RunKnot<T> stated = {};
};

/// A stretch of the cycle.
template <class T>
struct Segment {
  T share;     ///< of the cycle
  T from, to;  ///< displacement at its ends, in parts of the stroke
  /// How it moves. Without one it rests, or joins what is before and after it; of a segment that
  /// joins a law says how it departs from the 3-4-5 polynomial.
  std::optional<Law<T>> law = {};
  bool joins = false;
  Smoothness smoothness = Smoothness::Snap;  ///< of a segment that joins
  std::vector<SegmentPoint<T>> points = {};  ///< that a segment which joins passes, in turn
  RunKnot<T> stated_end = {};                ///< where a segment which joins ends
};

namespace detail {

/// A law's pieces over a part of the cycle, between two displacements.
template <class T>
std::vector<Piece<T>> pieces_over(const Law<T>& law, const T& begin, const T& share, const T& from,
                                  const T& to) {
  std::vector<Piece<T>> pieces;
  const T slope = number<T>(1) / share, shift = number<T>(0) - begin * slope;
  for (const Piece<T>& piece : law.pieces()) {
    pieces.push_back(map_piece(piece, slope, shift, to - from, from));
  }
  return pieces;
}

/// A piece of a run of segments that join: where it lies, and to whose pieces it belongs.
template <class T>
struct PlacedPiece {
  RunPiece<T> piece;
  T begin;
  std::size_t segment;
};

/// Segments that follow one another, round the cycle, and join: from `first` on.
template <class T>
struct Run {
  std::vector<PlacedPiece<T>> pieces;
  std::vector<RunKnot<T>> ends;  ///< what is stated where each piece ends
  Smoothness smoothness = Smoothness::Snap;

  std::optional<Impossible> add(const Segment<T>& segment, const T& begin, std::size_t index) {
    if (!pieces.empty() && segment.smoothness != smoothness) {
      return Impossible{"segments that join one another need the same continuity"};
    }
    smoothness = segment.smoothness;
    T before = number<T>(0), s = segment.from;
    const auto add_piece = [&](const T& share, const T& to, const RunKnot<T>& stated) {
      if (!(value_of(share) > value_of(before))) return false;
      pieces.push_back({{share - before, s, to}, begin + before, index});
      ends.push_back(stated);
      before = share;
      s = to;
      return true;
    };
    bool follow = true;
    for (const auto& point : segment.points) {
      follow = follow && add_piece(point.share, point.s, point.stated);
    }
    follow = follow && add_piece(segment.share, segment.to, segment.stated_end);
    if (follow) return {};
    return Impossible{"points must follow one another within their segment"};
  }

  /// The pieces' laws, with what is stated at the knots.
  std::optional<Impossible> place(const std::vector<RunKnot<T>>& knots,
                                  std::vector<std::vector<Piece<T>>>& parts) {
    std::vector<RunPiece<T>> plain;
    for (const auto& placed : pieces) plain.push_back(placed.piece);
    const std::vector<RunState<T>> states = run_states(plain, knots, smoothness);
    const bool quintic = smoothness == Smoothness::Snap;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const auto& [piece, begin, segment] = pieces[i];
      const T& d = piece.share;
      // In the piece's own x: a derivative by it is one by the cycle's, times the share.
      const auto conditions = [&](const T& s, const RunState<T>& state) {
        std::vector<T> result{s, d * state[0]};
        if (quintic) result.push_back(d * d * state[1]);
        return result;
      };
      const auto law = possible_boundary_polynomial<T>(
          conditions(piece.from, states[i]), conditions(piece.to, states[(i + 1) % states.size()]));
      if (!law) return law.reason();
      for (auto& part : pieces_over(*law, begin, d, number<T>(0), number<T>(1))) {
        parts[segment].push_back(std::move(part));
      }
    }
    return {};
  }
};

/// A segment that joins by one polynomial, with its law less the 3-4-5 polynomial added.
template <class T>
std::vector<Piece<T>> shaped(const Piece<T>& joining, const Segment<T>& segment, const T& begin) {
  const T zero = number<T>(0), size = segment.to - segment.from;
  std::vector<T> rest = joining.polynomial;  // about the segment's beginning
  const auto plain = pieces_over(poly_3_4_5<T>(), begin, segment.share, zero, size);
  const std::vector<T>& polynomial = plain.front().polynomial;
  rest.resize(std::max(rest.size(), polynomial.size()), zero);
  for (std::size_t k = 0; k < polynomial.size(); ++k) rest[k] = rest[k] - polynomial[k];
  std::vector<Piece<T>> pieces = pieces_over(*segment.law, begin, segment.share, zero, size);
  for (Piece<T>& piece : pieces) {
    std::vector<T> added = rest;
    shift_polynomial(added, T(piece.origin - begin));
    piece.polynomial.resize(std::max(piece.polynomial.size(), added.size()), zero);
    for (std::size_t k = 0; k < added.size(); ++k) {
      piece.polynomial[k] = piece.polynomial[k] + added[k];
    }
  }
  return pieces;
}

/// All that is known of the motion at a place of a piece.
template <class T>
RunKnot<T> knot_at(const Piece<T>& piece, const T& place) {
  const auto motion = derivatives<3>(piece, place);
  return {motion[1], motion[2]};
}

/// The pieces of the segments that join, from those of the others.
template <class T>
std::optional<Impossible> join(const std::vector<Segment<T>>& segments,
                               const std::vector<T>& begins,
                               std::vector<std::vector<Piece<T>>>& parts) {
  const std::size_t n = segments.size();
  std::size_t first = 0;  // one that does not join, where there is any
  while (first < n && segments[first].joins) ++first;
  if (first == n) {  // the whole cycle is one run that ends where it begins
    Run<T> run;
    for (std::size_t i = 0; i < n; ++i) {
      if (auto fault = run.add(segments[i], begins[i], i)) return fault;
    }
    std::vector<RunKnot<T>> knots{run.ends.back()};
    knots.insert(knots.end(), run.ends.begin(), run.ends.end() - 1);
    return run.place(knots, parts);
  }
  for (std::size_t k = first; k < first + n; ++k) {
    if (segments[k % n].joins || !segments[(k + 1) % n].joins) continue;
    Run<T> run;
    std::size_t i = k + 1;
    for (; segments[i % n].joins; ++i) {
      if (auto fault = run.add(segments[i % n], begins[i % n], i % n)) return fault;
    }
    const auto &before = parts[k % n], &after = parts[i % n];
    std::vector<RunKnot<T>> knots{knot_at(before.back(), before.back().end)};
    knots.insert(knots.end(), run.ends.begin(), run.ends.end());
    const RunKnot<T> next = knot_at(after.front(), after.front().begin);
    if (!knots.back().velocity) knots.back().velocity = next.velocity;
    if (!knots.back().acceleration) knots.back().acceleration = next.acceleration;
    if (auto fault = run.place(knots, parts)) return fault;
  }
  return {};
}

}  // namespace detail

/// The program of segments that fill the cycle one after another; the last ends at 1 whatever its
/// share. Segments that join are found together with those that they follow. Impossible where
/// points do not follow one another, and where the pieces make no law.
template <class T>
Possible<Law<T>> program_law(const std::vector<Segment<T>>& segments) {
  std::vector<std::vector<Piece<T>>> parts(segments.size());
  std::vector<T> begins;
  T begin = number<T>(0);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment<T>& segment = segments[i];
    begins.push_back(begin);
    if (segment.law && !segment.joins) {
      parts[i] = detail::pieces_over(*segment.law, begin, segment.share, segment.from, segment.to);
    } else if (!segment.joins) {
      parts[i] = {{begin, begin + segment.share, begin, {segment.from}, {}, {}}};
    }
    begin = begin + segment.share;
  }
  if (auto fault = detail::join(segments, begins, parts)) return std::move(*fault);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (!segments[i].joins || !segments[i].law) continue;
    parts[i] = detail::shaped(parts[i].front(), segments[i], begins[i]);
  }
  std::vector<Piece<T>> pieces;
  for (auto& part : parts) {
    for (auto& piece : part) pieces.push_back(std::move(piece));
  }
  if (!pieces.empty()) pieces.back().end = number<T>(1);
  return Law<T>::possible(std::move(pieces), {End::Motion, End::Motion});
}

}  // namespace camlaw
