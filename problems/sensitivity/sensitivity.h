// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "optim/verdict/sobol_indices.h"
#include "problems/sensitivity/design_numbers.h"

/// How what a problem asks of its design depends on the design's parameters (docs/theory.md,
/// "Sensitivities").
namespace camlaw::problems {

/// The derivative of a number by a parameter.
struct Sensitivity {
  double slope = 0;  ///< in the number's unit for one of the parameter's; the middle at a kink
  double low = 0, high = 0;  ///< at a kink those to either side; else the slope
  double elasticity = 0;     ///< (SE2) % for one %; not a number where number or parameter is 0
  /// Whether it is by differences, since the formula's derivative does not agree with them: where a
  /// value stands at a joint of the law that moves, or at a kink of the formula.
  bool by_difference = false;
  bool is_kink() const { return low < high; }
};

/// A number of the design, with its derivatives by every parameter.
struct NumberSensitivity {
  std::string name, unit;
  bool is_objective = false;
  double value = 0;
  std::vector<Sensitivity> by;
};

struct LocalSensitivity {
  std::vector<DesignParameter> parameters;
  std::vector<NumberSensitivity> numbers;
  std::string left_out = {};  ///< parameter_left_out
};

/// Exact derivatives, of peaks over the cycle by the envelope theorem (SE1), each compared with
/// differences to either side: where they do not agree the differences count, and say so. Throws
/// std::invalid_argument where the problem seeks and limits nothing that depends on a continuous
/// parameter.
LocalSensitivity local_sensitivity(const ProblemStatement& design);

/// A parameter that has any value between two, each as likely as the others.
struct SensitivityRange {
  DesignParameter parameter;
  double lower, upper;
};

/// Where ranges come from that nobody has stated for this purpose.
enum class RangesFrom : char { Stated, File, Hundredths };

struct SensitivityRanges {
  RangesFrom from = RangesFrom::Stated;
  std::vector<SensitivityRange> ranges;
};

/// Reads "radius=10:40 mm", of parameters of the machine and of the law. Without any the ranges of
/// the problem, [ranges]; and without these every parameter, but those that are 0, within a
/// hundredth of its value. Throws std::invalid_argument.
SensitivityRanges sensitivity_ranges(const ProblemStatement& design,
                                     std::span<const std::string> over);

struct GlobalSensitivity {
  SensitivityRanges over;
  std::vector<DesignNumber> numbers;  ///< of the ranges' parameters
  std::vector<optim::SobolIndices> indices;
};

/// Sobol indices of every number over the ranges. Throws as optim::sobol_indices, and
/// optim::Interrupted where `stop`, which may be null, is set before the end.
GlobalSensitivity global_sensitivity(const ProblemStatement& design, SensitivityRanges over,
                                     const optim::SobolOptions& options,
                                     const std::atomic<bool>* stop = nullptr);

}  // namespace camlaw::problems
