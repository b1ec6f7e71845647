// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "numerics/formula/blocks/block_program.h"
#include "numerics/formula/roots.h"

namespace camlaw {

/// Several formulas of the same inputs, evaluated together at many points (docs/theory.md,
/// "Recorded formulas"): what they share is computed once, and what the first inputs alone decide
/// once for all points, as a machine stays while its motion runs.
///
/// A value is that of Formula to the last bit where the formula has only arithmetic, roots and
/// choices; sine, cosine, arctangent, arcsine and logarithm are those of numerics/lanes, which
/// differ from the truth by the bounds stated there, and a tangent is a sine over a cosine; angles
/// above lanes::kLargestAngle, exponentials and powers are the library's. So a value depends on its
/// own point alone, and is the same in every instruction set.
class FormulaBlocks {
 public:
  /// Formulas with equally many inputs, the first ones of which stay.
  FormulaBlocks(std::span<const Formula> formulas, std::size_t first);

  /// At the first inputs, and at points of the others, a row for each input; a row that no formula
  /// uses may be empty. values[k] is where the k-th formula's go: as many as there are points,
  /// apart from all other rows.
  void operator()(std::span<const double> first, std::span<const std::span<const double>> others,
                  std::span<const std::span<double>> values) const;
  /// The same by the loops of one instruction set.
  void run(const BlockKernels& kernels, std::span<const double> first,
           std::span<const std::span<const double>> others,
           std::span<const std::span<double>> values) const;

  /// None where a root moves: such formulas are evaluated point by point.
  const BlockProgram& program() const { return program_; }

 private:
  void check(std::size_t first, std::span<const std::span<const double>> others,
             std::span<const std::span<double>> values) const;
  std::vector<double> still_at(std::span<const double> first) const;
  void run_each(std::span<const double> first, std::span<const std::span<const double>> others,
                std::span<const std::span<double>> values) const;

  std::size_t first_;
  std::vector<Formula> each_;  ///< where a root moves
  std::vector<Step> steps_;    ///< of all formulas
  FormulaRoots roots_;
  std::vector<double> constants_;      ///< results of the steps that no input reaches
  std::vector<std::uint32_t> design_;  ///< steps that the first inputs alone reach
  std::vector<bool> used_;             ///< which of the others any formula uses
  BlockProgram program_;
};

}  // namespace camlaw
