// SPDX-License-Identifier: MIT
#include "machines/model/range_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "machines/model/box_traces.h"
#include "machines/model/highest_along_ranges.h"
#include "machines/model/suspect.h"
#include "optim/cycle/extremes.h"
#include "optim/cycle/proof_time.h"
#include "optim/problem/deadline.h"

namespace camlaw::problems {

using optim::Bounds, optim::Design, optim::Function, optim::Place;

/// A curve over the ranges, and what bounds it; without `bounds` nothing is proved between places.
struct RangeParts {
  std::shared_ptr<const optim::Curve> curve;  ///< over the widened design
  std::shared_ptr<const Widened> wide;
  double sign;
  std::shared_ptr<const BoundedOverBoxes> bounds;
};

namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

/// The curve at a place, as a function of the design.
HighestKernel highest_at(const RangeParts& parts, Place place) {
  return HighestKernel(parts.curve->at(place), parts.wide, parts.sign);
}

class RangeTrace final : public optim::Trace {
 public:
  RangeTrace(std::shared_ptr<const RangeParts> parts, Design x)
      : parts_(std::move(parts)),
        x_(x.begin(), x.end()),
        box_(parts_->wide->box_at(x)),
        machines_(std::make_shared<const MachinesOfBox>(parts_->wide->machines_at(x_))),
        places_(places_of(box_)) {
    for (const Point& p : places_) at_place(p);
    breaks_ = at_place(places_.front()).breaks();
    if (!parts_->bounds || !machines_->all_possible) return;
    over_ = parts_->bounds->over_boxes(
        *parts_->wide, x_, [this](const Point& p) -> const optim::Trace& { return at_place(p); });
  }

  std::vector<double> breaks() const override { return breaks_; }

  std::array<double, 3> at(Place place) const override { return at_each({&place, 1}).front(); }

  std::vector<std::array<double, 3>> even(double from, double to, int count) const override {
    return at_each(optim::even_places(from, to, count));
  }

  std::vector<double> values(std::span<const Place> places) const override {
    std::vector<double> result;
    for (const auto& at : at_each(places)) result.push_back(at[0]);
    return result;
  }

  Bounds enclose(double from, double to) const override {
    if (!over_) return {};
    const Highest found = highest(from, to);
    told_ = {found.place, suspect_of(found)};
    return times(parts_->sign, found.value);
  }

  /// The part of the ranges that bounds it over a stretch; all of them where nothing is proved.
  Box left(double from, double to) const { return over_ ? highest(from, to).left : box_; }

  std::string why_unbounded() const override { return at_place(places_.front()).why_unbounded(); }

  Point worst(Place place) const { return worst(row_at(place), heights({&place, 1}).front()); }

 private:
  /// The curve at one place, as a function of the ranges.
  struct Row {
    HighestKernel highest;
    std::vector<double> u;  ///< the design's own inputs
  };

  Row row_at(Place place) const {
    Row row{highest_at(*parts_, place).knowing(machines_), {}};
    for (const std::size_t input : row.highest.own_inputs()) row.u.push_back(x_[input]);
    return row;
  }
  Point worst(const Row& row, const Heights& heights) const {
    return row.highest.climbed_highest(
        heights.places, [&](const Point& p) { return heights.at(p); }, row.u);
  }

  /// Of each place of the cycle the values in the ranges.
  std::vector<Heights> heights(std::span<const Place> places) const {
    std::vector<Point> points = places_;
    for (const Point& p : told_) {
      if (!p.empty()) points.push_back(p);
    }
    return heights_along_ranges(
        box_, points, places.size(), [&](const Point& p, const std::vector<std::size_t>& wanted) {
          if (wanted.size() == 1) {
            return std::vector{parts_->sign * at_place(p).at(places[wanted[0]])[0]};
          }
          std::vector<Place> there;
          for (const std::size_t i : wanted) there.push_back(places[i]);
          std::vector<double> values = at_place(p).values(there);
          for (double& value : values) value *= parts_->sign;
          return values;
        });
  }

  std::vector<std::array<double, 3>> at_each(std::span<const Place> places) const {
    const std::vector<Heights> all = heights(places);
    std::vector<std::array<double, 3>> result;
    for (std::size_t i = 0; i < places.size(); ++i) {
      optim::check_deadline();
      const Row row = row_at(places[i]);
      const Point found = worst(row, all[i]);
      const auto known = traces_.find(found);
      std::array<double, 3> at =
          known != traces_.end()
              ? known->second->at(places[i])
              : parts_->curve->trace(parts_->wide->design(x_, found))->at(places[i]);
      if (std::isnan(row.highest.settled(row.u, found, at[0]))) at.fill(kNoValue);
      result.push_back(at);
    }
    return result;
  }

  const optim::Trace& at_place(const Point& p) const {
    auto& known = traces_[p];
    if (known) return *known;
    optim::check_deadline();
    known = parts_->curve->trace(parts_->wide->design(x_, p));
    return *known;
  }
  /// How far the ranges are divided over a stretch.
  Division division() const {
    // A part comes of at most so many halvings, 1e-9 of a range. More parts of one stretch gain
    // less than a shorter stretch (theory: RG2).
    constexpr int kHalvingsOfOne = 30, kParts = 5000;
    return {kHalvingsOfOne * static_cast<int>(box_.size()), kParts};
  }

  /// How many parts of one range a part takes as long as: its corners are many.
  std::int64_t effort() const {
    constexpr std::array<std::int64_t, 3> kEfforts{1, 2, 8};
    return kEfforts[std::min(box_.size(), kEfforts.size()) - 1];
  }

  Highest highest(double from, double to) const {
    const double sign = parts_->sign;
    return highest_within(
        box_, division(),
        [&](const Point& p) {
          optim::check_deadline();
          return times(sign, at_place(p).enclose(from, to));
        },
        [&](const Box& box) {
          optim::PartsOfBounds::look_at(effort());
          return over_->over(box, from, to, sign);
        });
  }

  std::shared_ptr<const RangeParts> parts_;
  std::vector<double> x_;
  Box box_;
  std::shared_ptr<const MachinesOfBox> machines_;  ///< of the ranges
  std::vector<Point> places_;
  std::vector<double> breaks_;
  mutable std::map<Point, std::unique_ptr<optim::Trace>> traces_;
  std::unique_ptr<OverBoxes> over_;  ///< none: nothing is proved
  /// Where in the ranges the latest bounds were highest, and where nothing bounded the value: a
  /// top, or what has no value, may be too narrow for places_.
  mutable std::array<Point, 2> told_;
};

}  // namespace

RangeCurve::RangeCurve(RangeParts parts)
    : parts_(std::make_shared<const RangeParts>(std::move(parts))) {}

Function RangeCurve::at(Place place) const {
  return function_of_highest(highest_at(*parts_, place).looking_along_ranges());
}

std::vector<double> RangeCurve::slope_gradient(Place place, Design x) const {
  const Point p = RangeTrace(parts_, x).worst(place);
  const Widened& wide = *parts_->wide;
  const Box box = wide.box_at(x);
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (p[i] != box[i].lower && p[i] != box[i].upper) return {};
  }
  const std::vector<double> all = parts_->curve->slope_gradient(place, wide.design(x, p));
  if (all.empty()) return {};
  std::vector<double> slopes(x.size(), 0.0);
  std::copy(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(wide.first), slopes.begin());
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (wide.about[i]) slopes[*wide.about[i]] += all[wide.first + i];
  }
  return slopes;
}

bool RangeCurve::breaks_move() const { return parts_->curve->breaks_move(); }
Place RangeCurve::tied(Place place, Design x) const {
  const Point p = places_of(parts_->wide->box_at(x)).front();
  return parts_->curve->tied(place, parts_->wide->design(x, p));
}

std::unique_ptr<optim::Trace> RangeCurve::trace(Design x) const {
  return std::make_unique<RangeTrace>(parts_, x);
}

Box RangeCurve::left(double from, double to, Design x) const {
  return RangeTrace(parts_, x).left(from, to);
}

double RangeCurve::memory() const { return parts_->curve->memory(); }

Point RangeCurve::worst(Place place, Design x) const {
  const optim::Deadline none({}, nullptr);
  const optim::ProofTime unlimited(none);  // as optim::looked_closely, whose place it is
  const RangeTrace trace(parts_, x);
  optim::enclosed_at(trace, place);  // what a proof comes upon counts
  return told(parts_->curve->at(place), *parts_->wide, x, trace.worst(place));
}

std::shared_ptr<const RangeCurve> range_curve(const MechanismResponse& response,
                                              const std::vector<TakenRange>& ranges, double sign,
                                              const Binding& binding) {
  const auto wide = std::make_shared<const Widened>(widened(binding, ranges, response.possible_by));
  RangeParts parts{response.curve(wide->binding, optim::Shape::General), wide, sign, {}};
  parts.bounds = bounded_over_boxes(response, parts.curve, *wide);
  return std::make_shared<RangeCurve>(std::move(parts));
}

}  // namespace camlaw::problems
