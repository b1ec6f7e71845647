// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

/// Samples that lie farther from a fitted curve than chance explains (docs/optimisation.md, "Fits
/// to samples").
namespace camlaw::problems {

struct Outliers {
  std::vector<std::size_t> samples;  ///< their indexes, the farthest first
  double deviation = 0;  ///< of one residual, from the median, which far-off ones hardly move
  double bound = 0;      ///< how far off the farthest of all is with `chance`
};

/// (FS4) |r| > z sigma with sigma = 1.4826 median |r| sqrt(n / (n - p)) and the normal quantile z
/// that any of n residuals exceeds with `chance`; and |r| > 5 q, q the larger of the lower
/// quartiles of the five neighbours' |r| on each side: where those are far off too it is the curve
/// that is wrong.
/// What is below `least` does not count. No samples: n < p + 10. Throws std::invalid_argument for
/// lengths that differ.
Outliers find_outliers(std::span<const double> place, std::span<const double> residual,
                       std::size_t parameters, double least, double chance = 0.05);

/// Whether far-off samples have drawn a least-squares fit: they make more than a tenth of its
/// squares, which one good sample that chance has put beyond the bound does not.
bool draws(const Outliers& found, std::span<const double> residual);

}  // namespace camlaw::problems
