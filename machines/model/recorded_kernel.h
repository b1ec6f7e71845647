// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <memory>

#include "machines/model/curve_formula.h"
#include "machines/model/mechanism.h"
#include "numerics/formula/formula.h"
#include "numerics/lazy.h"
#include "optim/problem/function.h"

/// Formulas of machines as recorded data (numerics/formula). Values, derivatives by the design,
/// enclosures and ranges come from the record; only a curve along the angle of one design is
/// compiled.
namespace camlaw::problems {

/// Whether there is such a machine, in any scalar, of whose numbers the plain ones count: the
/// middles of intervals.
template <class T>
bool is_possible_at(const IsPossible& is_possible, std::span<const T> arguments) {
  if (!is_possible) return true;
  std::vector<double> plain;
  for (const T& value : arguments) plain.push_back(value_of(value));
  return is_possible(plain);
}

/// A record as a formula generic in its scalar, NaN where the machine is not possible. The
/// machine's arguments are the first inputs.
struct Recorded {
  Formula formula;
  std::size_t arguments;
  IsPossible is_possible;

  template <class T>
  T operator()(std::span<const T> u) const {
    return is_possible_at(is_possible, u.first(arguments))
               ? formula(u)
               : number<T>(std::numeric_limits<double>::quiet_NaN());
  }
};

std::shared_ptr<const optim::Kernel> recorded_kernel(Recorded recorded);

/// The enclosures of a curve's formula for one machine, which comes first among the inputs and is
/// followed by s, v, a, j and x; and its values at many places.
class RecordedCurveFormula : public CurveFormula {
 public:
  RecordedCurveFormula(const Formula& formula, std::span<const double> machine, bool is_possible);

  std::vector<double> values(const PlaceRows& places) const override;
  Series<Interval, 1> enclosed(const PlaceSeries<Interval, 1>& place) const override;
  Series<Interval, 2> enclosed(const PlaceSeries<Interval, 2>& place) const override;
  Series<Interval, 3> enclosed(const PlaceSeries<Interval, 3>& place) const override;

 private:
  template <std::size_t N>
  Series<Interval, N> at(const PlaceSeries<Interval, N>& place) const;

  Formula record_;
  std::vector<double> machine_;
  Lazy<FormulaAlong<Interval>> formula_;  ///< a search asks for numbers alone
  bool is_possible_;
};

/// Returns which arguments of one machine any of the records uses, increasing.
std::vector<std::size_t> used_arguments(const std::vector<Recorded>& records);

}  // namespace camlaw::problems
