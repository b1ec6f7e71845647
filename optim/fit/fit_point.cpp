// SPDX-License-Identifier: MIT
#include "optim/fit/fit_point.h"

#include <cmath>
#include <limits>

#include "numerics/linear/dense.h"
#include "optim/fit/identifiability.h"

namespace camlaw::optim {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Whether a parameter stands at a bound beyond which the direction leads.
bool leaves(const FitPoint& point, const FitBox& box, Index j, double direction) {
  return (point.p[j] <= box.lower[j] && direction < 0) ||
         (point.p[j] >= box.upper[j] && direction > 0);
}

/// The step of those that are not held.
void solve(const FitPoint& point, double tolerance, GaussNewton& result) {
  const std::vector<Index> free = free_parameters(result.held);
  result.step = VectorXd::Zero(point.p.size());
  result.reduction = 0;
  result.full_rank = true;
  if (free.empty()) return;
  const ScaledColumns columns(point.jacobian(Eigen::all, free));
  const auto [scaled, rank] = shortest_least_squares(columns.matrix, -point.r, tolerance);
  result.full_rank = rank == columns.matrix.cols();
  result.reduction = (columns.matrix * scaled).norm();
  result.step(free) = scaled.cwiseQuotient(columns.lengths);
}

}  // namespace

std::vector<Index> free_parameters(const std::vector<bool>& held) {
  std::vector<Index> free;
  for (std::size_t j = 0; j < held.size(); ++j) {
    if (!held[j]) free.push_back(static_cast<Index>(j));
  }
  return free;
}

std::optional<FitPoint> fit_point(const Residuals& residuals, VectorXd p) {
  FitPoint point;
  const auto n = static_cast<Index>(residuals.count());
  point.r.resize(n);
  point.jacobian.resize(n, p.size());
  const std::span<double> entries(point.jacobian.data(),
                                  static_cast<std::size_t>(point.jacobian.size()));
  if (!residuals.evaluate({p.data(), static_cast<std::size_t>(p.size())},
                          {point.r.data(), residuals.count()}, entries)) {
    return std::nullopt;
  }
  point.p = std::move(p);
  point.rest = residuals.rest();
  return point;
}

GaussNewton gauss_newton(const FitPoint& point, const FitBox& box, double tolerance) {
  GaussNewton result;
  const VectorXd gradient = point.jacobian.transpose() * point.r;
  for (Index j = 0; j < point.p.size(); ++j) {
    result.held.push_back(box.lower[j] == box.upper[j] || leaves(point, box, j, -gradient[j]));
  }
  // A parameter at its bound may be pulled inwards by the gradient and yet be led outwards by the
  // step, through its correlation with others; then it stays for this step.
  for (bool settled = false; !settled;) {
    solve(point, tolerance, result);
    settled = true;
    for (Index j = 0; j < point.p.size(); ++j) {
      if (!leaves(point, box, j, result.step[j])) continue;
      result.held[static_cast<std::size_t>(j)] = true;
      settled = false;
    }
  }
  result.rounding = std::numeric_limits<double>::epsilon() *
                    (point.jacobian.cwiseAbs() * point.p.cwiseAbs()).norm();
  return result;
}

VectorXd stepped(const FitPoint& point, const FitBox& box, const VectorXd& step, double share) {
  for (Index j = 0; j < step.size(); ++j) {
    if (step[j] == 0) continue;
    const double room = (step[j] > 0 ? box.upper[j] : box.lower[j]) - point.p[j];
    share = std::min(share, room / step[j]);
  }
  VectorXd p = point.p + share * step;
  // The parameter that ended the step stands at its bound exactly.
  for (Index j = 0; j < step.size(); ++j) {
    if (step[j] == 0) continue;
    const double bound = step[j] > 0 ? box.upper[j] : box.lower[j];
    if ((bound - point.p[j]) / step[j] <= share) p[j] = bound;
  }
  return p.cwiseMax(box.lower).cwiseMin(box.upper);
}

double followed(const FitPoint& point, const GaussNewton& step) {
  const double length = point.length();
  return length > 0 ? step.reduction / length : 0;
}

bool is_stationary(const FitPoint& point, const GaussNewton& step) {
  // The parameters are then within 1e-6 sqrt(dof / rank) of their standard deviations. Polished
  // fits reach 1e-10 as a rule.
  constexpr double kFollowed = 1e-6;
  // Residuals are worked out in some operations, each of which rounds.
  constexpr double kOperations = 16;
  return followed(point, step) <= kFollowed || step.reduction <= kOperations * step.rounding;
}

}  // namespace camlaw::optim
