// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>

/// Linear programs of a few variables, by Clp.
namespace camlaw::optim {

/// x >= 0 with the greatest gain . x where rows x <= limits; no limit is below zero, so that x = 0
/// is allowed. It is a corner, exactly but for rounding. None where the gain has no bound.
std::optional<Eigen::VectorXd> greatest_gain(const Eigen::VectorXd& gain,
                                             const Eigen::MatrixXd& rows,
                                             const Eigen::VectorXd& limits);

}  // namespace camlaw::optim
