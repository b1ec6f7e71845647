// SPDX-License-Identifier: MIT
#include "machines/model/rest_velocity.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace camlaw::problems {
namespace {

/// The sum of what the terms of s' can be in a piece, each by its magnitude.
double velocity_terms(const Piece<double>& piece) {
  const double far =
      std::max(std::abs(piece.begin - piece.origin), std::abs(piece.end - piece.origin));
  double sum = 0, power = 1;
  for (std::size_t k = 1; k < piece.polynomial.size(); ++k) {
    sum += static_cast<double>(k) * std::abs(piece.polynomial[k]) * power;
    power *= far;
  }
  for (const auto& h : piece.harmonics)
    sum += (std::abs(h.sine) + std::abs(h.cosine)) * std::abs(h.frequency);
  for (const auto& c : piece.curves) sum += std::abs(c.amplitude * c.rate);
  return sum;
}

}  // namespace

double velocity_rounding(const Law<double>& law) {
  constexpr double kRounding = 4e-15;  // some twenty units of the last place of the terms
  double terms = 0;
  for (const Piece<double>& piece : law.pieces()) terms = std::max(terms, velocity_terms(piece));
  return kRounding * terms;
}

double resting_velocity(double inside, double rounding) {
  // Far below what any product or sum of a machine shows, far above denormals.
  constexpr double kTiny = 1e-100;
  return std::abs(inside) > rounding ? std::copysign(kTiny, inside) : 0;
}

double velocity_from_within(double v, const Piece<double>& piece, double x, double rounding) {
  // The velocity there, 1e-3 to a power of up to 4, is above rounding.
  constexpr double kBeside = 1e-3;
  if (!(std::abs(v) <= rounding)) return v;
  const double beside = kBeside * (piece.end - piece.begin);
  const bool at_begin = x <= piece.begin + beside;
  if (!at_begin && x < piece.end - beside) return v;
  const double farther = at_begin ? piece.begin + beside : piece.end - beside;
  return resting_velocity(derivatives<2>(piece, farther)[1], rounding);
}

double resting_displacement(double s, double inside) {
  if (!(std::abs(inside - s) > kRestRounding)) return s;
  return s + std::copysign(2 * kRestRounding, inside - s);
}

double displacement_from_within(double s, const Piece<double>& piece, double x) {
  // The displacement there, 1e-2 to a power of up to 5, is above rounding.
  constexpr double kBeside = 1e-2;
  const double beside = kBeside * (piece.end - piece.begin);
  const bool at_begin = x <= piece.begin + beside;
  if (!at_begin && x < piece.end - beside) return s;
  const double end = derivatives<1>(piece, at_begin ? piece.begin : piece.end)[0];
  if (!(std::abs(s - end) <= kRestRounding)) return s;
  const double farther = at_begin ? piece.begin + beside : piece.end - beside;
  return resting_displacement(end, derivatives<1>(piece, farther)[0]);
}

double without_traces(double value) {
  constexpr double kTraces = 1e-80;  // what is left of the 1e-100 of a resting velocity
  if (std::abs(value) < kTraces) return 0;
  return std::abs(value) > 1 / kTraces
             ? std::copysign(std::numeric_limits<double>::infinity(), value)
             : value;
}

}  // namespace camlaw::problems
