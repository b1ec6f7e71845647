// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "kinematics/law.h"
#include "machines/model/cycle.h"
#include "machines/model/recorded_kernel.h"
#include "numerics/formula/blocks/formula_blocks.h"

namespace camlaw::problems {

class PieceInStretch;

/// Whether a formula of a machine's arguments, s, v, a, j and the place may jump as these change.
bool may_jump(const Recorded& record);

/// Where a curve's formula jumps inside the stretches of its law: where it goes over to another
/// number, as an index drive does to its next roller, or changes a sign, as friction does
/// (docs/theory.md, "Where a formula jumps").
class FormulaJumps {
 public:
  FormulaJumps() = default;
  /// Of a formula of a machine's arguments, s, v, a, j and the place.
  explicit FormulaJumps(const Recorded& record);

  /// Whether the formula may jump anywhere.
  bool possible() const { return !deciders_.empty(); }
  /// Which arguments of the machine move a jump, increasing.
  const std::vector<std::size_t>& moved_by() const { return moved_by_; }
  /// Places in the cycle's unit, increasing, at which the formula may jump: at each the number that
  /// decides has just changed its sign, and twice kBesideJump of the stretch before it has not.
  /// Signs that change twice within a step, a 64th of a piece of a law of few pieces, are not seen.
  std::vector<double> places(const Cycle& cycle, const Law<double>& law,
                             std::span<const double> arguments) const;
  /// The derivatives of the number that changes its sign between two lists of a formula's inputs,
  /// of those just before and those at one of places(), by each input. Empty where none does.
  std::vector<double> slopes_of_decider(std::span<const double> before,
                                        std::span<const double> here) const;

 private:
  void add_places(const PieceInStretch& piece, int steps, std::span<const double> arguments,
                  std::set<double>& places) const;

  std::vector<Formula> deciders_;
  std::vector<std::shared_ptr<const optim::Kernel>> kernels_;  ///< of the same
  std::optional<FormulaBlocks> together_;                      ///< the same
  std::vector<std::size_t> moved_by_;
};

/// Of the law's x: so far from a jump both of its sides are looked at, beyond all rounding of what
/// decides.
inline constexpr double kBesideJump = 1e-12;

/// The law's place; of a curve that may jump one that is seen from the left lies before the jump
/// that it may stand at.
LawPlace law_place(const Stretch& stretch, optim::Place place, bool may_jump);

}  // namespace camlaw::problems
