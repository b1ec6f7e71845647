// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "output/export/motion.h"

/// Motions as polynomials between knots, as controllers interpolate them, and how far that is from
/// the exact motion (docs/theory.md, "Accuracy of exports").
namespace camlaw::problems {

/// What a table tells of the motion at a place of the master: in the units that are written.
struct MotionKnot {
  double master = 0, s = 0, v = 0, a = 0;
};

/// A motion in the units that are written: places of the curve times `per_place` are the master's.
struct WrittenMotion {
  const ExportedMotion& motion;
  double per_place = 1;

  /// Rounded as it is written: the master's places and s to so many decimals, v and a to doubles.
  /// Where v or a jumps, the mean of its sides: a table has one of each.
  MotionKnot knot(double place, int decimals) const;
};

/// Between the knots k and k + 1 the slave is sum c_i (master - master_k)^i.
struct PiecewiseMotion {
  std::vector<MotionKnot> knots;
  std::vector<std::array<double, 6>> pieces;
};

/// Straight lines between the knots.
PiecewiseMotion lines_between(std::vector<MotionKnot> knots);
/// Polynomials of degree 5 that have s, v and a of both their knots.
PiecewiseMotion quintics_between(std::vector<MotionKnot> knots);
/// The spline of degree 3 through the knots, with continuous first and second derivatives, that has
/// the slopes of the first and the last knot (de Boor 1978, "A Practical Guide to Splines", ch. 4).
PiecewiseMotion cubic_spline_through(std::vector<MotionKnot> knots);

/// How far a written motion is from the exact one at most, in the slave's unit.
struct MotionDeviation {
  double most = 0;
  bool proved = false;  ///< by intervals over the whole cycle; else it is the largest that was met
};
MotionDeviation deviation_of(const WrittenMotion& exact, const PiecewiseMotion& written);

/// As few polynomials of degree 5 as bisection finds within a tolerance, in the slave's unit; the
/// deviation is that of quintics_between(knots). Throws std::invalid_argument where that takes more
/// than `most` pieces, or where the motion jumps.
struct QuinticMotion {
  PiecewiseMotion path;
  MotionDeviation deviation;
};
QuinticMotion quintics_within(const WrittenMotion& exact, double tolerance, int decimals,
                              std::size_t most);

/// Knots at even places, ends included.
std::vector<MotionKnot> even_knots(const WrittenMotion& exact, int count, int decimals);

}  // namespace camlaw::problems
