// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "optim/problem/problem.h"
#include "optim/verdict/variation.h"

/// What becomes of a design that is not made as it was meant (docs/optimisation.md, "Tolerances").
namespace camlaw::optim {

/// What one number of the problem may become: an objective, or the margin of a limit to its nearer
/// bound.
struct Spread {
  std::string name, unit;
  bool is_margin = false;
  bool worst_is_lowest = false;  ///< of margins and of what is to be great
  bool possible = true;          ///< whether there is a number at every corner and single change
  double nominal = 0;
  double lowest = 0, highest = 0;        ///< the worst of all designs that are possible
  double mean = 0, deviation = 0;        ///< over the samples that are possible
  double low = 0, high = 0;              ///< their quantiles, 5 and 95 %; no number of none
  std::vector<double> by_variable = {};  ///< change by each variable's variation, the larger side
};

struct ToleranceReport {
  std::vector<Spread> spreads;  ///< of the objectives, then of the limits
  std::size_t samples = 0;
  /// Where the model gives no number: such designs cannot be made, and meet no limit.
  std::size_t impossible_samples = 0, impossible_corners = 0;
  double yield = 0;          ///< share of all samples that meet every limit
  double yield_error = 0;    ///< its standard error
  bool all_corners = false;  ///< whether the extremes are over every corner of the box
};

/// Each variable off by its variation. Extremes: over the corners of the box, all of them for up to
/// ten variables that vary, else those that the single changes point to, and over the samples.
/// Samples are Sobol points with random shifts of this seed, eight times as many (docs/theory.md,
/// TV2). Bounds of variables do not hold here: a design at its bound may be made beyond it. Throws
/// std::invalid_argument where variations are not one for each variable.
ToleranceReport tolerance_report(const Problem& problem, Design x,
                                 const std::vector<Variation>& variations,
                                 std::size_t samples = 1000, std::uint64_t seed = 1);
/// The same of variables that are off by up to their tolerance to either side, in its unit. Throws
/// likewise, and where a tolerance is negative.
ToleranceReport tolerance_report(const Problem& problem, Design x,
                                 const std::vector<double>& tolerances, std::size_t samples = 1000,
                                 std::uint64_t seed = 1);

}  // namespace camlaw::optim
