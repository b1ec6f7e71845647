// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "kinematics/law.h"
#include "machines/model/law_binding.h"

namespace camlaw::problems {

/// The slopes of a number by the varying parameters of a law, from its slopes by the motion at many
/// places and by the ends of pieces (docs/theory.md, (R7)): these are handed back to the numbers
/// that the pieces are made of, and from there to the parameters, once.
class LawSlopes {
 public:
  /// Of a law at such values of the varying parameters.
  LawSlopes(const LawBinding& binding, const Law<double>& law, std::span<const double> values);

  /// Adds the slopes by s, v, a, j at a place of a piece, which itself stays.
  void add_motion(std::size_t piece, double x, const std::array<double, 4>& slopes);
  /// Adds the slope by the x of an end of a piece.
  void add_end(PieceEnd end, double slope);

  /// Adds the slopes by the varying parameters; not a number where their values make no law.
  void add_to(std::span<double> slopes) const;

 private:
  /// A place of a piece, and the slopes by the motion there.
  struct Place {
    double x;
    std::array<double, 4> slopes;
  };

  /// What a piece hands to the parameters that its numbers, as dual ones, have derivatives by.
  std::array<double, kDualWidth> of_piece(std::size_t piece, const Piece<Dual>& moved) const;

  const LawBinding& binding_;
  std::vector<double> values_;
  std::vector<Piece<double>> pieces_;
  std::vector<Piece<double>> owed_;         ///< the slopes by the numbers of each piece
  std::vector<std::vector<Place>> places_;  ///< of each piece
};

}  // namespace camlaw::problems
