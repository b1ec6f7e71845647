// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "kinematics/law.h"

/// Laws made from a formula's coefficients or from phases of acceleration. Where arguments may make
/// no law, the function makes a Possible<Law>; beside possible_NAME there is NAME for whoever asks
/// for just that law, which throws std::invalid_argument with the reason.
namespace camlaw {

/// The law of one polynomial s(x) = sum c[k] x^k on [0, 1]. Impossible where a coefficient is not
/// finite.
template <class T>
Possible<Law<T>> possible_polynomial_law(std::vector<T> coefficients, Ends ends = {}) {
  return Law<T>::possible(
      {{number<T>(0), number<T>(1), number<T>(0), std::move(coefficients), {}, {}}}, ends);
}

/// Throws std::invalid_argument where a coefficient is not finite.
template <class T>
Law<T> polynomial_law(std::vector<T> coefficients, Ends ends = {}) {
  return possible_polynomial_law(std::move(coefficients), ends).value();
}

/// The law of one curve, s(x) = curve(x).
template <class T>
Law<T> curve_law(PieceCurve<T> curve, Ends ends = {}) {
  const T zero = number<T>(0), one = number<T>(1);
  return Law<T>({{zero, one, zero, {}, {}, {{one, one, zero, std::move(curve)}}}}, ends);
}

/// Constants of a law that must add up to 1 may be printed ones: up to 0.1 % off they are taken and
/// scaled by the caller, beyond that it is said what `what` came to.
inline constexpr double kPrintedSum = 1e-3;
std::optional<Impossible> bad_sum(const char* what, double sum);

/// Twice integrated polynomial: s'' = sum a[k] t^k with s'(0) = v0, s(0) = s0.
template <class T>
std::vector<T> integrate_twice(const std::vector<T>& acceleration, const T& v0, const T& s0) {
  std::vector<T> result{s0, v0};
  for (std::size_t k = 0; k < acceleration.size(); ++k) {
    const double n = static_cast<double>(k);
    result.push_back(acceleration[k] / number<T>((n + 1) * (n + 2)));
  }
  return result;
}

/// One phase of an acceleration, t counted from the phase's begin:
///   s''(t) = sum polynomial[k] t^k + sine sin(frequency t) + cosine cos(frequency t).
/// Over the whole phase it adds mean * duration to the velocity, and lift * duration^2 to the
/// stroke that it covers from rest; a phase without duration has these alone, for its derivatives.
template <class T>
struct AccelerationPhase {
  T duration;
  T mean, lift;
  std::vector<T> polynomial;
  std::vector<Harmonic<T>> harmonics;
};

/// How far below zero a duration, or another room of a family (catalogue.h), counts as none.
inline constexpr double kLeastRoom = 1e-10;

/// Phases no longer than this are computed remainders of zero.
inline constexpr double kShortestPhase = 1e-12;

/// Joins phases from rest, continuous in displacement and velocity, and scales the whole to unit
/// stroke (docs/theory.md, "Laws from phases of acceleration"). Durations must add up to 1. A phase
/// without duration leaves no piece, but the derivatives by its duration are kept.
template <class T>
Possible<Law<T>> law_from_acceleration(const std::vector<AccelerationPhase<T>>& phases,
                                       Ends ends = {}) {
  std::vector<Piece<T>> pieces;
  T x = number<T>(0), v = number<T>(0), s = number<T>(0);
  for (const auto& phase : phases) {
    if (!(value_of(phase.duration) > kShortestPhase)) {
      const T d = phase.duration;
      s = s + v * d + phase.lift * d * d;
      v = v + phase.mean * d;
      x = x + d;
      continue;
    }
    Piece<T> piece{x, x + phase.duration, x, {}, {}, {}};
    T s0 = s, v0 = v;
    for (const auto& h : phase.harmonics) {
      const T w = h.frequency;
      piece.harmonics.push_back({-h.sine / (w * w), -h.cosine / (w * w), w});
      v0 = v0 + h.sine / w;
      s0 = s0 + h.cosine / (w * w);
    }
    piece.polynomial = integrate_twice(phase.polynomial, v0, s0);
    const auto d = derivatives<2>(piece, piece.end);
    s = d[0];
    v = d[1];
    x = piece.end;
    pieces.push_back(std::move(piece));
  }
  if (!pieces.empty()) pieces.back().end = number<T>(1);
  for (auto& piece : pieces) {
    for (T& c : piece.polynomial) c = c / s;
    for (auto& h : piece.harmonics) h = {h.sine / s, h.cosine / s, h.frequency};
  }
  return Law<T>::possible(std::move(pieces), ends);
}

}  // namespace camlaw
