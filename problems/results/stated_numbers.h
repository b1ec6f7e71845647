// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "problems/results/seal.h"

/// The numbers that a result states of its design. None of them is believed: they are there to be
/// compared with what the design is (`differences`, judged_design.h).
namespace camlaw::problems {

/// A limit as a result has it; NaN for what is not there.
struct StatedLimit {
  std::string name;
  double value, bound, margin;
  bool is_upper = true;
  bool met = false;
};

struct StatedNumbers {
  std::map<std::string, double> objectives = {};  ///< of a point of a front, by name
  std::optional<std::vector<StatedLimit>> limits = {};
  std::map<std::string, double> variables = {};  ///< as they are shown, by name
  std::optional<double> best_possible = {};
  std::string program = {};  ///< that wrote it: "camlaw 0.1.0"; empty: it does not say
  Seal seal = Seal::None;
};

/// Of the whole object of a result; what is not there or of another type is left out.
StatedNumbers stated_numbers(const Json& result);

}  // namespace camlaw::problems
