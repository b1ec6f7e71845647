// SPDX-License-Identifier: MIT
#include "machines/model/recorded_kernel.h"

#include <array>
#include <set>

#include "numerics/formula/blocks/formula_blocks.h"
#include "numerics/scalar/dual.h"
#include "optim/problem/automatic.h"

namespace camlaw::problems {
namespace {

std::vector<Interval> intervals(std::span<const double> values) {
  return std::vector<Interval>(values.begin(), values.end());
}

}  // namespace

std::shared_ptr<const optim::Kernel> recorded_kernel(Recorded recorded) {
  using Kernel = optim::AutomaticKernel<Recorded, Interval, Series<Interval, 2>>;
  return std::make_shared<Kernel>(std::move(recorded));
}

RecordedCurveFormula::RecordedCurveFormula(const Formula& formula, std::span<const double> machine,
                                           bool is_possible)
    : record_(formula),
      machine_(machine.begin(), machine.end()),
      formula_([formula, machine = machine_] {
        return FormulaAlong<Interval>(formula, intervals(machine));
      }),
      is_possible_(is_possible) {}

std::vector<double> RecordedCurveFormula::values(const PlaceRows& places) const {
  std::vector<double> result(places.x.size(), std::numeric_limits<double>::quiet_NaN());
  if (!is_possible_) return result;
  const std::array<std::span<const double>, 5> inputs{places.s, places.v, places.a, places.j,
                                                      places.x};
  const std::array<std::span<double>, 1> row{result};
  FormulaBlocks({&record_, 1}, machine_.size())(machine_, inputs, row);
  return result;
}

template <std::size_t N>
Series<Interval, N> RecordedCurveFormula::at(const PlaceSeries<Interval, N>& place) const {
  if (!is_possible_) {
    return Series<Interval, N>(number<Interval>(std::numeric_limits<double>::quiet_NaN()));
  }
  const auto& m = place.motion;
  const std::array<Series<Interval, N>, 5> inputs{m.s, m.v, m.a, m.j, place.x};
  return (*formula_)(std::span<const Series<Interval, N>>(inputs));
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

std::vector<std::size_t> used_arguments(const std::vector<Recorded>& records) {
  std::set<std::size_t> used;
  for (const Recorded& record : records) {
    for (const std::size_t input : record.formula.uses()) {
      if (input < record.arguments) used.insert(input);
    }
  }
  return {used.begin(), used.end()};
}

}  // namespace camlaw::problems
