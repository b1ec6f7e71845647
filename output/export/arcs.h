// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "output/export/curve_fit.h"

/// Curves as arcs and lines that go on in one direction where they meet.
namespace camlaw::problems {

/// An arc from one point to another, mm; a line where it sweeps nothing.
struct ArcPiece {
  Eigen::Vector2d from, to, centre;
  double sweep = 0;  ///< rad, counterclockwise above 0

  bool is_line() const { return sweep == 0; }
  double radius() const { return (from - centre).norm(); }
  double distance(const Eigen::Vector2d& point) const;
  /// No point of a stretch is farther than this; infinite where the stretch is not beside it.
  double bound(const CurveStretch& stretch) const;
};

struct ArcPath {
  std::vector<ArcPiece> pieces;
  double worst = 0;    ///< how far the curve departs from the path at most, mm
  bool proved = true;  ///< that it departs nowhere by more
};

/// Biarcs through points of the curve with the curve's tangents, as few as bisection finds within a
/// tolerance, mm: of each pair the joint lies where both tangent lengths are equal, d with
/// v.v = 2 d v.(t0 + t1) + 2 d^2 (1 - t0.t1), v from end to end (Bolton 1975). Neighbours on one
/// circle are one arc. What would have a larger radius than `most_radius`, mm, is a line instead. A
/// closed curve's path ends where it begins.
ArcPath arcs_within(const PlaneCurve& curve, double tolerance,
                    double most_radius = std::numeric_limits<double>::infinity());

}  // namespace camlaw::problems
