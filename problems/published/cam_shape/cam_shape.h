// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "optim/problem/problem.h"

/// The COPS cam-shape problem: the valve cam of largest mean radius among the convex ones whose
/// radius changes slowly.
///
/// - maximise (pi / n) sum r_i over 1 <= r_i <= 2, i = 1 .. n, where, with d = 2 pi / (5 n + 5),
/// - 2 r_{i-1} r_{i+1} cos d <= r_i (r_{i-1} + r_{i+1}) for i = 0 .. n + 1 (convexity),
/// - |r_{i+1} - r_i| <= 1.5 d for i = 0 .. n (slope),
/// - r_{-1} = r_0 = 1, r_{n+1} = 2, r_{n+2} = r_n.
///
/// Sources: M. Anitescu, R. Serban, A Sparse Superlinearly Convergent SQP with Applications to
/// Two-Dimensional Shape Optimization, Argonne National Laboratory, 1998; E. D. Dolan, J. J. More,
/// T. S. Munson, Benchmarking Optimization Software with COPS 3.0, ANL/MCS-TM-273, 2004, section 3.
namespace camlaw::problems {

inline constexpr int kLeastCamShape = 3, kMostCamShape = 100000;

/// The problem of n radii. Its convexity rows are over d^2, which makes them the cam's curvature to
/// first order (r r'' - 2 r'^2 - r^2 <= 0), and its slope rows over d: as published, a convexity
/// row is of the size of d^2, and a tolerance of 1e-8 is worth more than the answer's digits
/// (docs/optimisation.md, "Cam shape"). Throws std::invalid_argument for n outside [3, 100000].
optim::Problem cam_shape(int n);

/// d for n radii.
double cam_shape_angle(int n);

/// The optimal radii, by a forward recursion that is proved to bound every feasible cam
/// (docs/optimisation.md, "Cam shape"). Throws as cam_shape().
std::vector<double> cam_shape_radii(int n);

/// The optimum, (pi / n) times the sum of those.
double cam_shape_optimum(int n);

/// What the optimum tends to as n grows: 4.2728604777.
double cam_shape_limit();

/// The largest violation of the rows as they are published, for any n >= 1 radii; 0 where all hold.
double cam_shape_published_violation(std::span<const double> radii);

}  // namespace camlaw::problems
