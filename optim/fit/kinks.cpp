// SPDX-License-Identifier: MIT
#include "optim/fit/kinks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "numerics/linear/dense.h"
#include "optim/fit/identifiability.h"

namespace camlaw::optim {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kNothing = 1e-6;  // of the residuals' length: less is not followed

/// A residual's kink that the point lies at, with its row of the Jacobian on both sides.
struct Kink {
  Index row;
  RowVectorXd before, after;
  VectorXd p_after;  ///< next to the point, on the other side
  bool is_upward;    ///< the other side is where the row's jump points to
};

/// Two points next to each other.
struct Sides {
  FitPoint before, after;
};

double slope_along(const FitPoint& point, const VectorXd& direction) {
  return (point.jacobian * direction).dot(point.r);
}

/// Narrows two points to neighbours; `is_before` tells on which side one between them lies. Nothing
/// where the residuals are undefined between them.
template <class IsBefore>
std::optional<Sides> narrowed(const Residuals& residuals, Sides sides, IsBefore is_before) {
  constexpr int kMost = 200;  // some 60 make neighbours of most numbers, more are needed beside 0
  for (int i = 0; i < kMost; ++i) {
    const VectorXd p = (sides.before.p + sides.after.p) / 2;
    if (p == sides.before.p || p == sides.after.p) break;
    auto middle = fit_point(residuals, p);
    if (!middle) return {};
    (is_before(*middle) ? sides.before : sides.after) = std::move(*middle);
  }
  return sides;
}

/// Along a direction in which the sum falls: the points between which it ends to fall, or twice the
/// direction's end where it still falls there.
std::optional<Sides> lowest_along(const Residuals& residuals, const FitBox& box,
                                  const FitPoint& point, const VectorXd& direction) {
  constexpr double kRounding = 1e-12;  // of the sum: rounding alone may raise it by so much
  const double most = point.sum() * (1 + kRounding);
  const auto falls = [&](const FitPoint& at) {
    return slope_along(at, direction) < 0 && at.sum() <= most;
  };
  auto end = fit_point(residuals, stepped(point, box, direction, 1));
  for (double share = 0.5; !end && share > kNothing; share /= 2) {
    end = fit_point(residuals, stepped(point, box, direction, share));
  }
  if (!end || !falls(point)) return {};
  if (falls(*end)) return Sides{*end, *end};
  return narrowed(residuals, {point, std::move(*end)}, falls);
}

/// The kinks between neighbours; nothing where a residual jumps there.
std::optional<std::vector<Kink>> kinks_between(const Sides& sides) {
  const VectorXd lengths = ScaledColumns(sides.before.jacobian).lengths;
  const double most = kNothing * sides.before.r.norm();
  std::vector<Kink> kinks;
  for (Index i = 0; i < sides.before.r.size(); ++i) {
    if (std::abs(sides.after.r[i] - sides.before.r[i]) > most) return {};
    const VectorXd before = sides.before.jacobian.row(i).transpose().cwiseQuotient(lengths);
    const VectorXd after = sides.after.jacobian.row(i).transpose().cwiseQuotient(lengths);
    if ((after - before).norm() <= kNothing * std::max(before.norm(), after.norm())) continue;
    const RowVectorXd jump = sides.after.jacobian.row(i) - sides.before.jacobian.row(i);
    kinks.push_back({i, sides.before.jacobian.row(i), sides.after.jacobian.row(i), sides.after.p,
                     jump.dot(sides.after.p - sides.before.p) > 0});
  }
  return kinks;
}

/// The direction across a kink, to its other side, that changes all residuals by about one.
VectorXd across(const Kink& kink, const VectorXd& lengths) {
  const VectorXd jump = (kink.after - kink.before).transpose().cwiseQuotient(lengths);
  return (kink.is_upward ? 1 : -1) * jump.normalized().cwiseQuotient(lengths);
}

/// Moves the point next to a kink that it lay at before its last step, on the kink's first side.
bool move_back(const Residuals& residuals, FitPoint& point, Kink& kink) {
  const VectorXd lengths = ScaledColumns(point.jacobian).lengths;
  const VectorXd normal = across(kink, lengths);
  const auto scaled = [&](const RowVectorXd& row) -> VectorXd {
    return row.transpose().cwiseQuotient(lengths);
  };
  const VectorXd jump = scaled(kink.after - kink.before);
  // Thirteen factors lead from rounding to the length of the residuals; a jump that differs by more
  // than a third is another one.
  constexpr double kFactor = 16, kAlike = 0.3;
  double by =
      kEpsilon * std::max(point.p.cwiseProduct(lengths).cwiseAbs().maxCoeff(), point.r.norm());
  for (; by < point.r.norm(); by *= kFactor) {
    auto before = fit_point(residuals, point.p - by * normal);
    auto after = fit_point(residuals, point.p + by * normal);
    if (!before || !after) return false;
    const RowVectorXd first = before->jacobian.row(kink.row), last = after->jacobian.row(kink.row);
    if ((scaled(last - first) - jump).norm() > kAlike * jump.norm()) continue;
    const auto sides =
        narrowed(residuals, {std::move(*before), std::move(*after)}, [&](const FitPoint& middle) {
          const RowVectorXd own = middle.jacobian.row(kink.row);
          return scaled(own - first).norm() < scaled(own - last).norm();
        });
    if (!sides) return false;
    kink.before = sides->before.jacobian.row(kink.row);
    kink.after = sides->after.jacobian.row(kink.row);
    kink.p_after = sides->after.p;
    point = sides->before;
    return true;
  }
  return false;
}

bool move_back(const Residuals& residuals, FitPoint& point, std::vector<Kink>& kinks) {
  return std::all_of(kinks.begin(), kinks.end(),
                     [&](Kink& kink) { return move_back(residuals, point, kink); });
}

/// Shares of the kinks' other sides with which least can be followed, each from 0 to 1.
std::vector<double> best_shares(const FitPoint& point, const std::vector<bool>& held,
                                const std::vector<Kink>& kinks) {
  std::vector<double> shares(kinks.size(), 0.5);
  const std::vector<Index> free = free_parameters(held);
  if (free.empty()) return shares;
  const ScaledColumns columns(point.jacobian(Eigen::all, free));
  const MatrixXd metric = pseudo_inverse(columns.matrix.transpose() * columns.matrix).matrix;
  MatrixXd changes(static_cast<Index>(free.size()), static_cast<Index>(kinks.size()));
  VectorXd gradient = columns.matrix.transpose() * point.r;
  for (std::size_t k = 0; k < kinks.size(); ++k) {
    const Kink& kink = kinks[k];
    const auto of_free = [&](const RowVectorXd& row) -> VectorXd {
      return row(free).transpose().cwiseQuotient(columns.lengths);
    };
    const double r = point.r[kink.row];
    const RowVectorXd own = point.jacobian.row(kink.row);
    gradient += r * of_free(kink.before - own);
    changes.col(static_cast<Index>(k)) = r * of_free(kink.after - kink.before);
    gradient += shares[k] * changes.col(static_cast<Index>(k));
  }
  // A round is a few products; shares that depend on each other settle by a factor each.
  constexpr int kRounds = 200;
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t k = 0; k < kinks.size(); ++k) {
      const VectorXd change = changes.col(static_cast<Index>(k));
      const double curvature = change.dot(metric * change);
      if (!(curvature > 0)) continue;
      const double next =
          std::clamp(shares[k] - change.dot(metric * gradient) / curvature, 0.0, 1.0);
      gradient += (next - shares[k]) * change;
      shares[k] = next;
    }
  }
  return shares;
}

/// The point with rows between the sides of its kinks.
FitPoint blended(FitPoint point, const std::vector<Kink>& kinks,
                 const std::vector<double>& shares) {
  for (std::size_t k = 0; k < kinks.size(); ++k) {
    point.jacobian.row(kinks[k].row) =
        (1 - shares[k]) * kinks[k].before + shares[k] * kinks[k].after;
  }
  return point;
}

/// The Gauss-Newton step of the parameters that are not held that stays at the kinks.
GaussNewton step_along(const FitPoint& point, const std::vector<bool>& held,
                       const std::vector<Kink>& kinks) {
  GaussNewton result;
  result.held = held;
  result.step = VectorXd::Zero(point.p.size());
  const std::vector<Index> free = free_parameters(held);
  if (free.size() <= kinks.size()) return result;
  const ScaledColumns columns(point.jacobian(Eigen::all, free));
  MatrixXd normals(static_cast<Index>(free.size()), static_cast<Index>(kinks.size()));
  for (std::size_t k = 0; k < kinks.size(); ++k) {
    const RowVectorXd jump = kinks[k].after - kinks[k].before;
    normals.col(static_cast<Index>(k)) =
        jump(free).transpose().cwiseQuotient(columns.lengths).normalized();
  }
  const MatrixXd basis = left_null_space(normals, kRankTolerance);
  const MatrixXd along = columns.matrix * basis;
  const VectorXd own = shortest_least_squares(along, -point.r, kRankTolerance).x;
  result.reduction = (along * own).norm();
  result.step(free) = (basis * own).cwiseQuotient(columns.lengths);
  return result;
}

/// Leaves the kinks beyond which the sum falls; whether there is one.
bool leave(const Residuals& residuals, const std::vector<double>& shares, FitPoint& point,
           std::vector<Kink>& kinks) {
  for (std::size_t k = 0; k < kinks.size(); ++k) {
    if (shares[k] > 0 && shares[k] < 1) continue;
    if (shares[k] == 1) {
      auto beyond = fit_point(residuals, kinks[k].p_after);
      if (!beyond) return false;
      point = std::move(*beyond);
    }
    kinks.erase(kinks.begin() + static_cast<std::ptrdiff_t>(k));
    return true;
  }
  return false;
}

}  // namespace

std::optional<FitPoint> minimum_at_kinks(const Residuals& residuals, const FitBox& box,
                                         FitPoint point) {
  constexpr int kMostSteps = 50;  // each finds a kink, leaves one or follows those it stands at
  // Steps in turn that lead to no kink and gain next to nothing, as little as the step before: it
  // is not a kink that ends the descent, but a valley too flat to follow. Where the gains fall, the
  // descent is about to end.
  constexpr int kMostFlat = 8;
  constexpr double kGain = 1e-6;    // of the sum
  constexpr double kFalling = 0.8;  // of the gain before
  double gain_before = 0;
  std::vector<Kink> kinks;
  for (int i = 0, flat = 0; i < kMostSteps && flat < kMostFlat; ++i) {
    const std::vector<bool> held = gauss_newton(point, box, kRankTolerance).held;
    const std::vector<double> shares = best_shares(point, held, kinks);
    FitPoint between = blended(point, kinks, shares);
    const GaussNewton all = gauss_newton(between, box, kRankTolerance);
    if (is_stationary(between, all)) return between;
    const GaussNewton along = kinks.empty() ? all : step_along(between, all.held, kinks);
    if (along.reduction <= kNothing * point.r.norm()) {
      if (!leave(residuals, shares, point, kinks)) return {};
      continue;
    }
    auto sides = lowest_along(residuals, box, point, along.step);
    if (!sides) return {};
    const double before = point.sum();
    point = sides->before;
    const double gain = before - point.sum();
    const bool is_flat =
        gain <= kGain * (point.sum() + point.rest) && gain > kFalling * gain_before;
    gain_before = gain;
    if (!move_back(residuals, point, kinks)) return {};
    const auto found = kinks_between(*sides);
    if (!found) return {};
    flat = kinks.empty() && found->empty() && is_flat ? flat + 1 : 0;
    for (const Kink& kink : *found) {
      const bool is_there = std::any_of(kinks.begin(), kinks.end(),
                                        [&](const Kink& other) { return other.row == kink.row; });
      if (!is_there) kinks.push_back(kink);
    }
  }
  return {};
}

}  // namespace camlaw::optim
