// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "optim/problem/problem.h"
#include "problems/statement/statement.h"

/// What a problem asks of its design, as functions of any of the design's parameters, whether they
/// vary in the problem or are constants.
namespace camlaw::problems {

/// A continuous parameter of the machine or of the law.
struct DesignParameter {
  std::string name, unit;
  double value, low, high;                     ///< of the design, and what is accepted
  bool varies = false;                         ///< a variable of the problem
  std::optional<std::size_t> of_machine = {};  ///< its index; else it is of the law:
  std::size_t law_parameter = 0, element = 0;
};

/// All continuous parameters that objectives or limits depend on; without those that shape a law,
/// and lists of a law of more than eight values that do not vary.
std::vector<DesignParameter> design_parameters(const ProblemStatement& design);

/// Which parameter is left out of them though the numbers depend on it, and why, in a sentence;
/// empty where none is.
std::string parameter_left_out(const ProblemStatement& design);

/// Objective or limit: a number, or of a curve the highest or lowest value over the cycle.
struct DesignNumber {
  std::string name, unit;
  bool is_objective = false;
  optim::Response response;
  optim::Part part = optim::Part::Value;
  optim::Function function;  ///< of the parameters, in their order

  /// Its derivatives by all parameters; where several peaks are equally high the least and the
  /// greatest of theirs: to one side of the design one of them counts, to the other another.
  std::vector<std::pair<double, double>> slopes(optim::Design x) const;
};

/// The numbers of a design as functions of these parameters alone. Over ranges of parameters they
/// are those at the one value that the design has. Limits on parameters themselves, and those that
/// only a law has, are left out.
std::vector<DesignNumber> design_numbers(const ProblemStatement& design,
                                         const std::vector<DesignParameter>& parameters);

}  // namespace camlaw::problems
