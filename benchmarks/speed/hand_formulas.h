// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

namespace camlaw::benchmarks {

/// A machine's formula as an engineer would write it for that machine alone, in plain numbers. Its
/// inputs are those named, in the listed units, and of a curve s, v, a or the angle in rad; its
/// result has the response's listed unit.
struct HandFormula {
  std::string machine, response;
  std::vector<std::string> inputs;
  double (*value)(std::span<const double> u);
};

const std::vector<HandFormula>& hand_formulas();

}  // namespace camlaw::benchmarks
