// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>

#include "machines/model/curve_formula.h"
#include "numerics/formula/formula.h"
#include "optim/problem/function.h"

/// Formulas of machines as recorded data (numerics/formula): what is asked of them seldom, or in
/// scalars that are slow anyway, is worked out from the record; values and gradients, which a
/// search asks for all the time, run compiled.
namespace camlaw::problems {

/// Whether there is such a machine at values of its arguments.
using IsPossible = std::function<bool(std::span<const double>)>;

/// NaN where the machine is not possible. The formula's first inputs are the machine's arguments.
std::shared_ptr<const optim::Kernel> recorded_kernel(Formula formula, std::size_t arguments,
                                                     IsPossible is_possible);

/// The enclosures of a curve's formula for one machine, which comes first among the inputs and is
/// followed by s, v, a, j and x.
class RecordedCurveFormula : public CurveFormula {
 public:
  RecordedCurveFormula(const Formula& formula, std::span<const double> machine, bool is_possible);

  Series<Interval, 1> enclosed(const PlaceSeries<Interval, 1>& place) const override;
  Series<Interval, 2> enclosed(const PlaceSeries<Interval, 2>& place) const override;
  Series<Interval, 3> enclosed(const PlaceSeries<Interval, 3>& place) const override;

 private:
  template <std::size_t N>
  Series<Interval, N> at(const PlaceSeries<Interval, N>& place) const;

  FormulaAlong<Interval> formula_;
  bool is_possible_;
};

/// Returns which of the first `count` inputs any of the formulas uses, increasing.
std::vector<std::size_t> used_arguments(const std::vector<Formula>& formulas, std::size_t count);

}  // namespace camlaw::problems
