// SPDX-License-Identifier: MIT
#include "machines/model/over_ranges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "machines/model/arguments.h"
#include "machines/model/enclosed.h"
#include "machines/model/highest_in_box.h"
#include "machines/model/inner_numbers.h"
#include "machines/model/law_binding.h"
#include "machines/model/mechanism_trace.h"
#include "machines/model/recorded_response.h"
#include "numerics/formula/expression.h"

namespace camlaw::problems {
namespace {

using optim::Bounds, optim::Design, optim::Function, optim::Place;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Bounds times(double sign, const Bounds& b) { return sign > 0 ? b : Bounds{-b.upper, -b.lower}; }

bool holds(const std::vector<std::size_t>& all, std::size_t parameter) {
  return std::find(all.begin(), all.end(), parameter) != all.end();
}

/// A binding in which the parameters of the ranges vary too: their variables come behind those that
/// it has.
struct Widened {
  Binding binding;
  std::size_t first = 0;  ///< variable of the first range
  Box box;

  /// A design of the widened binding.
  std::vector<double> design(Design x, const Point& p) const {
    std::vector<double> all(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(first));
    all.insert(all.end(), p.begin(), p.end());
    return all;
  }
};

Widened widened(const Binding& binding, const std::vector<ParameterRange>& ranges) {
  Widened result{binding, design_size(binding), {}};
  std::vector<std::pair<std::size_t, std::size_t>> varying;
  for (std::size_t k = 0; k < binding.parameters.size(); ++k) {
    varying.emplace_back(binding.parameters[k], binding.variables[k]);
  }
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    varying.emplace_back(ranges[i].parameter, result.first + i);
    result.box.push_back({ranges[i].lower, ranges[i].upper});
  }
  std::sort(varying.begin(), varying.end());
  result.binding.parameters.clear();
  result.binding.variables.clear();
  for (const auto& [parameter, variable] : varying) {
    result.binding.parameters.push_back(parameter);
    result.binding.variables.push_back(variable);
  }
  return result;
}

/// The highest value of sign * f over the ranges, times the sign; f is a function over a widened
/// design. At the place where it is highest its derivatives by the design are those of f; where
/// that place lies within a range, the second ones change as it moves (theory: RG2).
class HighestKernel final : public optim::Kernel {
 public:
  HighestKernel(Function f, const Widened& wide, double sign)
      : f_(std::move(f)),
        first_(wide.first),
        box_(wide.box),
        sign_(sign),
        places_(places_of(box_)) {
    for (std::size_t k = 0; k < f_.inputs().size(); ++k) {
      (f_.inputs()[k] < first_ ? own_ : moved_).push_back(k);
    }
  }

  std::vector<std::size_t> own_inputs() const {
    std::vector<std::size_t> inputs;
    for (const std::size_t k : own_) inputs.push_back(f_.inputs()[k]);
    return inputs;
  }

  double value(std::span<const double> u) const override {
    const Point p = worst(u);
    return settled(u, p, f_.value(design(u, p)));
  }

  /// Whether the function has no bound close to a place in the ranges: then what was found there is
  /// no highest value, however large, but the flank of a pole.
  bool is_beside_pole(std::span<const double> u, const Point& p) const {
    constexpr double kBeside = 1e-7;  // of a range
    Box point, near;
    for (const double value : u) point.push_back({value, value});
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double room = kBeside * (box_[i].upper - box_[i].lower);
      near.push_back({std::max(box_[i].lower, p[i] - room), std::min(box_[i].upper, p[i] + room)});
    }
    const Bounds value = f_.range(widened_box(point, near)).value;
    return !(std::isfinite(value.lower) && std::isfinite(value.upper));
  }

  double gradient(std::span<const double> u, std::span<double> g) const override {
    std::vector<double> all(f_.inputs().size());
    const Point p = worst(u);
    const double value = settled(u, p, f_.gradient(design(u, p), all));
    for (std::size_t k = 0; k < own_.size(); ++k) g[k] = std::isnan(value) ? kNaN : all[own_[k]];
    return value;
  }

  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    const std::size_t n = f_.inputs().size();
    std::vector<double> all(n), second(optim::packed_size(n));
    const Point p = worst(u);
    const double value = settled(u, p, f_.hessian(design(u, p), all, second));
    if (std::isnan(value)) {
      std::fill(g.begin(), g.end(), kNaN);
      std::fill(h.begin(), h.end(), kNaN);
      return value;
    }
    const auto at = [&](std::size_t i, std::size_t k) -> double& {
      return second[optim::packed(std::max(i, k), std::min(i, k))];
    };
    // Ranges within which the place lies are eliminated one after the other.
    for (const std::size_t m : moved_) {
      const std::size_t range = f_.inputs()[m] - first_;
      const bool inside = p[range] > box_[range].lower && p[range] < box_[range].upper;
      const double bend = at(m, m);
      if (!inside || bend == 0) continue;
      const std::vector<double> column = [&] {
        std::vector<double> c(n);
        for (std::size_t i = 0; i < n; ++i) c[i] = at(i, m);
        return c;
      }();
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k <= i; ++k) at(i, k) -= column[i] * column[k] / bend;
      }
    }
    for (std::size_t i = 0; i < own_.size(); ++i) {
      g[i] = all[own_[i]];
      for (std::size_t k = 0; k <= i; ++k) h[optim::packed(i, k)] = at(own_[i], own_[k]);
    }
    return value;
  }

  Bounds enclose(std::span<const double> u) const override {
    Box box;
    for (const double value : u) box.push_back({value, value});
    return range(box).value;
  }

  optim::BoxRange range(std::span<const Bounds> box) const override {
    constexpr Division kDivision{.halvings = 14, .parts = 1000};
    std::vector<Bounds> slopes;
    const auto over = [&](const Box& ranges) {
      const optim::BoxRange all = f_.range(widened_box(box, ranges));
      OverBox result{times(sign_, all.value), std::vector<Bounds>(ranges.size(), Bounds{0, 0})};
      for (const std::size_t m : moved_) {
        result.slopes[f_.inputs()[m] - first_] = times(sign_, all.slopes[m]);
      }
      return result;
    };
    const auto at = [&](const Point& p) {
      Box point;
      for (const double value : p) point.push_back({value, value});
      return times(sign_, f_.range(widened_box(box, point)).value);
    };
    optim::BoxRange result;
    result.value = times(sign_, highest_within(box_, kDivision, at, over));
    const optim::BoxRange whole = f_.range(widened_box(box, box_));
    for (const std::size_t k : own_) result.slopes.push_back(whole.slopes[k]);
    return result;
  }
  bool is_enclosed() const override { return f_.is_enclosed(); }
  bool is_searched() const override { return true; }
  std::string why_undefined(std::span<const double> u) const override {
    for (const Point& p : places_) {
      if (std::string why = f_.why_undefined(design(u, p)); !why.empty()) return why;
    }
    return {};
  }

  /// The place in the ranges; where a value is not a number, the first such place.
  Point worst(std::span<const double> u) const {
    Point best = places_.front();
    double highest = -optim::kInfinity;
    for (const Point& p : places_) {
      const double value = sign_ * f_.value(design(u, p));
      if (std::isnan(value)) return p;
      if (value > highest) highest = value, best = p;
    }
    return climb(best, u);
  }

  /// The value at the worst place, not a number beside a pole.
  double settled(std::span<const double> u, const Point& p, double value) const {
    constexpr double kSteep =
        1e6;  // times another value: a formula that rises so far may have a pole
    const double other = std::abs(f_.value(design(u, places_.front())));
    if (std::abs(value) <= kSteep * other) return value;
    return is_beside_pole(u, p) ? kNaN : value;
  }

  /// From a place in the ranges to the highest value nearby.
  Point climb(const Point& from, std::span<const double> u) const {
    return climbed(from, box_, [&](const Point& p) {
      const std::size_t n = f_.inputs().size();
      std::vector<double> all(n), second(optim::packed_size(n));
      Slopes result{sign_ * f_.hessian(design(u, p), all, second), Point(box_.size()),
                    Point(optim::packed_size(box_.size()))};
      for (const std::size_t m : moved_) {
        const std::size_t i = f_.inputs()[m] - first_;
        result.first[i] = sign_ * all[m];
        result.second[optim::packed(i, i)] = sign_ * second[optim::packed(m, m)];
      }
      return result;
    });
  }

 private:
  std::vector<double> design(std::span<const double> u, const Point& p) const {
    std::vector<double> x(first_ + p.size());
    for (std::size_t k = 0; k < own_.size(); ++k) x[f_.inputs()[own_[k]]] = u[k];
    std::copy(p.begin(), p.end(), x.begin() + static_cast<std::ptrdiff_t>(first_));
    return x;
  }
  std::vector<Bounds> widened_box(std::span<const Bounds> u, const Box& ranges) const {
    std::vector<Bounds> all(first_ + ranges.size(), Bounds{0, 0});
    for (std::size_t k = 0; k < own_.size(); ++k) all[f_.inputs()[own_[k]]] = u[k];
    std::copy(ranges.begin(), ranges.end(), all.begin() + static_cast<std::ptrdiff_t>(first_));
    return all;
  }

  Function f_;
  std::size_t first_;
  Box box_;
  double sign_;
  std::vector<Point> places_;
  std::vector<std::size_t> own_, moved_;  ///< which of f's inputs are the design's, and the ranges'
};

Function highest_of(const Function& f, const Widened& wide, double sign) {
  auto kernel = std::make_shared<HighestKernel>(f, wide, sign);
  std::vector<std::size_t> inputs = kernel->own_inputs();
  return {std::move(inputs), std::move(kernel)};
}

/// A place in the ranges, not a number where a range does not change the value there.
Point told(const Function& f, const Widened& wide, Design x, const Point& p) {
  constexpr double kSame = 1e-12;
  const double value = f.value(wide.design(x, p));
  Point result = p;
  for (std::size_t i = 0; i < p.size(); ++i) {
    bool is_same = true;
    for (const double end : {wide.box[i].lower, wide.box[i].upper}) {
      Point other = p;
      other[i] = end;
      is_same &= std::abs(f.value(wide.design(x, other)) - value) <= kSame * std::abs(value);
    }
    if (is_same) result[i] = kNaN;
  }
  return result;
}

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
    return Series<double, 3>(kNaN);
  }
  std::vector<double> values(const PlaceRows& places) const override {
    return std::vector<double>(places.x.size(), kNaN);
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

/// A curve over the ranges, and what bounds it; without `record` nothing is proved between places.
struct RangeParts {
  std::shared_ptr<const optim::Curve> curve;  ///< over the widened design
  Widened wide;
  double sign;
  std::optional<CurveRecord> record;
  std::shared_ptr<const optim::Kernel> kernel;  ///< of the record
};

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
    const Point found = worst(place);
    const auto known = traces_.find(found);
    std::array<double, 3> at =
        known != traces_.end() ? known->second->at(place)
                               : parts_->curve->trace(parts_->wide.design(x_, found))->at(place);
    const Function f = parts_->curve->at(place);
    const HighestKernel highest(f, parts_->wide, parts_->sign);
    if (std::isnan(highest.settled(own_of(f), found, at[0]))) at.fill(kNaN);
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

  Point worst(Place place) const {
    const double sign = parts_->sign;
    Point best = places_.front();
    double highest = -optim::kInfinity;
    for (const Point& p : places_) {
      const double value = sign * at_place(p).at(place)[0];
      if (std::isnan(value)) return p;
      if (value > highest) highest = value, best = p;
    }
    const Function f = parts_->curve->at(place);
    return HighestKernel(f, parts_->wide, sign).climb(best, own_of(f));
  }

 private:
  /// The design's own inputs of a function over the widened design.
  std::vector<double> own_of(const Function& f) const {
    std::vector<double> u;
    for (const std::size_t input : f.inputs()) {
      if (input < parts_->wide.first) u.push_back(x_[input]);
    }
    return u;
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

class RangeCurve final : public optim::Curve {
 public:
  explicit RangeCurve(RangeParts parts)
      : parts_(std::make_shared<const RangeParts>(std::move(parts))) {}

  Function at(Place place) const override {
    return highest_of(parts_->curve->at(place), parts_->wide, parts_->sign);
  }
  /// As long as the worst place in the ranges stays.
  std::vector<double> slope_gradient(Place place, Design x) const override {
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
  bool breaks_move() const override { return parts_->curve->breaks_move(); }
  Place tied(Place place, Design x) const override {
    const Point p = places_of(parts_->wide.box).front();
    return parts_->curve->tied(place, parts_->wide.design(x, p));
  }
  std::unique_ptr<optim::Trace> trace(Design x) const override {
    return std::make_unique<RangeTrace>(parts_, x);
  }
  optim::Shape shape() const override { return optim::Shape::General; }
  double memory() const override { return parts_->curve->memory(); }

  Point worst(Place place, Design x) const {
    return told(parts_->curve->at(place), parts_->wide, x, RangeTrace(parts_, x).worst(place));
  }

 private:
  std::shared_ptr<const RangeParts> parts_;
};

/// The curve over the ranges for a binding. Nothing is proved of a curve that is not recorded, nor
/// where the ranges decide whether there is such a machine.
std::shared_ptr<const RangeCurve> range_curve(const MechanismResponse& response,
                                              const std::vector<ParameterRange>& ranges,
                                              double sign, const Binding& binding) {
  Widened wide = widened(binding, ranges);
  RangeParts parts{response.curve(wide.binding, optim::Shape::General), wide, sign, {}, {}};
  const bool decides = std::any_of(ranges.begin(), ranges.end(), [&](const ParameterRange& range) {
    return holds(response.possible_by, range.parameter);
  });
  if (response.write && response.cycle && response.held.empty() && !decides) {
    parts.record = curve_record(response, wide.binding);
    parts.kernel = recorded_kernel(parts.record->record);
  }
  return std::make_shared<RangeCurve>(std::move(parts));
}

/// The binding with what the ranges hold as constants.
Binding without_ranges(const Binding& binding, const std::vector<ParameterRange>& ranges) {
  Binding result{binding.constants, {}, {}, binding.law};
  for (std::size_t k = 0; k < binding.parameters.size(); ++k) {
    const bool is_range = std::any_of(ranges.begin(), ranges.end(), [&](const auto& range) {
      return range.parameter == binding.parameters[k];
    });
    if (is_range) continue;
    result.parameters.push_back(binding.parameters[k]);
    result.variables.push_back(binding.variables[k]);
  }
  return result;
}

}  // namespace

bool depends_on(const MechanismResponse& response, const std::vector<ParameterRange>& ranges) {
  return std::any_of(ranges.begin(), ranges.end(), [&](const ParameterRange& range) {
    return holds(response.uses, range.parameter) || holds(response.possible_by, range.parameter);
  });
}

std::shared_ptr<const MechanismResponse> over_ranges(const MechanismResponse& response,
                                                     std::vector<ParameterRange> ranges,
                                                     bool highest) {
  std::erase_if(ranges, [&](const ParameterRange& range) {
    return !holds(response.uses, range.parameter) && !holds(response.possible_by, range.parameter);
  });
  const double sign = highest ? 1 : -1;
  auto result = std::make_shared<MechanismResponse>(response);
  result->write = {};
  result->turn = {};
  result->inner = {};
  result->shapes = {};
  auto over = std::make_shared<OverRanges>();
  over->ranges = ranges;
  if (response.curve) {
    result->curve = [response, ranges, sign](const Binding& binding, optim::Shape) {
      return range_curve(response, ranges, sign, without_ranges(binding, ranges));
    };
    over->worst = [response, ranges, sign](const Binding& binding, Design x, const Place* place) {
      const Binding own = without_ranges(binding, ranges);
      return range_curve(response, ranges, sign, own)->worst(*place, x);
    };
  } else {
    const auto kernel = [response, ranges, sign](const Binding& binding) {
      const Widened wide = widened(without_ranges(binding, ranges), ranges);
      return std::pair(response.number(wide.binding, optim::Shape::General), wide);
    };
    result->number = [kernel, sign](const Binding& binding, optim::Shape) {
      const auto [f, wide] = kernel(binding);
      return highest_of(f, wide, sign);
    };
    over->worst = [kernel, sign](const Binding& binding, Design x, const Place*) {
      const auto [f, wide] = kernel(binding);
      const HighestKernel own(f, wide, sign);
      std::vector<double> u;
      for (const std::size_t input : own.own_inputs()) u.push_back(x[input]);
      return told(f, wide, x, own.worst(u));
    };
  }
  result->over_ranges = std::move(over);
  return result;
}

}  // namespace camlaw::problems
