// SPDX-License-Identifier: MIT
#include "fitting/motions/fitted_law.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "kinematics/laws/spline.h"

namespace camlaw::problems {
namespace {

/// A span's Taylor series at its begin.
Piece<double> piece_of(const optim::SmoothingSpline& spline, std::size_t span, double zero,
                       double stroke) {
  const auto& places = spline.basis().places();
  const double begin = places.front(), length = places.back() - begin;
  const double from = (places[span] - begin) / length, to = (places[span + 1] - begin) / length;
  Piece<double> piece{from, to, from, {}, {}, {}};
  double scale = 1 / stroke;  // length^k / k! by the stroke
  for (int k = 0; k <= spline.basis().degree(); ++k) {
    if (k > 0) scale *= length / k;
    piece.polynomial.push_back(spline(places[span], k) * scale);
  }
  piece.polynomial.front() -= zero / stroke;
  return piece;
}

Possible<Law<double>> periodic_law(const optim::SmoothingSpline& spline, double zero,
                                   double stroke) {
  std::vector<Piece<double>> pieces;
  for (std::size_t span = 0; span < spline.basis().spans(); ++span) {
    pieces.push_back(piece_of(spline, span, zero, stroke));
  }
  return Law<double>::possible(std::move(pieces), {End::Motion, End::Motion});
}

}  // namespace

Possible<Law<double>> possible_spline_law(const optim::SmoothingSpline& spline, double zero,
                                          double stroke) {
  if (!std::isfinite(stroke) || !std::isfinite(zero) || stroke == 0) {
    return Impossible{fmt::format("law of a spline: {:.6g} is not a possible stroke (from {:.6g})",
                                  stroke, zero)};
  }
  if (spline.basis().periodic()) return periodic_law(spline, zero, stroke);
  const auto& places = spline.basis().places();
  const double begin = places.front(), length = places.back() - begin;
  std::vector<double> interior, coefficients;
  for (std::size_t i = 1; i + 1 < places.size(); ++i) {
    interior.push_back((places[i] - begin) / length);
  }
  // B-splines add up to 1, so coefficients move with the displacement.
  for (const double c : spline.coefficients()) coefficients.push_back((c - zero) / stroke);
  return possible_b_spline(spline.basis().degree(), interior, coefficients);
}

Possible<Law<double>> possible_stretch_law(const optim::SmoothingSpline& spline) {
  if (spline.basis().periodic()) {
    return Impossible{"law of a spline: a periodic spline is not a single motion"};
  }
  // A clamped spline begins and ends at its outer coefficients.
  const double from = spline.coefficients().front(), to = spline.coefficients().back();
  return possible_spline_law(spline, from, to - from);
}

Law<double> spline_law(const optim::SmoothingSpline& spline, double zero, double stroke) {
  return possible_spline_law(spline, zero, stroke).value();
}

Law<double> stretch_law(const optim::SmoothingSpline& spline) {
  return possible_stretch_law(spline).value();
}

}  // namespace camlaw::problems
