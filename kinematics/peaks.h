// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <limits>
#include <optional>

#include "kinematics/law.h"

/// Exact peaks of a law. No value here comes from sampling: every smooth piece is divided until a
/// bound closes each part, and the peaks that remain are polished to the last bits
/// (docs/theory.md, "Peaks").
namespace camlaw {

/// What a peak is of: s', s'', s''' or the dynamic moment s' s''.
enum class Quantity { Velocity, Acceleration, Jerk, Moment };
inline constexpr std::size_t kQuantities = 4;

/// A peak and the x where it is first reached (an end point of the set where it is a plateau).
template <class T>
struct Peak {
  T value;
  T position;
};

/// The peak constants of a law (VDI 2143: C_v, C_a, C_j, C_Mdyn).
///
/// A jump of s' makes the peaks of s'', s''' and s' s'' infinite in both directions, a jump of s''
/// those of s''': a pulse is bounded neither way. A jump counts inside the stretch, and at an end
/// that is declared a rest or a constant velocity (of s' at a reversal too); not where the motion
/// goes on (B).
template <class T>
struct Peaks {
  std::array<Peak<T>, kQuantities> highest;  ///< by Quantity, jumps counted
  std::array<Peak<T>, kQuantities> lowest;
  Peak<T> jerk_inside_highest;  ///< of the smooth pieces alone, jumps left out
  Peak<T> jerk_inside_lowest;
  Ends ends;

  const Peak<T>& high(Quantity q) const { return highest[static_cast<std::size_t>(q)]; }
  const Peak<T>& low(Quantity q) const { return lowest[static_cast<std::size_t>(q)]; }

  /// The peak of |quantity|: its value is not negative.
  Peak<T> absolute(Quantity q) const;
  T max_velocity() const { return absolute(Quantity::Velocity).value; }          ///< max |s'|
  T max_acceleration() const { return absolute(Quantity::Acceleration).value; }  ///< max |s''|
  T max_jerk() const { return absolute(Quantity::Jerk).value; }                  ///< max |s'''|
  T max_dynamic_moment() const { return absolute(Quantity::Moment).value; }      ///< max |s' s''|
};

/// Peaks of a law. With double: closed or bracketed to a relative error below 1e-12. With Dual and
/// Dual2: the derivatives by the law's parameters are exact too (a peak that moves with the
/// parameters is followed; at ties between two peaks, of the one found first). With Interval: each
/// value encloses the peak, no wider than 1e-9 of the quantity's largest size for laws whose
/// coefficients are points or of that accuracy; positions are those of the midpoint law. Intervals
/// are meant to be narrow (rounding of constants, 1e-8 at most): whether s'' jumps, and where the
/// crossover of an asymmetric law lies, is read off the midpoint law.
template <class T>
Peaks<T> peaks(const Law<T>& law);

/// First x at which s' or s'' jumps, where there is one.
struct Jumps {
  std::optional<double> velocity;
  std::optional<double> acceleration;
};
Jumps jumps(const Law<double>& law);

// ---------------------------------------------------------------------------------------------

namespace detail {

/// A piece's begin or end, a stationary point inside, or a point that was the highest seen where
/// the curve is flat beyond what doubles tell.
enum class Where { Begin, Stationary, End, Sample };

/// An extremum of the smooth pieces, as plain numbers.
struct Extremum {
  double value;
  double position;
  std::size_t piece;
  Where where;
};

template <class E>
struct Extrema {
  std::array<E, kQuantities> highest, lowest;
};

Extrema<Extremum> extrema(const Law<double>& law);
/// Enclosures of the same; `plain` is the midpoint law and `seeds` are its extrema.
Extrema<Interval> enclose_extrema(const Law<Interval>& law, const Law<double>& plain,
                                  const Extrema<Extremum>& seeds);

/// A quantity and its first two derivatives, from s', s'', s''', s'''', s''''' in d[1..5].
template <class R>
std::array<R, 3> quantity_from(Quantity q, const std::array<R, 6>& d) {
  if (q == Quantity::Moment) {
    return {d[1] * d[2], d[2] * d[2] + d[1] * d[3], number<R>(3) * d[2] * d[3] + d[1] * d[4]};
  }
  const std::size_t k = 1 + static_cast<std::size_t>(q);
  return {d[k], d[k + 1], d[k + 2]};
}

/// v a where v vanishes as a grows without bound: the half-ellipse of velocity alone has this, and
/// its product is linear. Empty for every other piece.
template <class T, class X, class R = Joined<T, X>>
std::optional<R> closed_moment(const Piece<T>& piece, const X& x) {
  if (piece.curves.size() != 1 || !piece.harmonics.empty()) return {};
  const auto& term = piece.curves.front();
  const auto* arc = std::get_if<HalfEllipse<T>>(&term.curve);
  if (arc == nullptr || arc->integrations != 1) return {};
  for (std::size_t k = 1; k < piece.polynomial.size(); ++k) {
    if (!is_number(piece.polynomial[k], 0)) return {};
  }
  const R rate = convert<R>(term.rate);
  const R scale = convert<R>(term.amplitude) * rate;
  const R y = rate * (convert<R>(x) - convert<R>(piece.origin)) + convert<R>(term.shift);
  return -(scale * scale * rate * y);
}

/// The extremum followed in the scalar T. Its plain place stays; the dual part follows from
/// Newton's method on the derivative, two steps, which makes first and second derivatives right. At
/// a flat peak the place is not followed: the value's first derivative does not need it.
template <class T>
Peak<T> follow(const Law<T>& law, Quantity q, const Extremum& e) {
  const Piece<T>& piece = law.pieces()[e.piece];
  T x = e.where == Where::Begin ? piece.begin
        : e.where == Where::End ? piece.end
                                : number<T>(e.position);
  if (q == Quantity::Moment) {
    if (const auto moment = closed_moment(piece, x)) return {*moment, x};
  }
  auto f = quantity_from(q, camlaw::derivatives<6>(piece, x));
  // Of the value: Newton's quotient has no digits where the second derivative has none.
  constexpr double kFlat = 1e-8;
  const double size = std::max(1.0, std::abs(value_of(f[0])));
  const bool moves = e.where == Where::Stationary && std::abs(value_of(f[2])) > kFlat * size;
  for (int step = 0; step < 2 && moves; ++step) {
    x = x - (f[1] - number<T>(value_of(f[1]))) / f[2];
    f = quantity_from(q, camlaw::derivatives<6>(piece, x));
  }
  return {f[0], x};
}

/// Writes the infinities that jumps bring.
template <class T>
void count_jumps(Peaks<T>& result, const Jumps& found) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto unbounded = [&](Quantity q, double at) {
    const auto i = static_cast<std::size_t>(q);
    result.highest[i] = {number<T>(kInfinity), number<T>(at)};
    result.lowest[i] = {number<T>(-kInfinity), number<T>(at)};
  };
  if (found.velocity) {
    unbounded(Quantity::Acceleration, *found.velocity);
    unbounded(Quantity::Moment, *found.velocity);
    unbounded(Quantity::Jerk, *found.velocity);
  } else if (found.acceleration) {
    unbounded(Quantity::Jerk, *found.acceleration);
  }
}

}  // namespace detail

template <class T>
Peak<T> Peaks<T>::absolute(Quantity q) const {
  const Peak<T>& up = high(q);
  const Peak<T>& down = low(q);
  if constexpr (std::is_same_v<T, Interval>) {
    const Interval value(std::max({0.0, up.value.lower(), -down.value.upper()}),
                         std::max({0.0, up.value.upper(), -down.value.lower()}));
    return {value, value_of(up.value) >= -value_of(down.value) ? up.position : down.position};
  }
  if (value_of(up.value) >= -value_of(down.value)) return up;
  return {-down.value, down.position};
}

template <class T>
Peaks<T> peaks(const Law<T>& law) {
  const Law<double> plain = law.template as<double>();
  const auto found = detail::extrema(plain);
  Peaks<T> result;
  result.ends = law.ends();
  for (std::size_t i = 0; i < kQuantities; ++i) {
    const auto q = static_cast<Quantity>(i);
    result.highest[i] = detail::follow(law, q, found.highest[i]);
    result.lowest[i] = detail::follow(law, q, found.lowest[i]);
  }
  result.jerk_inside_highest = result.high(Quantity::Jerk);
  result.jerk_inside_lowest = result.low(Quantity::Jerk);
  detail::count_jumps(result, jumps(plain));
  return result;
}

template <>
Peaks<double> peaks(const Law<double>& law);
template <>
Peaks<Interval> peaks(const Law<Interval>& law);

// What is physically possible: the rulers that laws are measured with. Proofs: docs/theory.md,
// "Analytic limits".

/// Least peak acceleration C of any rest-to-rest law whose peak velocity is at most B: B^2 / (B -
/// 1) up to B = 2, 4 beyond. Infinite for B <= 1, which no such law reaches.
double least_acceleration(double B);

/// Least time of any rest-to-rest motion over unit stroke with peaks no larger than B, C and D,
/// each of which may be infinite: 1/B + B/C + C/D where C/D <= B/C and B/C + C/D <= 1/B, and the
/// time of the S-curve that does without the phases it cannot reach elsewhere.
double least_time(double B, double C, double D);

/// Least peak jerk D of any rest-to-rest law whose peaks of velocity and acceleration are at most B
/// and C, each of which may be infinite: with b = min(B, 2) and c = min(C, 2 b^2 / (b - 1)) it is
/// b c^2 / (c (b - 1) - b^2), where least_time(B, C, D) = 1. Infinite where C <=
/// least_acceleration.
double least_jerk(double B, double C);

/// Least peak |s' s''| of any rest-to-rest law whose peaks of velocity and acceleration are at most
/// B and C, each of which may be infinite: 9/4 without either, B^3 / (3 (B - 1)) for B <= 3/2 and
/// no C (D8). Infinite where no law has such peaks.
double least_dynamic_moment(double B, double C);

/// What peaks a law may have: each infinite where it is not limited.
struct PeakLimits {
  double velocity = std::numeric_limits<double>::infinity();
  double acceleration = std::numeric_limits<double>::infinity();
  double jerk = std::numeric_limits<double>::infinity();
};

/// The one of a quantity; null of the moment.
double* limit_among(PeakLimits& limits, Quantity quantity);

/// Least peak of a quantity of any rest-to-rest law with such peaks, rounded down: the least value
/// of it for which least_time(B, C, D) is 1, and of the moment least_dynamic_moment(B, C). What is
/// said of the quantity itself among the limits does not count. Infinite where no law has such
/// peaks.
double least_peak(Quantity quantity, PeakLimits limits);

/// The limit index lambda = least_time(B, C, D) of a law's own peaks: 1 for a law than which none
/// is faster with these peaks, less for every other. Only rest-to-rest laws have it.
std::optional<double> limit_index(const Peaks<double>& peaks);

}  // namespace camlaw
