// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "optim/problem/curve.h"

namespace camlaw::optim {

/// What a limit on a curve is divided by near the ends at which it vanishes whatever the design:
/// the distance from the end, over the stretch, to the power with which the limit vanishes there
/// (docs/optimisation.md, "Limits that vanish").
class RestWeights {
 public:
  /// No limit vanishes anywhere.
  RestWeights() = default;
  RestWeights(const Curve& curve, double bound, Design x) : rests_(curve.rests(bound, x)) {}

  const std::vector<Rest>& rests() const { return rests_; }
  /// 1 away from rests, 0 at one.
  double at(Place place) const;
  /// Whether a place is so near a rest that what is left of the limit is rounding: the leading
  /// coefficient stands for it.
  bool is_rest(Place place) const { return at(place) <= kRest; }

 private:
  /// At a weight this small rounding of the limit, 1e-16, leaves its quotient seven digits.
  static constexpr double kRest = 1e-9;
  std::vector<Rest> rests_;
};

/// Whether a gradient, over the size of its response and by typical changes, is rounding: no
/// variable moves the response there.
bool vanishes(double largest_slope);

}  // namespace camlaw::optim
