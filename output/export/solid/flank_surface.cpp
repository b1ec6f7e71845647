// SPDX-License-Identifier: MIT
#include "output/export/solid/flank_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace camlaw::problems {
namespace {

using Patch = FlankSurface::Patch;

/// A cubic by its Bernstein coefficients at a share t, by de Casteljau.
double cubic_at(std::array<double, 4> c, double t) {
  for (std::size_t level = 3; level > 0; --level) {
    for (std::size_t i = 0; i < level; ++i) c[i] += t * (c[i + 1] - c[i]);
  }
  return c[0];
}
double cubic_slope_at(const std::array<double, 4>& c, double t) {
  const double a = c[1] - c[0], b = c[2] - c[1], d = c[3] - c[2];
  const double e = a + t * (b - a), f = b + t * (d - b);
  return 3 * (e + t * (f - e));
}

std::array<double, 4> column_of(const Patch& patch, std::size_t k) {
  return {patch[0][k], patch[1][k], patch[2][k], patch[3][k]};
}

/// A patch at two shares, and its slopes by each.
struct PatchPlace {
  double value, by_first, by_second;
};
PatchPlace place_on(const Patch& patch, double first, double second) {
  std::array<double, 4> values, slopes;
  for (std::size_t k = 0; k < 4; ++k) {
    values[k] = cubic_at(column_of(patch, k), first);
    slopes[k] = cubic_slope_at(column_of(patch, k), first);
  }
  return {cubic_at(values, second), cubic_at(slopes, second), cubic_slope_at(values, second)};
}

/// The largest second derivatives of a patch by its shares: no greater than those of their
/// Bernstein coefficients.
struct PatchBend {
  double first = 0, second = 0, both = 0;
};
PatchBend bend_of(const Patch& p) {
  PatchBend bend;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      if (i < 2) {
        bend.first = std::max(bend.first, 6 * std::abs(p[i][j] - 2 * p[i + 1][j] + p[i + 2][j]));
      }
      if (j < 2) {
        bend.second = std::max(bend.second, 6 * std::abs(p[i][j] - 2 * p[i][j + 1] + p[i][j + 2]));
      }
      if (i < 3 && j < 3) {
        bend.both = std::max(bend.both,
                             9 * std::abs(p[i + 1][j + 1] - p[i + 1][j] - p[i][j + 1] + p[i][j]));
      }
    }
  }
  return bend;
}

}  // namespace

PatchSlopes slopes_over(const Patch& patch, const Interval& first, const Interval& second) {
  const PatchPlace middle =
      place_on(patch, boost::numeric::median(first), boost::numeric::median(second));
  const PatchBend bend = bend_of(patch);
  const double half = boost::numeric::width(first) / 2, across = boost::numeric::width(second) / 2;
  const Interval unit(-1, 1);
  return {middle.by_first + (half * bend.first + across * bend.both) * unit,
          middle.by_second + (half * bend.both + across * bend.second) * unit};
}

FlankSurface::FlankSurface(double floor, double outside, std::vector<std::vector<Corner>> corners)
    : floor_(floor), outside_(outside), corners_(std::move(corners)) {}

double FlankSurface::angle_step() const { return kWholeTurn / static_cast<double>(angles()); }

double FlankSurface::distance_step() const {
  return (outside_ - floor_) / static_cast<double>(distances());
}

FlankSurface::Patch FlankSurface::patch(std::size_t i, std::size_t j) const {
  const double a = angle_step() / 3, b = distance_step() / 3;
  Patch patch;
  const auto fill = [&](const Corner& c, std::size_t p, std::size_t q) {
    const double along = p == 0 ? a : -a, across = q == 0 ? b : -b;
    const std::size_t p1 = p == 0 ? 1 : 2, q1 = q == 0 ? 1 : 2;
    patch[p][q] = c.height;
    patch[p1][q] = c.height + along * c.by_angle;
    patch[p][q1] = c.height + across * c.by_distance;
    patch[p1][q1] =
        c.height + along * c.by_angle + across * c.by_distance + along * across * c.by_both;
  };
  fill(corners_[j][i], 0, 0);
  fill(corners_[j][i + 1], 3, 0);
  fill(corners_[j + 1][i], 0, 3);
  fill(corners_[j + 1][i + 1], 3, 3);
  return patch;
}

double FlankSurface::height(double angle, double distance) const {
  double turn = std::fmod(angle, kWholeTurn);
  if (turn < 0) turn += kWholeTurn;
  const double t = turn / angle_step(), v = (distance - floor_) / distance_step();
  const auto i = std::min(static_cast<std::size_t>(t), angles() - 1);
  const auto j = std::min(static_cast<std::size_t>(std::max(v, 0.0)), distances() - 1);
  return place_on(patch(i, j), t - static_cast<double>(i), v - static_cast<double>(j)).value;
}

double groove_volume(const FlankSurface& lower, const FlankSurface& upper) {
  // Bernstein polynomials of degree 3 have the mean 1/4; times the distance q from the axis, which
  // is linear, the mean of the k-th is (q at the share (k + 1) / 5) / 4.
  const auto moment = [](const FlankSurface& s) {
    double sum = 0;
    for (std::size_t j = 0; j < s.distances(); ++j) {
      const double near = s.floor() + s.distance_step() * static_cast<double>(j);
      for (std::size_t i = 0; i < s.angles(); ++i) {
        const auto patch = s.patch(i, j);
        for (std::size_t k = 0; k < 4; ++k) {
          const double q = near + s.distance_step() * static_cast<double>(k + 1) / 5;
          for (std::size_t p = 0; p < 4; ++p) sum += q * patch[p][k] / 16;
        }
      }
    }
    return sum * s.angle_step() * s.distance_step();
  };
  return moment(upper) - moment(lower);
}

}  // namespace camlaw::problems
