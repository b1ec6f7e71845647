// SPDX-License-Identifier: MIT
#include "optim/verdict/kkt.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "optim/verdict/borne_prices.h"
#include "optim/verdict/conditions.h"
#include "optim/verdict/dual_bound.h"
#include "optim/verdict/flat_directions.h"
#include "optim/verdict/kinks.h"
#include "optim/verdict/second_order.h"
#include "optim/verdict/unknown_prices.h"
#include "optim/verdict/verdict.h"

namespace camlaw::optim {
namespace {

constexpr double kPushes = 1e-4;  // over the scales: less is as good as nothing

/// From multipliers over scales to the engineer's units.
Kkt in_units(const Problem& problem, const Weighed& weighed, double objective_size) {
  Kkt result;
  result.residual = weighed.residual;
  result.condition = weighed.condition;
  const std::size_t constraints = problem.constraints.size(), variables = problem.variables.size();
  result.constraints.assign(constraints, 0);
  result.at_rest.assign(constraints, false);
  result.pushing_sides.assign(constraints, 0);
  std::vector<double> most(constraints, 0);  // of the sides' multipliers so far
  result.active_constraints.assign(constraints, false);
  result.lower.assign(variables, 0);
  result.upper.assign(variables, 0);
  result.active_lower.assign(variables, false);
  result.active_upper.assign(variables, false);
  const double sense = problem.objective().sense == Sense::Minimize ? 1 : -1;
  double largest = 0;
  for (const double multiplier : weighed.multipliers)
    largest = std::max(largest, std::abs(multiplier));
  for (std::size_t j = 0; j < weighed.limits.size(); ++j) {
    const ActiveLimit& limit = weighed.limits[j];
    if (limit.told && std::abs(weighed.multipliers[j]) <= kIdle * largest) continue;
    const double multiplier = weighed.multipliers[j] * objective_size / limit.size;
    if (limit.constraint && weighed.multipliers[j] > std::max(kPushes, most[*limit.constraint])) {
      most[*limit.constraint] = weighed.multipliers[j];
      result.pushing_sides[*limit.constraint] = limit.sign > 0 ? 1 : -1;
    }
    if (limit.at_moving_break && weighed.multipliers[j] > kPushes) result.at_moving_break = true;
    if (limit.constraint && limit.at_rest) {
      // No price: what an easing gains there grows faster than the easing.
      if (weighed.multipliers[j] <= kPushes) continue;
      result.at_rest[*limit.constraint] = true;
      result.active_constraints[*limit.constraint] = true;
    } else if (limit.constraint) {
      const double gain = limit.is_equation ? -sense * multiplier : multiplier;
      result.constraints[*limit.constraint] += gain;
      result.active_constraints[*limit.constraint] = true;
    } else if (limit.variable) {
      (limit.sign > 0 ? result.upper : result.lower)[*limit.variable] += multiplier;
      (limit.sign > 0 ? result.active_upper : result.active_lower)[*limit.variable] = true;
    }
  }
  return result;
}

/// What the limits' tolerances are worth together, over the objective's size. Near a rest limit and
/// tolerance are divided alike.
double worth_of_tolerances(const Scales& scales, const Weighed& weighed) {
  double worth = 0;
  for (std::size_t j = 0; j < weighed.limits.size(); ++j) {
    const ActiveLimit& limit = weighed.limits[j];
    if (!limit.constraint) continue;
    const ConstraintScale& own = scales.constraints[*limit.constraint];
    worth += std::abs(weighed.multipliers[j]) * own.default_tolerance / own.scale;
  }
  return worth;
}

/// The objective's slope, of a peak the weighed sum of its places' slopes: the longest entry.
double objective_slope(const Problem& problem, const Scales& scales, Design x, const Layout& layout,
                       const Weighed& weighed) {
  if (layout.auxiliary < 0) {
    const auto gradient = objective_gradient(problem, scales, x, layout);
    return gradient.size() == 0 ? 0 : gradient.cwiseAbs().maxCoeff();
  }
  std::vector<double> sum(problem.variables.size(), 0.0);
  for (std::size_t j = 0; j < weighed.limits.size(); ++j) {
    const ActiveLimit& limit = weighed.limits[j];
    if (limit.constraint || limit.variable) continue;
    for (const auto& [variable, slope] : limit.gradient) {
      sum[variable] += weighed.multipliers[j] * slope;
    }
  }
  double largest = 0;
  for (const double slope : sum) largest = std::max(largest, std::abs(slope));
  return largest;
}

/// Whether a limit that pushes has no slope to speak of, beside the violation, though it is not
/// known to be convex: such a point may be a saddle of the violation, or lie on a plateau.
bool has_flat_push(const Problem& problem, const Weighed& weighed, double violation) {
  // Typical changes would not move the violation by a thousandth of itself.
  constexpr double kFlat = 1e-3;
  for (std::size_t j = 0; j < weighed.limits.size(); ++j) {
    const ActiveLimit& limit = weighed.limits[j];
    if (!limit.constraint || weighed.multipliers[j] < kPushes) continue;
    const Shape shape = problem.constraints[*limit.constraint].response.shape();
    if (limit.sign > 0 ? is_convex(shape) : is_concave(shape)) continue;
    const bool flat =
        std::all_of(limit.gradient.begin(), limit.gradient.end(),
                    [&](const auto& entry) { return std::abs(entry.second) < kFlat * violation; });
    if (flat) return true;
  }
  return false;
}

/// Tells how well the conditions hold at a design with multipliers that were found in one or
/// another way.
class Weighing {
 public:
  Weighing(const Problem& problem, const Scales& scales, Design x, Optimality optimality,
           const Layout& layout, bool wants_condition)
      : problem_(problem),
        scales_(scales),
        x_(x),
        optimality_(optimality),
        layout_(layout),
        wants_condition_(wants_condition) {}

  /// The multipliers with which the conditions hold best. Those that are told come first where the
  /// search for others is long, else last.
  Weighed best(const Teller& told) const {
    constexpr int kMany = 30;  // rows
    if (!told || layout_.rows == 0) return best_of_nets();
    if (layout_.rows <= kMany) {
      Weighed own = best_of_nets();
      return holds(own) ? own : better(std::move(own), as_told(told()));
    }
    Weighed given = as_told(told());
    if (holds(given)) return given;
    // Where the conditions hold, others only sharpen the bound, and many places take long to weigh.
    const bool only_sharpens = given.residual <= kKktTolerance;
    return better(only_sharpens ? best_of_nets(1) : best_of_nets(), std::move(given));
  }

 private:
  static constexpr double kGood = 1e-10;  // nothing is gained by less

  /// A solver leaves active limits a little slack. Wider nets are cast until the conditions hold;
  /// slack times multiplier counts against them. Nets of more places than `most` are not cast.
  Weighed best_of_nets(int most = 64) const {
    constexpr Net kNets[] = {{0}, {1e-4}, {1e-4, 8}, {1e-4, 64}};
    // What is farther from optimal than this no closer look brings nearer.
    constexpr double kWorthwhile = 1e-4;
    Weighed best;
    for (const Net& net : kNets) {
      if (net.places > most) break;
      Weighed weighed = weigh(problem_, scales_, x_, optimality_, layout_, net);
      if (weighed.residual < best.residual || net.width == 0) best = std::move(weighed);
      if (best.residual <= kGood || (net.places > 1 && best.residual > kWorthwhile)) break;
      if (best.residual <= kKktTolerance && (is_tight(best) || is_enough(best))) break;
    }
    return best;
  }

  bool holds(const Weighed& weighed) const {
    if (optimality_ == Optimality::LeastViolation)
      return weighed.residual <= kLeastViolationTolerance;
    return weighed.residual <= kGood || is_tight(weighed) || is_enough(weighed);
  }

  /// Whether the conditions hold, and no multipliers would tell a bound.
  bool is_enough(const Weighed& weighed) const {
    return weighed.residual <= kKktTolerance && !why_convex(problem_);
  }

  /// Whether a lower bound leaves nothing better: then multipliers need not be sharper.
  bool is_tight(const Weighed& weighed) const {
    constexpr double kSharp = 0.5;  // of what a design may leave to gain and be called global
    if (optimality_ != Optimality::Objective) return false;
    const auto gain = largest_gain(problem_, scales_, x_, layout_, weighed);
    return gain && *gain <= kSharp * kBoundTolerance * objective_measure(problem_, scales_, x_);
  }

  Weighed better(Weighed own, Weighed given) const {
    if (holds(own)) return own;
    return holds(given) || given.residual <= own.residual ? given : own;
  }

  /// As they are told, or where the conditions do not hold so, fitted once more.
  Weighed as_told(const std::vector<Push>& pushes) const {
    Weighed plain = as_told(pushes, false);
    return holds(plain) ? plain : better(as_told(pushes, true), std::move(plain));
  }

  /// The limits that the design stands at come beside those that are told, with no multiplier.
  Weighed as_told(const std::vector<Push>& pushes, bool are_fitted) const {
    Weighed weighed =
        weigh(problem_, scales_, x_, optimality_, layout_, pushes, are_fitted, wants_condition_);
    for (ActiveLimit& limit : active_limits(problem_, scales_, x_, optimality_, {0})) {
      weighed.limits.push_back(std::move(limit));
      weighed.multipliers.push_back(0);
    }
    return weighed;
  }

  const Problem& problem_;
  const Scales& scales_;
  Design x_;
  Optimality optimality_;
  const Layout& layout_;
  bool wants_condition_;
};

}  // namespace

Teller told_as(const std::vector<Push>& pushes) {
  if (pushes.empty()) return {};
  return [&pushes] { return pushes; };
}

bool is_global_valley(const Problem& problem, double objective_slope) {
  constexpr double kSlopes = 1e-6;  // (CX2) needs a slope that rounding cannot make
  return why_convex(problem) && (!needs_slope(problem) || objective_slope > kSlopes);
}

namespace {

/// Prices that no small step bears out are not numbers.
void drop_unborne(const Problem& problem, const Scales& scales, Design x, const Layout& layout,
                  const Weighed& weighed, Kkt& result) {
  if (!(result.residual <= kPriceTolerance)) return;
  for (const std::size_t j : unborne_prices(problem, scales, x, layout, weighed)) {
    const ActiveLimit& limit = weighed.limits[j];
    auto& prices = limit.constraint ? result.constraints
                   : limit.sign > 0 ? result.upper
                                    : result.lower;
    prices[limit.constraint ? *limit.constraint : *limit.variable] =
        std::numeric_limits<double>::quiet_NaN();
  }
}

/// The conditions of a problem that is `stated` about the design.
Kkt kkt_as_given(const Problem& problem, const Problem& stated, const Scales& scales, Design x,
                 Optimality optimality, const Teller& told, bool wants_condition) {
  const Layout layout = lay_out(problem, optimality);
  const Weighed best = Weighing(problem, scales, x, optimality, layout, wants_condition).best(told);
  const bool least_violation = optimality == Optimality::LeastViolation;
  Kkt result = in_units(problem, best, least_violation ? 1 : scales.objective);
  if (least_violation) {
    result.flat = has_flat_push(problem, best, largest_violation(problem, scales, x));
    result.second_order = true;
    return result;
  }
  result.objective_slope = objective_slope(problem, scales, x, layout, best);
  result.gain_of_tolerances =
      worth_of_tolerances(scales, best) / objective_measure(problem, scales, x);
  if (const auto gain = largest_gain(problem, scales, x, layout, best)) {
    result.largest_gain = *gain * scales.objective;
  }
  result.second_order = is_global_valley(problem, result.objective_slope);
  if (!result.second_order) {
    const SecondOrder second =
        second_order({problem, scales, x, layout}, best.limits, best.multipliers);
    result.second_order =
        second.holds && !improves_along({stated, scales, x, layout}, best, second.flat);
  }
  drop_unborne(problem, scales, x, layout, best, result);
  return result;
}

}  // namespace

Kkt kkt(const Problem& problem, const Scales& scales, Design x, Optimality optimality,
        const Teller& told, bool wants_condition) {
  Kkt result = kkt_as_given(problem, problem, scales, x, optimality, told, wants_condition);
  const bool least_violation = optimality == Optimality::LeastViolation;
  if (result.residual <= (least_violation ? kLeastViolationTolerance : kKktTolerance)) {
    return result;
  }
  const std::optional<Problem> apart = with_pieces_apart(problem, scales, x);
  if (!apart) return result;
  Kkt kinked = kkt_as_given(*apart, problem, scales, x, optimality, {}, wants_condition);
  return kinked.residual < result.residual ? kinked : result;
}

}  // namespace camlaw::optim
