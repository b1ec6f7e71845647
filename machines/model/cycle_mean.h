// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "kinematics/expansion.h"
#include "machines/model/curve_formula.h"
#include "machines/model/enclosed_steps.h"
#include "machines/model/quadrature.h"

namespace camlaw::problems {
namespace detail {

/// At least this many steps over the whole law, and over each piece.
inline constexpr double kMeanSteps = 16, kMeanBoxes = 256;
inline constexpr int kLeastSteps = 2;

/// The steps in x = 1 with which no harmonic of a piece turns by more than two rad within a step,
/// so that its square, of twice the frequency, is integrated as well.
template <class T>
double harmonic_rate(const Piece<T>& piece) {
  // Ten places in a step integrate the square, which turns by 4 rad, to rounding.
  constexpr double kTurn = 2;
  double rate = 0;
  for (const auto& h : piece.harmonics) {
    rate = std::max(rate, std::abs(value_of(h.frequency)) / kTurn);
  }
  return rate;
}

/// As many steps as a piece needs: `whole` over the whole law, or as its harmonics need.
template <class T>
int steps_over(const Piece<T>& piece, double whole) {
  const double rate = std::max(whole, harmonic_rate(piece));
  const double length = value_of(piece.end) - value_of(piece.begin);
  return std::max(kLeastSteps, static_cast<int>(std::ceil(rate * length)));
}

/// The steps between two places of a piece, as many by length as the whole piece has.
template <class T>
void add_steps(const Piece<T>& piece, const T& begin, const T& end, std::size_t number_of_piece,
               std::vector<MeanStep<T>>& steps) {
  const double whole = value_of(piece.end) - value_of(piece.begin);
  const double share = whole > 0 ? value_of(T(end - begin)) / whole : 0;
  const int count = std::max(1, static_cast<int>(std::ceil(share * steps_over(piece, kMeanSteps))));
  add_even_steps(begin, end, count, number_of_piece, steps);
}

/// Those of a law between the places that breaks(piece's number) names, increasing.
template <class T, class Breaks>
std::vector<MeanStep<T>> mean_steps(const Law<T>& law, const Breaks& breaks) {
  std::vector<MeanStep<T>> steps;
  for (std::size_t p = 0; p < law.pieces().size(); ++p) {
    const Piece<T>& piece = law.pieces()[p];
    T begin = piece.begin;
    for (const T& place : breaks(p)) {
      add_steps(piece, begin, place, p, steps);
      begin = place;
    }
    add_steps(piece, begin, piece.end, p, steps);
  }
  return steps;
}

/// The integral of f(motion, x) over steps of a law.
template <class T, class F>
T integral_over(const Law<T>& law, const std::vector<MeanStep<T>>& steps, const F& f) {
  const auto integrand = [&](std::size_t piece, const T& x) {
    const auto d = derivatives<4>(law.pieces()[piece], x);
    return f(Motion<T>{d[0], d[1], d[2], d[3]}, x);
  };
  const auto evaluate = [&](std::span<const MeanStep<T>> at, const auto& take) {
    at_each_place(at, integrand, take);
  };
  return Quadrature<T>(steps, evaluate).sum();
}

/// What a piece and its derivatives are over a box: each bound is sharp where the other is not, the
/// first of a piece that rests.
inline std::array<Interval, kTaylorTerms + 3> derivatives_over(const Piece<Interval>& piece,
                                                               const PieceExpander& expander,
                                                               const Interval& box) {
  const Expansion motion = expander(box);
  auto all = derivatives<kTaylorTerms + 3>(piece, box);
  for (std::size_t k = 0; k < motion.over.size(); ++k) all[k] = both(all[k], motion.over[k]);
  if (piece.harmonics.empty()) return all;
  // Where a harmonic comes to rest its terms nearly cancel: each derivative changes by no more than
  // the next one over the box, which is small there.
  const Interval c(boost::numeric::median(box)), offset = box - c;
  const auto at = derivatives<kTaylorTerms + 3>(piece, c);
  for (std::size_t k = all.size() - 1; k-- > 0;) {
    all[k] = both(all[k], at[k] + all[k + 1] * offset);
  }
  return all;
}

/// Encloses, over even steps.
template <class F>
Interval piece_integral(const Piece<Interval>& piece, const F& f) {
  const PieceExpander expander(piece);
  const auto terms = [&](const Interval& c, const Interval& box) {
    const Interval one(1.0);
    using Terms = Series<Interval, kTaylorTerms>;
    return TaylorTerms{f(motion_series<kTaylorTerms>(derivatives<kTaylorTerms + 3>(piece, c)),
                         Terms::variable(c, one)),
                       f(motion_series<kTaylorTerms>(derivatives_over(piece, expander, box)),
                         Terms::variable(box, one))};
  };
  return enclosed_over(terms, piece.begin, piece.end, steps_over(piece, kMeanBoxes));
}

}  // namespace detail

/// (R3) The integral over x from 0 to 1 of f(motion, x) along a law by Gauss-Legendre quadrature
/// over steps that are halved until it is known to about 1e-11 of the integral of f's size, where f
/// is smooth within the pieces but at the places that breaks(piece's number) names, increasing.
/// With the derivatives by whatever the law depends on, its breaks included.
template <class T, class F, class Breaks>
T cycle_mean(const Law<T>& law, const F& f, const Breaks& breaks) {
  return detail::integral_over(law, detail::mean_steps(law, breaks), f);
}

/// An enclosure of the integral.
template <class F>
Interval enclosed_cycle_mean(const Law<Interval>& law, const F& f) {
  Interval sum(0.0);
  for (const Piece<Interval>& piece : law.pieces()) sum = sum + detail::piece_integral(piece, f);
  return sum;
}

}  // namespace camlaw::problems
