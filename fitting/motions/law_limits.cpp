// SPDX-License-Identifier: MIT
#include "fitting/motions/law_limits.h"

#include <algorithm>
#include <cmath>

#include "fitting/motions/fit_parameters.h"
#include "kinematics/laws/free_ends.h"
#include "numerics/linear/statistics.h"
#include "optim/fit/eigen_matrix.h"

namespace camlaw::problems {
namespace {

using Eigen::Index;

}  // namespace

std::optional<LawLimit> limit_of(const Member& law) {
  const auto& rooms = law.family->rooms;
  const auto room =
      std::find_if(rooms.begin(), rooms.end(), [](const Room& r) { return r.linear; });
  if (room == rooms.end()) return {};
  LawLimit limit{{}, room->name, room->is_equal};
  const auto& parameters = law.family->parameters;
  Arguments<double> at(std::vector(parameters.size(), std::vector{0.0}));
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (parameters[i].name == kCrossover) continue;
    at.values()[i] = {1.0};
    limit.factors.push_back(1 - room->left.make(at));
    at.values()[i] = {0.0};
  }
  return limit;
}

bool is_end_value(const Member& law, const Coefficient& coefficient) {
  return has_free_ends(*law.family) && is_end_displacement(coefficient.name);
}

LimitedResiduals::LimitedResiduals(const optim::Residuals& residuals, LawLimit limit,
                                   std::size_t first, std::span<const double> start)
    : ResidualsOf(residuals), limit_(std::move(limit)), first_(first), replaced_(0) {
  double most = 0;
  for (std::size_t i = 0; i < limit_.factors.size(); ++i) {
    const double share = limit_.factors[i] * start[first + i];
    if (share > most) most = share, replaced_ = i;
  }
}

double LimitedResiduals::coefficient(std::span<const double> p) const {
  double rest = 1 - p[first_ + replaced_];
  for (std::size_t i = 0; i < limit_.factors.size(); ++i) {
    if (i != replaced_) rest -= limit_.factors[i] * p[first_ + i];
  }
  return rest / limit_.factors[replaced_];
}

std::vector<double> LimitedResiduals::given(std::span<const double> p) const {
  std::vector<double> result(p.begin(), p.end());
  result[first_ + replaced_] = coefficient(p);
  return result;
}

bool LimitedResiduals::evaluate(std::span<const double> p, std::span<double> r,
                                std::span<double> jacobian) const {
  if (!residuals_.evaluate(given(p), r, jacobian)) return false;
  for (std::size_t row = 0; row * p.size() < jacobian.size(); ++row) {
    double* d = &jacobian[row * p.size() + first_];
    const double by_rest = -d[replaced_] / limit_.factors[replaced_];
    for (std::size_t i = 0; i < limit_.factors.size(); ++i) d[i] += limit_.factors[i] * by_rest;
    d[replaced_] = by_rest;
  }
  return true;
}

std::vector<optim::FitParameter> LimitedResiduals::limited(
    std::vector<optim::FitParameter> parameters) const {
  double rest = 1;
  for (std::size_t i = 0; i < limit_.factors.size(); ++i) {
    rest -= limit_.factors[i] * parameters[first_ + i].start;
  }
  optim::FitParameter& left = parameters[first_ + replaced_];
  left = {limit_.name,
          "1",
          0,
          limit_.is_equal ? 0.0 : 1.0,
          limit_.is_equal ? 0 : std::clamp(rest, 0.0, 1.0),
          1};
  return parameters;
}

optim::FitResult LimitedResiduals::of_coefficients(
    optim::FitResult fit, const std::vector<optim::FitParameter>& parameters,
    double confidence) const {
  const std::vector<double> p = values_of(fit);
  const std::size_t k = first_ + replaced_;
  const auto size = static_cast<Index>(p.size()), at = static_cast<Index>(k);
  Eigen::VectorXd row = Eigen::VectorXd::Zero(size);
  bool identifiable = true;
  for (std::size_t i = 0; i < limit_.factors.size(); ++i) {
    const bool own = i == replaced_;
    row[static_cast<Index>(first_ + i)] =
        -(own ? 1 : limit_.factors[i]) / limit_.factors[replaced_];
    identifiable = identifiable && fit.parameters[first_ + i].identifiable;
  }
  auto stated = optim::as_eigen(fit.covariance);
  Eigen::VectorXd covariance = Eigen::VectorXd::Constant(size, std::nan(""));
  double variance = optim::kInfinity;
  if (identifiable) {
    // Of parameters that cannot be told apart covariances are NaN: they have no part in this one.
    for (Index j = 0; j < size; ++j) {
      covariance[j] = 0;
      for (Index i = 0; i < size; ++i) {
        if (row[i] != 0) covariance[j] += row[i] * stated(i, j);
      }
    }
    variance = 0;
    for (Index i = 0; i < size; ++i) {
      if (row[i] != 0) variance += row[i] * covariance[i];
    }
  }
  stated.row(at) = covariance.transpose();
  stated.col(at) = covariance;
  stated(at, at) = variance;
  optim::FittedParameter& found = fit.parameters[k];
  const optim::FitParameter& given = parameters[k];
  found = {.name = given.name, .unit = given.unit, .value = coefficient(p)};
  found.identifiable = identifiable;
  found.standard_deviation = std::sqrt(variance);
  const double half = identifiable ? found.standard_deviation *
                                         optim::student_quantile(fit.degrees_of_freedom, confidence)
                                   : optim::kInfinity;
  found.low = std::isnan(half) ? half : std::max(given.lower, found.value - half);
  found.high = std::isnan(half) ? half : std::min(given.upper, found.value + half);
  return fit;
}

}  // namespace camlaw::problems
