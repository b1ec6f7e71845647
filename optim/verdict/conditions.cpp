// SPDX-License-Identifier: MIT
#include "optim/verdict/conditions.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numerics/linear/column_factors.h"
#include "numerics/linear/least_squares.h"

namespace camlaw::optim {
namespace {

/// The limits' gradients as columns of length one, and the lengths. Below them a row for each limit
/// with a margin: what its multiplier leaves open.
Eigen::SparseMatrix<double> limit_gradients(const std::vector<ActiveLimit>& limits,
                                            const Layout& layout, std::vector<double>& lengths) {
  constexpr double kOpen = 1e-10;  // less is what an interior-point method leaves
  std::vector<Eigen::Triplet<double>> entries;
  int rows = layout.rows;
  for (std::size_t j = 0; j < limits.size(); ++j) {
    double square = limits[j].auxiliary * limits[j].auxiliary;
    for (const auto& [variable, slope] : limits[j].gradient) {
      if (layout.row[variable] >= 0) square += slope * slope;
    }
    lengths.push_back(square > 0 ? std::sqrt(square) : 1);
    const auto column = static_cast<int>(j);
    for (const auto& [variable, slope] : limits[j].gradient) {
      if (layout.row[variable] < 0) continue;
      entries.emplace_back(layout.row[variable], column, slope / lengths.back());
    }
    if (limits[j].auxiliary != 0) {
      entries.emplace_back(layout.auxiliary, column, limits[j].auxiliary / lengths.back());
    }
    if (!limits[j].is_equation && limits[j].margin > kOpen) {
      entries.emplace_back(rows++, column, limits[j].margin / lengths.back());
    }
  }
  Eigen::SparseMatrix<double> A(rows, static_cast<Eigen::Index>(limits.size()));
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

/// How far a variable may be expected to move, in typical changes: by its own magnitude, in however
/// narrow a box; of a least violation through the whole box, and the violation itself down to zero.
std::vector<double> reaches(const Problem& problem, const Scales& scales, Design x,
                            const Layout& layout, Optimality optimality) {
  std::vector<double> result(static_cast<std::size_t>(layout.rows), 1.0);
  if (optimality == Optimality::LeastViolation)
    result[static_cast<std::size_t>(layout.auxiliary)] = largest_violation(problem, scales, x);
  for (std::size_t i = 0; i < problem.variables.size(); ++i) {
    const Variable& v = problem.variables[i];
    if (layout.row[i] < 0) continue;
    const double range = v.upper - v.lower;
    const bool through_box = optimality == Optimality::LeastViolation && std::isfinite(range);
    result[static_cast<std::size_t>(layout.row[i])] =
        (through_box ? range : scales.own[i]) / scales.variables[i];
  }
  return result;
}

/// A limit's margin beyond what rounding leaves of it: its value is a difference of terms of the
/// size of the slopes times the variables.
double margin_beyond_rounding(const ActiveLimit& limit, const Scales& scales, Design x) {
  // Value and bound are each rounded once.
  constexpr double kRounding = 2 * std::numeric_limits<double>::epsilon();
  double terms = 0;
  for (const auto& [variable, slope] : limit.gradient)
    terms += std::abs(slope * x[variable] / scales.variables[variable]);
  return std::max(0.0, std::abs(limit.margin) - kRounding * terms);
}

/// How far the conditions are from holding with the multipliers; `left` is what these leave of the
/// objective's gradient.
double residual_of(const Problem& problem, const Scales& scales, Design x, Optimality optimality,
                   const Layout& layout, const std::vector<ActiveLimit>& limits,
                   const std::vector<double>& multipliers, const Eigen::VectorXd& left) {
  double open = 0;
  for (std::size_t j = 0; j < limits.size(); ++j)
    open += std::abs(multipliers[j]) * margin_beyond_rounding(limits[j], scales, x);
  const auto reach = reaches(problem, scales, x, layout, optimality);
  double largest = 0, sum = 0;
  for (std::size_t i = 0; i < reach.size(); ++i) {
    const double entry = std::abs(left[static_cast<Eigen::Index>(i)]) * reach[i];
    largest = std::max(largest, entry);
    sum += entry;
  }
  // By the sum a least violation is bounded from below (docs/optimisation.md, (LV3)).
  const bool least = optimality == Optimality::LeastViolation;
  const double residual = least ? (sum + open) / largest_violation(problem, scales, x)
                                : std::max(largest, open) / objective_measure(problem, scales, x);
  // A slope that is not a number shows nothing; std::max passes over it, the sums do not.
  return std::isfinite(sum + open) && residual >= 0 ? residual : kInfinity;
}

/// The objective's gradient above the rows of limits with a margin.
Eigen::VectorXd target_of(const Problem& problem, const Scales& scales, Design x,
                          const Layout& layout, Eigen::Index rows) {
  Eigen::VectorXd target = Eigen::VectorXd::Zero(rows);
  target.head(layout.rows) = objective_gradient(problem, scales, x, layout);
  return target;
}

/// Multipliers that a method has told, by columns of length one.
struct Told {
  std::vector<ActiveLimit> limits;
  std::vector<double> lengths;
  Eigen::SparseMatrix<double> A;
  Eigen::VectorXd multipliers;

  /// All but the idle rows of an interior-point method.
  std::vector<int> pushing() const {
    const double least = kIdle * multipliers.cwiseAbs().maxCoeff();
    std::vector<int> columns;
    for (int j = 0; j < multipliers.size(); ++j) {
      if (std::abs(multipliers[j]) > least) columns.push_back(j);
    }
    return columns;
  }
};

Told columns_of(std::vector<ActiveLimit> limits, double unit, const Layout& layout) {
  Told told;
  told.A = limit_gradients(limits, layout, told.lengths);
  told.multipliers.resize(told.A.cols());
  for (std::size_t j = 0; j < limits.size(); ++j) {
    const double multiplier = *limits[j].told * limits[j].size / unit * told.lengths[j];
    told.multipliers[static_cast<Eigen::Index>(j)] =
        limits[j].is_equation ? multiplier : std::max(multiplier, 0.0);
  }
  told.limits = std::move(limits);
  return told;
}

/// Fitted once more, for what a method's rounding left, as far as signs allow. Each changes by a
/// share of itself, so that of limits that are nearly the same none takes all from another.
Eigen::VectorXd refined(const Told& told, const std::vector<int>& pushing,
                        const Eigen::VectorXd& target) {
  Eigen::VectorXd result = told.multipliers;
  const Eigen::SparseMatrix<double> weighted = told.A * told.multipliers.asDiagonal();
  const Eigen::VectorXd shares =
      cheaper_factors(weighted)(pushing)->solve(-(told.A * result + target));
  for (std::size_t k = 0; k < pushing.size(); ++k) {
    const int j = pushing[k];
    result[j] *= 1 + shares[static_cast<Eigen::Index>(k)];
    if (!told.limits[static_cast<std::size_t>(j)].is_equation) result[j] = std::max(result[j], 0.0);
  }
  return result;
}

}  // namespace

double objective_measure(const Problem& problem, const Scales& scales, Design x) {
  const double value = objective_value(problem.objective(), x);
  return objective_size(problem.objective(), scales.objective_typical, value) / scales.objective;
}

Layout lay_out(const Problem& problem, Optimality optimality) {
  Layout layout;
  for (const Variable& v : problem.variables) {
    layout.row.push_back(v.lower == v.upper ? -1 : layout.rows++);
  }
  const bool peak = problem.objective().response.is_curve();
  if (peak || optimality == Optimality::LeastViolation) layout.auxiliary = layout.rows++;
  return layout;
}

Eigen::VectorXd objective_gradient(const Problem& problem, const Scales& scales, Design x,
                                   const Layout& layout) {
  Eigen::VectorXd b = Eigen::VectorXd::Zero(layout.rows);
  if (layout.auxiliary >= 0) {
    b[layout.auxiliary] = 1;
    return b;
  }
  const Function& f = problem.objective().response.function();
  std::vector<double> g(f.inputs().size());
  f.gradient(x, g);
  const double sign = problem.objective().sense == Sense::Minimize ? 1 : -1;
  for (std::size_t k = 0; k < g.size(); ++k) {
    const std::size_t variable = f.inputs()[k];
    if (layout.row[variable] < 0) continue;
    b[layout.row[variable]] = sign * g[k] * scales.variables[variable] / scales.objective;
  }
  return b;
}

Weighed weigh(const Problem& problem, const Scales& scales, Design x, Optimality optimality,
              const Layout& layout, Net net) {
  Weighed result;
  result.limits = active_limits(problem, scales, x, optimality, net);
  std::vector<double> lengths;
  const auto A = limit_gradients(result.limits, layout, lengths);
  std::vector<bool> free;
  for (const ActiveLimit& limit : result.limits) free.push_back(limit.is_equation);
  if (layout.rows == 0) {  // nothing varies: nothing can be better
    result.multipliers.assign(result.limits.size(), 0);
    result.residual = 0;
    return result;
  }
  const auto solved =
      bounded_least_squares(A, target_of(problem, scales, x, layout, A.rows()), free);
  result.multipliers = solved.multipliers;
  result.condition = solved.condition;
  for (std::size_t j = 0; j < lengths.size(); ++j) result.multipliers[j] /= lengths[j];
  result.residual = residual_of(problem, scales, x, optimality, layout, result.limits,
                                result.multipliers, solved.left);
  return result;
}

Weighed weigh(const Problem& problem, const Scales& scales, Design x, Optimality optimality,
              const Layout& layout, const std::vector<Push>& pushes, bool are_fitted,
              bool wants_condition) {
  const double unit = optimality == Optimality::Objective ? scales.objective : 1;
  Told told = columns_of(told_limits(problem, scales, x, optimality, pushes), unit, layout);
  if (told.limits.empty()) return {};
  const Eigen::VectorXd target = target_of(problem, scales, x, layout, told.A.rows());
  Weighed best;
  const auto consider = [&](const Eigen::VectorXd& columns) {
    std::vector<double> multipliers(columns.begin(), columns.end());
    for (std::size_t j = 0; j < multipliers.size(); ++j) multipliers[j] /= told.lengths[j];
    const double residual = residual_of(problem, scales, x, optimality, layout, told.limits,
                                        multipliers, told.A * columns + target);
    if (!best.multipliers.empty() && !(residual < best.residual)) return;
    best.multipliers = std::move(multipliers);
    best.residual = residual;
  };
  consider(told.multipliers);
  if (const std::vector<int> pushing = told.pushing(); !pushing.empty()) {
    if (are_fitted) consider(refined(told, pushing, target));
    best.condition = wants_condition ? cheaper_factors(told.A)(pushing)->condition()
                                     : std::numeric_limits<double>::quiet_NaN();
  }
  best.limits = std::move(told.limits);
  return best;
}

}  // namespace camlaw::optim
