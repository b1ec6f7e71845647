// SPDX-License-Identifier: MIT
#pragma once

#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <numbers>

#include "optim/problem/curve.h"

/// Elastic trains by the Fourier series of their motion, and how their curves are enclosed.
namespace camlaw::problems::testing {

/// What a cycloidal piece of stroke h over [begin, begin + length] of a turn adds to the n-th
/// Fourier coefficient of s'', the integral of s'' exp(-i k x), k = 2 pi n.
inline std::complex<double> cycloidal_term(double h, double begin, double length, double k) {
  using namespace std::complex_literals;
  constexpr double kTurn = 2 * std::numbers::pi;
  const double w = kTurn / length, peak = h * kTurn / (length * length);
  const auto shifted = peak * std::exp(-1i * k * begin);
  if (std::abs(w - k) < 1e-9 * w) return shifted * (-1i * length / 2.0);
  return shifted * w * (1.0 - std::exp(-1i * k * length)) / (w * w - k * k);
}

/// z of the undamped steady state of a train with tau periods in a turn, at x of the turn:
/// (W^2 - k^2) z_n = -s''_n, of coefficients by k.
template <class Coefficient>
double fourier_deviation(double tau, double x, const Coefficient& coefficient) {
  constexpr int kTerms = 20000;
  constexpr double kTurn = 2 * std::numbers::pi;
  const double W = kTurn * tau;
  double z = 0;
  for (int n = 1; n <= kTerms; ++n) {
    const double k = kTurn * n;
    z += 2 * std::real(-coefficient(k) / (W * W - k * k) * std::polar(1.0, k * x));
  }
  return z;
}

/// The coefficients of a rise over 120 deg, a dwell of 40, a return over 90 and a dwell, by
/// cycloids, for a stroke of 1.
inline std::complex<double> rise_and_return(double k) {
  return cycloidal_term(1, 0, 120.0 / 360, k) + cycloidal_term(-1, 160.0 / 360, 0.25, k);
}

/// Bounds over stretches about a place hold there, and close on the value as the stretch shrinks.
inline void check_bounds_close(const optim::Trace& trace, double place) {
  double before = 0;
  for (const double h : {1.0, 0.1, 0.01}) {
    const auto bounds = trace.enclose(place - h, place + h);
    for (const double by : {-h, -0.4 * h, 0.0, 0.9 * h}) {
      const double value = trace.at({place + by})[0];
      CHECK((bounds.lower <= value && value <= bounds.upper));
    }
    const double width = bounds.upper - bounds.lower;
    if (before > 0) CHECK(width <= 0.15 * before);
    before = width;
  }
}

}  // namespace camlaw::problems::testing
