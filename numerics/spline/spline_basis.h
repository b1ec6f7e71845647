// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "numerics/possible.h"

namespace camlaw::optim {

/// The highest degree of a spline that is fitted.
inline constexpr int kMostDegree = 12;

/// B-splines of one degree p over places t_0 < t_1 < ... < t_N, C^(p-1) at the inner places
/// (docs/theory.md, "Smoothing splines"). Clamped: both end knots count p + 1 times, so there are
/// N + p coefficients. Periodic: the places go on with the period t_N - t_0, and there are N.
class SplineBasis {
 public:
  /// Values of the p + 1 functions that do not vanish in a span; the k-th belongs to the
  /// coefficient (span + k) modulo their number.
  struct Row {
    std::size_t span;
    std::array<double, kMostDegree + 1> values;
  };

  /// Why there is no such basis, if so: a degree that is not 1 to kMostDegree, places that do not
  /// increase or are not finite, fewer than two, and periodic ones of fewer than p + 1 spans.
  static std::optional<Impossible> fault(int degree, const std::vector<double>& places,
                                         bool periodic);
  /// Throws std::invalid_argument with the fault.
  SplineBasis(int degree, std::vector<double> places, bool periodic);

  int degree() const { return degree_; }
  bool periodic() const { return periodic_; }
  const std::vector<double>& places() const { return places_; }
  /// The whole knot vector, t_0 being the p-th of it.
  const std::vector<double>& knots() const { return knots_; }
  std::size_t spans() const { return places_.size() - 1; }
  std::size_t coefficients() const;

  /// x itself, or brought into one period; NaN outside a basis that is not periodic.
  double inside(double x) const;
  /// The span that holds x, which is inside: t_span <= x < t_(span+1), the last one at t_N.
  std::size_t span_at(double x) const;
  /// The order-th derivatives at x, which is inside; above p they are 0.
  Row row(double x, int order) const { return row_in(span_at(x), x, order); }
  /// The same of the polynomials of one span.
  Row row_in(std::size_t span, double x, int order) const;
  /// The sum of a row's functions, each times its coefficient.
  double value(const Row& row, const std::vector<double>& coefficients) const;

 private:
  int degree_;
  bool periodic_;
  std::vector<double> places_, knots_;
};

}  // namespace camlaw::optim
