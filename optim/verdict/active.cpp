// SPDX-License-Identifier: MIT
#include "optim/verdict/active.h"

#include <algorithm>
#include <cmath>

#include "optim/cycle/maxima_at.h"
#include "optim/cycle/rest_weights.h"

namespace camlaw::optim {
namespace {

/// Collects the limits of one design.
class Collector {
 public:
  Collector(const Problem& problem, const Scales& scales, Design x, Optimality optimality, Net net)
      : problem_(problem), scales_(scales), x_(x), optimality_(optimality), net_(net), maxima_(x) {}

  std::vector<ActiveLimit> collect() {
    const bool least_violation = optimality_ == Optimality::LeastViolation;
    take_violation();
    if (!least_violation && problem_.objective().response.is_curve()) add_objective();
    for (std::size_t i = 0; i < problem_.constraints.size(); ++i) add_constraint(i);
    for (std::size_t i = 0; i < problem_.variables.size(); ++i) add_bounds(i);
    return std::move(limits_);
  }

  std::vector<ActiveLimit> collect(const std::vector<Push>& told) {
    take_violation();
    peak_ = objective_value(problem_.objective(), x_);
    for (const Push& push : told) {
      std::optional<ActiveLimit> limit = push.variable ? bound_of(push) : limit_of(push);
      if (!limit || !is_moved(*limit)) continue;
      limit->told = push.price;
      limits_.push_back(std::move(*limit));
    }
    return std::move(limits_);
  }

 private:
  void take_violation() {
    if (optimality_ == Optimality::LeastViolation)
      violation_ = std::max(0.0, largest_violation(problem_, scales_, x_));
  }

  /// Whether a limit may be passed by the violation that is least.
  bool is_eased(std::optional<std::size_t> constraint) const {
    return optimality_ == Optimality::LeastViolation && constraint &&
           !problem_.constraints[*constraint].is_strict;
  }

  std::optional<ActiveLimit> bound_of(const Push& push) const {
    const Variable& v = problem_.variables[*push.variable];
    if (v.lower == v.upper || std::isinf(push.sign > 0 ? v.upper : v.lower)) return {};
    return bound_limit(*push.variable, push.sign);
  }

  std::optional<ActiveLimit> limit_of(const Push& push) const {
    const bool eased = optimality_ == Optimality::LeastViolation;
    const std::optional<double> bound =
        push.constraint ? bound_of_constraint(push) : level_of(push);
    if (!bound) return {};
    // The objective's peak is an auxiliary variable in its size, which may be another by now.
    const double size = push.constraint ? push.size : scales_.objective;
    ActiveLimit limit = gradient_of(*push.function, {push.sign, *bound, size, kInfinity});
    limit.constraint = push.constraint;
    limit.at_rest = push.at_rest;
    limit.is_equation =
        !eased && push.constraint && problem_.constraints[*push.constraint].is_equation();
    if (!push.constraint || is_eased(push.constraint)) limit.auxiliary = -1;
    return limit;
  }

  std::optional<double> bound_of_constraint(const Push& push) const {
    const Constraint& c = problem_.constraints[*push.constraint];
    const auto& bound = push.sign > 0 ? c.upper : c.lower;
    if (!bound || push.at_rest) return bound ? std::optional(0.0) : std::nullopt;
    return *bound + push.sign * (c.is_strict ? 0 : violation_) * push.size;
  }

  /// The level of a peak that is sought, on the side that it is sought on.
  std::optional<double> level_of(const Push& push) const {
    const Objective& objective = problem_.objective();
    if (!objective.response.is_curve() || optimality_ == Optimality::LeastViolation) return {};
    if (objective.part == Part::Magnitude) return push.sign * peak_;
    const bool is_its_side = (objective.part == Part::Lowest) == (push.sign < 0);
    return is_its_side ? std::optional(peak_) : std::nullopt;
  }

  struct Level {
    double sign, bound, size, reach;  ///< reach: the largest margin that counts as active
  };

  void add_objective() {
    const Objective& objective = problem_.objective();
    const Curve& curve = objective.response.curve();
    const Trace& trace = maxima_.trace(curve);
    const double reach = std::max(net_.width * scales_.objective, 2 * scales_.objective_tolerance);
    std::vector<Extreme> up, down;
    if (objective.part != Part::Lowest) up = maxima_.maxima(curve, 1);
    if (objective.part != Part::Highest) down = maxima_.maxima(curve, -1);
    double peak = -kInfinity;
    for (const Extreme& e : up) peak = std::max(peak, e.value);
    for (const Extreme& e : down) peak = std::max(peak, -e.value);
    const auto add = [&](double sign, const std::vector<Extreme>& peaks) {
      const Level level{sign, sign * peak, scales_.objective, reach};
      add_places({objective.response, trace, trace.breaks(), level, {}, {}}, peaks);
    };
    if (objective.part != Part::Lowest) add(1, up);
    if (objective.part != Part::Highest) add(-1, down);
  }

  void add_constraint(std::size_t i) {
    const Constraint& c = problem_.constraints[i];
    const ConstraintScale& own = scales_.constraints[i];
    const double reach = std::max(net_.width * own.scale, 2 * own.tolerance);
    const bool equation = c.is_equation();
    const double eased = c.is_strict ? 0 : violation_ * own.scale;
    const auto add = [&](double sign, double bound) {
      const Level level{sign, bound + sign * eased, own.scale, reach};
      if (c.response.is_curve()) {
        add_curve(c.response, level, bound, i);
      } else {
        add_number(c.response.function(), level, i, equation);
      }
    };
    if (c.upper) add(1, *c.upper);
    if (c.lower && (!equation || optimality_ == Optimality::LeastViolation)) add(-1, *c.lower);
  }

  void add_number(const Function& f, const Level& level, std::size_t constraint, bool equation) {
    ActiveLimit limit = gradient_of(f, level);
    const bool free = equation && optimality_ == Optimality::Objective;
    if (!free && limit.margin * level.size > level.reach) return;
    limit.constraint = constraint;
    limit.is_equation = free;
    if (is_eased(constraint)) limit.auxiliary = -1;
    if (is_moved(limit)) limits_.push_back(std::move(limit));
  }

  /// The bound is the limit's own, without what it is eased by.
  void add_curve(const Response& response, const Level& level, double bound,
                 std::size_t constraint) {
    const Trace& trace = maxima_.trace(response.curve());
    const auto& peaks = maxima_.maxima(response.curve(), level.sign);
    // A limit that the curve is far from has no place that stands at it.
    constexpr double kFar = 2;
    const double room = level.sign * (level.bound - highest_of(peaks, level.sign).value);
    if (room > kFar * level.reach) return;
    RestWeights weights;
    if (!is_eased(constraint)) {
      weights = RestWeights(response.curve(), bound, x_);
      add_rests(weights.rests(), level, constraint);
    }
    add_places({response, trace, trace.breaks(), level, constraint, std::move(weights)}, peaks);
  }

  /// The leading coefficients that stand near zero, or on the wrong side of it.
  void add_rests(const std::vector<Rest>& rests, const Level& level, std::size_t constraint) {
    for (const Rest& rest : rests) {
      const double size = typical_change(rest.leading, x_, scales_.variables);
      if (!(size > 0) || !std::isfinite(size)) continue;
      const double reach = std::max(net_.width, 2 * kRestTolerance) * size;
      const Level own{level.sign, 0, size, reach};
      ActiveLimit limit = gradient_of(rest.leading, own);
      if (limit.margin * size > reach) continue;
      limit.constraint = constraint;
      limit.at_rest = true;
      limits_.push_back(std::move(limit));
    }
  }

  /// Whether some variable moves a limit, more than rounding does. What is not a number stays: it
  /// must show in the conditions.
  static bool is_moved(const ActiveLimit& limit) {
    const auto moves = [](double slope) { return std::isnan(slope) || !vanishes(std::abs(slope)); };
    return moves(limit.auxiliary) ||
           std::any_of(limit.gradient.begin(), limit.gradient.end(),
                       [&](const auto& entry) { return moves(entry.second); });
  }

  /// One side of a curve at this design.
  struct CurveLevel {
    const Response& response;
    const Trace& trace;
    std::vector<double> breaks;
    Level level;
    std::optional<std::size_t> constraint;
    RestWeights weights;
  };

  /// Local maxima that stand at the level, and other places that do: where a curve runs along its
  /// bound, as near as a solver leaves it, its highest place alone does not hold it.
  void add_places(const CurveLevel& side, const std::vector<Extreme>& peaks) {
    for (const Extreme& peak : peaks) {
      add_place(side, peak, true);
      if (std::isnan(peak.value)) return;
    }
    const int steps = steps_of_stretch(side.breaks.size() - 1);
    for (std::size_t k = 0; k + 1 < side.breaks.size(); ++k) {
      const double from = side.breaks[k], to = side.breaks[k + 1];
      for (int i = 0; i <= steps; ++i) {
        const Place place = even_place(from, to, steps, i);
        const double value = side.trace.at(place)[0];
        if (!is_near_level(side, place, value)) continue;
        const bool known = std::any_of(peaks.begin(), peaks.end(),
                                       [&](const Extreme& peak) { return peak.place == place; });
        if (!known) add_place(side, {place, value}, false);
      }
    }
  }

  /// Curves of many stretches need no more than a few places in each.
  int steps_of_stretch(std::size_t stretches) const {
    // The places of the first net; up to 32 stretches have all 64 of the finer one.
    constexpr int kFew = 8;
    constexpr std::size_t kMost = 2048;
    const auto shared = static_cast<int>(kMost / std::max<std::size_t>(stretches, 1));
    return std::min(net_.places, std::max(kFew, shared));
  }

  static bool is_near_level(const CurveLevel& side, Place place, double value) {
    const double reach = side.level.reach * side.weights.at(place);
    return !(side.level.sign * (side.level.bound - value) > reach);
  }

  void add_place(const CurveLevel& side, const Extreme& at, bool is_peak) {
    if (side.weights.is_rest(at.place) || !is_near_level(side, at.place, at.value)) return;
    Level level = side.level;
    const double weight = side.weights.at(at.place);
    level.size *= weight;
    level.reach *= weight;
    const Curve& curve = side.response.curve();
    const Place place = curve.tied(at.place, x_);
    ActiveLimit limit = gradient_of(curve.at(place), level);
    limit.constraint = side.constraint;
    if (!side.constraint || is_eased(side.constraint)) limit.auxiliary = -1;
    if (is_smooth_at(side, at.place)) {
      if (is_peak) limit.slope_gradient = curve.slope_gradient(at.place, x_);
      limit.curvature = side.trace.at(at.place)[2];
    } else if (curve.breaks_move() && place.joint < 0) {
      limit.at_moving_break = slopes_at_break(side, at.place);
    }
    if (is_moved(limit) && !is_twin(limit)) limits_.push_back(std::move(limit));
  }

  /// Whether a place is not a break, or one at which nothing breaks (see watched()).
  static bool is_smooth_at(const CurveLevel& side, Place place) {
    const std::vector<double>& breaks = side.breaks;
    const double cycle = breaks.back() - breaks.front();
    constexpr double kRounding = 1e-12;  // of the cycle
    const auto after =
        std::lower_bound(breaks.begin(), breaks.end(), place.angle - kRounding * cycle);
    if (after == breaks.end() || *after > place.angle + kRounding * cycle) return true;
    if (place.angle == breaks.front() || place.angle == breaks.back()) return false;
    return side.trace.at({place.angle, true}) == side.trace.at({place.angle, false});
  }

  /// Whether a limit of the same constraint has the same gradient, as rise and return of a
  /// symmetric cycle have: the two would share a multiplier in any proportion.
  bool is_twin(const ActiveLimit& limit) const {
    static constexpr double kSame = 1e-9;  // gradients of twins differ by rounding
    double length = 0;
    for (const auto& entry : limit.gradient) length = std::max(length, std::abs(entry.second));
    return std::any_of(limits_.begin(), limits_.end(), [&](const ActiveLimit& other) {
      if (other.constraint != limit.constraint || other.variable || !other.function) return false;
      if (other.at_moving_break != limit.at_moving_break) return false;
      if (std::abs(other.margin - limit.margin) > kSame) return false;
      return std::equal(limit.gradient.begin(), limit.gradient.end(), other.gradient.begin(),
                        other.gradient.end(), [&](const auto& a, const auto& b) {
                          return a.first == b.first &&
                                 std::abs(a.second - b.second) <= kSame * length;
                        });
    });
  }

  /// Whether a peak stands at a break inside the cycle, with a slope that a shift of it would show.
  static bool slopes_at_break(const CurveLevel& side, Place place) {
    // Of the size, over the whole cycle: a level peak has less by rounding.
    constexpr double kSlope = 1e-6;
    const double first = side.breaks.front(), last = side.breaks.back();
    if (place.angle == first || place.angle == last) return false;
    return std::abs(side.trace.at(place)[1]) * (last - first) > kSlope * side.level.size;
  }

  ActiveLimit gradient_of(const Function& f, const Level& level) const {
    ActiveLimit limit;
    limit.function = f;
    limit.size = level.size;
    limit.sign = level.sign;
    std::vector<double> g(f.inputs().size());
    const double value = f.gradient(x_, g);
    limit.margin = level.sign * (level.bound - value) / level.size;
    for (std::size_t k = 0; k < g.size(); ++k) {
      const std::size_t variable = f.inputs()[k];
      const double slope = level.sign * g[k] * scales_.variables[variable] / level.size;
      if (slope != 0) limit.gradient.emplace_back(variable, slope);
    }
    return limit;
  }

  void add_bounds(std::size_t i) {
    const Variable& v = problem_.variables[i];
    if (v.lower == v.upper) return;
    constexpr double kStopsShort = 1e-7;  // solvers end about so far from a bound that holds them
    for (const double sign : {1.0, -1.0}) {
      ActiveLimit limit = bound_limit(i, sign);
      if (limit.margin <= std::max(net_.width, kStopsShort)) limits_.push_back(std::move(limit));
    }
  }

  ActiveLimit bound_limit(std::size_t i, double sign) const {
    const Variable& v = problem_.variables[i];
    ActiveLimit limit;
    limit.gradient = {{i, sign}};
    limit.margin = sign * ((sign > 0 ? v.upper : v.lower) - x_[i]) / scales_.variables[i];
    limit.size = scales_.variables[i];
    limit.sign = sign;
    limit.variable = i;
    return limit;
  }

  /// What a leading coefficient may lie beyond zero, over its size.
  static constexpr double kRestTolerance = 1e-6;

  const Problem& problem_;
  const Scales& scales_;
  Design x_;
  Optimality optimality_;
  Net net_;
  MaximaAt maxima_;
  double violation_ = 0;
  double peak_ = 0;  ///< of the objective, where limits are told
  std::vector<ActiveLimit> limits_;
};

}  // namespace

std::vector<ActiveLimit> active_limits(const Problem& problem, const Scales& scales, Design x,
                                       Optimality optimality, Net net) {
  return Collector(problem, scales, x, optimality, net).collect();
}

std::vector<ActiveLimit> told_limits(const Problem& problem, const Scales& scales, Design x,
                                     Optimality optimality, const std::vector<Push>& told) {
  return Collector(problem, scales, x, optimality, Net{0}).collect(told);
}

}  // namespace camlaw::optim
