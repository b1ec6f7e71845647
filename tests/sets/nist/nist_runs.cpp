// SPDX-License-Identifier: MIT
#include "tests/sets/nist/nist_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/sets/nist/nist_models.h"

namespace camlaw::sets {
namespace {

constexpr double kCertifiedDigits = 11;

std::vector<optim::FitParameter> parameters(const std::vector<double>& start) {
  std::vector<optim::FitParameter> all;
  for (std::size_t j = 0; j < start.size(); ++j) {
    all.push_back({.name = fmt::format("b{}", j + 1), .start = start[j]});
  }
  return all;
}

NistRun run(const NistSet& set, const optim::Residuals& residuals, int start) {
  NistRun run{set.name, start, kCertifiedDigits, kCertifiedDigits, 0, {}};
  run.result = optim::fit(parameters(set.starts[static_cast<std::size_t>(start - 1)]), residuals);
  for (std::size_t j = 0; j < set.certified.size(); ++j) {
    const optim::FittedParameter& p = run.result.parameters[j];
    run.parameters = std::min(run.parameters, agreeing_digits(p.value, set.certified[j]));
    run.deviations =
        std::min(run.deviations, agreeing_digits(p.standard_deviation, set.deviations[j]));
  }
  run.sum_of_squares = agreeing_digits(run.result.sum_of_squares, set.sum_of_squares);
  return run;
}

}  // namespace

double agreeing_digits(double x, double certified) {
  const double error = std::abs(x - certified) / std::abs(certified);
  return std::isnan(error) ? 0 : std::clamp(-std::log10(error), 0.0, kCertifiedDigits);
}

std::vector<NistRun> nist_runs(const std::filesystem::path& folder) {
  std::vector<NistRun> runs;
  for (const std::string& name : nist_names()) {
    const NistSet set = read_nist(folder / (name + ".dat"));
    const auto residuals = nist_residuals(set);
    for (const int start : {1, 2}) runs.push_back(run(set, *residuals, start));
  }
  return runs;
}

}  // namespace camlaw::sets
