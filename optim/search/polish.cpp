// SPDX-License-Identifier: MIT
#include "optim/search/polish.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "numerics/linear/dense.h"
#include "optim/verdict/limits.h"
#include "optim/verdict/second_order.h"

namespace camlaw::optim {
namespace {

constexpr int kMostVariables = 300;  // the step's matrix is dense: its time grows with the cube
constexpr double kHolds = 1e-9;      // over the scales: a limit with less does not hold the design

/// The limits that push, as equations, and the Lagrangian's second derivatives: one linear system.
/// Its solution is the step of the design, by typical changes; empty where there is none.
std::optional<Eigen::VectorXd> newton_step(const SecondOrderPoint& point, const Weighed& weighed) {
  std::vector<std::size_t> pushing;
  for (std::size_t j = 0; j < weighed.limits.size(); ++j) {
    if (weighed.limits[j].is_equation || weighed.multipliers[j] > kHolds) pushing.push_back(j);
  }
  const Eigen::Index n = point.layout.rows, m = static_cast<Eigen::Index>(pushing.size());
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n + m, n + m);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n + m);
  K.topLeftCorner(n, n) = lagrangian_hessian(point, weighed.limits, weighed.multipliers);
  right.head(n) = -objective_gradient(point.problem, point.scales, point.x, point.layout);
  for (Eigen::Index k = 0; k < m; ++k) {
    const ActiveLimit& limit = weighed.limits[pushing[static_cast<std::size_t>(k)]];
    for (const auto& [variable, slope] : limit.gradient) {
      if (point.layout.row[variable] < 0) continue;
      K(n + k, point.layout.row[variable]) = K(point.layout.row[variable], n + k) = slope;
    }
    if (limit.auxiliary != 0) {
      K(n + k, point.layout.auxiliary) = K(point.layout.auxiliary, n + k) = limit.auxiliary;
    }
    right[n + k] = limit.margin;
  }
  Eigen::VectorXd step = solve_lu(K, right);
  const double off = (K * step - right).cwiseAbs().maxCoeff();
  if (!step.allFinite() || !(off <= 1e-9 * (1 + right.cwiseAbs().maxCoeff()))) return {};
  return step;
}

std::vector<double> moved(const SecondOrderPoint& point, const Eigen::VectorXd& step) {
  std::vector<double> x(point.x.begin(), point.x.end());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Variable& v = point.problem.variables[i];
    if (point.layout.row[i] < 0) continue;
    x[i] =
        std::clamp(x[i] + step[point.layout.row[i]] * point.scales.variables[i], v.lower, v.upper);
  }
  return x;
}

/// Steps with the limits of one width until the conditions hold to rounding or cease to improve.
std::optional<std::vector<double>> polished(const Problem& problem, const Scales& scales,
                                            Design start, Optimality optimality, double width) {
  constexpr int kSteps = 8;  // Newton's method doubles the digits at each step
  // A residual of kDone is rounding, and kGood is a tenth of what certifies a design. The limits
  // are met to kMet of their tolerances, so that a verdict still finds them met.
  constexpr double kDone = 1e-11, kGood = 1e-8, kMet = 0.1;
  const Layout layout = lay_out(problem, optimality);
  const bool free = optimality == Optimality::LeastViolation;
  std::vector<double> best, x(start.begin(), start.end());
  double residual = kInfinity;
  for (int step = 0; step < kSteps; ++step) {
    const Weighed weighed = weigh(problem, scales, x, optimality, layout, Net{width});
    const bool met = free || worst_violation(limit_reports(problem, scales, x, false)) <= kMet;
    if (met && weighed.residual < residual) best = x, residual = weighed.residual;
    if (residual <= kDone) break;
    const SecondOrderPoint point{problem, scales, x, layout};
    const auto delta = newton_step(point, weighed);
    if (!delta || delta->head(layout.rows).cwiseAbs().maxCoeff() > 1) break;
    x = moved(point, *delta);
  }
  if (residual > kGood) return {};
  return best;
}

}  // namespace

std::optional<std::vector<double>> polished(const Problem& problem, const Scales& scales, Design x,
                                            Optimality optimality) {
  constexpr double kWidths[] = {1e-6, 1e-3};
  const int rows = lay_out(problem, optimality).rows;
  if (rows > kMostVariables || rows == 0) return {};
  for (const double width : kWidths) {
    if (auto found = polished(problem, scales, x, optimality, width)) return found;
  }
  return {};
}

}  // namespace camlaw::optim
