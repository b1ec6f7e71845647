// SPDX-License-Identifier: MIT
#include "machines/follower_train/train_boxes.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace camlaw::problems {

using optim::Bounds;

namespace {

double side_of_box(const Bounds& b) { return step_up(b.upper - b.lower); }

/// What of the steady state a quantity holds.
Steady steady_of(TrainQuantity which) {
  const bool is_displacement =
      which == TrainQuantity::Deviation || which == TrainQuantity::MassDisplacement;
  return is_displacement ? Steady::Deviation : Steady::Acceleration;
}

/// A quantity as terms of what moves in the steady state, of which steady_of() reaches `y`.
std::vector<SteadyTerm> terms_of(TrainQuantity which, const std::vector<Series<Interval, 3>>& part,
                                 const TurnHarmonics& law, const SteadyReach& y) {
  const SteadyReach still{.value = 1};
  const SteadyReach s{.value = law.most_displacement()}, a{.value = law.most_acceleration()};
  switch (which) {
    case TrainQuantity::MassDisplacement:
      return {{part[2], s}, {part[2], y}};
    case TrainQuantity::CamForce:
      return {{part[3], still}, {part[4], s}, {part[5], a}, {part[6], y}};
    default:
      return {{part[2], y}};
  }
}

class TrainOverBoxes final : public OverBoxes {
 public:
  TrainOverBoxes(TrainQuantity which, PartsOverBox parts, double factor,
                 std::shared_ptr<const TurnHarmonics> harmonics, BoundedOverBoxes::TraceAt at)
      : which_(which),
        parts_(std::move(parts)),
        factor_(factor),
        harmonics_(std::move(harmonics)),
        at_(std::move(at)) {}

  OverBox over(const Box& box, double from, double to, double sign) override {
    OverBox result{{}, std::vector<Bounds>(box.size())};
    std::vector<std::size_t> sides;
    for (std::size_t i = 0; i < box.size(); ++i) {
      if (box[i].lower < box[i].upper) sides.push_back(i);
    }
    if (sides.size() > kMostSides) return result;
    std::vector<TrainExpansion> corners;
    for (std::size_t mask = 0; mask < std::size_t{1} << sides.size(); ++mask) {
      const auto here = corner(box, sides, mask, from, to);
      if (!here || !is_bounded(here->range())) return result;
      corners.push_back(*here);
    }
    const std::vector<double>& bends = bends_over(box);
    const double off = off_corners(box, bends);
    Interval value = corners.front().range();
    for (const TrainExpansion& c : corners) value = boost::numeric::hull(value, c.range());
    result.value = bounds_about(value, off, sign);
    for (std::size_t k = 0; k < sides.size(); ++k) {
      const double width = side_of_box(box[sides[k]]);
      const double own = bends[sides[k]] * width / 2;
      const double others = 2 * off / (box[sides[k]].upper - box[sides[k]].lower);
      result.slopes[sides[k]] =
          bounds_about(rise_along(corners, k, box[sides[k]]), own + others, sign);
    }
    return result;
  }

 private:
  /// An interval that is not a number would be left out of a hull.
  static bool is_bounded(const Interval& range) {
    return std::isfinite(range.lower()) && std::isfinite(range.upper());
  }

  static Bounds bounds_about(const Interval& value, double off, double sign) {
    const Interval range = value + Interval(-off, off);
    const Bounds bounds{range.lower(), range.upper()};
    return std::isnan(bounds.lower + bounds.upper) ? Bounds{} : times(sign, bounds);
  }

  std::optional<TrainExpansion> corner(const Box& box, const std::vector<std::size_t>& sides,
                                       std::size_t mask, double from, double to) const {
    Point p;
    for (const Bounds& b : box) p.push_back(b.lower);
    for (std::size_t k = 0; k < sides.size(); ++k) {
      if (mask >> k & 1) p[sides[k]] = box[sides[k]].upper;
    }
    const auto* trace = dynamic_cast<const ExpandsTrain*>(&at_(p));
    return trace == nullptr ? std::nullopt : trace->expansion(from, to);
  }

  /// The difference quotients along the edges of one direction.
  static Interval rise_along(const std::vector<TrainExpansion>& corners, std::size_t side,
                             const Bounds& along) {
    const Interval width = Interval(along.upper) - Interval(along.lower);
    Interval all = Interval::empty();
    for (std::size_t mask = 0; mask < corners.size(); ++mask) {
      if (mask >> side & 1) continue;
      const TrainExpansion &a = corners[mask], &b = corners[mask | std::size_t{1} << side];
      const TrainExpansion rise{b.value - a.value, b.slope - a.slope, b.second - a.second,
                                a.radius};
      all = boost::numeric::hull(all, rise.range() / width);
    }
    return all;
  }

  const std::vector<double>& bends_over(const Box& box) {
    std::vector<double>& known = bends_[ends_of(box)];
    if (!known.empty()) return known;
    const FollowerTrain<Interval> train = parts_.train(box);
    const SteadyReach y = harmonics_->reach(steady_of(which_), Interval(1.0) / train.period_ratio,
                                            train.damping_ratio);
    for (std::size_t i = 0; i < box.size(); ++i) {
      const auto along = parts_.along(box, i);
      const auto terms = terms_of(which_, along, *harmonics_, y);
      known.push_back(step_up(std::abs(factor_) * bend_along(terms, along[0], along[1])));
    }
    return known;
  }

  TrainQuantity which_;
  PartsOverBox parts_;
  double factor_;
  std::shared_ptr<const TurnHarmonics> harmonics_;
  BoundedOverBoxes::TraceAt at_;
  std::map<std::vector<double>, std::vector<double>> bends_;
};

}  // namespace

Interval TrainExpansion::range() const {
  const Interval h(-radius, radius), square(0, step_up(radius * radius));
  return value + slope * h + Interval(0.5) * square * second;
}

std::vector<Series<Interval, 3>> PartsOverBox::along(const Box& box, std::size_t range) const {
  std::vector<Series<Interval, 3>> arguments;
  for (const std::size_t variable : binding_.variables) {
    const bool is_range = variable >= first_;
    const Interval value =
        is_range ? Interval(box[variable - first_].lower, box[variable - first_].upper)
                 : Interval(x_[variable]);
    const bool moves = is_range && variable - first_ == range;
    arguments.push_back(Series<Interval, 3>::variable(value, Interval(moves ? 1.0 : 0.0)));
  }
  std::vector<Series<Interval, 3>> result;
  for (const Recorded& part : parts_) {
    result.push_back(part.formula(std::span<const Series<Interval, 3>>(arguments)));
  }
  return result;
}

FollowerTrain<Interval> PartsOverBox::train(const Box& box) const {
  const auto parts = along(box, box.size());
  return {parts[0].c[0], parts[1].c[0]};
}

double off_corners(const Box& box, const std::vector<double>& bends) {
  Interval sum(0.0);
  for (std::size_t i = 0; i < box.size(); ++i) {
    const double side = box[i].upper - box[i].lower;
    if (side == 0 || bends[i] == 0) continue;
    sum += boost::numeric::square(Interval(step_up(side))) * Interval(bends[i]) / Interval(8.0);
  }
  return sum.upper();
}

std::unique_ptr<OverBoxes> train_over_boxes(TrainQuantity which, PartsOverBox parts, double factor,
                                            std::shared_ptr<const TurnHarmonics> harmonics,
                                            BoundedOverBoxes::TraceAt at) {
  return std::make_unique<TrainOverBoxes>(which, std::move(parts), factor, std::move(harmonics),
                                          std::move(at));
}

}  // namespace camlaw::problems
