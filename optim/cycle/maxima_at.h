// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "optim/cycle/extremes.h"

namespace camlaw::optim {

/// Where curves are highest at one design, each looked at once: many limits may be on one curve.
class MaximaAt {
 public:
  /// The design must outlive this.
  explicit MaximaAt(Design x) : x_(x) {}

  const Trace& trace(const Curve& curve);
  /// local_maxima of sign * curve, sign being 1 or -1.
  const std::vector<Extreme>& maxima(const Curve& curve, double sign);
  /// The first of the highest of them.
  Extreme highest(const Curve& curve, double sign);
  /// As camlaw::optim::extreme_of.
  Extreme extreme_of(const Curve& curve, Part part);

 private:
  Design x_;
  std::map<const Curve*, std::unique_ptr<Trace>> traces_;
  std::map<std::pair<const Curve*, bool>, std::vector<Extreme>> maxima_;
};

}  // namespace camlaw::optim
