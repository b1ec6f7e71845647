// SPDX-License-Identifier: MIT
#include "optim/fit/ceres_search.h"

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <cmath>
#include <exception>
#include <mutex>

namespace camlaw::optim {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// All residuals as one block in p / scales.
class Block final : public ceres::CostFunction {
 public:
  Block(const Residuals& residuals, const FitBox& box, const VectorXd& scales)
      : residuals_(residuals), box_(box), scales_(scales) {
    set_num_residuals(static_cast<int>(residuals.count()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(scales.size()));
  }

  bool Evaluate(double const* const* parameters, double* r, double** jacobians) const override {
    const VectorXd p = unscaled(Eigen::Map<const VectorXd>(parameters[0], scales_.size()));
    double* const jacobian = jacobians ? jacobians[0] : nullptr;
    const std::size_t m = static_cast<std::size_t>(p.size()), n = residuals_.count();
    const std::span<double> entries(jacobian, jacobian ? n * m : 0);
    // Ceres does not expect exceptions: they wait until it has returned.
    try {
      if (!residuals_.evaluate({p.data(), m}, {r, n}, entries)) return false;
    } catch (...) {
      thrown_ = std::current_exception();
      return false;
    }
    for (std::size_t i = 0; i < entries.size(); ++i) {
      entries[i] *= scales_[static_cast<Index>(i % m)];
    }
    return true;
  }

  VectorXd unscaled(const VectorXd& y) const {
    return y.cwiseProduct(scales_).cwiseMax(box_.lower).cwiseMin(box_.upper);
  }
  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  const Residuals& residuals_;
  const FitBox& box_;
  const VectorXd& scales_;
  mutable std::exception_ptr thrown_;
};

ceres::Solver::Options settings(int max_iterations, double tolerance, Pace pace) {
  ceres::Solver::Options options;
  options.max_num_iterations = max_iterations;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;

  options.function_tolerance = options.parameter_tolerance = tolerance;
  // Never: a gradient has units, in which no number is small for every problem.
  options.gradient_tolerance = 1e-30;
  options.max_num_consecutive_invalid_steps = 50;
  if (pace == Pace::Cautious) {
    // Levenberg's damping, the same for all parameters in their scales, instead of Marquardt's by
    // columns: a parameter that hardly matters at the start is not sent far for it.
    options.jacobi_scaling = false;
    options.min_lm_diagonal = options.max_lm_diagonal = 1;
    // The damping is the reciprocal: 1e4 in the parameters' scales, which shortens the first steps.
    options.initial_trust_region_radius = 1e-4;
  }
  return options;
}

/// Ceres tells the terminal of each search that ends where there are no numbers: that is ours to
/// tell. The level is the process's own: the first of several threads sets it, the last gives it
/// back.
class Silence {
 public:
  Silence() {
    const std::lock_guard lock(guard_);
    if (searches_++ > 0) return;
    before_ = FLAGS_minloglevel;
    FLAGS_minloglevel = google::GLOG_FATAL;
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;
  ~Silence() {
    const std::lock_guard lock(guard_);
    if (--searches_ == 0) FLAGS_minloglevel = before_;
  }

 private:
  static inline std::mutex guard_;
  static inline int searches_ = 0, before_ = 0;
};

}  // namespace

CeresSearch ceres_search(const Residuals& residuals, const FitBox& box, const VectorXd& scales,
                         const VectorXd& start, int max_iterations, double tolerance, Pace pace) {
  Block block(residuals, box, scales);
  VectorXd y = start.cwiseQuotient(scales);
  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ownership.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(ownership);
  problem.AddResidualBlock(&block, nullptr, y.data());
  // Fixed parameters stay by a manifold; Ceres refuses equal bounds.
  std::vector<int> fixed;
  for (Index j = 0; j < y.size(); ++j) {
    const int index = static_cast<int>(j);
    if (box.lower[j] == box.upper[j]) {
      fixed.push_back(index);
      continue;
    }
    if (std::isfinite(box.lower[j])) {
      problem.SetParameterLowerBound(y.data(), index, std::min(y[j], box.lower[j] / scales[j]));
    }
    if (std::isfinite(box.upper[j])) {
      problem.SetParameterUpperBound(y.data(), index, std::max(y[j], box.upper[j] / scales[j]));
    }
  }
  if (static_cast<Index>(fixed.size()) == y.size()) return {start, 0};
  ceres::SubsetManifold manifold(static_cast<int>(y.size()), fixed);
  ceres::Solver::Summary summary;
  if (!fixed.empty()) problem.SetManifold(y.data(), &manifold);
  const Silence silence;
  ceres::Solve(settings(max_iterations, tolerance, pace), &problem, &summary);
  block.rethrow();
  return {block.unscaled(y), static_cast<int>(summary.iterations.size())};
}

std::string ceres_version() { return "ceres " CERES_VERSION_STRING; }

}  // namespace camlaw::optim
