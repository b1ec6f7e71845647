// SPDX-License-Identifier: MIT
#include "optim/fit/gauss_newton_polish.h"

#include <algorithm>

#include "optim/fit/identifiability.h"

namespace camlaw::optim {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Whether to go on from `next`: the sum is clearly less, or the same to its own rounding and less
/// of it is left to follow.
bool better(const FitPoint& next, const GaussNewton& next_step, const FitPoint& point,
            const GaussNewton& step) {
  // A sum of thousands of squares is rounded to some 1e-13 of itself, and each residual before.
  constexpr double kSame = 1e-12;
  const double slack = kSame * point.sum() + step.rounding * (2 * point.r.norm() + step.rounding);
  if (next.sum() < point.sum() - slack) return true;
  return next.sum() <= point.sum() + slack && next_step.reduction < step.reduction;
}

/// Steps until none is better, or what is left to follow is at most `enough` of the residuals.
FitPoint polished(const Residuals& residuals, const FitBox& box, double tolerance, double enough,
                  FitPoint point) {
  // Steps converge linearly with a rate that grows with the residuals: slow fits are given time.
  constexpr int kMostSteps = 200;
  constexpr double kShares[] = {1, 0.5, 0.1, 0.01};
  GaussNewton step = gauss_newton(point, box, tolerance);
  for (int i = 0; i < kMostSteps && step.reduction > enough * point.length(); ++i) {
    bool went = false;
    for (const double share : kShares) {
      auto next = fit_point(residuals, stepped(point, box, step.step, share));
      if (!next) continue;
      GaussNewton next_step = gauss_newton(*next, box, tolerance);
      if (!better(*next, next_step, point, step)) continue;
      point = std::move(*next);
      step = std::move(next_step);
      went = true;
      break;
    }
    if (!went) break;
  }
  return point;
}

}  // namespace

FitPoint polish(const Residuals& residuals, const FitBox& box, double enough, FitPoint point) {
  // Weak directions have digits of their own to gain. Where the Jacobian is singular at the minimum
  // they lead astray instead, and the others go on without them.
  constexpr double kWeakest = 1e-13;
  point = polished(residuals, box, kWeakest, enough, std::move(point));
  if (gauss_newton(point, box, kRankTolerance).full_rank) return point;
  return polished(residuals, box, kRankTolerance, enough, std::move(point));
}

}  // namespace camlaw::optim
