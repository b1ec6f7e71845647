// SPDX-License-Identifier: MIT
#pragma once

#include "output/export/curve_fit.h"

/// Curves as points with straight lines between them.
namespace camlaw::problems {

/// A point and, mm, how far the curve was met to depart from the line to the next.
struct ChordPoint {
  double angle;
  Eigen::Vector2d at;
  double deviation;  ///< of the last point 0
};

/// Points of a curve; of a closed one the last is the first again.
struct Chords {
  std::vector<ChordPoint> points;
  double worst = 0;    ///< the largest deviation
  bool proved = true;  ///< that no deviation is larger than the largest that is told
};

/// As many points as it takes to stay within a tolerance, mm. Coordinates are rounded to `decimals`
/// places first: what is said of the deviation holds for what is written.
Chords chords_within(const PlaneCurve& curve, double tolerance, int decimals,
                     const ProofRoom& room = {});

/// Points at even angles, deg.
Chords chords_at_steps(const PlaneCurve& curve, double step, int decimals);

/// How many steps a cycle has. Throws std::invalid_argument where that is not a whole number, with
/// the nearest step that divides the cycle, or where it is more than a million.
int count_steps(double cycle, double step, const std::string& unit);

/// A value with so many decimals.
double rounded(double value, int decimals);
Eigen::Vector2d rounded(const Eigen::Vector2d& point, int decimals);

}  // namespace camlaw::problems
