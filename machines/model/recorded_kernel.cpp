// SPDX-License-Identifier: MIT
#include "machines/model/recorded_kernel.h"

#include <limits>
#include <set>

#include "numerics/scalar/dual.h"
#include "optim/problem/automatic.h"

namespace camlaw::problems {
namespace {

/// The record as a formula generic in its scalar.
class Recorded {
 public:
  Recorded(Formula formula, std::size_t arguments, IsPossible is_possible)
      : formula_(std::move(formula)), arguments_(arguments), is_possible_(std::move(is_possible)) {}

  template <class T>
  T operator()(std::span<const T> u) const {
    std::vector<double> machine(arguments_);
    for (std::size_t i = 0; i < arguments_; ++i) machine[i] = value_of(u[i]);
    if (!is_possible_(machine)) return number<T>(std::numeric_limits<double>::quiet_NaN());
    return formula_(u);
  }

 private:
  Formula formula_;
  std::size_t arguments_;
  IsPossible is_possible_;
};

std::vector<Interval> intervals(std::span<const double> values) {
  return std::vector<Interval>(values.begin(), values.end());
}

}  // namespace

std::shared_ptr<const optim::Kernel> recorded_kernel(Formula formula, std::size_t arguments,
                                                     IsPossible is_possible) {
  using Kernel = optim::AutomaticKernel<Recorded, Interval, Series<Interval, 2>>;
  return std::make_shared<Kernel>(Recorded(std::move(formula), arguments, std::move(is_possible)));
}

RecordedCurveFormula::RecordedCurveFormula(const Formula& formula, std::span<const double> machine,
                                           bool is_possible)
    : formula_(formula, intervals(machine)), is_possible_(is_possible) {}

template <std::size_t N>
Series<Interval, N> RecordedCurveFormula::at(const PlaceSeries<Interval, N>& place) const {
  if (!is_possible_) {
    return Series<Interval, N>(number<Interval>(std::numeric_limits<double>::quiet_NaN()));
  }
  const auto& m = place.motion;
  const std::array<Series<Interval, N>, 5> inputs{m.s, m.v, m.a, m.j, place.x};
  return formula_(std::span<const Series<Interval, N>>(inputs));
}

Series<Interval, 1> RecordedCurveFormula::enclosed(const PlaceSeries<Interval, 1>& place) const {
  return at(place);
}
Series<Interval, 2> RecordedCurveFormula::enclosed(const PlaceSeries<Interval, 2>& place) const {
  return at(place);
}
Series<Interval, 3> RecordedCurveFormula::enclosed(const PlaceSeries<Interval, 3>& place) const {
  return at(place);
}

std::vector<std::size_t> used_arguments(const std::vector<Formula>& formulas, std::size_t count) {
  std::set<std::size_t> used;
  for (const Formula& formula : formulas) {
    for (const std::size_t input : formula.uses()) {
      if (input < count) used.insert(input);
    }
  }
  return {used.begin(), used.end()};
}

}  // namespace camlaw::problems
