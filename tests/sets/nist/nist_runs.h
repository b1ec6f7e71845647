// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "optim/fit/least_squares.h"
#include "tests/sets/nist/nist_set.h"

/// Fits of NIST's sets, and in how many digits they agree with the certified answers.
namespace camlaw::sets {

/// Logarithmic relative error: how many digits agree, -log10(|x - certified| / |certified|),
/// between 0 and 11, as many as are certified. 0 where x is not a number.
double agreeing_digits(double x, double certified);

struct NistRun {
  std::string name;
  int start = 1;          ///< 1 or 2
  double parameters = 0;  ///< agreeing digits of the worst parameter
  double deviations = 0;  ///< of the worst standard deviation
  double sum_of_squares = 0;
  optim::FitResult result;
};

/// All sets of a folder from both starts, without bounds and with the fit's own settings. Throws as
/// read_nist() does.
std::vector<NistRun> nist_runs(const std::filesystem::path& folder);

}  // namespace camlaw::sets
