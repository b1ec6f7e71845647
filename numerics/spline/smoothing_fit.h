// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "numerics/spline/smoothing_spline.h"

namespace camlaw::optim {

struct SplineSample {
  double x, y, weight;
  std::size_t index;  ///< as given
};

/// The fit of samples that have been checked, inside the basis. Throws std::invalid_argument where
/// they do not determine it, and as SplineUnknowns does.
SmoothedFit smoothed(const SplineBasis& basis, std::vector<SplineSample> samples,
                     const SmoothingOptions& options);

}  // namespace camlaw::optim
