// SPDX-License-Identifier: MIT
#include "benchmarks/speed/hand_laws.h"

#include <cmath>
#include <numbers>

namespace camlaw::benchmarks {
namespace {

constexpr double kPi = std::numbers::pi;

/// Plain pointers: through the spans of `out` the compiler would load them again at every point.
struct Curves {
  double *s, *v, *a, *j;
  explicit Curves(MotionSpans out)
      : s(out.s.data()), v(out.v.data()), a(out.a.data()), j(out.j.data()) {}
};

}  // namespace

void hand_poly_3_4_5(std::span<const double> x, MotionSpans out) {
  const Curves to(out);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double t = x[i], rest = 1 - t, both = t * rest;
    to.s[i] = t * t * t * (10 + t * (6 * t - 15));
    to.v[i] = 30 * both * both;
    to.a[i] = 60 * both * (rest - t);
    to.j[i] = 60 - 360 * both;
  }
}

void hand_poly_4_5_6_7(std::span<const double> x, MotionSpans out) {
  const Curves to(out);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double t = x[i], rest = 1 - t, both = t * rest, square = t * t;
    to.s[i] = square * square * (35 + t * (t * (70 - 20 * t) - 84));
    to.v[i] = 140 * both * both * both;
    to.a[i] = 420 * both * both * (rest - t);
    to.j[i] = 840 * both * (1 - 5 * both);
  }
}

void hand_cycloidal(std::span<const double> x, MotionSpans out) {
  const Curves to(out);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double angle = 2 * kPi * x[i];
    const double sine = std::sin(angle), cosine = std::cos(angle);
    to.s[i] = x[i] - sine / (2 * kPi);
    to.v[i] = 1 - cosine;
    to.a[i] = 2 * kPi * sine;
    to.j[i] = 4 * kPi * kPi * cosine;
  }
}

void hand_modified_sine(std::span<const double> x, MotionSpans out) {
  // Neklutin: sines of 4 pi x in the outer eighths, of 4 pi x / 3 between; VDI 2143's constants.
  constexpr double kScale = 1 / (4 + kPi);
  const Curves to(out);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double t = x[i];
    const bool outer = t < 0.125 || t >= 0.875;
    const double angle = outer ? 4 * kPi * t : (4 * kPi * t + kPi) / 3;
    const double sine = std::sin(angle), cosine = std::cos(angle);
    if (outer) {
      const double start = t < 0.5 ? 0 : 4;
      to.s[i] = kScale * (start + kPi * t - sine / 4);
      to.v[i] = kScale * kPi * (1 - cosine);
      to.a[i] = kScale * 4 * kPi * kPi * sine;
      to.j[i] = kScale * 16 * kPi * kPi * kPi * cosine;
    } else {
      to.s[i] = kScale * (2 + kPi * t - 2.25 * sine);
      to.v[i] = kScale * kPi * (1 - 3 * cosine);
      to.a[i] = kScale * 4 * kPi * kPi * sine;
      to.j[i] = kScale * (16.0 / 3) * kPi * kPi * kPi * cosine;
    }
  }
}

}  // namespace camlaw::benchmarks
