// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

/// Which samples lie off the curve of their neighbours by themselves (docs/theory.md, "Segments of
/// a measured lift").
namespace camlaw::problems {

/// By how much a sample misses the cubic through four neighbours.
struct CubicMiss {
  double by;     ///< signed, in the samples' unit
  double noise;  ///< deviation of that where each sample has noise of deviation 1
};

/// The miss of sample i of the cubic through the samples `at`.
CubicMiss cubic_miss(std::span<const double> x, std::span<const double> s,
                     std::span<const std::size_t> at, std::size_t i);

/// The miss of sample i of those at increasing x: of the cubic through the four nearest that are
/// not left out, two on each side as far as there are.
CubicMiss miss_without(std::span<const double> x, std::span<const double> s,
                       const std::vector<bool>& left_out, std::size_t i);

/// Of the suspects, which have these residuals to a smooth curve, those that lie off by themselves.
/// A suspect that follows its neighbours does not: there the curve is wrong. Nor does one that
/// misses their cubic by less than four times of what (without all that lie off) they miss each
/// other's by, unless that is noise of this deviation: so much the step may hide.
std::vector<bool> lone_samples(std::span<const double> x, std::span<const double> s,
                               std::span<const double> residuals,
                               const std::vector<std::size_t>& suspects, double noise);

}  // namespace camlaw::problems
