// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "numerics/formula/formula.h"

namespace camlaw {

/// What a formula's values and its slopes by every input are over a box of the inputs, from one
/// pass: each step is enclosed once, and then its slopes by the inputs that reach it, by the rules
/// of Series<Interval, 2> (docs/theory.md, (RF3)).
class FormulaRanges {
 public:
  /// Of a formula that has no roots.
  explicit FormulaRanges(const Formula& formula);

  /// Encloses the value over the box, which has a range for each input, but for last ones that the
  /// formula does not use; slopes[i], as many, is by input i: of a kink its difference quotients,
  /// infinite or not a number where nothing is known.
  Interval operator()(std::span<const Interval> box, std::span<Interval> slopes) const;

 private:
  /// A step that an input reaches.
  struct Varying {
    Operation operation;
    std::uint32_t result;
    std::uint32_t a, b, c;  ///< as of Step
    /// Of the inputs that reach it, in reached_.
    std::uint32_t begin, end;
  };

  /// The slopes of all steps: those of a step by the inputs, in their order.
  Interval& slope(std::vector<Interval>& slopes, std::uint32_t step, std::uint32_t input) const {
    return slopes[step * inputs_ + input];
  }
  void add_slopes(const Varying& step, const Interval* values, std::vector<Interval>& slopes) const;

  std::size_t inputs_;
  std::vector<Varying> varying_;
  std::vector<std::uint32_t> reached_;  ///< inputs, increasing for each step
  std::vector<Interval> constants_;     ///< results of the steps that no input reaches
};

}  // namespace camlaw
