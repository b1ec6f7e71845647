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

/// More than kMostSamples are taken as at most 10000 means of equally many neighbours: so narrow a
/// stretch is straight but for 1e-8 of the lift, the means scatter by the square root of their
/// count less, and intervals found from them are the same. Deviations are by the median.
/// `resolution`: what values are rounded to.
Condensed condensed(std::vector<double> place, std::vector<double> value, double resolution = 0);

}  // namespace camlaw::problems
