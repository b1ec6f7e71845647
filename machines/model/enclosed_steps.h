// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "machines/model/enclosed.h"

/// Integrals that are enclosed step by step (docs/theory.md, (R2)).
namespace camlaw::problems::detail {

/// Taylor terms of an integrand about a place, and over a whole step.
inline constexpr std::size_t kTaylorTerms = 7;
struct TaylorTerms {
  Series<Interval, kTaylorTerms> at, over;
};

/// A step from `begin` to `end` with the Taylor terms of an integrand f about its middle.
struct EnclosedStep {
  Interval begin, end, middle;
  TaylorTerms f;
  Interval integral = {};  ///< over the whole step

  /// (R2) The integral of f from the step's beginning to a place in it: by so many terms, the last
  /// one over the whole step; an odd number, so that the power of x - c in it has one sign.
  Interval by_terms(std::size_t count, const Interval& place) const {
    const Interval left = begin - middle, right = place - middle;
    Interval sum(0.0), from = left, to = right;
    for (std::size_t k = 0; k < count; ++k) {
      const Interval& term = k + 1 < count ? f.at.c[k] : f.over.c[k];
      sum += term * (to - from) / Interval(static_cast<double>(k + 1));
      from *= left, to *= right;
    }
    return sum;
  }
  /// What all of them bound, from the bound by most terms.
  Interval to(const Interval& place, Interval by_most) const {
    for (const std::size_t count : {3, 1}) by_most = both(by_most, by_terms(count, place));
    return by_most;
  }
  Interval to(const Interval& place) const { return to(place, by_terms(kTaylorTerms, place)); }
};

/// Whether both bounds are numbers.
inline bool is_bounded(const Interval& x) {
  return std::isfinite(x.lower()) && std::isfinite(x.upper());
}

/// So many even steps between two places of what terms(c, box) -> TaylorTerms has, c in the middle
/// of the box. A step is halved where f may have a kink, a jump or no bound, so that nearly all of
/// it is smooth; and where the last term leaves open more than a share of 1e-8 of the integral of
/// the size of f, as beside a pole.
template <class F>
class EnclosedSteps {
 public:
  EnclosedSteps(const F& terms, const Interval& begin, const Interval& end, int count)
      : terms_(terms) {
    const Interval length = end - begin;
    const auto edge = [&](int i) {
      return begin + length * Interval(double(i)) / Interval(double(count));
    };
    std::vector<EnclosedStep> even;
    for (int i = 0; i < count; ++i) {
      even.push_back(step(edge(i), edge(i + 1)));
      const double here = magnitude(even.back().f.at.c[0]);
      if (std::isfinite(here)) size_ += here / count;
    }
    all_.reserve(even.size());
    for (const EnclosedStep& one : even) add(one, kHalvings);
  }

  std::vector<EnclosedStep> all() && { return std::move(all_); }
  Interval sum() const { return sum_; }

 private:
  /// A jump is known to a part in 2^30 of a step, and a piece may have many.
  static constexpr int kHalvings = 30, kMostHalved = 2000;
  static constexpr double kLeftOpen = 1e-8;

  EnclosedStep step(const Interval& begin, const Interval& end) const {
    const Interval box = boost::numeric::hull(begin, end), c(boost::numeric::median(box));
    return {begin, end, c, terms_(c, box)};
  }
  void add(const EnclosedStep& one, int halvings) {
    const Interval by_most = one.by_terms(kTaylorTerms, one.end);
    const bool may_halve = halvings > 0 && halved_ < kMostHalved && is_bounded(sum_);
    if (may_halve && is_long(one, by_most)) {
      ++halved_;
      add(step(one.begin, one.middle), halvings - 1);
      add(step(one.middle, one.end), halvings - 1);
      return;
    }
    all_.push_back(one);
    all_.back().integral = one.to(one.end, by_most);
    sum_ = sum_ + all_.back().integral;
  }
  bool is_long(const EnclosedStep& one, const Interval& integral) const {
    if (!is_bounded(integral)) return true;
    const double length = value_of(one.end) - value_of(one.begin), half = length / 2;
    const double open = boost::numeric::width(integral);
    if (open <= kLeftOpen * size_ * length) return false;
    // What the other terms leave open does not become less.
    double last = 2 * boost::numeric::width(one.f.over.c.back()) / kTaylorTerms;
    for (std::size_t k = 0; k < kTaylorTerms; ++k) last *= half;
    return last > open / 4;
  }

  const F& terms_;
  double size_ = 0;  ///< the mean of that of f
  std::vector<EnclosedStep> all_;
  Interval sum_ = Interval(0.0);  ///< where one step has no bound, no other is halved
  int halved_ = 0;
};

/// The integral between two places over so many even steps, enclosed.
template <class F>
Interval enclosed_over(const F& terms, const Interval& begin, const Interval& end, int steps) {
  return EnclosedSteps(terms, begin, end, steps).sum();
}

}  // namespace camlaw::problems::detail
