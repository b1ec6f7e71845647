// SPDX-License-Identifier: MIT
#include "machines/follower_train/turn_harmonics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "machines/follower_train/follower_train.h"
#include "machines/follower_train/law_boxes.h"
#include "machines/follower_train/resonances.h"

namespace camlaw {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::infinity();

Interval square_sum(const Interval& re, const Interval& im) {
  return sqrt(boost::numeric::square(re) + boost::numeric::square(im));
}

/// Sizes of G = r^2 / Q, of H = 1 + G and of their derivatives by ln r and zeta (U14).
struct TransferSizes {
  Interval h, g, by_log, by_damping, by_log_twice, by_both, by_damping_twice;
};

TransferSizes transfer_sizes(const Interval& r, const Interval& zeta) {
  const auto n = [](double x) { return Interval(x); };
  const Interval s = boost::numeric::square(r), cube = r * s, damped = n(2) * zeta * r;
  const Interval q = square_sum(n(1) - s, damped), q2 = q * q, q3 = q * q2;
  const Interval even = n(4) + n(4) * s * (n(1) - boost::numeric::square(zeta));
  const Interval odd = n(3) * damped + damped * s;
  return {.h = square_sum(n(1), damped) / q,
          .g = s / q,
          .by_log = s * square_sum(n(2), damped) / q2,
          .by_damping = n(2) * cube / q2,
          .by_log_twice = s * square_sum(even, odd) / q3,
          .by_both = n(2) * cube * square_sum(n(3) + s, damped) / q3,
          .by_damping_twice = n(8) * s * s / q3};
}

/// From r = 4 on such a size is at most stays + slow * / r + fast / r^2.
struct Falling {
  double stays, slow, fast;
};

/// The sum behind the last harmonic, of the k-th size at most most / k^power.
Interval rest_behind(const Falling& size, double most, int power, int last, double turns) {
  const auto rest = [&](int n) {  // of 1 / k^n
    const Interval k(last);
    Interval product(1.0);
    for (int i = 1; i < n; ++i) product *= k;
    return Interval(1.0) / (Interval(n - 1) * product);
  };
  Interval sum = Interval(size.slow) / Interval(turns) * rest(power + 1) +
                 Interval(size.fast) / boost::numeric::square(Interval(turns)) * rest(power + 2);
  if (size.stays > 0) sum += Interval(size.stays) * rest(power);
  return Interval(most) * sum;
}

/// a * b, where what does not matter may be without bound.
double product(double a, double b) { return a == 0 || b == 0 ? 0 : step_up(a * b); }

}  // namespace

TurnHarmonics::TurnHarmonics(const Law<Interval>& law)
    : law_(law), variation_(acceleration_variation(law)) {
  visit_boxes(law, [&](const Interval&, const Interval&, const auto& over) {
    for (std::size_t k = 0; k < most_.size(); ++k) {
      most_[k] = std::max(most_[k], magnitude(over[k]));
    }
  });
}

double TurnHarmonics::size(int k) const {
  const std::lock_guard lock(guard_);
  while (sizes_.size() < static_cast<std::size_t>(k)) {
    const Interval order(static_cast<double>(sizes_.size() + 1));
    const Interval turn = Interval(2.0) * pi<Interval>() * order;
    double least = std::min(most_[2], (Interval(variation_) / turn).upper());
    // (U1) of a train without damping, where the motion begins and ends at rest.
    const FollowerTrain<Interval> train{order, Interval(0.0)};
    if (const auto state = train.after(law_)) {
      const double exact = (turn * train.amplitude(*state)).upper();
      if (exact < least) least = exact;
    }
    sizes_.push_back(least);
  }
  return sizes_[static_cast<std::size_t>(k) - 1];
}

SteadyReach TurnHarmonics::reach(Steady which, const Interval& turns, const Interval& zeta) const {
  // From so many turns in a natural period on, a closed form bounds all harmonics.
  constexpr double kFar = 4;
  constexpr int kMost = 4000;  // harmonics: of a train with more of them nothing is said
  constexpr SteadyReach kNothing{kUnknown, kUnknown, kUnknown, kUnknown, kUnknown, kUnknown};
  const double slowest = turns.lower();
  if (!(slowest > kFar / kMost && zeta.lower() >= 0 && zeta.upper() < 1)) return kNothing;
  const int last = static_cast<int>(std::ceil(kFar / slowest)) + 1;
  const int whole = which == Steady::Acceleration ? 0 : which == Steady::Rate ? 1 : 2;
  const Interval two_pi = Interval(2.0) * pi<Interval>();
  std::array<Interval, 6> sums;
  sums.fill(Interval(0.0));
  for (int k = 1; k <= last; ++k) {
    const TransferSizes t = transfer_sizes(Interval(k) * turns, zeta);
    Interval c(size(k));
    for (int i = 0; i < whole; ++i) c = c / (two_pi * Interval(k));
    const Interval* const sizes[] = {whole == 0 ? &t.h : &t.g, &t.by_log,  &t.by_damping,
                                     &t.by_log_twice,          &t.by_both, &t.by_damping_twice};
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += c * *sizes[i];
  }
  Interval most(variation_);
  for (int i = 0; i <= whole; ++i) most = most / two_pi;
  const double z = zeta.upper();
  const Falling falling[] = {whole == 0 ? Falling{0, 2.2 * z, 1.1} : Falling{1.1, 0, 0},
                             {0, 2.3 * z, 2.3},
                             {0, 2.3, 0},
                             {0, 2.9 * z, 5.2},
                             {0, 4.2, 0},
                             {0, 0, 9.8}};
  std::array<double, 6> found{};
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const Interval rest = rest_behind(falling[i], most.upper(), whole + 1, last, slowest);
    found[i] = (Interval(2.0) * (sums[i] + rest)).upper();
    if (!(found[i] < kUnknown)) found[i] = kUnknown;
  }
  return {found[0], found[1], found[2], found[3], found[4], found[5]};
}

double bend_along(std::span<const SteadyTerm> terms, const Series<Interval, 3>& period_ratio,
                  const Series<Interval, 3>& damping_ratio) {
  // The logarithm of the turns in a natural period is -ln tau.
  const Series<Interval, 3> turns = log(period_ratio);
  const double log_slope = magnitude(turns.c[1]), log_bend = magnitude(turns.c[2]) * 2;
  const double slope = magnitude(damping_ratio.c[1]), bend = magnitude(damping_ratio.c[2]) * 2;
  double sum = 0;
  for (const SteadyTerm& term : terms) {
    const SteadyReach& y = term.of;
    const double first = product(y.by_log, log_slope) + product(y.by_damping, slope);
    const double second = product(y.by_log_twice, log_slope * log_slope) +
                          product(y.by_both, 2 * log_slope * slope) +
                          product(y.by_damping_twice, slope * slope) + product(y.by_log, log_bend) +
                          product(y.by_damping, bend);
    sum += product(magnitude(term.factor.c[2]) * 2, y.value) +
           product(magnitude(term.factor.c[1]) * 2, first) +
           product(magnitude(term.factor.c[0]), second);
  }
  constexpr double kRounding = 1 + 1e-12;  // of these few sums, all of numbers above 0
  return std::isnan(sum) ? kUnknown : kRounding * sum;
}

}  // namespace camlaw
