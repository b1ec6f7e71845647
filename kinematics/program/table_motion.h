// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "kinematics/law.h"

/// A motion over the whole cycle from a table of its displacement (docs/theory.md, "Motion from a
/// table").
namespace camlaw {

struct TableMotion {
  Law<double> law;
  /// How far it is from the table, root mean square and at most; 0 where it passes every row.
  double deviation = 0, greatest = 0;
  /// Its greatest acceleration over that of the curve which passes every row.
  double acceleration_kept = 1;
};

/// How far a motion may be from the rows of its table.
struct TableSmoothing {
  enum class Kind { None, Automatic, Deviation } kind = Kind::Automatic;
  double deviation = 0;  ///< root mean square, of the displacement's unit
};

/// The periodic motion through displacements s at places x of the cycle, increasing, in [0, 1).
/// None: of all curves through the rows that with the least mean square of jerk. Automatic: a
/// smoothing spline of degree 5, by generalised cross-validation. Deviation: the smoothest such
/// spline that is as far from the rows as stated. Throws std::invalid_argument for fewer than 8
/// rows, places that do not increase, values that are not finite, and a deviation that no spline
/// has.
TableMotion table_motion(std::span<const double> x, std::span<const double> s,
                         const TableSmoothing& smoothing);

}  // namespace camlaw
