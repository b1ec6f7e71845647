// SPDX-License-Identifier: MIT
#include "machines/model/recorded_kernel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <list>
#include <optional>
#include <set>

#include "numerics/formula/blocks/formula_blocks.h"
#include "numerics/formula/formula_ranges.h"
#include "numerics/formula/formula_slopes.h"
#include "numerics/formula/undefined_step.h"
#include "numerics/scalar/dual.h"
#include "optim/problem/automatic.h"

namespace camlaw::problems {
namespace {

std::vector<Interval> intervals(std::span<const double> values) {
  return std::vector<Interval>(values.begin(), values.end());
}

bool all_finite(std::span<const double> numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

/// Derivatives by a pass back through the record, and ranges of all slopes by one pass. Where a
/// derivative has no bound, and of formulas with roots, passes forward count: they leave out what
/// does not move.
class RecordedKernel final : public optim::Kernel {
 public:
  explicit RecordedKernel(const Recorded& recorded)
      : is_possible_(recorded.is_possible),
        arguments_(recorded.arguments),
        formula_(recorded.formula),
        forward_(recorded) {
    if (!FormulaSlopes::knows(recorded.formula)) return;
    slopes_.emplace(recorded.formula);
    ranges_.emplace(recorded.formula);
  }

  double value(std::span<const double> u) const override { return forward_.value(u); }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    if (slopes_ && is_possible(u)) {
      const double value = (*slopes_)(u, g);
      if (all_finite(g)) return value;
    }
    return forward_.gradient(u, g);
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    if (slopes_ && is_possible(u)) {
      const double value = slopes_->hessian(u, g, h);
      if (all_finite(g) && all_finite(h)) return value;
    }
    return forward_.hessian(u, g, h);
  }
  optim::Bounds enclose(std::span<const double> u) const override { return forward_.enclose(u); }
  optim::BoxRange range(std::span<const optim::Bounds> box) const override;
  bool is_enclosed() const override { return true; }
  std::string why_undefined(std::span<const double> u) const override {
    return is_possible(u) ? camlaw::why_undefined(formula_, u) : std::string();
  }

 private:
  bool is_possible(std::span<const double> u) const {
    return !is_possible_ || is_possible_(u.first(arguments_));
  }

  IsPossible is_possible_;
  std::size_t arguments_;
  Formula formula_;
  optim::AutomaticKernel<Recorded, Interval, Series<Interval, 2>> forward_;
  std::optional<FormulaSlopes> slopes_;
  std::optional<FormulaRanges> ranges_;
};

optim::BoxRange RecordedKernel::range(std::span<const optim::Bounds> box) const {
  if (!ranges_) return forward_.range(box);
  std::vector<Interval> inputs, slopes(box.size());
  std::vector<double> middle;
  for (const optim::Bounds& bounds : box) {
    inputs.emplace_back(bounds.lower, bounds.upper);
    middle.push_back(value_of(inputs.back()));
  }
  optim::BoxRange result = Kernel::range(box);
  if (!is_possible(middle)) return result;
  result.value = optim::bounds_of((*ranges_)(inputs, slopes));
  // Where the value is not known, its slopes say nothing.
  if (!std::isfinite(result.value.lower) && !std::isfinite(result.value.upper)) return result;
  std::transform(slopes.begin(), slopes.end(), result.slopes.begin(),
                 [](const Interval& slope) { return optim::bounds_of(slope); });
  return result;
}

/// A formula as steps over many points, of which the first inputs stay. Those that a thread asked
/// for last are kept: a curve is looked at for one machine after the other.
const FormulaBlocks& blocks_of(const Formula& formula, std::size_t first) {
  struct Known {
    Formula formula;  ///< holds the steps, so that no other formula's are at their address
    std::size_t first;
    FormulaBlocks blocks;
  };
  constexpr std::size_t kKept = 16;
  thread_local std::list<Known> known;  // the last one first
  const auto found = std::find_if(known.begin(), known.end(), [&](const Known& one) {
    return &one.formula.steps() == &formula.steps() && one.first == first;
  });
  if (found != known.end()) {
    known.splice(known.begin(), known, found);
    return known.front().blocks;
  }
  known.push_front({formula, first, FormulaBlocks({&formula, 1}, first)});
  if (known.size() > kKept) known.pop_back();
  return known.front().blocks;
}

}  // namespace

std::shared_ptr<const optim::Kernel> recorded_kernel(Recorded recorded) {
  return std::make_shared<RecordedKernel>(recorded);
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
  blocks_of(record_, machine_.size())(machine_, inputs, row);
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
