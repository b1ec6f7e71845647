// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace camlaw::problems {

/// More samples than this are condensed.
inline constexpr std::size_t kMostSamples = 20000;

/// Samples of which there are many more than a fit needs, as means of neighbours.
struct Condensed {
  std::vector<double> place, value;  ///< by place where `each` is above 1
  std::size_t each = 1;              ///< how many samples a mean stands for
  double deviation = 0;      ///< of one sample from its neighbours, the median over the means
  std::size_t left_out = 0;  ///< that lie 6 deviations or more off the median of their neighbours,
                             ///< and as many steps of what values are rounded to
};

/// Means of `each` neighbours by place, far-off ones left out.
Condensed means_of_neighbours(std::vector<double> place, std::vector<double> value,
                              std::size_t each, double resolution = 0);

/// More than kMostSamples are taken as means of equally many neighbours: about 10000 of them, or up
/// to `most_means` where the noise is so small that the bend of the curve within a mean would show.
/// The means scatter by the square root of their count less, and intervals found from them are the
/// same. Deviations are by the median. `resolution`: what values are rounded to.
Condensed condensed(std::vector<double> place, std::vector<double> value, double resolution = 0,
                    std::size_t most_means = 10000);

}  // namespace camlaw::problems
