// SPDX-License-Identifier: MIT
#include "optim/cycle/maxima_at.h"

#include <algorithm>
#include <cmath>

namespace camlaw::optim {

Extreme highest_of(const std::vector<Extreme>& maxima, double sign) {
  return *std::max_element(maxima.begin(), maxima.end(), [&](const Extreme& a, const Extreme& b) {
    return sign * a.value < sign * b.value;
  });
}

const Trace& MaximaAt::trace(const Curve& curve) {
  auto& trace = traces_[&curve];
  if (!trace) trace = curve.trace(x_);
  return *trace;
}

const std::vector<Extreme>& MaximaAt::maxima(const Curve& curve, double sign) {
  const auto key = std::pair(&curve, sign > 0);
  const auto known = maxima_.find(key);
  if (known != maxima_.end()) return known->second;
  return maxima_.emplace(key, local_maxima(trace(curve), sign)).first->second;
}

Extreme MaximaAt::highest(const Curve& curve, double sign) {
  return highest_of(maxima(curve, sign), sign);
}

Extreme MaximaAt::extreme_of(const Curve& curve, Part part) {
  if (part == Part::Lowest) return highest(curve, -1);
  const Extreme high = highest(curve, 1);
  if (part != Part::Magnitude || std::isnan(high.value)) return high;
  const Extreme low = highest(curve, -1);
  return -low.value > high.value ? low : high;
}

}  // namespace camlaw::optim
