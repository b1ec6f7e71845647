// SPDX-License-Identifier: MIT
#pragma once

#include "optim/fit/fit_point.h"
#include "optim/fit/least_squares.h"

/// From a minimum to what is known of it.
namespace camlaw::optim {

/// Where a search ended.
struct FitEnd {
  Eigen::VectorXd p;
  std::optional<double> loss_scale;
  std::string doubt;         ///< what is wrong with an estimated scale; empty where nothing is
  bool is_at_kinks = false;  ///< of the residuals, where their sum is least
};

/// Deviations and intervals of the parameters by the covariance that the result has.
void set_intervals(const std::vector<FitParameter>& parameters, double confidence,
                   FitResult& result);

/// Everything of a FitResult but the counts.
FitResult fit_report(const std::vector<FitParameter>& parameters, const Residuals& residuals,
                     const FitOptions& options, const FitBox& box, const FitEnd& end);

}  // namespace camlaw::optim
