// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "kinematics/expansion.h"
#include "machines/model/curve_formula.h"
#include "machines/model/enclosed.h"
#include "numerics/polynomial/gauss_legendre.h"

namespace camlaw::problems {
namespace detail {

/// At least this many steps over the whole law, and over each piece.
inline constexpr double kMeanSteps = 16, kMeanBoxes = 256;
inline constexpr int kLeastSteps = 2;

/// The steps in x = 1 with which no harmonic of a piece turns by more than two rad within a step,
/// so that its square, of twice the frequency, is integrated as well.
template <class T>
double harmonic_rate(const Piece<T>& piece) {
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

/// Calls at(x, weight) for the places of Gauss-Legendre of 10 points on so many even steps.
template <class T, class At>
void each_mean_place(const T& begin, const T& end, int steps, const At& at) {
  const auto& [places, weights] = gauss_legendre(10);
  const T half = (end - begin) / number<T>(2.0 * steps);
  for (int i = 0; i < steps; ++i) {
    const T middle = begin + number<T>(2 * i + 1) * half;
    for (std::size_t k = 0; k < places.size(); ++k) {
      for (const double side : {-1.0, 1.0}) {
        at(T(middle + number<T>(side * places[k]) * half), T(number<T>(weights[k]) * half));
      }
    }
  }
}

/// The same between two places of a piece, on as many steps by length as the whole piece has.
template <class T, class At>
void each_mean_place(const Piece<T>& piece, const T& begin, const T& end, const At& at) {
  const double whole = value_of(piece.end) - value_of(piece.begin);
  const double share = whole > 0 ? value_of(T(end - begin)) / whole : 0;
  const int steps = std::max(1, static_cast<int>(std::ceil(share * steps_over(piece, kMeanSteps))));
  each_mean_place(begin, end, steps, at);
}

/// Calls at(piece, x, weight) for those of a law between the places that breaks(piece's number)
/// names, increasing.
template <class T, class Breaks, class At>
void each_mean_place(const Law<T>& law, const Breaks& breaks, const At& at) {
  for (std::size_t p = 0; p < law.pieces().size(); ++p) {
    const Piece<T>& piece = law.pieces()[p];
    const auto in_piece = [&](const T& x, const T& weight) { at(piece, x, weight); };
    T begin = piece.begin;
    for (const T& place : breaks(p)) {
      each_mean_place(piece, begin, place, in_piece);
      begin = place;
    }
    each_mean_place(piece, begin, piece.end, in_piece);
  }
}

/// f(motion, x) at a place of a piece.
template <class T, class F>
T at_mean_place(const Piece<T>& piece, const T& x, const F& f) {
  const auto d = derivatives<4>(piece, x);
  return f(Motion<T>{d[0], d[1], d[2], d[3]}, x);
}

template <class T, class F>
T piece_integral(const Piece<T>& piece, const F& f) {
  T sum = number<T>(0);
  each_mean_place(piece, piece.begin, piece.end, [&](const T& x, const T& weight) {
    sum = sum + weight * at_mean_place(piece, x, f);
  });
  return sum;
}

/// Taylor terms of an integrand about a place, and over a whole step.
inline constexpr std::size_t kTaylorTerms = 7;
struct TaylorTerms {
  Series<Interval, kTaylorTerms> at, over;
};

/// Encloses the integral over steps of what terms(c, box) -> TaylorTerms has, c in the middle of
/// the box. Where it may have a kink or a jump a step is halved, so that nearly all of it is
/// smooth.
template <class F>
class StepEnclosure {
 public:
  explicit StepEnclosure(const F& terms) : terms_(terms) {}

  /// (R2) From the Taylor terms of f about the middle c of the step from a to b, the last one over
  /// the whole step.
  Interval operator()(const Interval& a, const Interval& b, int halvings = kHalvings) {
    const Interval box = boost::numeric::hull(a, b), c(boost::numeric::median(box));
    const Interval left = a - c, right = b - c;
    const TaylorTerms f = terms_(c, box);
    // By so many terms, an odd number, so that the power of x - c in the last one has one sign.
    const auto by_terms = [&](std::size_t terms) {
      Interval sum(0.0), from = left, to = right;
      for (std::size_t k = 0; k < terms; ++k) {
        const Interval& term = k + 1 < terms ? f.at.c[k] : f.over.c[k];
        sum += term * (to - from) / Interval(static_cast<double>(k + 1));
        from *= left, to *= right;
      }
      return sum;
    };
    Interval result = by_terms(kTaylorTerms);
    const bool may_halve = halvings > 0 && halved_ < kMostHalved && is_bounded(f.over.c[0]);
    if (!is_bounded(result) && may_halve) {
      ++halved_;
      return (*this)(a, c, halvings - 1) + (*this)(c, b, halvings - 1);
    }
    for (const std::size_t terms : {3, 1}) result = both(result, by_terms(terms));
    return result;
  }

 private:
  /// A jump is known to a part in 2^30 of a step, and a piece may have many.
  static constexpr int kHalvings = 30, kMostHalved = 2000;
  static bool is_bounded(const Interval& x) {
    return std::isfinite(x.lower()) && std::isfinite(x.upper());
  }

  const F& terms_;
  int halved_ = 0;
};

/// What a piece and its derivatives are over a box: each bound is sharp where the other is not, the
/// first of a piece that rests.
inline std::array<Interval, kTaylorTerms + 3> derivatives_over(const Piece<Interval>& piece,
                                                               const PieceExpander& expander,
                                                               const Interval& box) {
  const Expansion motion = expander(box);
  auto all = derivatives<kTaylorTerms + 3>(piece, box);
  for (std::size_t k = 0; k < motion.over.size(); ++k) all[k] = both(all[k], motion.over[k]);
  return all;
}

/// The integral between two places over so many even steps, enclosed.
template <class F>
Interval enclosed_over(const F& terms, const Interval& begin, const Interval& end, int steps) {
  StepEnclosure step(terms);
  const Interval length = end - begin;
  const auto edge = [&](int i) {
    return begin + length * Interval(double(i)) / Interval(double(steps));
  };
  Interval sum(0.0);
  for (int i = 0; i < steps; ++i) sum = sum + step(edge(i), edge(i + 1));
  return sum;
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

/// The integral over x from 0 to 1 of f(motion, x) along a law by Gauss-Legendre quadrature, to the
/// last places for what is smooth within the pieces but at the places that breaks(piece's number)
/// names, increasing. With the derivatives by whatever the law depends on, its breaks included.
template <class T, class F, class Breaks>
T cycle_mean(const Law<T>& law, const F& f, const Breaks& breaks) {
  T sum = number<T>(0);
  detail::each_mean_place(law, breaks, [&](const Piece<T>& piece, const T& x, const T& weight) {
    sum = sum + weight * detail::at_mean_place(piece, x, f);
  });
  return sum;
}

/// The places and weights of that quadrature, for an integrand that is evaluated at all together.
struct MeanPlaces {
  std::vector<double> x, weights;
};

template <class Breaks>
MeanPlaces mean_places(const Law<double>& law, const Breaks& breaks) {
  MeanPlaces all;
  detail::each_mean_place(law, breaks, [&](const Piece<double>&, double x, double weight) {
    all.x.push_back(x);
    all.weights.push_back(weight);
  });
  return all;
}

/// An enclosure of the integral.
template <class F>
Interval enclosed_cycle_mean(const Law<Interval>& law, const F& f) {
  Interval sum(0.0);
  for (const Piece<Interval>& piece : law.pieces()) sum = sum + detail::piece_integral(piece, f);
  return sum;
}

}  // namespace camlaw::problems
