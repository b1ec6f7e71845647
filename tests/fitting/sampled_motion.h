// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "fitting/motions/law_fit.h"

/// Samples of a motion whose numbers are known.
namespace camlaw::testing {

/// A law from 10 to 130 deg over 20 mm, zero at 3 mm, at these places, deg; of its derivative by
/// `order`.
inline problems::MotionSamples sampled_at(const std::vector<double>& places, const Law<double>& law,
                                          double noise, std::uint64_t seed, int order) {
  problems::MotionSamples samples;
  samples.order = order;
  samples.place_unit = "deg";
  samples.unit = order == 0 ? "mm" : order == 1 ? "mm/deg" : "mm/deg2";
  samples.place = places;
  std::mt19937_64 random(seed);
  std::normal_distribution<> normal;
  for (const double place : places) {
    const double u = (place - 10) / 120;
    const auto d = law.derivatives<3>(std::clamp(u, 0.0, 1.0), Side::Right);
    const bool moves = u > 0 && u < 1;
    const double clean = order == 0 ? 3 + 20 * d[0]
                         : moves    ? 20 * d[static_cast<std::size_t>(order)] / std::pow(120, order)
                                    : 0;
    samples.value.push_back(clean + noise * normal(random));
  }
  return samples;
}

/// About where that motion is.
inline problems::MotionGuess rough() { return {4, 138, 2.5, 23.9}; }

}  // namespace camlaw::testing
