// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

/// The nonlinear regression sets of the NIST Statistical Reference Datasets (StRD): data, starts
/// and certified answers. The files are NIST's own (https://www.itl.nist.gov/div898/strd/), one
/// NAME.dat for each set; they are not part of the project.
namespace camlaw::sets {

struct NistSet {
  std::string name;
  std::array<std::vector<double>, 2> starts;  ///< the first is farther from the answer
  std::vector<double> certified, deviations;  ///< parameters and their standard deviations
  double sum_of_squares = 0;                  ///< certified, of the residuals
  std::vector<double> y;
  std::vector<std::vector<double>> x;  ///< one list for each predictor
};

/// Names of the 27 sets, in alphabetical order.
const std::vector<std::string>& nist_names();

/// Throws std::invalid_argument naming the file where it cannot be read or misses something.
NistSet read_nist(const std::filesystem::path& file);

}  // namespace camlaw::sets
