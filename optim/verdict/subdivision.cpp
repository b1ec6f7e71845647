// SPDX-License-Identifier: MIT
#include "optim/verdict/subdivision.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "optim/cycle/extremes.h"
#include "optim/problem/interrupted.h"
#include "optim/verdict/conditions.h"
#include "optim/verdict/limits.h"

namespace camlaw::optim {
namespace {

constexpr int kMostLooks = 200;      // at designs, over the whole cycle
constexpr double kRounding = 1e-13;  // of the terms of a sum
/// Designs that are better by this share of the objective's measure are looked for: as much as the
/// tolerance of a number is (SC3), so that none which is better by more than that is left in a
/// divided box.
constexpr double kSought = 1e-7;

using Box = std::vector<Bounds>;

/// sign * function <= level for every design within the limits, or a little beyond; of the
/// objective's rows sign * function <= objective.
struct BoxRow {
  Function function;
  double sign;
  double level;
  bool of_objective;
  double weight;  ///< its multiplier, in the objective's unit: part of the Lagrangian
  const Curve* curve = nullptr;  ///< where it is one place of a curve that was added later
  Place place = {};
};

/// A weighted sum of rows: its value at the middle of a box, and its slopes over the box.
struct LinearSum {
  double centre = 0;
  std::vector<Bounds> slopes;
  double terms = 0;  ///< how large what it is summed from is, which rounding goes by
};

double width(const Bounds& range) { return range.upper - range.lower; }
double middle(const Bounds& range) { return range.lower + 0.5 * width(range); }

/// The least of slope * step for |step| <= radius.
double least_change(const Bounds& slope, double radius) {
  return radius == 0 ? 0 : -radius * std::max(-slope.lower, slope.upper);
}

class Division {
 public:
  Division(const Problem& problem, const Scales& scales, Design x)
      : problem_(problem),
        scales_(scales),
        x_(x.begin(), x.end()),
        sense_(problem.objective().sense == Sense::Minimize ? 1 : -1),
        best_(sense_ * objective_value(problem.objective(), x)),
        tolerance_(kSought * scales.objective * objective_measure(problem, scales, x)) {
    take_rows();
  }

  std::optional<Subdivision> run(const std::function<bool()>& stop, int most_boxes) {
    if (!is_known()) return {};
    Box whole;
    for (const Variable& v : problem_.variables) whole.push_back({v.lower, v.upper});
    unless_cut(-kInfinity, [&] { add(whole, -kInfinity); });
    while (!waiting_.empty() && !result_.better && result_.boxes < most_boxes && !is_hopeless() &&
           !is_cut(stop)) {
      const Box box = waiting_.top().box;
      const double lower = waiting_.top().lower;
      waiting_.pop();
      unless_cut(lower, [&] { divide(box, lower); });
    }
    if (result_.better) return result_;
    // What is left undivided may hold what its own range allows; what is gone holds nothing better.
    const double least = std::min(left_, waiting_.empty() ? kInfinity : waiting_.top().lower);
    const double bound = std::min(best_ - 0.5 * tolerance_, least);
    if (!std::isfinite(bound) && !result_.is_cut) return {};
    result_.best_possible = sense_ * bound;
    return result_;
  }

 private:
  /// Whether the objective has ranges, which close on its value at the design.
  bool is_known() const {
    Box point;
    for (const double value : x_) point.push_back({value, value});
    return std::any_of(rows_.begin(), rows_.end(), [&](const BoxRow& row) {
      return row.of_objective && std::isfinite(width(row.function.range(point).value));
    });
  }

  /// Where the work at a box is interrupted, either part of it may hold what the box may.
  template <class Work>
  void unless_cut(double lower, const Work& work) {
    try {
      work();
    } catch (const Interrupted&) {
      left_ = std::min(left_, lower);
      result_.is_cut = true;
    }
  }
  /// Parts without any bound come first. Where there still are some after so many, as of a number
  /// that is known over small boxes only, no bound of the whole is to be had.
  bool is_hopeless() const {
    constexpr int kMostUnbounded = 3000;
    return result_.boxes >= kMostUnbounded && waiting_.top().lower == -kInfinity;
  }
  bool is_cut(const std::function<bool()>& stop) {
    result_.is_cut = result_.is_cut || stop();
    return result_.is_cut;
  }

  struct Waiting {
    double lower;  ///< no design of the box within the limits is better
    int order;
    Box box;
    friend bool operator<(const Waiting& a, const Waiting& b) {
      return a.lower != b.lower ? a.lower > b.lower : a.order > b.order;
    }
  };

  /// The objective, every limit that is a number, and what holds the design, with its multipliers.
  void take_rows() {
    const Objective& objective = problem_.objective();
    const Layout layout = lay_out(problem_, Optimality::Objective);
    constexpr double kWidth = 1e-4;  // of a net that the verdict casts too (kkt.cpp)
    const Weighed weighed =
        layout.rows > 0 ? weigh(problem_, scales_, x_, Optimality::Objective, layout, Net{kWidth})
                        : Weighed{};
    if (objective.part == Part::Value) {
      rows_.push_back({objective.response.function(), sense_, 0, true, 1});
    }
    for (std::size_t i = 0; i < problem_.constraints.size(); ++i) {
      const Constraint& c = problem_.constraints[i];
      if (c.response.is_curve()) continue;
      if (c.upper) rows_.push_back({c.response.function(), 1, level(i, 1), false, 0});
      if (c.lower) rows_.push_back({c.response.function(), -1, level(i, -1), false, 0});
    }
    double peaks = 0;
    for (std::size_t j = 0; j < weighed.limits.size(); ++j) {
      const ActiveLimit& limit = weighed.limits[j];
      if (!limit.function || limit.at_rest) continue;
      double weight = weighed.multipliers[j] * scales_.objective / limit.size;
      const double sign = weight < 0 ? -limit.sign : limit.sign;
      if (!limit.constraint) {
        rows_.push_back({*limit.function, sign, 0, true, weighed.multipliers[j]});
        peaks += weighed.multipliers[j];
        continue;
      }
      rows_.push_back(
          {*limit.function, sign, level(*limit.constraint, sign), false, std::abs(weight)});
    }
    // The shares of the objective's peaks add up to one; else there is no Lagrangian.
    const bool weighs = objective.part == Part::Value || peaks > 0;
    for (BoxRow& row : rows_) {
      if (!weighs) row.weight = 0;
      if (row.of_objective && objective.part != Part::Value && weighs) row.weight /= peaks;
    }
    has_lagrangian_ = weighs;
  }

  /// sign * bound, eased by more than rounding leaves of a value, and by so little of the tolerance
  /// that the objective does not show it.
  double level(std::size_t constraint, double sign) const {
    const Constraint& c = problem_.constraints[constraint];
    const ConstraintScale& own = scales_.constraints[constraint];
    // A thousandth of the tolerance does not show in the objective; a value rounds by some 1e-16 of
    // its size.
    constexpr double kOfTolerance = 1e-3, kOfScale = 1e-12;
    return sign * (sign > 0 ? *c.upper : *c.lower) +
           std::max(kOfTolerance * own.tolerance, kOfScale * own.scale);
  }

  /// A row over a box: numbers that sign * function is not below there, and at the middle.
  struct OverBox {
    double least, at_middle;
    std::vector<Bounds> slopes;  ///< of sign * function, by the function's inputs
    double terms;                ///< how large what `least` is summed from is
  };

  OverBox over(const BoxRow& row, const Box& box, const Box& centre) const {
    const BoxRange range = row.function.range(box);
    const Bounds value = turned(range.value, row.sign);
    OverBox result{value.lower, turned(row.function.range(centre).value, row.sign).lower, {}, 0};
    double mean = result.at_middle;
    result.terms = std::abs(mean);
    for (std::size_t k = 0; k < range.slopes.size(); ++k) {
      result.slopes.push_back(turned(range.slopes[k], row.sign));
      const double change = least_change(result.slopes[k], radius(box[row.function.inputs()[k]]));
      mean += change;
      result.terms += std::abs(change);
    }
    mean -= kRounding * result.terms;
    if (mean > result.least) result.least = mean;
    return result;
  }

  static void add_to(LinearSum& sum, const BoxRow& row, const OverBox& part) {
    if (row.weight == 0) return;
    const double level = row.of_objective ? 0 : row.level;
    sum.centre += row.weight * (part.at_middle - level);
    sum.terms += row.weight * (part.terms + std::abs(level));
    for (std::size_t k = 0; k < part.slopes.size(); ++k) {
      Bounds& slope = sum.slopes[row.function.inputs()[k]];
      slope.lower += row.weight * part.slopes[k].lower;
      slope.upper += row.weight * part.slopes[k].upper;
    }
  }

  /// Puts a box aside to be divided, unless it holds nothing better. No design of it within the
  /// limits is better than `parent`.
  void add(const Box& box, double parent) {
    ++result_.boxes;
    Box centre;
    for (const Bounds& side : box) centre.push_back({middle(side), middle(side)});
    double lower = parent;
    LinearSum lagrangian{0, Box(box.size(), Bounds{0, 0})};
    bool promising = true;
    for (const BoxRow& row : rows_) {
      const OverBox part = over(row, box, centre);
      const double level = row.of_objective ? goal() : row.level;
      if (part.least > level) return;  // no design here meets the limit, or none is better
      if (row.of_objective) lower = std::max(lower, part.least);
      promising = promising && !(part.at_middle > level);
      add_to(lagrangian, row, part);
    }
    double least = lagrangian.centre - kRounding * lagrangian.terms;
    for (std::size_t i = 0; i < box.size(); ++i) {
      least += least_change(lagrangian.slopes[i], radius(box[i]));
    }
    if (has_lagrangian_ && least > lower) lower = least;
    if (lower > goal()) return;
    if (promising) look(box);
    if (!result_.better) waiting_.push({lower, result_.boxes, box});
  }

  /// What a design must be below to be better.
  double goal() const { return best_ - 0.5 * tolerance_; }

  /// A few units of the last place more than half the width, so that the box is covered.
  static double radius(const Bounds& side) {
    // The middle and half the width are rounded by a few units of the last place.
    constexpr double kUnits = 1e-15;
    return 0.5 * width(side) * (1 + kUnits);
  }
  static Bounds turned(const Bounds& range, double sign) {
    return sign > 0 ? range : Bounds{-range.upper, -range.lower};
  }

  void divide(const Box& box, double lower) {
    const std::size_t side = longest(box);
    const double cut = middle(box[side]);
    if (!(cut > box[side].lower && cut < box[side].upper) || is_small(box)) {
      left_ = std::min(left_, lower);
      return;
    }
    Box part = box;
    part[side].upper = cut;
    add(part, lower);
    part = box;
    part[side].lower = cut;
    if (!result_.better) add(part, lower);
  }

  bool is_small(const Box& box) const {
    constexpr double kSmall = 1e-12;  // of a typical change: halves would differ by rounding
    for (std::size_t i = 0; i < box.size(); ++i) {
      if (width(box[i]) > kSmall * scales_.variables[i]) return false;
    }
    return true;
  }

  /// The side along which what is not decided yet changes most, over the limits' scales.
  std::size_t longest(const Box& box) const {
    std::vector<double> changes(box.size(), 0.0);
    for (const BoxRow& row : rows_) {
      const BoxRange range = row.function.range(box);
      const double greatest = row.sign > 0 ? range.value.upper : -range.value.lower;
      if (!row.of_objective && greatest <= row.level) continue;
      const double size = std::isfinite(width(range.value)) ? width(range.value) : 0;
      if (!(size > 0)) continue;
      for (std::size_t k = 0; k < row.function.inputs().size(); ++k) {
        const std::size_t i = row.function.inputs()[k];
        const double change = -least_change(range.slopes[k], width(box[i])) / size;
        if (std::isfinite(change)) changes[i] = std::max(changes[i], change);
      }
    }
    std::size_t result = 0;
    double most = -1;
    for (std::size_t i = 0; i < box.size(); ++i) {
      // No side may stay much longer than the others, whatever the slopes say.
      const double whole = problem_.variables[i].upper - problem_.variables[i].lower;
      if (whole == 0) continue;
      const double length = changes[i] + width(box[i]) / whole;
      if (length > most) most = length, result = i;
    }
    return result;
  }

  /// Looks at the design in the middle over the whole cycle: it may be a better one, or show a
  /// place at which the limits have not been looked at.
  void look(const Box& box) {
    if (looks_ == kMostLooks) return;
    ++looks_;
    std::vector<double> y;
    for (const Bounds& side : box) y.push_back(middle(side));
    bool news = false;
    const Objective& objective = problem_.objective();
    const double value = sense_ * objective_value(objective, y);
    if (!(value < best_ - tolerance_)) {
      if (objective.part != Part::Value && std::isfinite(value)) {
        const Extreme peak = extreme_of(*objective.response.curve().trace(y), objective.part);
        const double sign = objective.part == Part::Lowest || peak.value < 0 ? -1 : 1;
        const bool turns = objective.part == Part::Magnitude || sign == sense_;
        add_place(objective.response.curve(), peak.place, turns ? sign : sense_, 0, true);
      }
      return;
    }
    for (std::size_t i = 0; i < problem_.constraints.size(); ++i) {
      const Constraint& c = problem_.constraints[i];
      if (!c.response.is_curve()) continue;
      const auto trace = c.response.curve().trace(y);
      for (const double sign : {1.0, -1.0}) {
        const auto& bound = sign > 0 ? c.upper : c.lower;
        if (!bound) continue;
        const Extreme worst = highest(*trace, sign);
        const double eased = level(i, sign);
        if (!std::isfinite(worst.value) || !(sign * worst.value > eased)) continue;
        news = add_place(c.response.curve(), worst.place, sign, eased, false) || news;
      }
    }
    if (news) return;
    const Scales there = judged_at(problem_, scales_, y);
    if (worst_violation(limit_reports(problem_, there, y, false)) <= 1) result_.better = y;
  }

  /// Whether the place was not among the rows.
  bool add_place(const Curve& curve, Place place, double sign, double level, bool of_objective) {
    const bool known = std::any_of(rows_.begin(), rows_.end(), [&](const BoxRow& row) {
      return row.curve == &curve && row.place == place && row.sign == sign;
    });
    if (known || rows_.size() >= kMostRows) return false;
    rows_.push_back({curve.at(place), sign, level, of_objective, 0, &curve, place});
    return true;
  }

  // Each is bounded over each box; the places that hold the design are few.
  static constexpr std::size_t kMostRows = 60;

  const Problem& problem_;
  const Scales& scales_;
  std::vector<double> x_;
  double sense_;
  double best_;  ///< the objective of x, less being better
  double tolerance_;
  std::vector<BoxRow> rows_;
  std::priority_queue<Waiting> waiting_;
  bool has_lagrangian_ = false;
  double left_ = kInfinity;  ///< the least bound of what is too small to be divided
  int looks_ = 0;
  Subdivision result_{};
};

}  // namespace

std::optional<Subdivision> subdivided(const Problem& problem, const Scales& scales, Design x,
                                      const std::function<bool()>& stop, int most_boxes) {
  std::size_t free = 0;
  for (const Variable& v : problem.variables) {
    if (!std::isfinite(v.upper - v.lower)) return {};
    free += v.lower < v.upper;
  }
  if (free == 0 || free > kMostDivided) return {};
  try {
    return Division(problem, scales, x).run(stop, most_boxes);
  } catch (...) {
    return {};
  }
}

}  // namespace camlaw::optim
