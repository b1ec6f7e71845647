// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "numerics/spline/smoothing_spline.h"

/// Samples of a lift, put in order for the search of segments (docs/theory.md, "Segments of a
/// measured lift").
namespace camlaw::problems {

/// The standard deviation of noise that is independent from sample to sample (I9): what a cubic
/// through two neighbours on each side leaves, by the median. x must increase.
/// Impossible for fewer than 12 samples or lengths that differ.
Possible<double> possible_noise(std::span<const double> x, std::span<const double> s);
/// The same; throws std::invalid_argument where it is impossible.
double estimated_noise(std::span<const double> x, std::span<const double> s);

struct LiftSamples {
  std::vector<double> phi, s;  ///< phi increases, periodic ones from 0 to the period
  double noise = 0;            ///< standard deviation of these, given or estimated
  double sample_noise = 0;     ///< of one sample as measured
  std::vector<std::size_t>
      outlying;             ///< left out of phi and s, by their place as given, increasing
  std::vector<double> off;  ///< by how much each of these lies off the others' curve
};

/// Orders samples, takes those at one place as their median, and leaves out those that lie farther
/// than chance explains from a smoothing spline that is robust against them. Impossible: lengths
/// that differ, values that are not numbers, fewer than 24 samples, a lift that is the same
/// throughout, a period or noise out of range. `least_noise` is what rounding makes of the lifts
/// (deviation).
Possible<LiftSamples> lift_samples(std::span<const double> phi, std::span<const double> s,
                                   std::optional<double> period, std::optional<double> noise,
                                   double least_noise = 0);

/// A smoothing spline through them.
Possible<optim::SmoothingSpline> smooth_lift(
    const LiftSamples& lift, std::optional<double> period,
    optim::Reweighting reweighting = optim::Reweighting::None);

}  // namespace camlaw::problems
