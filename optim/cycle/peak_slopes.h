// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "optim/problem/curve.h"

namespace camlaw::optim {

/// The derivatives of a curve's peak by every variable, to first order.
struct PeakSlopes {
  std::vector<double> by;
  /// Whether the peak is a jump or a corner of the formula, which moves with the design.
  bool moves_with_edge = false;
};

/// Of the peak of trace(x) that stands at a place (docs/theory.md, "Sensitivities"): by (SE1) where
/// the curve is smooth or the place is an end that stands or is tied to a joint; by (SE3) where the
/// formula jumps; by (SE4) at a corner that is not one of the trace's breaks.
PeakSlopes peak_slopes(const Curve& curve, const Trace& trace, Place place, Design x);

}  // namespace camlaw::optim
