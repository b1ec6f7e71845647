// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numeric>

#include "machines/model/highest_in_box.h"

namespace camlaw::problems {

/// Where a function may have no value, as far as bounds of its highest value tell: the middle of
/// the part of the box that nothing bounds. Empty where every part is bounded.
inline Point suspect_of(const Highest& highest) {
  Point place;
  if (std::isfinite(highest.value.upper)) return place;
  for (const optim::Bounds& b : highest.left) place.push_back(std::midpoint(b.lower, b.upper));
  return place;
}

}  // namespace camlaw::problems
