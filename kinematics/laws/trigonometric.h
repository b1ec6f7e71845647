// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/laws/build.h"

/// Laws of sines and cosines over the whole stretch. Equations: docs/theory.md, "Harmonic laws".
namespace camlaw {

/// s = sum polynomial[k] x^k + harmonics on [0, 1].
template <class T>
Law<T> harmonic_law(std::vector<T> polynomial, std::vector<Harmonic<T>> harmonics, Ends ends = {}) {
  const T zero = number<T>(0);
  return Law<T>({{zero, number<T>(1), zero, std::move(polynomial), std::move(harmonics), {}}},
                ends);
}

/// Cosine of acceleration: s = (1 - cos(pi x)) / 2.
template <class T>
Law<T> cosine(Ends ends = {}) {
  return harmonic_law<T>({ratio<T>(1, 2)}, {{number<T>(0), ratio<T>(-1, 2), pi<T>()}}, ends);
}

/// The same curve from turn to turn.
template <class T>
Law<T> harmonic() {
  return cosine<T>({End::Reversal, End::Reversal});
}

/// s = [(1 - cos(pi x)) - (1 - cos(2 pi x)) / 4] / 2, dwell to turn.
template <class T>
Law<T> double_harmonic() {
  const T zero = number<T>(0);
  return harmonic_law<T>(
      {ratio<T>(3, 8)},
      {{zero, ratio<T>(-1, 2), pi<T>()}, {zero, ratio<T>(1, 8), number<T>(2) * pi<T>()}},
      {End::Rest, End::Reversal});
}

/// s = x - sum a[n-1] sin(2 pi n x) / (2 pi n). The stretch starts and ends at rest when the a add
/// up to 1; the caller sees to that.
template <class T>
Law<T> sine_series(const std::vector<T>& a) {
  std::vector<Harmonic<T>> harmonics;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (is_number(a[i], 0)) continue;
    const T frequency = number<T>(2.0 * static_cast<double>(i + 1)) * pi<T>();
    harmonics.push_back({-a[i] / frequency, number<T>(0), frequency});
  }
  return harmonic_law<T>({number<T>(0), number<T>(1)}, std::move(harmonics));
}

/// Sine of acceleration, the cycloid: s = x - sin(2 pi x) / (2 pi).
template <class T>
Law<T> cycloidal() {
  return sine_series<T>({number<T>(1)});
}

/// Fourier sine series with a_1 = 1 - sum of the given a_2, a_3, ..., so that the ends are at rest.
template <class T>
Law<T> fourier(const std::vector<T>& higher) {
  std::vector<T> a{number<T>(1)};
  for (const T& next : higher) {
    a.front() = a.front() - next;
    a.push_back(next);
  }
  return sine_series(a);
}

/// Freudenstein's low-harmonic law of the first and third harmonic.
template <class T>
Law<T> freudenstein_1_3() {
  return fourier<T>({number<T>(0), ratio<T>(1, 28)});
}

/// Freudenstein's law of the first, third and fifth harmonic: shares 1125 (1, 1/18, 1/250) / 1192.
template <class T>
Law<T> freudenstein_1_3_5() {
  const T zero = number<T>(0);
  return fourier<T>({zero, ratio<T>(1125, 1192.0 * 18), zero, ratio<T>(1125, 1192.0 * 250)});
}

/// Gutman's law: s = x - 15 / (32 pi) sin(2 pi x) - 1 / (96 pi) sin(6 pi x).
template <class T>
Law<T> gutman_1_3() {
  return fourier<T>({number<T>(0), ratio<T>(1, 16)});
}

/// s'' = h1 sin(2 pi x) + h2 sin(4 pi x) + h3 sin(6 pi x). Rest and unit stroke need
/// h1 / (2 pi) + h2 / (4 pi) + h3 / (6 pi) = 1. Constants that meet it within 0.1 %, as printed
/// ones do, are scaled onto it; others are impossible, with what the sum is.
template <class T>
Possible<Law<T>> possible_triple_harmonic(const T& h1, const T& h2, const T& h3) {
  const T two_pi = number<T>(2) * pi<T>();
  std::vector<T> a{h1 / two_pi, h2 / (number<T>(2) * two_pi), h3 / (number<T>(3) * two_pi)};
  const T sum = a[0] + a[1] + a[2];
  if (auto fault = bad_sum("h1 / (2 pi) + h2 / (4 pi) + h3 / (6 pi)", value_of(sum))) {
    return std::move(*fault);
  }
  for (T& share : a) share = share / sum;
  return sine_series(a);
}

/// Throws std::invalid_argument where the levels make no law.
template <class T>
Law<T> triple_harmonic(const T& h1, const T& h2, const T& h3) {
  return possible_triple_harmonic(h1, h2, h3).value();
}

}  // namespace camlaw
