// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
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

/// The top of value(x) between two places on both sides of a higher one, by golden sections.
template <class Value>
double top_between(double low, double high, const Value& value) {
  constexpr double kGolden = 0.6180339887498949;
  constexpr int kSections = 16;  // which leave 1e-3 of the way, and 1e-6 of the rise over it
  double left = high - kGolden * (high - low), right = low + kGolden * (high - low);
  double at_left = value(left), at_right = value(right);
  for (int i = 0; i < kSections; ++i) {
    if (at_left > at_right) {
      high = right, right = left, at_right = at_left;
      left = high - kGolden * (high - low), at_left = value(left);
    } else {
      low = left, left = right, at_left = at_right;
      right = low + kGolden * (high - low), at_right = value(right);
    }
  }
  return std::max(at_left, at_right);
}

/// The largest distance(place, point) over a span: looked for at 17 even places, then around each
/// that is higher than its neighbours.
template <class Distance>
double worst_over(const PlaneCurve& curve, const CurveSpan& span, const Distance& distance) {
  constexpr std::size_t kLooks = 16;
  const auto look = [&](double place) {
    const double share = place / kLooks;
    const double angle = span.from.angle + (span.to.angle - span.from.angle) * share;
    const optim::Place here{angle, share == 1};
    return distance(here, curve.at(here).at);
  };
  std::array<double, kLooks + 1> values;
  for (std::size_t i = 0; i <= kLooks; ++i) values[i] = look(static_cast<double>(i));
  double worst = *std::max_element(values.begin(), values.end());
  for (std::size_t i = 1; i < kLooks; ++i) {
    // Others, at half the highest, are not the highest in between.
    if (values[i] < values[i - 1] || values[i] < values[i + 1] || values[i] < worst / 2) continue;
    const auto place = static_cast<double>(i);
    worst = std::max(worst, top_between(place - 1, place + 1, look));
  }
  return worst;
}

/// How far a curve is from what replaces it at most, mm.
struct CurveDeviation {
  double most = 0;
  bool proved = true;  ///< by intervals over every place; else the largest that was met
};

/// The largest distance(place, point) over a span, and a proof: bound(stretch, from, to) is a
/// number that no distance over a stretch exceeds. The span is divided until that is hardly above
/// what worst_over met. A deviation above the tolerance is of no use and is not proved.
template <class Distance, class Bound>
CurveDeviation deviation_over(const PlaneCurve& curve, const CurveSpan& span, double tolerance,
                              const Distance& distance, const Bound& bound) {
  constexpr double kRoom = 1.005, kLeast = 2e-9;  // mm
  constexpr int kMostStretches = 4000;
  const double met = worst_over(curve, span, distance);
  if (!(met <= tolerance)) return {met, false};
  const double enough = kRoom * met + kLeast;
  std::vector<std::pair<double, double>> open{{span.from.angle, span.to.angle}};
  double most = met;
  for (int count = 0; !open.empty(); ++count) {
    const auto [from, to] = open.back();
    open.pop_back();
    const CurveStretch stretch = curve.stretch(from, to);
    const double here = std::isfinite(stretch.bow) ? bound(stretch, from, to) : stretch.bow;
    const double middle = std::midpoint(from, to);
    const bool is_last = count >= kMostStretches || !(from < middle && middle < to);
    if (here <= enough || is_last) {
      if (!std::isfinite(here)) return {met, false};
      most = std::max(most, here);
      continue;
    }
    open.emplace_back(middle, to);
    open.emplace_back(from, middle);
  }
  return {most, true};
}

/// Pieces that follow one another, and how far the curve is from them at most, mm.
template <class Piece>
struct CurveFit {
  std::vector<Piece> pieces;
  CurveDeviation worst = {};
};

/// Divides a curve until each piece_of(span) has a deviation within the tolerance, mm. Where the
/// curve jumps, of a closed one at its end too, join(angle, point, point) bridges it. Throws
/// std::invalid_argument where that takes more than 200,000 pieces.
template <class PieceOf, class Join>
auto fitted(const PlaneCurve& curve, double tolerance, const PieceOf& piece_of, const Join& join) {
  using Piece = decltype(piece_of(std::declval<const CurveSpan&>()));
  constexpr std::size_t kMostPieces = 200'000;
  constexpr double kFirst = 1.0 / 36, kLeast = 1e-9;  // of the cycle
  const double cycle = curve.end() - curve.begin();
  CurveFit<Piece> fit;
  const auto divide = [&](auto& self, double from, double to) -> void {
    const Piece piece = piece_of(span_of(curve, from, to));
    if (piece.deviation.most <= tolerance) {
      fit.worst.most = std::max(fit.worst.most, piece.deviation.most);
      fit.worst.proved = fit.worst.proved && piece.deviation.proved;
      fit.pieces.push_back(piece);
      return;
    }
    if (fit.pieces.size() >= kMostPieces || to - from < kLeast * cycle) {
      throw std::invalid_argument(fmt::format(
          "the {} cannot be followed within {:.6g} {} at {:.6g} deg; a larger tolerance is wanted",
          curve.name(), tolerance, curve.unit(), from));
    }
    const double middle = std::midpoint(from, to);
    self(self, from, middle);
    self(self, middle, to);
  };
  double gap = 0;  // what is no jump, but moves the pieces' ends onto each other
  const auto bridge = [&](double angle, const CurvePoint& before, const CurvePoint& after) {
    const double jump = (after.at - before.at).norm();
    if (jump <= PlaneCurve::kJump) {
      gap = std::max(gap, jump);
      return;
    }
    fit.pieces.push_back(join(angle, before, after));
  };
  const std::vector<double>& breaks = curve.breaks();
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    if (k > 0) bridge(breaks[k], curve.at({breaks[k], true}), curve.at({breaks[k]}));
    const double length = breaks[k + 1] - breaks[k];
    const int count = static_cast<int>(std::ceil(length / (kFirst * cycle) - kLeast));
    for (int i = 0; i < std::max(count, 1); ++i) {
      const int n = std::max(count, 1);
      divide(divide, optim::even_place(breaks[k], breaks[k + 1], n, i).angle,
             optim::even_place(breaks[k], breaks[k + 1], n, i + 1).angle);
    }
  }
  if (curve.is_closed()) {
    bridge(curve.end(), curve.at({curve.end(), true}), curve.at({curve.begin()}));
  }
  fit.worst.most += gap;
  return fit;
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
