// SPDX-License-Identifier: MIT
#include "fitting/motions/occam.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>

#include "fitting/motions/fit_parameters.h"
#include "numerics/linear/dense.h"
#include "optim/fit/eigen_matrix.h"

namespace camlaw::problems {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The coefficients that the fit moved freely.
struct OwnColumns {
  std::vector<Index> own;
  bool has_open = false;  ///< the samples do not determine some of them
};

OwnColumns own_columns(const std::vector<optim::FitParameter>& parameters, std::size_t first,
                       const optim::FitResult& fit) {
  OwnColumns result;
  for (std::size_t j = first; j < parameters.size(); ++j) {
    if (is_held(parameters[j]) || fit.parameters[j].at_bound) continue;
    result.own.push_back(static_cast<Index>(j));
    if (!fit.parameters[j].identifiable) result.has_open = true;
  }
  return result;
}

/// What the samples say of the coefficients, the other numbers being free, in the scale of what was
/// known before: eigenvalues of P C^-1, which are 0 for what they do not determine. `jacobian` has
/// the samples' weights. Where all are determined C is that of the fit.
VectorXd information_of(const MatrixXd& jacobian, const OwnColumns& columns, std::size_t first,
                        const VectorXd& before, double deviation, const optim::FitResult& fit) {
  if (!columns.has_open) {
    const VectorXd scale = before.cwiseInverse() * std::max(1.0, deviation / fit.sigma);
    const MatrixXd known = scale.asDiagonal() *
                           MatrixXd(optim::as_eigen(fit.covariance)(columns.own, columns.own)) *
                           scale.asDiagonal();
    if (!known.allFinite()) return {};
    constexpr double kLeast = 1e-30;  // an eigenvalue that rounding leaves at 0 or below
    return optim::symmetric_eigen(known).values.cwiseMax(kLeast).cwiseInverse();
  }
  MatrixXd others = jacobian.leftCols(static_cast<Index>(first));
  others.colwise().normalize();  // so that the rank does not depend on units
  const MatrixXd basis = optim::column_space(others);
  MatrixXd own = jacobian(Eigen::all, columns.own);
  own -= basis * (basis.transpose() * own);
  own = own * before.asDiagonal() / std::max(fit.sigma, deviation);
  if (!own.allFinite()) return {};
  return optim::symmetric_eigen(own.transpose() * own).values;
}

}  // namespace

Occam occam_of(const optim::Residuals& residuals,
               const std::vector<optim::FitParameter>& parameters, std::size_t first, double size,
               double deviation, const optim::FitResult& fit) {
  constexpr double kMost = 0.1;  // of the stroke: the prior's reach of a coefficient (LC1)
  const std::size_t m = parameters.size(), n = residuals.count();
  const auto samples = static_cast<double>(residuals.measurements());
  // Where a coefficient has no effect to first order it has one to second order, as a rule: a
  // polynomial's where it changes as begin and end do. The samples then leave it the square root of
  // what they else would.
  const double most = kMost * size / deviation;
  const double second = 0.5 * std::log1p(samples * most * most / 12);
  const OwnColumns columns = own_columns(parameters, first, fit);
  const std::size_t open =
      columns.has_open ? std::min(columns.own.size(), fit.free_directions.size()) : 0;
  Occam result{columns.own.size() - open, second * static_cast<double>(open)};
  const std::vector<double> p = values_of(fit);
  std::vector<double> r(n), rows(n * m);
  if (result.count == 0 || !residuals.evaluate(p, r, rows)) return result;
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  MatrixXd jacobian =
      Eigen::Map<const RowMajor>(rows.data(), static_cast<Index>(n), static_cast<Index>(m));
  VectorXd before(static_cast<Index>(columns.own.size()));
  for (std::size_t k = 0; k < columns.own.size(); ++k) {
    const Index j = columns.own[k];
    const optim::FitParameter& own = parameters[static_cast<std::size_t>(j)];
    const double effect = jacobian.col(j).norm() / std::sqrt(samples);
    const double range = std::min(own.upper - own.lower, kMost * size / effect);
    before[static_cast<Index>(k)] = range / std::sqrt(12.0);
  }
  for (std::size_t i = 0; i < n; ++i) {
    jacobian.row(static_cast<Index>(i)) *= std::sqrt(fit.weights[i]);
  }
  VectorXd told = information_of(jacobian, columns, first, before, deviation, fit);
  std::sort(told.begin(), told.end(), std::greater<>());
  const auto count = std::min<Index>(told.size(), static_cast<Index>(result.count));
  for (Index i = 0; i < count; ++i) {
    result.logarithm += std::max(std::log1p(std::max(told[i], 0.0)), second);
  }
  return result;
}

}  // namespace camlaw::problems
