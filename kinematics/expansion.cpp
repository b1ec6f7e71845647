// SPDX-License-Identifier: MIT
#include "kinematics/expansion.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace camlaw {
namespace {

constexpr std::size_t kOrders = Expansion::kOrders;
/// Polynomials with more terms are enclosed by plain intervals, which are wider.
constexpr std::size_t kMostTerms = 16;
using Terms = std::array<double, kMostTerms>;

/// Half a unit in the last place of 1: the relative error of one operation.
constexpr double kHalfStep = std::numeric_limits<double>::epsilon() / 2;
/// Error bounds are sums and products of positive numbers, fewer than 100 roundings each: this
/// covers them, and kTiny what vanishes below the smallest numbers.
constexpr double kUpwards = 1 + 100 * kHalfStep;
constexpr double kTiny = 1e-300;

/// i (i - 1) ... (i - k + 1): the k-th derivative makes this many x^(i - k) of x^i.
constexpr auto kFallingPowers = [] {
  std::array<Terms, kOrders> table{};
  table[0].fill(1);
  for (int k = 1; k < static_cast<int>(kOrders); ++k) {
    for (int i = 0; i < static_cast<int>(kMostTerms); ++i) {
      table[k][i] = table[k - 1][i] * (i - k + 1);
    }
  }
  return table;
}();

/// From powers of t + by to powers of t.
void shift(Terms& c, std::size_t terms, double by) {
  for (std::size_t k = 0; k + 1 < terms; ++k) {
    for (std::size_t i = terms - 1; i-- > k;) c[i] += by * c[i + 1];
  }
}

}  // namespace

/// Derivatives at the middle, what they are wrong by at most, and how far they move within the
/// radius.
struct PieceExpander::Sums {
  double radius;
  std::array<double, kOrders> value{}, error{}, moved{};

  void add(std::size_t k, double term, double term_error, double term_moved) {
    value[k] += term;
    error[k] += term_error + kHalfStep * std::abs(value[k]);
    moved[k] += term_moved;
  }
  Interval at(std::size_t k) const { return around(k, error[k] * kUpwards + kTiny); }
  Interval over(std::size_t k) const { return around(k, (error[k] + moved[k]) * kUpwards + kTiny); }

 private:
  Interval around(std::size_t k, double by) const {
    return {step_down(value[k] - by), step_up(value[k] + by)};
  }
};

PieceExpander::Near::Near(const Interval& x)
    : value(boost::numeric::median(x)), error(magnitude(x - value)) {}

PieceExpander::PieceExpander(Piece<Interval> piece)
    : piece_(std::move(piece)), origin_(piece_.origin) {
  if (piece_.polynomial.size() <= kMostTerms) {
    for (const Interval& c : piece_.polynomial) polynomial_.emplace_back(c);
  }
  for (const auto& h : piece_.harmonics) {
    const double amplitude = std::hypot(magnitude(h.sine), magnitude(h.cosine)) * kUpwards;
    harmonics_.push_back({Near(h.sine), Near(h.cosine), Near(h.frequency), amplitude});
  }
}

void PieceExpander::add_polynomial(double t, double slack, Sums& sums) const {
  const std::size_t terms = polynomial_.size();
  Terms c, sizes, errors;
  // No path from a coefficient to a shifted one has more than 2 terms operations.
  const double rounding = static_cast<double>(2 * terms + 4) * kHalfStep;
  for (std::size_t i = 0; i < terms; ++i) {
    c[i] = polynomial_[i].value;
    sizes[i] = polynomial_[i].size();
    errors[i] = polynomial_[i].error + rounding * std::abs(c[i]);
  }
  const double reach = std::abs(t) + slack;
  shift(c, terms, t);
  shift(sizes, terms, reach);
  shift(errors, terms, reach);
  for (std::size_t i = 0; i + 1 < terms; ++i) {  // t itself is wrong by up to `slack`
    errors[i] += slack * static_cast<double>(i + 1) * sizes[i + 1];
  }
  for (std::size_t k = 0; k < std::min(kOrders, terms); ++k) {
    double moved = 0;
    for (std::size_t i = terms; i-- > k + 1;) {
      moved = moved * sums.radius + kFallingPowers[k][i] * (std::abs(c[i]) + errors[i]);
    }
    const double factorial = kFallingPowers[k][k];
    sums.add(k, factorial * c[k], factorial * errors[k] + kHalfStep * factorial * std::abs(c[k]),
             moved * sums.radius);
  }
}

void PieceExpander::add_harmonic(const NearHarmonic& h, double t, double slack, Sums& sums) const {
  const double w = h.frequency.value, bound = h.frequency.size();
  const double angle = w * t;
  const double angle_error =
      kHalfStep * std::abs(angle) + bound * slack + h.frequency.error * (std::abs(t) + slack);
  // glibc's sin and cos are right to a unit in the last place, at most 2 kHalfStep.
  const double sine = std::sin(angle), cosine = std::cos(angle);
  const double wobble = angle_error + 2 * kHalfStep;
  double a = h.sine.value, b = h.cosine.value, power = 1;
  std::array<double, kOrders + 1> d, errors;
  for (std::size_t k = 0; k <= kOrders; ++k) {
    const double order = static_cast<double>(k);
    const double relative = wobble + (order + 3) * kHalfStep + order * h.frequency.error / bound;
    d[k] = a * sine + b * cosine;
    errors[k] =
        power * ((h.sine.size() + h.cosine.size()) * relative + h.sine.error + h.cosine.error);
    const double next = -w * b;  // d/dt turns (a, b) into (-w b, w a)
    b = w * a;
    a = next;
    power *= bound;
  }
  power = h.amplitude;
  for (std::size_t k = 0; k < kOrders; ++k) {
    const double curved = power * bound * bound * sums.radius / 2;
    const double moved = sums.radius * (std::abs(d[k + 1]) + errors[k + 1] + curved);
    sums.add(k, d[k], errors[k], std::min(moved, 2 * power));
    power *= bound;
  }
}

/// What has no fast way: curves, and polynomials of many terms.
void PieceExpander::add_intervals(const Interval& x, Expansion& e) const {
  const Interval middle = Interval(e.middle) - piece_.origin, all = x - piece_.origin;
  if (polynomial_.empty()) {
    detail::add_polynomial(piece_.polynomial, middle, e.at);
    detail::add_polynomial(piece_.polynomial, all, e.over);
  }
  for (const auto& term : piece_.curves) {
    detail::add_curve(term, middle, e.at);
    detail::add_curve(term, all, e.over);
  }
}

Expansion PieceExpander::operator()(const Interval& x) const {
  Expansion e;
  e.middle = boost::numeric::median(x);
  e.radius = magnitude(x - e.middle);
  const double t = e.middle - origin_.value;
  const double slack = kHalfStep * std::abs(t) + origin_.error;
  Sums sums{.radius = e.radius};
  add_polynomial(t, slack, sums);
  for (const NearHarmonic& harmonic : harmonics_) add_harmonic(harmonic, t, slack, sums);
  for (std::size_t k = 0; k < kOrders; ++k) {
    e.at[k] = sums.at(k);
    e.over[k] = sums.over(k);
  }
  if (polynomial_.empty() || !piece_.curves.empty()) add_intervals(x, e);
  return e;
}

}  // namespace camlaw
