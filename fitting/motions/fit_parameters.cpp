// SPDX-License-Identifier: MIT
#include "fitting/motions/fit_parameters.h"

#include <algorithm>

namespace camlaw::problems {

std::vector<double> values_of(const optim::FitResult& fit) {
  std::vector<double> result;
  for (const auto& p : fit.parameters) result.push_back(p.value);
  return result;
}

FitParameters starting_at(FitParameters parameters, std::span<const double> values) {
  for (std::size_t j = 0; j < values.size(); ++j) {
    parameters[j].start = std::clamp(values[j], parameters[j].lower, parameters[j].upper);
  }
  return parameters;
}

FitParameters holding(FitParameters parameters, std::size_t first, std::size_t last) {
  for (std::size_t j = first; j < last; ++j) {
    parameters[j].lower = parameters[j].upper = parameters[j].start;
  }
  return parameters;
}

bool is_held(const optim::FitParameter& parameter) { return parameter.lower == parameter.upper; }

}  // namespace camlaw::problems
