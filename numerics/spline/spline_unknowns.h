// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "numerics/spline/band_triangle.h"
#include "numerics/spline/spline_basis.h"

namespace camlaw::optim {

/// What a spline must be at an end, exactly: s, s' and s''. A rest at y is {y, 0, 0}.
struct EndCondition {
  std::optional<double> s = {}, v = {}, a = {};
};

/// The coefficients of a spline by what is left free in them: at a clamped end the k-th derivative
/// is a combination of the outer k + 1 coefficients, so each condition gives away the innermost of
/// them (docs/theory.md, (O5)). Those of a periodic spline are all free, the last p make the
/// border of the equations.
class SplineUnknowns {
 public:
  /// Why a spline cannot be such at its ends, if so: conditions on a periodic spline, of a higher
  /// order than its degree, or that are not finite, and too few coefficients for them.
  static std::optional<Impossible> fault(const SplineBasis& basis, const EndCondition& begin,
                                         const EndCondition& end);
  /// Throws std::invalid_argument with the fault.
  SplineUnknowns(const SplineBasis& basis, const EndCondition& begin, const EndCondition& end);

  std::size_t count() const { return columns_ + border_; }
  /// A triangle that takes equations of these unknowns.
  BandTriangle triangle() const { return {columns_, width_, border_}; }
  /// factor * (row of coefficients) = factor * right, as an equation of the unknowns.
  BandRow equation(const SplineBasis::Row& row, double right, double factor) const;
  /// All coefficients from the unknowns.
  std::vector<double> coefficients(const std::vector<double>& unknowns) const;

 private:
  struct Term {
    std::size_t column;
    double factor;
  };
  /// constant + terms.
  struct Combination {
    double constant = 0;
    std::vector<Term> terms;
  };
  void fix(const SplineBasis& basis, const EndCondition& condition, bool at_end);
  void number_columns();

  std::size_t degree_;
  std::vector<Combination> coefficients_;
  std::size_t columns_ = 0, width_ = 0, border_ = 0;
};

}  // namespace camlaw::optim
