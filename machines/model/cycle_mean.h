// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "kinematics/expansion.h"
#include "machines/model/curve_formula.h"
#include "numerics/polynomial/gauss_legendre.h"

namespace camlaw::problems {
namespace detail {

/// At least this many steps over the whole law, and over each piece.
inline constexpr double kMeanSteps = 16, kMeanBoxes = 256;
inline constexpr int kLeastSteps = 2;

/// As many steps as a piece needs: `whole` over the whole law, and no harmonic turns by more than
/// two rad within a step, so that its square, of twice the frequency, is integrated as well.
template <class T>
int steps_over(const Piece<T>& piece, double whole) {
  constexpr double kTurn = 2;
  double rate = whole;
  for (const auto& h : piece.harmonics) {
    rate = std::max(rate, std::abs(value_of(h.frequency)) / kTurn);
  }
  const double length = value_of(piece.end) - value_of(piece.begin);
  return std::max(kLeastSteps, static_cast<int>(std::ceil(rate * length)));
}

/// Gauss-Legendre of 10 points on even steps.
template <class T, class F>
T piece_integral(const Piece<T>& piece, const F& f) {
  const auto& [places, weights] = gauss_legendre(10);
  const T length = piece.end - piece.begin;
  const int steps = steps_over(piece, kMeanSteps);
  const T half = length / number<T>(2.0 * steps);
  T sum = number<T>(0);
  for (int i = 0; i < steps; ++i) {
    const T middle = piece.begin + number<T>(2 * i + 1) * half;
    for (std::size_t k = 0; k < places.size(); ++k) {
      for (const double side : {-1.0, 1.0}) {
        const T x = middle + number<T>(side * places[k]) * half;
        const auto d = derivatives<4>(piece, x);
        sum = sum + number<T>(weights[k]) * f(Motion<T>{d[0], d[1], d[2], d[3]}, x);
      }
    }
  }
  return half * sum;
}

/// Encloses: over a step from a to b about c, f(c) (b - a) + f'(c) ((b - c)^2 - (a - c)^2) / 2 +
/// f''/2 ((b - c)^3 - (a - c)^3) / 3, f'' over the whole step.
template <class F>
Interval piece_integral(const Piece<Interval>& piece, const F& f) {
  const PieceExpander expander(piece);
  const Interval length = piece.end - piece.begin, one(1.0);
  const int steps = steps_over(piece, kMeanBoxes);
  const auto edge = [&](int i) {
    return piece.begin + length * Interval(double(i)) / Interval(double(steps));
  };
  Interval sum(0.0);
  for (int i = 0; i < steps; ++i) {
    const Interval a = edge(i), b = edge(i + 1), box = boost::numeric::hull(a, b);
    const Expansion motion = expander(box);
    const Interval c(motion.middle), left = a - c, right = b - c;
    const auto at = f(motion_series<2>(motion.at), Series<Interval, 2>::variable(c, one));
    const auto over = f(motion_series<3>(motion.over), Series<Interval, 3>::variable(box, one));
    sum = sum + at.c[0] * (b - a) + at.c[1] * (right * right - left * left) / Interval(2.0) +
          over.c[2] * (right * right * right - left * left * left) / Interval(3.0);
  }
  return sum;
}

}  // namespace detail

/// The integral over x from 0 to 1 of f(motion, x) along a law: for intervals an enclosure, else by
/// Gauss-Legendre quadrature, to the last places for what is smooth within the pieces. With the
/// derivatives by whatever the law depends on, its breaks included.
template <class T, class F>
T cycle_mean(const Law<T>& law, const F& f) {
  T sum = number<T>(0);
  for (const Piece<T>& piece : law.pieces()) sum = sum + detail::piece_integral(piece, f);
  return sum;
}

}  // namespace camlaw::problems
