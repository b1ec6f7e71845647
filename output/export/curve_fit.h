// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

#include "output/export/plane_curve.h"

/// Curves replaced by pieces that stay within a tolerance of them: chords, arcs, cubics.
namespace camlaw::problems {

/// A stretch of a curve between two of its breaks.
struct CurveSpan {
  optim::Place from, to;
  CurvePoint begin, end;
};

inline CurveSpan span_of(const PlaneCurve& curve, double from, double to) {
  const optim::Place low{from}, high{to, true};
  return {low, high, curve.at(low), curve.at(high)};
}

/// How far a point of a curve is from what replaces it there.
using DistanceAt = std::function<double(optim::Place, const Eigen::Vector2d&)>;

/// The largest distance over a span: looked for at 17 even places, then around each that is higher
/// than its neighbours. One above `enough` ends the search: it is too far already.
double worst_over(const PlaneCurve& curve, const CurveSpan& span, double enough,
                  const DistanceAt& distance);

/// How far a curve is from what replaces it at most, mm.
struct CurveDeviation {
  double most = 0;
  bool proved = true;  ///< by intervals over every place; else the largest that was met
};

/// Whether no point of a span is farther than a limit: bound(stretch, from, to) is a number that no
/// distance over a stretch exceeds, and the span is divided until it is within. Gives the largest
/// bound that was left, or what was met where nothing is proved.
template <class Bound>
CurveDeviation proved_over(const PlaneCurve& curve, const CurveSpan& span, double met, double limit,
                           const Bound& bound) {
  // A stretch so small that it is not within by then counts with what bounds it.
  constexpr int kMostStretches = 20000;
  std::vector<std::pair<double, double>> open{{span.from.angle, span.to.angle}};
  double most = met;
  for (int count = 0; !open.empty(); ++count) {
    const auto [from, to] = open.back();
    open.pop_back();
    const CurveStretch stretch = curve.stretch(from, to);
    const bool known = std::isfinite(stretch.bow);
    const double here = known ? bound(stretch, from, to) : stretch.bow;
    const double middle = std::midpoint(from, to);
    if (here <= limit || count >= kMostStretches || !(from < middle && middle < to)) {
      if (!std::isfinite(here)) return {met, false};
      most = std::max(most, here);
      continue;
    }
    open.emplace_back(middle, to);
    open.emplace_back(from, middle);
  }
  return {most, true};
}

/// What is proved is hardly above what was met: by this factor, or by a small part of the tolerance
/// where a curve is followed nearly exactly.
struct ProofRoom {
  double factor = 1.01;
  double least = 2e-3;  ///< of the tolerance

  double limit(double met, double tolerance) const {
    constexpr double kMost = 1e-5;  // mm
    return std::max(factor * met, std::min(least * tolerance, kMost));
  }
};

/// Pieces that follow one another, and how far the curve is from them at most, mm.
template <class Piece>
struct CurveFit {
  std::vector<Piece> pieces;
  CurveDeviation worst = {};
};

/// Divides a curve until each piece_of(span, within) has a deviation that is met within the
/// tolerance, mm (it need not be the largest where it is not), and proves bound(piece, stretch,
/// from, to) for all. Where the curve jumps, of a closed one at its end too, join(angle, point,
/// point) bridges it. Throws std::invalid_argument where that takes more than 200,000 pieces.
template <class PieceOf, class Bound, class Join>
auto fitted(const PlaneCurve& curve, double tolerance, const ProofRoom& room,
            const PieceOf& piece_of, const Bound& bound, const Join& join) {
  using Piece = decltype(piece_of(std::declval<const CurveSpan&>(), tolerance));
  constexpr std::size_t kMostPieces = 200'000;
  constexpr double kFirst = 1.0 / 36, kLeast = 1e-9;  // of the cycle
  constexpr int kTries = 6;  // each asks for a fifth less: the last for a third of the tolerance
  const double cycle = curve.end() - curve.begin();
  CurveFit<Piece> fit;
  std::vector<std::pair<std::size_t, CurveSpan>> spans;  // of the pieces that are no bridges
  double gap = 0;  // what is no jump, but moves the pieces' ends onto each other
  const auto divide = [&](auto& self, double from, double to, double within) -> void {
    const CurveSpan span = span_of(curve, from, to);
    const Piece piece = piece_of(span, within);
    if (piece.deviation <= within) {
      spans.emplace_back(fit.pieces.size(), span);
      fit.pieces.push_back(piece);
      return;
    }
    if (fit.pieces.size() >= kMostPieces || to - from < kLeast * cycle) {
      throw std::invalid_argument(fmt::format(
          "the {} cannot be followed within {:.6g} {} at {:.6g} deg; use a larger tolerance",
          curve.name(), tolerance, curve.unit(), from));
    }
    const double middle = std::midpoint(from, to);
    self(self, from, middle, within);
    self(self, middle, to, within);
  };
  const auto bridge = [&](double angle, const CurvePoint& before, const CurvePoint& after) {
    const double jump = (after.at - before.at).norm();
    if (jump > PlaneCurve::kJump) {
      fit.pieces.push_back(join(angle, before, after));
    } else {
      gap = std::max(gap, jump);
    }
  };
  const auto divide_all = [&](double within) {
    fit = {}, spans.clear(), gap = 0;
    const std::vector<double>& breaks = curve.breaks();
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
      if (k > 0) bridge(breaks[k], curve.at({breaks[k], true}), curve.at({breaks[k]}));
      const double length = breaks[k + 1] - breaks[k];
      const int count =
          std::max(static_cast<int>(std::ceil(length / (kFirst * cycle) - kLeast)), 1);
      for (int i = 0; i < count; ++i) {
        divide(divide, optim::even_place(breaks[k], breaks[k + 1], count, i).angle,
               optim::even_place(breaks[k], breaks[k + 1], count, i + 1).angle, within);
      }
    }
    if (curve.is_closed()) {
      bridge(curve.end(), curve.at({curve.end(), true}), curve.at({curve.begin()}));
    }
  };
  double within = tolerance / room.factor;
  for (int i = 0; i < kTries; ++i, within *= 0.8) {
    divide_all(within);
    double met = 0;
    for (const Piece& piece : fit.pieces) met = std::max(met, piece.deviation);
    const double limit = room.limit(met, tolerance);
    fit.worst = {met, true};
    for (const auto& [index, span] : spans) {
      const Piece& piece = fit.pieces[index];
      const CurveDeviation here =
          proved_over(curve, span, piece.deviation, limit,
                      [&](const CurveStretch& stretch, double from, double to) {
                        return bound(piece, stretch, from, to);
                      });
      fit.worst.most = std::max(fit.worst.most, here.most);
      fit.worst.proved = fit.worst.proved && here.proved;
      if (!here.proved) break;
    }
    fit.worst.most += gap;
    if (fit.worst.most <= tolerance) return fit;
  }
  throw std::invalid_argument(fmt::format(
      "it cannot be proved that the {} is followed within {:.6g} {}; use a larger tolerance",
      curve.name(), tolerance, curve.unit()));
}

/// The distance of a point from the straight line between two others.
inline double distance_to_line(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                               const Eigen::Vector2d& b) {
  const Eigen::Vector2d way = b - a;
  const double length = way.squaredNorm();
  const double share = length > 0 ? std::clamp((p - a).dot(way) / length, 0.0, 1.0) : 0;
  return (p - a - share * way).norm();
}

/// No point of a stretch is farther than this from a straight line: the distance is convex.
inline double line_bound(const CurveStretch& stretch, const Eigen::Vector2d& a,
                         const Eigen::Vector2d& b) {
  return std::max(distance_to_line(stretch.a, a, b), distance_to_line(stretch.b, a, b)) +
         stretch.bow;
}

}  // namespace camlaw::problems
