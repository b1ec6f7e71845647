// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>
#include <random>

namespace camlaw::testing {

/// The same on every platform, unlike the standard library's distributions.
class Random {
 public:
  explicit Random(unsigned seed) : generator_(seed) {}

  /// Even between low and high.
  double operator()(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(generator_()), -32);
  }
  /// Normal with mean 0 and deviation 1 (Box and Muller).
  double normal() {
    const double radius = std::sqrt(-2 * std::log1p(-(*this)(0, 1)));
    return radius * std::cos(2 * std::numbers::pi * (*this)(0, 1));
  }

 private:
  std::mt19937 generator_;
};

}  // namespace camlaw::testing
