// SPDX-License-Identifier: MIT
#include "problems/published/cam_shape/cam_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "problems/published/cam_shape/kernels.h"

namespace camlaw::problems {
namespace {

using cam_shape_parts::Radius;
using optim::Constraint;

constexpr double kPi = std::numbers::pi;
/// The data of COPS 3.0, section 3.
constexpr double kLeastRadius = 1, kMostRadius = 2, kSteepest = 1.5;

void check(int n) {
  if (n >= kLeastCamShape && n <= kMostCamShape) return;
  throw std::invalid_argument(
      fmt::format("cam shape: n = {} is outside {} .. {}", n, kLeastCamShape, kMostCamShape));
}

/// r_i of n radii, i = -1 .. n + 2, with those that the statement gives.
Radius radius(int i, int n) {
  if (i <= 0) return {-1, kLeastRadius};
  if (i == n + 1) return {-1, kMostRadius};
  return {i == n + 2 ? n - 1 : i - 1};
}

/// If every row is violated by its tolerance, the optimum grows by 0.82 times that of the convexity
/// rows and 0.19 times that of the slope rows (the recursion with both relaxed): by 8e-8 of it.
/// Rounding the three radii of a row, all below 1.5 where it holds them, to doubles moves it by up
/// to 6 (eps / 2) / d^2. From n = 10000 on, where the tolerance is nine times that, it has to grow.
double convexity_tolerance(int n) {
  constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
  return std::max(4e-7, 28 * kEpsilon / (cam_shape_angle(n) * cam_shape_angle(n)));
}
/// The objective's is 1e-7 of the optimum, 4.27, as of every objective (optimisation: SC3); slopes
/// that are a tolerance off move it by a twentieth of that.
constexpr double kSlopeTolerance = 1e-7, kObjectiveTolerance = 4e-7;

/// Solvers work to 1e-9 of the scaled rows; that is to be a tenth of the tolerance.
double convexity_scale(int n) { return 1e8 * convexity_tolerance(n); }

Constraint convexity_row(int i, int n) {
  Constraint row;
  row.response.name = fmt::format("convexity {}", i);
  row.response.measure = cam_shape_parts::convexity(radius(i - 1, n), radius(i, n),
                                                    radius(i + 1, n), cam_shape_angle(n));
  row.upper = 0;
  row.tolerance = convexity_tolerance(n);
  row.scale = convexity_scale(n);
  return row;
}

Constraint slope_row(int i, int n) {
  Constraint row;
  row.response.name = fmt::format("slope {}", i);
  row.response.measure = cam_shape_parts::slope(radius(i, n), radius(i + 1, n), cam_shape_angle(n));
  row.lower = -kSteepest;
  row.upper = kSteepest;
  row.tolerance = kSlopeTolerance;
  row.scale = 1;
  return row;
}

}  // namespace

double cam_shape_angle(int n) { return 2 * kPi / (5 * (n + 1.0)); }

optim::Problem cam_shape(int n) {
  check(n);
  optim::Problem problem;
  problem.name = fmt::format("cam shape, n = {}", n);
  for (int i = 1; i <= n; ++i) {
    // From 1 to 2 without a kink at 1: half the iterations of COPS's start, 1.5 everywhere.
    const double t = i / (n + 1.0);
    problem.variables.push_back(
        {fmt::format("r{}", i), "1", kLeastRadius, kMostRadius, 1 + t * t, 1.0});
  }
  problem.objectives = {
      {.response = {.name = "valve opening",
                    .measure = cam_shape_parts::sum(problem.variables.size(), kPi / n)},
       .sense = optim::Sense::Maximize,
       .tolerance = kObjectiveTolerance}};
  for (int i = 0; i <= n + 1; ++i) problem.constraints.push_back(convexity_row(i, n));
  for (int i = 0; i <= n; ++i) problem.constraints.push_back(slope_row(i, n));
  problem.known = {cam_shape_optimum(n), cam_shape_radii(n), "forward recursion in 1/r"};
  return problem;
}

std::vector<double> cam_shape_radii(int n) {
  check(n);
  const double d = cam_shape_angle(n);
  const double chord = 4 * std::sin(d / 2) * std::sin(d / 2);  // 2 - 2 cos d, without cancellation
  std::vector<double> radii;
  double u = 1, change = 0;  // u = 1 / r; its last difference, kept so that rounding does not grow
  for (int i = 1; i <= n; ++i) {
    const double convex = u + (change - chord * u);
    const double next = std::max({convex, 1 / (1 / u + kSteepest * d), 1 / kMostRadius});
    change = next == convex ? change - chord * u : next - u;
    u = next;
    radii.push_back(1 / u);
  }
  return radii;
}

double cam_shape_optimum(int n) {
  const std::vector<double> radii = cam_shape_radii(n);
  return kPi / n * std::accumulate(radii.begin(), radii.end(), 0.0);
}

double cam_shape_limit() {
  // r = 1 / cos up to the angle where its slope is 1.5: there r = s and s t = 1.5, t = sqrt(s^2-1).
  const double s = std::sqrt((1 + std::sqrt(10.0)) / 2), t = std::sqrt((std::sqrt(10.0) - 1) / 2);
  const double convex = std::log(s + t);
  const double steep = (kMostRadius * kMostRadius - s * s) / (2 * kSteepest);
  const double flat = kMostRadius * (2 * kPi / 5 - std::atan(t) - (kMostRadius - s) / kSteepest);
  return 2.5 * (convex + steep + flat);
}

double cam_shape_published_violation(std::span<const double> radii) {
  const int n = static_cast<int>(radii.size());
  const double d = cam_shape_angle(n);
  const auto r = [&](int i) {
    const Radius at = radius(i, n);
    return at.variable < 0 ? at.given : radii[static_cast<std::size_t>(at.variable)];
  };
  double worst = 0;
  for (int i = 0; i <= n + 1; ++i) {
    const double a = r(i - 1), b = r(i), c = r(i + 1);
    worst = std::max(worst, 2 * a * c * std::cos(d) - b * (a + c));
    worst = std::max({worst, kLeastRadius - b, b - kMostRadius});
    if (i <= n) worst = std::max(worst, std::abs(c - b) - kSteepest * d);
  }
  return worst;
}

}  // namespace camlaw::problems
