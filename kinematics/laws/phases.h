// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/laws/build.h"

/// Laws laid together from phases of acceleration. Equations: docs/theory.md, "Laws from phases of
/// acceleration".
namespace camlaw {

namespace detail {

/// Whether a phase lasts; the frequency and slope of one that does not have no value.
template <class T>
bool lasts(const T& duration) {
  return value_of(duration) > kShortestPhase;
}

/// `level` times the rising quarter of a sine.
template <class T>
AccelerationPhase<T> quarter_sine(const T& duration, const T& level) {
  const T share = number<T>(2) / pi<T>();
  AccelerationPhase<T> phase{
      duration, level * share, level * share * (number<T>(1) - share), {}, {}};
  if (lasts(duration)) {
    phase.harmonics = {{level, number<T>(0), pi<T>() / (number<T>(2) * duration)}};
  }
  return phase;
}

/// `level` times the falling quarter of a cosine.
template <class T>
AccelerationPhase<T> quarter_cosine(const T& duration, const T& level) {
  const T share = number<T>(2) / pi<T>();
  AccelerationPhase<T> phase{duration, level * share, level * share * share, {}, {}};
  if (lasts(duration)) {
    phase.harmonics = {{number<T>(0), level, pi<T>() / (number<T>(2) * duration)}};
  }
  return phase;
}

/// Acceleration that goes straight from one value to another.
template <class T>
AccelerationPhase<T> ramp(const T& duration, const T& from, const T& to) {
  const T lift = from / number<T>(3) + to / number<T>(6);
  AccelerationPhase<T> phase{duration, (from + to) / number<T>(2), lift, {}, {}};
  if (lasts(duration)) phase.polynomial = {from, (to - from) / duration};
  return phase;
}

template <class T>
AccelerationPhase<T> constant(const T& duration, const T& level) {
  return {duration, level, level / number<T>(2), {level}, {}};
}

/// Why seven phases of such durations make no law, if so.
std::optional<Impossible> bad_durations(std::span<const double> durations);

template <class T>
std::optional<Impossible> bad_durations(const std::vector<T>& durations) {
  std::vector<double> plain;
  for (const T& d : durations) plain.push_back(value_of(d));
  return bad_durations(std::span<const double>(plain));
}

}  // namespace detail

/// Makino's universal cam curve: seven phases of the given durations - quarter sine up, constant,
/// quarter cosine down, nothing, and the same below zero. The two acceleration levels follow from
/// rest at the end and unit stroke. Impossible unless there are seven durations, none negative,
/// that add up to 1, and both halves accelerate.
template <class T>
Possible<Law<T>> possible_universal(const std::vector<T>& d) {
  if (d.size() != 7) return Impossible{"universal: seven durations are needed"};
  if (auto fault = detail::bad_durations(d)) return std::move(*fault);
  const T quarter = number<T>(2) / pi<T>();  // mean of a quarter sine
  const T up = quarter * (d[0] + d[2]) + d[1];
  const T down = quarter * (d[4] + d[6]) + d[5];
  const T rise = number<T>(1), fall = -(up / down);
  return law_from_acceleration<T>({detail::quarter_sine(d[0], rise), detail::constant(d[1], rise),
                                   detail::quarter_cosine(d[2], rise),
                                   detail::constant(d[3], number<T>(0)),
                                   detail::quarter_sine(d[4], fall), detail::constant(d[5], fall),
                                   detail::quarter_cosine(d[6], fall)});
}

/// Sine-constant-cosine acceleration. a, b, c are fractions of the whole stretch over both halves:
/// acceleration rises for a/2, stays for b/2, falls for c/2, is zero for 1 - a - b - c, and
/// mirrors.
template <class T>
Possible<Law<T>> possible_scca(const T& a, const T& b, const T& c) {
  const T two = number<T>(2);
  return possible_universal<T>(
      {a / two, b / two, c / two, number<T>(1) - a - b - c, c / two, b / two, a / two});
}

/// Constant acceleration for t1, constant velocity, constant deceleration for the last t2.
template <class T>
Possible<Law<T>> possible_trapezoidal_velocity(const T& t1, const T& t2) {
  const T cruise = number<T>(1) - t1 - t2;
  if (auto fault = detail::bad_durations<T>(
          {t1, number<T>(0), number<T>(0), cruise, t2, number<T>(0), number<T>(0)})) {
    return std::move(*fault);
  }
  return law_from_acceleration<T>({detail::constant(t1, number<T>(1)),
                                   detail::constant(cruise, number<T>(0)),
                                   detail::constant(t2, -(t1 / t2))});
}

/// Seven phases with straight acceleration ramps: up for `ramp`, constant, down for `ramp`,
/// constant velocity, and the same below zero; constant velocity takes what the others leave.
template <class T>
Possible<Law<T>> possible_trapezoidal_acceleration(const T& ramp, const T& constant) {
  const T one = number<T>(1), zero = number<T>(0);
  const T cruise = one - number<T>(4) * ramp - number<T>(2) * constant;
  if (auto fault = detail::bad_durations<T>({ramp, constant, ramp, cruise, ramp, constant, ramp})) {
    return std::move(*fault);
  }
  return law_from_acceleration<T>({detail::ramp(ramp, zero, one), detail::constant(constant, one),
                                   detail::ramp(ramp, one, zero), detail::constant(cruise, zero),
                                   detail::ramp(ramp, zero, -one), detail::constant(constant, -one),
                                   detail::ramp(ramp, -one, zero)});
}

/// The seven-phase S-curve with peaks B, C, D, which must satisfy 1/B + B/C + C/D = 1 (the law
/// takes exactly its stretch). Peaks that meet it within 0.1 %, as printed ones do, have their
/// phases scaled onto it; others are impossible, as are peaks that leave no room for a phase
/// (C / D <= B / C, and B no more than is reached).
template <class T>
Possible<Law<T>> possible_s_curve(const T& B, const T& C, const T& D) {
  const T total = number<T>(1) / B + B / C + C / D;
  if (auto fault = bad_sum("1/B + B/C + C/D", value_of(total))) return std::move(*fault);
  return possible_trapezoidal_acceleration<T>(C / D / total, (B / C - C / D) / total);
}

/// These throw std::invalid_argument where arguments make no law.
template <class T>
Law<T> universal(const std::vector<T>& d) {
  return possible_universal(d).value();
}

template <class T>
Law<T> scca(const T& a, const T& b, const T& c) {
  return possible_scca(a, b, c).value();
}

template <class T>
Law<T> trapezoidal_velocity(const T& t1, const T& t2) {
  return possible_trapezoidal_velocity(t1, t2).value();
}

template <class T>
Law<T> trapezoidal_acceleration(const T& ramp, const T& constant) {
  return possible_trapezoidal_acceleration(ramp, constant).value();
}

template <class T>
Law<T> s_curve(const T& B, const T& C, const T& D) {
  return possible_s_curve(B, C, D).value();
}

/// The modified sine family and its kin: a member of scca by numerators over one denominator.
template <class T>
Law<T> scca_of(double a, double b, double c, double denominator) {
  return scca<T>(ratio<T>(a, denominator), ratio<T>(b, denominator), ratio<T>(c, denominator));
}

/// s = 2 x^2, then its mirror image: constant acceleration and deceleration.
template <class T>
Law<T> parabolic() {
  return trapezoidal_velocity<T>(ratio<T>(1, 2), ratio<T>(1, 2));
}

}  // namespace camlaw
