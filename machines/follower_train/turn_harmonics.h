// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <mutex>
#include <span>
#include <vector>

#include "kinematics/law.h"
#include "numerics/scalar/series.h"

/// How much the steady state of an elastic train may bend as the train or its speed changes, at any
/// place of a turn (docs/theory.md, "Over a box of parameters").
namespace camlaw {

/// What of the steady state is meant: the end's y'', or z = y - s, or z', in parts of the stroke.
enum class Steady { Acceleration, Deviation, Rate };

/// Bounds over a turn of |y| for such a y and of its derivatives by the logarithm of the turns in a
/// natural period and by the damping ratio, first and second.
struct SteadyReach {
  double value = 0, by_log = 0, by_damping = 0;
  double by_log_twice = 0, by_both = 0, by_damping_twice = 0;
};

/// The harmonics of a motion's acceleration by the turn. Several threads may ask at once.
class TurnHarmonics {
 public:
  explicit TurnHarmonics(const Law<Interval>& law);

  /// (U14), (U15) Over a box of turns in a natural period and of damping ratios; infinite where
  /// nothing is known.
  SteadyReach reach(Steady which, const Interval& turns, const Interval& damping_ratio) const;
  double most_displacement() const { return most_[0]; }
  double most_acceleration() const { return most_[2]; }

 private:
  /// A bound of the k-th Fourier coefficient of s''.
  double size(int k) const;

  Law<Interval> law_;
  double variation_;
  std::array<double, 3> most_{};
  mutable std::mutex guard_;
  mutable std::vector<double> sizes_;  ///< from k = 1 on, as far as they were asked for
};

/// A factor along one parameter of the train's machine, as a series over a box, and what it
/// multiplies.
struct SteadyTerm {
  Series<Interval, 3> factor;
  SteadyReach of;
};

/// (U16) A bound of the second derivative of a sum of such terms along a parameter, from the series
/// of tau and zeta along it.
double bend_along(std::span<const SteadyTerm> terms, const Series<Interval, 3>& period_ratio,
                  const Series<Interval, 3>& damping_ratio);

}  // namespace camlaw
