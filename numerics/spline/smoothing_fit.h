// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "numerics/spline/smoothing_spline.h"

namespace camlaw::optim {

struct SplineSample {
  double x, y, weight;
  std::size_t index;  ///< as given
};

/// The fit of samples that have been checked, inside the basis. Impossible where they do not
/// determine it, and where SplineUnknowns has a fault.
Possible<SmoothedFit> smoothed(const SplineBasis& basis, std::vector<SplineSample> samples,
                               const SmoothingOptions& options);

}  // namespace camlaw::optim
