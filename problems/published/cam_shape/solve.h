// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "problems/published/cam_shape/cam_shape.h"
#include "problems/published/table/reproduction.h"

/// The cam-shape problem solved, beside what is printed of it.
namespace camlaw::problems {

struct CamShapeCase {
  int n = 0;
  std::optional<double> printed;  ///< where a source prints this n
  double objective = 0;
  double true_optimum = 0;   ///< cam_shape_optimum(n)
  double max_violation = 0;  ///< of the rows as published
  std::string verdict;       ///< "certified optimum"
  std::string reason;
  int iterations = 0;
  double wall_s = 0;  ///< search and verdict
};

/// Solves the problem of n radii, by the methods that problems of this kind take. Throws
/// std::invalid_argument for n outside [3, 100000], and optim::Interrupted where `stop` is set
/// before the end.
CamShapeCase solve_cam_shape(int n, const std::atomic<bool>* stop = nullptr);

/// What Ipopt answers with its own settings to the rows as they are published: each bound is
/// widened by 1e-8, which is a hundredth of d^2 at n = 1000. No feasible cam. Throws likewise, and
/// std::runtime_error where Ipopt finds none.
std::vector<double> cam_shape_by_ipopt_defaults(int n);

/// The printed values, and the n of one.
std::vector<PrintedValue> printed_cam_shapes();
int points_of(const PrintedValue& printed);

}  // namespace camlaw::problems
