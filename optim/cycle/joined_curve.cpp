// SPDX-License-Identifier: MIT
#include "optim/cycle/joined_curve.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "optim/cycle/moving_jumps.h"

namespace camlaw::optim {
namespace {

/// A number as a curve that is the same everywhere.
class LevelTrace final : public Trace {
 public:
  LevelTrace(const Function& number, Design x, double length) : length_(length) {
    const Function proved = number.proved();
    value_ = proved.value(x);
    bounds_ =
        proved.is_enclosed() || proved.is_searched() ? proved.enclose(x) : Bounds{value_, value_};
  }
  std::vector<double> breaks() const override { return {0, length_}; }
  std::array<double, 3> at(Place) const override { return {value_, 0, 0}; }
  Bounds enclose(double, double) const override { return bounds_; }

 private:
  double length_, value_;
  Bounds bounds_;
};

class LevelCurve final : public Curve {
 public:
  LevelCurve(Function number, std::size_t variables, double length)
      : number_(std::move(number)), variables_(variables), length_(length) {}

  Function at(Place) const override { return number_; }
  std::vector<double> slope_gradient(Place, Design x) const override {
    return std::vector<double>(std::max(variables_, x.size()));
  }
  std::unique_ptr<Trace> trace(Design x) const override {
    return std::make_unique<LevelTrace>(number_, x, length_);
  }
  Shape shape() const override { return number_.shape(); }

 private:
  Function number_;
  std::size_t variables_;
  double length_;
};

/// The break that rounding has left an angle beside, else the angle.
double onto_break(double angle, const std::vector<double>& breaks) {
  constexpr double kRounding = 1e-9;  // of the cycle
  const double beside = kRounding * (breaks.back() - breaks.front());
  const auto next = std::lower_bound(breaks.begin(), breaks.end(), angle - beside);
  return next != breaks.end() && *next <= angle + beside ? *next : angle;
}

using Breaks = std::vector<std::vector<double>>;  ///< of each part, in its own angles

struct OwnPlace {
  std::size_t part;
  Place own;
};

/// Where two parts meet, from the left the earlier one; between two the end of the earlier one.
OwnPlace locate(Place place, const Breaks& breaks, double length) {
  auto [k, angle] = part_place(place.angle, breaks.size(), length);
  angle = onto_break(angle, breaks[k]);
  const double begin = breaks[k].front(), end = breaks[k].back();
  if (k > 0 && (angle < begin || (angle == begin && place.from_left))) {
    return {k - 1, {breaks[k - 1].back(), true}};
  }
  if (angle > end || (angle == end && k + 1 < breaks.size())) return {k, {end, true}};
  return {k, {angle, place.from_left}};
}

class JoinedTrace final : public Trace {
 public:
  JoinedTrace(std::vector<std::unique_ptr<Trace>> parts, double length)
      : parts_(std::move(parts)), length_(length) {
    for (const auto& part : parts_) breaks_.push_back(part->breaks());
  }

  std::vector<double> breaks() const override {
    std::vector<double> all;
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      for (const double b : breaks_[k]) {
        const double joined = static_cast<double>(k) * length_ + b;
        if (all.empty() || joined > all.back()) all.push_back(joined);
      }
    }
    return all;
  }
  std::array<double, 3> at(Place place) const override {
    if (const auto stretch = own_stretch(place.angle, place.angle, place.from_left)) {
      const Place own{place.from_left ? stretch->to : stretch->from, place.from_left};
      return parts_[stretch->part]->at(own);
    }
    const auto [k, own] = locate(place, breaks_, length_);
    return {parts_[k]->at(own)[0], 0, 0};
  }
  std::vector<std::array<double, 3>> even(double from, double to, int count) const override {
    const auto stretch = own_stretch(from, to, false);
    if (!stretch) return Trace::even(from, to, count);
    return parts_[stretch->part]->even(stretch->from, stretch->to, count);
  }
  Bounds enclose(double from, double to) const override {
    auto stretch = own_stretch(from, to, false);
    if (!stretch && from == to) stretch = own_stretch(from, to, true);
    if (stretch) return parts_[stretch->part]->enclose(stretch->from, stretch->to);
    const auto [k, end] = locate({from, false}, breaks_, length_);
    return parts_[k]->enclose(end.angle, end.angle);
  }
  std::string why_unbounded() const override {
    for (const auto& part : parts_) {
      if (std::string why = part->why_unbounded(); !why.empty()) return why;
    }
    return {};
  }

 private:
  struct OwnStretch {
    std::size_t part;
    double from, to;
  };

  /// A stretch of one part; none of what lies between two.
  std::optional<OwnStretch> own_stretch(double from, double to, bool from_left) const {
    auto [k, begin] = part_place(from, parts_.size(), length_);
    if (from_left && k > 0 && begin == 0) begin = from - static_cast<double>(--k) * length_;
    const std::vector<double>& own = breaks_[k];
    begin = onto_break(begin, own);
    const double end = onto_break(to - static_cast<double>(k) * length_, own);
    const bool is_behind = begin == own.back() && !from_left && k + 1 < parts_.size();
    const bool is_before = end == own.front() && from_left && k > 0;
    if (begin < own.front() || end > own.back() || is_behind || is_before) return {};
    return OwnStretch{k, begin, end};
  }

  std::vector<std::unique_ptr<Trace>> parts_;
  double length_;
  Breaks breaks_;
};

class JoinedCurve final : public Curve, public MovingJumps {
 public:
  JoinedCurve(std::vector<std::shared_ptr<const Curve>> parts, double length, std::size_t variables)
      : parts_(std::move(parts)), length_(length) {
    const std::vector<double> any(variables);
    for (const auto& part : parts_) {
      fixed_.push_back(part->breaks_move() ? std::vector<double>{0, length}
                                           : part->trace(any)->breaks());
    }
  }

  Function at(Place place) const override {
    const auto [k, own] = own_place(place);
    return parts_[k]->at(own);
  }
  std::vector<double> slope_gradient(Place place, Design x) const override {
    const auto [k, own] = own_place(place);
    return parts_[k]->slope_gradient(own, x);
  }
  bool breaks_move() const override {
    return std::any_of(parts_.begin(), parts_.end(),
                       [](const auto& part) { return part->breaks_move(); });
  }
  /// Joint j of part k is counted as j * parts + k.
  Place tied(Place place, Design x) const override {
    Breaks breaks;
    for (const auto& part : parts_) breaks.push_back(part->trace(x)->breaks());
    const auto [k, own] = locate(place, breaks, length_);
    const Place tied = parts_[k]->tied(own, x);
    const auto count = static_cast<int>(parts_.size());
    return {static_cast<double>(k) * length_ + own.angle, tied.from_left,
            tied.joint < 0 ? -1 : tied.joint * count + static_cast<int>(k)};
  }
  std::vector<double> jump_motion(Place place, Design x) const override {
    Breaks breaks;
    for (const auto& part : parts_) breaks.push_back(part->trace(x)->breaks());
    const auto [k, own] = locate(place, breaks, length_);
    return optim::jump_motion(*parts_[k], own, x);
  }
  std::vector<Rest> rests(double bound, Design x) const override {
    std::vector<Rest> all;
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      for (Rest rest : parts_[k]->rests(bound, x)) {
        rest.angle += static_cast<double>(k) * length_;
        all.push_back(std::move(rest));
      }
    }
    return all;
  }
  std::unique_ptr<Trace> trace(Design x) const override {
    std::vector<std::unique_ptr<Trace>> traces;
    for (const auto& part : parts_) traces.push_back(part->trace(x));
    return std::make_unique<JoinedTrace>(std::move(traces), length_);
  }
  Shape shape() const override {
    Shape shape = parts_.front()->shape();
    for (const auto& part : parts_) shape = common_shape(shape, part->shape());
    return shape;
  }
  double memory() const override {
    double sum = 0;
    for (const auto& part : parts_) sum += part->memory();
    return sum;
  }

 private:
  OwnPlace own_place(Place place) const {
    if (place.joint < 0) return locate(place, fixed_, length_);
    const auto count = static_cast<int>(parts_.size());
    const auto k = static_cast<std::size_t>(place.joint % count);
    return {k,
            {place.angle - static_cast<double>(k) * length_, place.from_left, place.joint / count}};
  }

  std::vector<std::shared_ptr<const Curve>> parts_;
  double length_;
  Breaks fixed_;  ///< of the parts whose breaks stay; of others the ends of the cycle
};

}  // namespace

PartPlace part_place(double angle, std::size_t count, double length) {
  const auto last = static_cast<double>(count - 1);
  const double part = std::clamp(std::floor(angle / length), 0.0, last);
  return {static_cast<std::size_t>(part), angle - part * length};
}

std::shared_ptr<const Curve> joined_curve(std::vector<Response> parts, double length,
                                          std::size_t variables) {
  std::vector<std::shared_ptr<const Curve>> curves;
  for (Response& part : parts) {
    curves.push_back(part.is_curve()
                         ? std::get<std::shared_ptr<const Curve>>(std::move(part.measure))
                         : std::make_shared<LevelCurve>(part.function(), variables, length / 2));
  }
  return std::make_shared<JoinedCurve>(std::move(curves), length, variables);
}

Shape common_shape(Shape a, Shape b) {
  if (a == b) return a;
  const bool convex = is_convex(a) && is_convex(b), concave = is_concave(a) && is_concave(b);
  const bool below = convex_below(a) && convex_below(b);
  const bool above = convex_above(a) && convex_above(b);
  if (convex && concave) return Shape::Linear;
  if (convex) return Shape::Convex;
  if (concave) return Shape::Concave;
  if (below && above) return Shape::Quasilinear;
  if (below) return Shape::Quasiconvex;
  return above ? Shape::Quasiconcave : Shape::General;
}

}  // namespace camlaw::optim
