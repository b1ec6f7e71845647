// SPDX-License-Identifier: MIT
#include "optim/fit/fit_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cassert>
#include <cmath>
#include <limits>

#include "numerics/linear/statistics.h"
#include "optim/fit/eigen_matrix.h"
#include "optim/fit/identifiability.h"
#include "optim/fit/kinks.h"
#include "optim/fit/loss.h"

namespace camlaw::optim {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Collects reasons.
void add(std::string& reason, const std::string& another) {
  if (!reason.empty()) reason += "; ";
  reason += another;
}

/// The loss at each residual.
std::vector<LossAt> losses(const FitResult& result, Loss loss) {
  std::vector<LossAt> all;
  for (const double r : result.residuals) {
    all.push_back(result.loss_scale ? loss_at(loss, *result.loss_scale, r)
                                    : loss_at(Loss::None, 1, r));
  }
  return all;
}

/// (FT6): sqrt of K^2 (sum psi^2 / dof) / (mean psi')^2.
double residual_deviation(const std::vector<LossAt>& at, const Residuals& residuals,
                          std::size_t rank) {
  const auto count = static_cast<double>(at.size()), p = static_cast<double>(rank);
  const auto n = static_cast<double>(residuals.measurements());
  double squares = residuals.rest(), mean = 0, variance = 0;
  for (const LossAt& a : at) squares += a.pull * a.pull, mean += a.slope / count;
  for (const LossAt& a : at) variance += (a.slope - mean) * (a.slope - mean) / count;
  if (residuals.measurements() <= rank || !(mean > 0)) return kNan;
  const double correction = 1 + p / n * variance / (mean * mean);
  return correction * std::sqrt(squares / (n - p)) / mean;
}

/// What is known of the residuals as numbers.
void describe_residuals(const FitPoint& point, const Residuals& residuals, FitResult& result) {
  result.residuals.assign(point.r.data(), point.r.data() + point.r.size());
  result.sum_of_squares = point.sum() + residuals.rest();
  result.rms = std::sqrt(result.sum_of_squares / static_cast<double>(residuals.measurements()));
  Index largest = 0;
  point.r.cwiseAbs().maxCoeff(&largest);
  result.largest = static_cast<std::size_t>(largest);
}

/// The point with rows between the sides of its kinks, where it is a minimum at these.
std::optional<FitPoint> at_kinks_of(const Residuals& summed, const FitBox& box,
                                    const FitPoint& point) {
  constexpr double kSame = 1e-6;  // of the residuals' length
  auto minimum = minimum_at_kinks(summed, box, point);
  if (!minimum || (minimum->r - point.r).norm() > kSame * point.r.norm()) return {};
  return minimum;
}

/// Whether the point is a minimum of the sum of losses. Returns which parameters are held.
std::vector<bool> judge(const Residuals& residuals, const FitBox& box, Loss loss, const FitEnd& end,
                        FitResult& result) {
  const LossResiduals summed(residuals, result.loss_scale ? loss : Loss::None,
                             result.loss_scale.value_or(1));
  auto point = fit_point(summed, end.p);
  assert(point);
  GaussNewton step = gauss_newton(*point, box, kRankTolerance);
  if (end.is_at_kinks) {
    if (auto kinked = at_kinks_of(summed, box, *point)) {
      point = std::move(kinked);
      step = gauss_newton(*point, box, kRankTolerance);
    }
  }
  result.followed = followed(*point, step);
  result.converged = is_stationary(*point, step);
  if (!result.converged) {
    add(result.reason, fmt::format("not converged: the model can still follow {:.1e} of the "
                                   "residuals",
                                   result.followed));
  }
  return step.held;
}

std::string quoted(const FreeDirection& direction, const FitResult& result) {
  std::vector<std::string> names;
  for (const std::size_t j : direction.parameters) {
    names.push_back(fmt::format("'{}'", result.parameters[j].name));
  }
  if (names.size() == 1) return "the residuals do not depend on " + names[0];
  const std::string last = names.back();
  names.pop_back();
  return fmt::format("{} and {} cannot be told apart", fmt::join(names, ", "), last);
}

/// Directions without effect, in the indexes of all parameters.
void describe_directions(const Identifiability& known, const std::vector<Index>& free,
                         FitResult& result) {
  for (const VectorXd& direction : known.directions) {
    FreeDirection described;
    for (Index k = 0; k < direction.size(); ++k) {
      if (direction[k] == 0) continue;
      const auto j = static_cast<std::size_t>(free[static_cast<std::size_t>(k)]);
      described.parameters.push_back(j);
      described.changes.push_back(direction[k]);
      result.parameters[j].identifiable = false;
    }
    add(result.reason, quoted(described, result));
    result.free_directions.push_back(std::move(described));
  }
}

void fill_covariance(const Identifiability& known, const std::vector<Index>& free,
                     FitResult& result) {
  const auto m = static_cast<Index>(result.parameters.size());
  result.covariance = SquareMatrix(result.parameters.size());
  auto covariance = as_eigen(result.covariance);
  covariance(free, free) = result.sigma * result.sigma * known.inverse;
  for (Index j = 0; j < m; ++j) {
    if (result.parameters[static_cast<std::size_t>(j)].identifiable) continue;
    covariance.row(j).setConstant(kNan);
    covariance.col(j).setConstant(kNan);
    covariance(j, j) = kInfinity;
  }
}

/// Which parameters stand at a bound.
void describe_bounds(const std::vector<FitParameter>& given, const std::vector<bool>& held,
                     FitResult& result) {
  for (std::size_t j = 0; j < given.size(); ++j) {
    FittedParameter& p = result.parameters[j];
    const FitParameter& bounds = given[j];
    p.at_bound = held[j] && bounds.lower != bounds.upper;
    if (!p.at_bound) continue;
    const bool low = p.value <= bounds.lower;
    add(result.reason, fmt::format("'{}' is at its {} bound {:.6g}", p.name,
                                   low ? "lower" : "upper", low ? bounds.lower : bounds.upper));
  }
}

/// How many residuals there are for how many parameters.
void judge_counts(std::size_t residuals, std::size_t parameters, FitResult& result) {
  if (residuals < parameters) {
    add(result.reason,
        fmt::format("fewer residuals ({}) than parameters ({})", residuals, parameters));
  } else if (result.degrees_of_freedom == 0) {
    add(result.reason, "as many parameters as residuals: no scatter is left to judge them by");
  }
}

}  // namespace

void set_intervals(const std::vector<FitParameter>& parameters, double confidence,
                   FitResult& result) {
  const double quantile = student_quantile(result.degrees_of_freedom, confidence);
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    FittedParameter& p = result.parameters[j];
    const FitParameter& bounds = parameters[j];
    const bool fixed = bounds.lower == bounds.upper;
    p.standard_deviation = p.at_bound ? kNan : std::sqrt(result.covariance(j, j));
    const double half = fixed ? 0 : p.identifiable ? quantile * p.standard_deviation : kInfinity;
    p.low = std::isnan(half) ? kNan : std::max(bounds.lower, p.value - half);
    p.high = std::isnan(half) ? kNan : std::min(bounds.upper, p.value + half);
  }
}

FitResult fit_report(const std::vector<FitParameter>& parameters, const Residuals& residuals,
                     const FitOptions& options, const FitBox& box, const FitEnd& end) {
  FitResult result;
  const auto point = fit_point(residuals, end.p);
  assert(point);
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    result.parameters.push_back({.name = parameters[j].name,
                                 .unit = parameters[j].unit,
                                 .value = end.p[static_cast<Index>(j)]});
  }
  describe_residuals(*point, residuals, result);
  result.loss_scale = end.loss_scale;
  result.reason = end.doubt;
  const std::vector<bool> held = judge(residuals, box, options.loss, end, result);
  const std::vector<Index> free = free_parameters(held);
  const Identifiability known = identify(point->jacobian(Eigen::all, free));
  result.rank = known.rank;
  result.condition = known.condition;
  result.degrees_of_freedom = static_cast<int>(residuals.measurements() - known.rank);
  judge_counts(residuals.measurements(), free.size(), result);
  describe_directions(known, free, result);
  const std::vector<LossAt> at = losses(result, options.loss);
  for (const LossAt& a : at) result.weights.push_back(a.weight);
  result.sigma = residual_deviation(at, residuals, known.rank);
  if (std::isnan(result.sigma) && result.degrees_of_freedom > 0) {
    add(result.reason, "most residuals lie beyond the scale of the loss");
  }
  fill_covariance(known, free, result);
  result.reason_but_bounds = result.reason;
  describe_bounds(parameters, held, result);
  set_intervals(parameters, options.confidence, result);
  return result;
}

}  // namespace camlaw::optim
