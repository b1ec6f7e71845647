// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "output/export/curve_fit.h"

/// Curves as splines of degree 3.
namespace camlaw::problems {

/// A cubic over a stretch of the cam angle, deg, by its Bezier points, mm.
struct CubicPiece {
  double from, to;
  std::array<Eigen::Vector2d, 4> control;
  double deviation;
};

struct CubicPath {
  std::vector<CubicPiece> pieces;
  double worst = 0;    ///< of points at the same angle: no point is farther from the path, mm
  bool proved = true;  ///< that none is farther

  /// As one B-spline: knots (each end four times; inside twice, or three times where the curve's
  /// speed changes at once, so that it interpolates with a continuous derivative) and control
  /// points.
  std::vector<double> knots() const;
  std::vector<Eigen::Vector2d> control_points() const;

  /// The stretches that are smooth and have none of some angles, deg, within them. Each ends in the
  /// very digits in which the next begins.
  std::vector<CubicPath> smooth_runs(const std::vector<double>& angles) const;
  /// The stretches between cusps, ended in the same way.
  std::vector<CubicPath> runs_between_cusps() const;

 private:
  bool is_smooth(std::size_t i) const;  ///< where the pieces i and i + 1 meet
  bool is_cusp(std::size_t i) const;    ///< the same: the curve turns back there
  /// The stretches that end where ends(i) says so, after the piece i.
  template <class Ends>
  std::vector<CubicPath> runs(const Ends& ends) const;
};

/// Hermite cubics through points of the curve with the curve's derivatives there, as few as
/// bisection finds within a tolerance, mm. A piece ends at each cusp.
CubicPath cubics_within(const PlaneCurve& curve, double tolerance);

}  // namespace camlaw::problems
