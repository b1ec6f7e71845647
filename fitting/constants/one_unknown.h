// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <utility>
#include <vector>

/// Where a function of one number takes the values that are printed (docs/optimisation.md, (FS2)).
namespace camlaw::problems {

/// A function at a place, with its slope; NaN where it has no value.
struct SlopedValue {
  double x, value, slope;
};

/// From where to where, in increasing order.
using Stretches = std::vector<std::pair<double, double>>;

/// Where low <= f <= high between neighbouring places, which are in increasing order. Between two
/// of them f goes from one value to the other, or turns no further than its slopes there lead:
/// where that does not tell, more places in between are asked for.
Stretches stretches_between(const std::function<SlopedValue(double)>& f,
                            const std::vector<SlopedValue>& places, double low, double high);

/// What two sets of stretches share.
Stretches common(const Stretches& a, const Stretches& b);

}  // namespace camlaw::problems
