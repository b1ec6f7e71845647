// SPDX-License-Identifier: MIT
#include "optim/cycle/maxima_at.h"

namespace camlaw::optim {

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
  return optim::extreme_of(part, [&](double sign) { return highest(curve, sign); });
}

}  // namespace camlaw::optim
