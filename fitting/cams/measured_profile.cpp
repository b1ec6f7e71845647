// SPDX-License-Identifier: MIT
#include "fitting/cams/measured_profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fitting/cams/measured_refusal.h"
#include "numerics/tables/turn.h"

namespace camlaw::problems {
namespace {

using Complex = std::complex<double>;

using measured::refuse;

double degrees(double angle) { return angle / kDegree; }

struct PolarPoints {
  std::vector<double> theta, r;
};

void check_points(const PolarPoints& points) {
  // The order of the penalty, a few spans and what cross-validation needs.
  constexpr std::size_t kLeast = 12;
  if (points.r.size() < kLeast) {
    refuse(fmt::format("{} points are too few, {} are needed", points.r.size(), kLeast));
  }
  for (std::size_t k = 0; k < points.r.size(); ++k) {
    if (!std::isfinite(points.theta[k]) || !std::isfinite(points.r[k])) {
      refuse(fmt::format("point {} is not a number", k));
    }
    if (!(points.r[k] > 0)) {
      refuse(
          fmt::format("the point at a polar angle of {:.6g} deg has the radius {:.6g}, not above 0",
                      degrees(points.theta[k]), points.r[k]));
    }
  }
}

/// Steps of the polar angle from point to point, the last one back to the first.
std::vector<double> steps_of(const std::vector<double>& theta) {
  std::vector<double> steps;
  for (std::size_t k = 0; k < theta.size(); ++k) {
    steps.push_back(std::remainder(theta[(k + 1) % theta.size()] - theta[k], kTurn));
  }
  return steps;
}

/// That the points go round the centre once, and every ray meets them once.
void check_round(const std::vector<double>& steps) {
  double sum = 0;
  for (const double step : steps) sum += step;
  if (std::abs(std::abs(sum) - kTurn) > 1) {
    refuse(fmt::format("it does not go round the centre once: its polar angle turns by {:.4g} deg",
                       std::round(1e6 * degrees(sum)) / 1e6 + 0.0));
  }
  // Noise may turn the angle back by a little between points that are close.
  constexpr double kMostBack = kDegree;
  const double sense = sum > 0 ? 1 : -1;
  double reached = 0, now = 0;
  for (std::size_t k = 0; k + 1 < steps.size(); ++k) {
    now += sense * steps[k];
    reached = std::max(reached, now);
    if (reached - now > kMostBack) {
      refuse(fmt::format("it turns back at point {}: a ray from the centre meets it twice", k + 1));
    }
  }
}

void check_gaps(std::vector<double> theta) {
  // Over a wider gap a smooth curve tells nothing of the profile.
  constexpr double kMostGap = kTurn / 8;
  std::sort(theta.begin(), theta.end());
  for (std::size_t k = 0; k < theta.size(); ++k) {
    const bool last = k + 1 == theta.size();
    const double next = last ? theta.front() + kTurn : theta[k + 1];
    if (next - theta[k] <= kMostGap) continue;
    refuse(fmt::format("it is not closed: there are no points from {:.4g} to {:.4g} deg",
                       degrees(theta[k]), degrees(last ? theta.front() : next)));
  }
}

/// Points that can be a profile, their angles from 0 to a turn.
PolarPoints checked(PolarPoints points) {
  check_points(points);
  check_round(steps_of(points.theta));
  for (double& theta : points.theta) {
    theta = std::clamp(in_turn(theta), 0.0, kTurn);
  }
  check_gaps(points.theta);
  return points;
}

optim::SmoothingSpline closed_spline(const PolarPoints& points, optim::SmoothingOptions smoothing) {
  smoothing.periodic = true;
  smoothing.range = {0, kTurn};
  smoothing.begin = smoothing.end = {};
  return optim::smoothing_spline(points.theta, points.r, smoothing);
}

}  // namespace

MeasuredProfile MeasuredProfile::polar(std::span<const double> theta, std::span<const double> r,
                                       const optim::SmoothingOptions& smoothing) {
  if (theta.size() != r.size()) {
    refuse(fmt::format("{} polar angles and {} radii: there must be as many of one as of the other",
                       theta.size(), r.size()));
  }
  PolarPoints polar = checked({{theta.begin(), theta.end()}, {r.begin(), r.end()}});
  optim::SmoothingSpline spline = closed_spline(polar, smoothing);
  return {std::move(polar.theta), std::move(spline)};
}

/// (I1), (I2)
ProfilePoint MeasuredProfile::at(double theta) const {
  const double r = spline_(theta), d = spline_(theta, 1), dd = spline_(theta, 2);
  const Complex ray = std::polar(1.0, theta);
  const double speed = std::hypot(r, d);
  const Complex tangent = Complex(d, r) / speed * ray;
  return {r * ray, tangent, Complex(0, -1) * tangent,
          (r * r + 2 * d * d - r * dd) / (speed * speed * speed), speed};
}

}  // namespace camlaw::problems
