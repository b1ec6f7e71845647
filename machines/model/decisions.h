// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "kinematics/law.h"
#include "machines/model/recorded_kernel.h"
#include "numerics/formula/blocks/formula_blocks.h"

namespace camlaw::problems {

/// A place of a law at which a formula decides otherwise on both sides.
struct Decision {
  std::size_t decider;  ///< which of the numbers that decide changes its sign
  double place;
};

/// The numbers by which a formula of a machine's arguments and of s, v, a and j decides, as far as
/// the motion changes them.
class Decisions {
 public:
  explicit Decisions(const Recorded& record);

  const Formula& decider(std::size_t k) const { return deciders_[k]; }
  /// Inside each piece of a law where a continuous decider changes its sign, in no order. Where it
  /// jumps it is not asked: what makes it jump is a sign of its own.
  std::vector<std::vector<Decision>> in_pieces(const Law<double>& law,
                                               std::span<const double> machine) const;

 private:
  std::vector<Formula> deciders_;
  std::optional<FormulaBlocks> together_;  ///< the same
};

/// Rows of s, v, a and j at places of a law.
std::array<std::vector<double>, 4> motion_rows(const Law<double>& law, std::span<const double> x);

/// A row of values for each of `count` formulas of a machine's arguments and of rows of inputs.
std::vector<std::vector<double>> value_rows(const FormulaBlocks& formulas, std::size_t count,
                                            std::span<const double> machine,
                                            std::span<const std::vector<double>> inputs);

}  // namespace camlaw::problems
