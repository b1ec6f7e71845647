// SPDX-License-Identifier: MIT
#include "machines/model/box_traces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "machines/model/enclosed.h"
#include "machines/model/law_binding.h"
#include "machines/model/mechanism_trace.h"
#include "machines/model/recorded_response.h"
#include "numerics/formula/expression.h"

namespace camlaw::problems {

using optim::Bounds, optim::Design;

namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// A formula over a box of its arguments; it is asked for bounds alone, which Own::over gives.
template <class Own>
class BoxFormula : public CurveFormula {
 public:
  Series<double, 3> plain(const PlaceSeries<double, 3>&) const override {
    return Series<double, 3>(kNoNumber);
  }
  std::vector<double> values(const PlaceRows& places) const override {
    return std::vector<double>(places.x.size(), kNoNumber);
  }
  bool follows_pulse() const override { return false; }
  Series<Interval, 1> enclosed(const PlaceSeries<Interval, 1>& p) const override { return own(p); }
  Series<Interval, 2> enclosed(const PlaceSeries<Interval, 2>& p) const override { return own(p); }
  Series<Interval, 3> enclosed(const PlaceSeries<Interval, 3>& p) const override { return own(p); }

 protected:
  template <std::size_t N>
  static std::array<Interval, kOfPlace> plain_place(const PlaceSeries<Interval, N>& place) {
    const auto& m = place.motion;
    return {m.s.c[0], m.v.c[0], m.a.c[0], m.j.c[0], place.x.c[0]};
  }

 private:
  template <std::size_t N>
  Series<Interval, N> own(const PlaceSeries<Interval, N>& place) const {
    return static_cast<const Own&>(*this).over(place);
  }
};

class ValueOverBox final : public BoxFormula<ValueOverBox> {
 public:
  ValueOverBox(const CurveRecord& curve, std::span<const Interval> arguments)
      : formula_(curve.record.formula, arguments) {
    if (curve.domain) domain_.emplace(*curve.domain, arguments);
  }

  template <std::size_t N>
  Series<Interval, N> over(const PlaceSeries<Interval, N>& place) const {
    const auto& m = place.motion;
    const std::array<Series<Interval, N>, kOfPlace> inputs{m.s, m.v, m.a, m.j, place.x};
    const auto value = formula_(std::span<const Series<Interval, N>>(inputs));
    if (!domain_) return value;
    const auto plain = this->plain_place(place);
    return known_where((*domain_)(std::span<const Interval>(plain)), value);
  }

 private:
  FormulaAlong<Interval> formula_;
  std::optional<FormulaAlong<Interval>> domain_;
};

/// The slope by one argument; of its own derivatives along the cycle nothing is known.
class SlopeOverBox final : public BoxFormula<SlopeOverBox> {
 public:
  SlopeOverBox(std::shared_ptr<const optim::Kernel> kernel, std::vector<Bounds> arguments,
               std::size_t argument)
      : kernel_(std::move(kernel)), arguments_(std::move(arguments)), argument_(argument) {}

  template <std::size_t N>
  Series<Interval, N> over(const PlaceSeries<Interval, N>& place) const {
    std::vector<Bounds> box = arguments_;
    for (const Interval& input : plain_place(place)) {
      box.push_back({input.lower(), input.upper()});
    }
    Series<Interval, N> result(Interval::whole());
    const bool is_bounded = std::all_of(box.begin(), box.end(), [](const Bounds& b) {
      return std::isfinite(b.lower) && std::isfinite(b.upper);
    });
    if (is_bounded) {
      const Bounds found = kernel_->range(box).slopes[argument_];
      if (found.lower <= found.upper) result.c[0] = Interval(found.lower, found.upper);
    }
    for (std::size_t k = 1; k < N; ++k) result.c[k] = Interval::whole();
    return result;
  }

 private:
  std::shared_ptr<const optim::Kernel> kernel_;
  std::vector<Bounds> arguments_;
  std::size_t argument_;
};

/// By the formula.
class RecordedOverBoxes final : public OverBoxes {
 public:
  RecordedOverBoxes(const CurveRecord& record, const Widened& wide, Design x)
      : record_(record), wide_(wide), x_(x.begin(), x.end()) {}

  OverBox over(const Box& box, double from, double to, double sign) override {
    auto& known = boxes_[ends_of(box)];
    if (!known) known = std::make_unique<BoxTraces>(record_, wide_, x_, box);
    return known->over(from, to, sign);
  }

 private:
  const CurveRecord& record_;
  const Widened& wide_;
  std::vector<double> x_;
  std::map<std::vector<double>, std::unique_ptr<BoxTraces>> boxes_;
};

class RecordedBounds final : public BoundedOverBoxes {
 public:
  explicit RecordedBounds(CurveRecord record) : record_(std::move(record)) {}

  std::unique_ptr<OverBoxes> over_boxes(const Widened& wide, Design x, TraceAt) const override {
    return std::make_unique<RecordedOverBoxes>(record_, wide, x);
  }

 private:
  CurveRecord record_;
};

}  // namespace

std::shared_ptr<const BoundedOverBoxes> bounded_over_boxes(
    const MechanismResponse& response, const std::shared_ptr<const optim::Curve>& curve,
    const Widened& wide) {
  if (auto record = curve_record(response, wide.binding)) {
    return std::make_shared<RecordedBounds>(*std::move(record));
  }
  return std::dynamic_pointer_cast<const BoundedOverBoxes>(curve);
}

std::optional<CurveRecord> curve_record(const MechanismResponse& response, const Binding& binding) {
  if (!response.write || !response.cycle || !response.held.empty()) return {};
  CurveRecord result{recorded_for(binding, response.write, kOfPlace, response.is_possible),
                     {},
                     *response.cycle,
                     {},
                     {}};
  if (response.domain) {
    result.domain = recorded_for(binding, response.domain, kOfPlace, {}).formula;
  }
  for (std::size_t i = 0; i < result.uses.size(); ++i) {
    result.uses[i] = result.record.formula.depends_on(binding.parameters.size() + i);
  }
  result.kernel = recorded_kernel(result.record);
  return result;
}

BoxTraces::BoxTraces(const CurveRecord& curve, const Widened& wide, Design x, const Box& box) {
  const Binding& binding = wide.binding;
  std::vector<Bounds> arguments;
  std::vector<std::size_t> places(box.size());
  for (std::size_t k = 0; k < binding.parameters.size(); ++k) {
    const std::size_t variable = binding.variables[k];
    const bool is_range = variable >= wide.first;
    if (is_range) places[variable - wide.first] = k;
    arguments.push_back(is_range ? box[variable - wide.first] : Bounds{x[variable], x[variable]});
  }
  std::vector<Interval> exact;
  for (const Bounds& b : arguments) exact.emplace_back(b.lower, b.upper);
  const Member member = binding.law->member_at(x);
  const auto trace = [&](std::unique_ptr<const CurveFormula> formula) {
    return std::make_unique<MechanismTrace>(
        curve.cycle, curve.uses, member.possible_law<double>().if_any(),
        [member] { return member.possible_law<Interval>().if_any(); }, std::move(formula));
  };
  value_ = trace(std::make_unique<ValueOverBox>(curve, exact));
  for (std::size_t i = 0; i < box.size(); ++i) {
    slopes_.push_back(trace(std::make_unique<SlopeOverBox>(curve.kernel, arguments, places[i])));
  }
}

OverBox BoxTraces::over(double from, double to, double sign) const {
  OverBox result{times(sign, value_->enclose(from, to)), {}};
  for (const auto& slope : slopes_) {
    result.slopes.push_back(times(sign, slope->enclose(from, to)));
  }
  return result;
}

}  // namespace camlaw::problems
