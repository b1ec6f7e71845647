// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "numerics/formula/formula.h"
#include "numerics/formula/hand_back.h"

namespace camlaw {

/// The slopes of a sum of several formulas over many points (docs/theory.md, (RF4)): of
///   S = sum over k and i of weights[k][i] f_k(first, others at the point i),
/// from one pass through the steps and one back for each block of points, and one back through the
/// steps that the first inputs alone decide. They cost the same for any number of first inputs.
class BlockSlopes {
 public:
  /// What the sum is taken over.
  struct Points {
    std::span<const std::span<const double>> others;   ///< a row for each of the other inputs
    std::span<const std::span<const double>> weights;  ///< for each formula; empty: it is left out
  };
  /// Where the results go.
  struct Slopes {
    std::span<double> by_first;                    ///< dS/dfirst is added to these
    std::span<const std::span<double>> by_others;  ///< dS/d(the other input at the point)
    std::span<const std::span<double>> values;     ///< of the formulas that count
  };

  /// Of formulas with equally many inputs and without roots, the first inputs of which stay.
  BlockSlopes(std::span<const Formula> formulas, std::size_t first);

  /// Every row is as long as there are points. A slope that has no bound comes out infinite or not
  /// a number, as of FormulaSlopes.
  void operator()(std::span<const double> first, const Points& points, const Slopes& slopes) const;

 private:
  friend class BlockPass;

  std::size_t first_, inputs_;
  std::vector<std::uint32_t> values_;    ///< which step is the value of each formula
  std::vector<BackStep> still_;          ///< steps that the first inputs alone reach
  std::vector<BackStep> moving_;         ///< steps that the others reach
  std::vector<bool> varies_;             ///< whether any input reaches a step
  std::vector<std::uint32_t> operands_;  ///< steps that stay, of which a moving one makes use
  std::vector<double> constants_;        ///< results of the steps that no input reaches
};

}  // namespace camlaw
