// SPDX-License-Identifier: MIT
#include "optim/verdict/dual_bound.h"

#include <algorithm>
#include <cmath>

namespace camlaw::optim {
namespace {

/// One inequality sign * (f - level) <= 0 of all designs that could be better, over a size.
struct Inequality {
  Function function;
  double sign;
  double level;
  double size;
  double weight;      ///< its multiplier
  bool is_convex;     ///< sign * f is; else it is quasiconvex
  bool of_objective;  ///< its level is what the better design has
  double terms = 1;   ///< how large slopes of this response are elsewhere, which rounding goes by
};

/// The sum of weighted linear inequalities about x: constant + slopes * (y - x), in typical
/// changes.
struct RowSum {
  double constant = 0;
  std::vector<double> slopes;
  std::vector<double> scales;  ///< of the terms of each slope: what rounding is a share of
};

class Duality {
 public:
  Duality(const Problem& problem, const Scales& scales, Design x)
      : problem_(problem), scales_(scales), x_(x.begin(), x.end()) {}

  double value(const Inequality& row, Design y) const {
    return row.sign * (row.function.value(y) - row.level) / row.size;
  }

  /// The row's slopes at y, by typical changes, for each of its inputs.
  std::vector<double> slopes(const Inequality& row, Design y) const {
    std::vector<double> g(row.function.inputs().size());
    row.function.gradient(y, g);
    for (std::size_t k = 0; k < g.size(); ++k) {
      const std::size_t i = row.function.inputs()[k];
      g[k] *= is_fixed(i) ? 0 : row.sign * scales_.variables[i] / row.size;
    }
    return g;
  }

  /// Adds the row's linear inequality. Of a convex one its tangent at x. Of a quasiconvex one the
  /// tangent at a point beside x where the row is not below zero: no design that is has a direction
  /// uphill from there. False where there is no such point.
  bool add(const Inequality& row, RowSum& sum) const {
    if (row.is_convex) {
      accumulate(row, value(row, x_), slopes(row, x_), sum);
      return true;
    }
    const std::vector<double> here = slopes(row, x_);
    double square = 0;
    for (const double slope : here) square += slope * slope;
    if (!(square > 0)) return false;
    const double start = value(row, x_);
    // Uphill to the level where x lies below it; downhill, not quite as far, where it lies above.
    constexpr int kTries = 40;
    constexpr double kBeyond = 1e-9;    // so that rounding leaves it at the level
    constexpr double kShort = 1e-3;     // of the way down, so that it stays above the level
    constexpr double kNoStep = 1e-300;  // halving it further would end in subnormal numbers
    double step = (start < 0 ? 1.0 + kBeyond : 1.0 - kShort) * -start / square;
    for (int i = 0; i < kTries; ++i) {
      const std::vector<double> y = moved(row, here, step);
      const double there = value(row, y);
      if (there >= 0) {
        const std::vector<double> own = slopes(row, y);
        double way = 0;
        for (std::size_t k = 0; k < own.size(); ++k) way += own[k] * step * here[k];
        accumulate(row, -way, own, sum);
        return true;
      }
      step = start < 0 ? 2 * step : (step < -kNoStep ? 0.5 * step : 0);
    }
    return false;
  }

  /// The least that a sum can be over the box.
  double least(const RowSum& sum) const {
    constexpr double kRounding = 1e-13;  // of the terms that a slope is made of
    double result = sum.constant;
    for (std::size_t i = 0; i < x_.size(); ++i) {
      const Variable& v = problem_.variables[i];
      if (is_fixed(i)) continue;
      const double far = kFar * scales_.own[i];
      const double down = std::min(x_[i] - v.lower, far) / scales_.variables[i];
      const double up = std::min(v.upper - x_[i], far) / scales_.variables[i];
      const double slack = kRounding * sum.scales[i];
      result -= std::max({0.0, (sum.slopes[i] + slack) * down, (slack - sum.slopes[i]) * up});
    }
    return result;
  }

  RowSum nothing() const {
    return {0, std::vector<double>(x_.size(), 0.0), std::vector<double>(x_.size(), 0.0)};
  }

 private:
  bool is_fixed(std::size_t i) const {
    return problem_.variables[i].lower == problem_.variables[i].upper;
  }

  std::vector<double> moved(const Inequality& row, const std::vector<double>& direction,
                            double step) const {
    std::vector<double> y = x_;
    for (std::size_t k = 0; k < direction.size(); ++k) {
      const std::size_t i = row.function.inputs()[k];
      y[i] += step * direction[k] * scales_.variables[i];
    }
    return y;
  }

  static void accumulate(const Inequality& row, double constant, const std::vector<double>& slopes,
                         RowSum& sum) {
    sum.constant += row.weight * constant;
    // least() takes maxima, which pass over what is not a number.
    for (const double slope : slopes) sum.constant += 0 * slope;
    for (std::size_t k = 0; k < slopes.size(); ++k) {
      const double term = row.weight * slopes[k];
      sum.slopes[row.function.inputs()[k]] += term;
      sum.scales[row.function.inputs()[k]] += std::max(std::abs(term), row.weight * row.terms);
    }
  }

  const Problem& problem_;
  const Scales& scales_;
  std::vector<double> x_;
};

/// The limits that push, as inequalities; the objective's rows with the level that x has.
std::vector<Inequality> inequalities(const Problem& problem, const Scales& scales, Design x,
                                     const Weighed& weighed) {
  std::vector<Inequality> rows;
  const Objective& objective = problem.objective();
  const double best = objective_value(objective, x);
  const auto convex_row = [](Shape shape, double sign) {
    return sign > 0 ? is_convex(shape) : is_concave(shape);
  };
  if (objective.part == Part::Value) {
    const Function& f = objective.response.function();
    const double sign = objective.sense == Sense::Minimize ? 1 : -1;
    rows.push_back({f, sign, best, scales.objective, 1, convex_row(f.shape(), sign), true});
  }
  for (std::size_t j = 0; j < weighed.limits.size(); ++j) {
    const ActiveLimit& limit = weighed.limits[j];
    const double weight = weighed.multipliers[j];
    if (limit.variable || weight == 0) continue;
    const double sign = weight > 0 ? limit.sign : -limit.sign;  // of an equation either side
    const bool of_objective = !limit.constraint;
    double level = 0, terms = 1;
    if (of_objective) {
      // Of a magnitude either side of the curve; of a lowest value the lower one.
      level = objective.part == Part::Lowest ? best : limit.sign * best;
    } else if (!limit.at_rest) {
      const Constraint& c = problem.constraints[*limit.constraint];
      level = limit.sign > 0 ? *c.upper : *c.lower;
      terms = scales.constraints[*limit.constraint].scale / limit.size;
    }
    rows.push_back({*limit.function, sign, level, limit.size, std::abs(weight),
                    convex_row(limit.function->shape(), sign), of_objective, terms});
  }
  return rows;
}

/// What the multipliers leave to gain, over the objective's size.
std::optional<double> gain_left(const Problem& problem, const Scales& scales, Design x,
                                const Weighed& weighed) {
  const Duality duality(problem, scales, x);
  std::vector<Inequality> rows = inequalities(problem, scales, x, weighed);
  const auto sum_with = [&](double gain) -> std::optional<double> {
    RowSum sum = duality.nothing();
    for (Inequality row : rows) {
      if (row.of_objective) row.level -= row.sign * gain * row.size;
      if (!duality.add(row, sum)) return {};
    }
    return duality.least(sum);
  };
  double weights = 0;
  for (const Inequality& row : rows) weights += row.of_objective ? row.weight : 0;
  if (!(weights > 0.5)) return {};
  // With a gain that is large enough no design obeys all of the inequalities. Rounding in the
  // values counts too.
  constexpr double kRounding = 1e-13;
  const double value = std::abs(objective_value(problem.objective(), x)) / scales.objective;
  double gain = kRounding * std::max(1.0, value);
  for (int i = 0; i < 20; ++i) {
    const auto left = sum_with(gain);
    if (!left || std::isnan(*left)) return {};
    if (*left > 0) return gain;
    gain += 1.1 * -*left / weights + kRounding * std::max(1.0, value);
  }
  return {};
}

}  // namespace

std::optional<double> largest_gain(const Problem& problem, const Scales& scales, Design x,
                                   const Layout& layout, const Weighed& weighed) {
  if (!why_convex(problem) || layout.rows == 0) return {};
  const std::optional<double> gain = gain_left(problem, scales, x, weighed);
  const Objective& objective = problem.objective();
  if (objective.part != Part::Magnitude || objective.sense != Sense::Minimize) return gain;
  // A magnitude is not below zero.
  const double whole = objective_value(objective, x) / scales.objective;
  return gain ? std::min(*gain, whole) : whole;
}

}  // namespace camlaw::optim
