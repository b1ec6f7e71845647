// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "optim/fit/fit_point.h"

/// The way from a start to the neighbourhood of a minimum.
namespace camlaw::optim {

/// How far the first steps go.
enum class Pace {
  Bold,  ///< next to Gauss and Newton's
  /// Small steps at first, measured by the scales. For starts from which bold steps leap to where
  /// the residuals no longer depend on a parameter.
  Cautious
};

struct CeresSearch {
  Eigen::VectorXd p;
  int iterations = 0;
};

/// Levenberg and Marquardt's method of Ceres, from a start within the box at which the residuals
/// are defined. `scales` are typical sizes of the parameters. Where the residuals are undefined a
/// step is refused. Ends after `max_iterations` or where the sum and the parameters change by no
/// more than about `tolerance` of themselves; whether the end is a minimum is for the caller to
/// see. What the residuals throw is thrown on.
CeresSearch ceres_search(const Residuals& residuals, const FitBox& box,
                         const Eigen::VectorXd& scales, const Eigen::VectorXd& start,
                         int max_iterations, double tolerance, Pace pace);

/// "ceres 2.1.0".
std::string ceres_version();

}  // namespace camlaw::optim
