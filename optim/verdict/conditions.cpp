// SPDX-License-Identifier: MIT
#include "optim/verdict/conditions.h"

#include <algorithm>
#include <cmath>

#include "optim/verdict/least_squares.h"

namespace camlaw::optim {
namespace {

/// The limits' gradients as columns of length one, and the lengths. Below them a row for each limit
/// with a margin: what its multiplier leaves open.
Eigen::SparseMatrix<double> limit_gradients(const std::vector<ActiveLimit>& limits,
                                            const Layout& layout, std::vector<double>& lengths) {
  constexpr double kOpen = 1e-12;  // less is rounding
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

/// What one typical change of the objective is: the unit that the residual is measured in.
double objective_measure(const Problem& problem, const Sizes& sizes, Design x) {
  const double value = objective_value(problem.objective, x);
  const double moved = std::abs(sizes.objective_value - value);
  return std::max({std::abs(value), std::isfinite(moved) ? moved : 0.0,
                   typical_change(problem.objective.response, x, sizes.variables)});
}

}  // namespace

Layout lay_out(const Problem& problem, Optimality optimality) {
  Layout layout;
  for (const Variable& v : problem.variables) {
    layout.row.push_back(v.lower == v.upper ? -1 : layout.rows++);
  }
  const bool peak = problem.objective.response.is_curve();
  if (peak || optimality == Optimality::LeastViolation) layout.auxiliary = layout.rows++;
  return layout;
}

Eigen::VectorXd objective_gradient(const Problem& problem, const Sizes& sizes, Design x,
                                   const Layout& layout) {
  Eigen::VectorXd b = Eigen::VectorXd::Zero(layout.rows);
  if (layout.auxiliary >= 0) {
    b[layout.auxiliary] = 1;
    return b;
  }
  const Function& f = problem.objective.response.function();
  std::vector<double> g(f.inputs().size());
  f.gradient(x, g);
  const double sign = problem.objective.sense == Sense::Minimize ? 1 : -1;
  for (std::size_t k = 0; k < g.size(); ++k) {
    const std::size_t variable = f.inputs()[k];
    if (layout.row[variable] < 0) continue;
    b[layout.row[variable]] = sign * g[k] * sizes.variables[variable] / sizes.objective;
  }
  return b;
}

Weighed weigh(const Problem& problem, const Sizes& sizes, Design x, Optimality optimality,
              const Layout& layout, Net net) {
  Weighed result;
  result.limits = active_limits(problem, sizes, x, optimality, net);
  std::vector<double> lengths;
  const auto A = limit_gradients(result.limits, layout, lengths);
  std::vector<bool> free;
  for (const ActiveLimit& limit : result.limits) free.push_back(limit.is_equation);
  if (layout.rows == 0) {  // nothing varies: nothing can be better
    result.multipliers.assign(result.limits.size(), 0);
    result.residual = 0;
    return result;
  }
  Eigen::VectorXd target = Eigen::VectorXd::Zero(A.rows());
  target.head(layout.rows) = objective_gradient(problem, sizes, x, layout);
  const auto solved = bounded_least_squares(A, target, free);
  result.multipliers = solved.multipliers;
  result.condition = solved.condition;
  double open = 0;
  for (std::size_t j = 0; j < lengths.size(); ++j) {
    result.multipliers[j] /= lengths[j];
    open += std::abs(result.multipliers[j] * result.limits[j].margin);
  }
  const double measure =
      optimality == Optimality::LeastViolation ? 1 : objective_measure(problem, sizes, x);
  const double unit = optimality == Optimality::LeastViolation ? 1 : sizes.objective;
  result.residual = std::max(solved.residual_max, open) * (measure > 0 ? unit / measure : 1);
  if (std::isnan(result.residual)) result.residual = kInfinity;
  return result;
}

}  // namespace camlaw::optim
