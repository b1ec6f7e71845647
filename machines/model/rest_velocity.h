// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <type_traits>

#include "kinematics/law.h"
#include "numerics/scalar/series.h"

namespace camlaw::problems {

/// What rounding can leave of a velocity s' that is 0: some units in the last place of the terms
/// that s' is summed from, in the piece of the law where these are largest.
double velocity_rounding(const Law<double>& law);

/// The velocity of a rest, as one comes there from within, where s' is `inside`. Rounding leaves
/// one of either sign at a rest, and friction or the loss of a gear, which follow its sign, would
/// push the wrong way: this is 1e-100 with the sign that s' has inside, and 0 where s' is no more
/// than `rounding` there too, as in a dwell.
double resting_velocity(double inside, double rounding);

/// The velocity at a place x of a piece: at its ends, and within a thousandth of its length, where
/// it is no more than `rounding`, that of a rest.
double velocity_from_within(double v, const Piece<double>& piece, double x, double rounding);

/// Of the law's displacement: what tells the end of a motion from a place just inside it.
inline constexpr double kRestRounding = 1e-12;

/// The displacement of a rest at s, as one comes there from a place inside a motion, where it is
/// `inside`: twice kRestRounding on its side, and s in a dwell. A formula that goes over to another
/// number at s itself, as an index drive does to the next roller, has its limit from within there.
double resting_displacement(double s, double inside);

/// The displacement at a place x of a piece: within a hundredth of its length from its ends, where
/// it is no farther than kRestRounding from that at the end, that of a rest.
double displacement_from_within(double s, const Piece<double>& piece, double x);

/// How far beyond 0 or 1 a law's displacement counts as being there, in strokes: rounding and the
/// width of enclosures leave less (docs/theory.md, "Ends of the stroke").
inline constexpr double kBeyondEnds = 1e-10;

/// A displacement that lies at most kBeyondEnds beyond 0 or 1 is moved to that end; its derivatives
/// stay. No enclosure may be moved so.
template <class T>
T onto_ends(const T& s) {
  static_assert(!std::is_same_v<T, Interval> && !is_interval_series<T>);
  const double x = value_of(s), beyond = x < 0 ? x : x > 1 ? x - 1 : 0;
  const bool is_rounding = beyond != 0 && std::abs(beyond) <= kBeyondEnds;
  return is_rounding ? s - number<T>(beyond) : s;
}
template <class T>
Motion<T> onto_ends(const Motion<T>& m) {
  return {onto_ends(m.s), m.v, m.a, m.j};
}

/// A value of a formula without what such a velocity leaves of it: 0, and infinite where the
/// formula divides by it.
double without_traces(double value);

}  // namespace camlaw::problems
