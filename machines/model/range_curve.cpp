// SPDX-License-Identifier: MIT
#include "machines/model/range_curve.h"

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

using optim::Bounds, optim::Design, optim::Function, optim::Place;

namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// What a curve's formula needs to be bounded over a box of its arguments.
struct CurveRecord {
  Recorded record;
  std::optional<Formula> domain;
  Cycle cycle;
  std::array<bool, 4> uses;
};

CurveRecord curve_record(const MechanismResponse& response, const Binding& binding) {
  CurveRecord result{recorded_for(binding, response.write, kOfPlace, response.is_possible),
                     {},
                     *response.cycle,
                     {}};
  if (response.domain) {
    result.domain = recorded_for(binding, response.domain, kOfPlace, {}).formula;
  }
  for (std::size_t i = 0; i < result.uses.size(); ++i) {
    result.uses[i] = result.record.formula.depends_on(binding.parameters.size() + i);
  }
  return result;
}

/// A formula over a box of its arguments; it is asked for bounds alone.
class BoxFormula : public CurveFormula {
 public:
  Series<double, 3> plain(const PlaceSeries<double, 3>&) const override {
    return Series<double, 3>(kNoValue);
  }
  std::vector<double> values(const PlaceRows& places) const override {
    return std::vector<double>(places.x.size(), kNoValue);
  }
  bool follows_pulse() const override { return false; }
  Series<Interval, 1> enclosed(const PlaceSeries<Interval, 1>& p) const override { return at(p); }
  Series<Interval, 2> enclosed(const PlaceSeries<Interval, 2>& p) const override { return at(p); }
  Series<Interval, 3> enclosed(const PlaceSeries<Interval, 3>& p) const override { return at(p); }

 protected:
  template <std::size_t N>
  static std::array<Interval, kOfPlace> plain_place(const PlaceSeries<Interval, N>& place) {
    const auto& m = place.motion;
    return {m.s.c[0], m.v.c[0], m.a.c[0], m.j.c[0], place.x.c[0]};
  }

 private:
  virtual Series<Interval, 1> at(const PlaceSeries<Interval, 1>& place) const = 0;
  virtual Series<Interval, 2> at(const PlaceSeries<Interval, 2>& place) const = 0;
  virtual Series<Interval, 3> at(const PlaceSeries<Interval, 3>& place) const = 0;
};

class ValueOverBox final : public BoxFormula {
 public:
  ValueOverBox(const CurveRecord& curve, std::span<const Interval> arguments)
      : formula_(curve.record.formula, arguments) {
    if (curve.domain) domain_.emplace(*curve.domain, arguments);
  }

 private:
  template <std::size_t N>
  Series<Interval, N> value(const PlaceSeries<Interval, N>& place) const {
    const auto& m = place.motion;
    const std::array<Series<Interval, N>, kOfPlace> inputs{m.s, m.v, m.a, m.j, place.x};
    const auto value = formula_(std::span<const Series<Interval, N>>(inputs));
    if (!domain_) return value;
    const auto plain = plain_place(place);
    return known_where((*domain_)(std::span<const Interval>(plain)), value);
  }
  Series<Interval, 1> at(const PlaceSeries<Interval, 1>& place) const override {
    return value(place);
  }
  Series<Interval, 2> at(const PlaceSeries<Interval, 2>& place) const override {
    return value(place);
  }
  Series<Interval, 3> at(const PlaceSeries<Interval, 3>& place) const override {
    return value(place);
  }

  FormulaAlong<Interval> formula_;
  std::optional<FormulaAlong<Interval>> domain_;
};

/// The slope by one argument; of its own derivatives along the cycle nothing is known.
class SlopeOverBox final : public BoxFormula {
 public:
  SlopeOverBox(std::shared_ptr<const optim::Kernel> kernel, std::vector<Bounds> arguments,
               std::size_t argument)
      : kernel_(std::move(kernel)), arguments_(std::move(arguments)), argument_(argument) {}

 private:
  template <std::size_t N>
  Series<Interval, N> slope(const PlaceSeries<Interval, N>& place) const {
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
  Series<Interval, 1> at(const PlaceSeries<Interval, 1>& place) const override {
    return slope(place);
  }
  Series<Interval, 2> at(const PlaceSeries<Interval, 2>& place) const override {
    return slope(place);
  }
  Series<Interval, 3> at(const PlaceSeries<Interval, 3>& place) const override {
    return slope(place);
  }

  std::shared_ptr<const optim::Kernel> kernel_;
  std::vector<Bounds> arguments_;
  std::size_t argument_;
};

}  // namespace

/// A curve over the ranges, and what bounds it; without `record` nothing is proved between places.
struct RangeParts {
  std::shared_ptr<const optim::Curve> curve;  ///< over the widened design
  Widened wide;
  double sign;
  std::optional<CurveRecord> record;
  std::shared_ptr<const optim::Kernel> kernel;  ///< of the record
};

namespace {

/// Bounds of a curve's value and slopes over a box of the ranges, for one design.
class BoxTraces {
 public:
  BoxTraces(const RangeParts& parts, Design x, const Box& box) {
    const CurveRecord& curve = *parts.record;
    const Binding& binding = parts.wide.binding;
    std::vector<Bounds> arguments;
    std::vector<std::size_t> places(box.size());
    for (std::size_t k = 0; k < binding.parameters.size(); ++k) {
      const std::size_t variable = binding.variables[k];
      const bool is_range = variable >= parts.wide.first;
      if (is_range) places[variable - parts.wide.first] = k;
      arguments.push_back(is_range ? box[variable - parts.wide.first]
                                   : Bounds{x[variable], x[variable]});
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
      slopes_.push_back(trace(std::make_unique<SlopeOverBox>(parts.kernel, arguments, places[i])));
    }
  }

  OverBox over(double from, double to, double sign) const {
    OverBox result{times(sign, value_->enclose(from, to)), {}};
    for (const auto& slope : slopes_) {
      result.slopes.push_back(times(sign, slope->enclose(from, to)));
    }
    return result;
  }

 private:
  std::unique_ptr<optim::Trace> value_;
  std::vector<std::unique_ptr<optim::Trace>> slopes_;
};

class RangeTrace final : public optim::Trace {
 public:
  RangeTrace(std::shared_ptr<const RangeParts> parts, Design x)
      : parts_(std::move(parts)), x_(x.begin(), x.end()), places_(places_of(parts_->wide.box)) {
    for (const Point& p : places_) at_place(p);
    breaks_ = at_place(places_.front()).breaks();
  }

  std::vector<double> breaks() const override { return breaks_; }

  std::array<double, 3> at(Place place) const override {
    const Row row = row_at(place);
    const Point found = worst(place, row);
    const auto known = traces_.find(found);
    std::array<double, 3> at =
        known != traces_.end() ? known->second->at(place)
                               : parts_->curve->trace(parts_->wide.design(x_, found))->at(place);
    if (std::isnan(row.highest.settled(row.u, found, at[0]))) at.fill(kNoValue);
    return at;
  }

  Bounds enclose(double from, double to) const override {
    if (!parts_->record) return {};
    constexpr int kLeast = 2, kMost = 24, kParts = 64;
    const double share = (breaks_.back() - breaks_.front()) / std::max(to - from, 1e-300);
    const int halvings =
        std::min(kMost, kLeast + static_cast<int>(std::log2(std::min(share, 1e9))));
    const double sign = parts_->sign;
    const Bounds found = highest_within(
        parts_->wide.box, {halvings, kParts},
        [&](const Point& p) { return times(sign, at_place(p).enclose(from, to)); },
        [&](const Box& box) { return over(box).over(from, to, sign); });
    return times(sign, found);
  }

  std::string why_unbounded() const override { return at_place(places_.front()).why_unbounded(); }

  Point worst(Place place) const { return worst(place, row_at(place)); }

 private:
  /// The curve at one place, as a function of the ranges.
  struct Row {
    HighestKernel highest;
    std::vector<double> u;  ///< the design's own inputs
  };

  Row row_at(Place place) const {
    Row row{HighestKernel(parts_->curve->at(place), parts_->wide, parts_->sign), {}};
    for (const std::size_t input : row.highest.own_inputs()) row.u.push_back(x_[input]);
    return row;
  }
  Point worst(Place place, const Row& row) const {
    const Point best = highest_place(
        places_, [&](const Point& p) { return parts_->sign * at_place(p).at(place)[0]; });
    return row.highest.climb(best, row.u);
  }
  const optim::Trace& at_place(const Point& p) const {
    auto& known = traces_[p];
    if (!known) known = parts_->curve->trace(parts_->wide.design(x_, p));
    return *known;
  }
  const BoxTraces& over(const Box& box) const {
    std::vector<double> key;
    for (const Bounds& b : box) key.insert(key.end(), {b.lower, b.upper});
    auto& known = boxes_[key];
    if (!known) known = std::make_unique<BoxTraces>(*parts_, x_, box);
    return *known;
  }

  std::shared_ptr<const RangeParts> parts_;
  std::vector<double> x_;
  std::vector<Point> places_;
  std::vector<double> breaks_;
  mutable std::map<Point, std::unique_ptr<optim::Trace>> traces_;
  mutable std::map<std::vector<double>, std::unique_ptr<BoxTraces>> boxes_;
};

}  // namespace

RangeCurve::RangeCurve(RangeParts parts)
    : parts_(std::make_shared<const RangeParts>(std::move(parts))) {}

Function RangeCurve::at(Place place) const {
  return highest_of(parts_->curve->at(place), parts_->wide, parts_->sign);
}

std::vector<double> RangeCurve::slope_gradient(Place place, Design x) const {
  const Point p = RangeTrace(parts_, x).worst(place);
  const Box& box = parts_->wide.box;
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (p[i] != box[i].lower && p[i] != box[i].upper) return {};
  }
  std::vector<double> slopes = parts_->curve->slope_gradient(place, parts_->wide.design(x, p));
  slopes.resize(x.size());
  for (std::size_t i = parts_->wide.first; i < slopes.size(); ++i) slopes[i] = 0;
  return slopes;
}

bool RangeCurve::breaks_move() const { return parts_->curve->breaks_move(); }
Place RangeCurve::tied(Place place, Design x) const {
  const Point p = places_of(parts_->wide.box).front();
  return parts_->curve->tied(place, parts_->wide.design(x, p));
}

std::unique_ptr<optim::Trace> RangeCurve::trace(Design x) const {
  return std::make_unique<RangeTrace>(parts_, x);
}

double RangeCurve::memory() const { return parts_->curve->memory(); }

Point RangeCurve::worst(Place place, Design x) const {
  return told(parts_->curve->at(place), parts_->wide, x, RangeTrace(parts_, x).worst(place));
}

std::shared_ptr<const RangeCurve> range_curve(const MechanismResponse& response,
                                              const std::vector<ParameterRange>& ranges,
                                              double sign, const Binding& binding) {
  Widened wide = widened(binding, ranges);
  RangeParts parts{response.curve(wide.binding, optim::Shape::General), wide, sign, {}, {}};
  const bool decides = std::any_of(ranges.begin(), ranges.end(), [&](const ParameterRange& range) {
    return std::binary_search(response.possible_by.begin(), response.possible_by.end(),
                              range.parameter);
  });
  if (response.write && response.cycle && response.held.empty() && !decides) {
    parts.record = curve_record(response, wide.binding);
    parts.kernel = recorded_kernel(parts.record->record);
  }
  return std::make_shared<RangeCurve>(std::move(parts));
}

}  // namespace camlaw::problems
