// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace camlaw::problems {

/// Neighbouring samples at which a function has other signs.
struct SignBracket {
  double low, high, at_low, at_high;
};

inline double largest_size(std::span<const double> values) {
  double size = 0;
  for (const double value : values) size = std::max(size, std::abs(value));
  return size;
}

/// Of values at increasing x, the largest of which has this size. What is noise has no sign.
inline std::vector<SignBracket> sign_brackets(std::span<const double> x,
                                              std::span<const double> values, double size) {
  constexpr double kNoise = 1e-13;  // of the size
  std::vector<SignBracket> found;
  std::optional<std::size_t> before;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!(std::abs(values[i]) > kNoise * size)) continue;
    if (before && values[*before] * values[i] < 0) {
      found.push_back({x[*before], x[i], values[*before], values[i]});
    }
    before = i;
  }
  return found;
}

}  // namespace camlaw::problems
