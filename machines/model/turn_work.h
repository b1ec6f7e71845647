// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

#include "machines/model/turn_sections.h"

/// The work of a torque over a turn beyond that of its mean, (SH4), in any scalar.
namespace camlaw::problems::detail {

/// f(torque, share) integrated over part of a section, the torque in any scalar.
template <class T, class F>
T weighted(const TurnSections<T>& turn, const typename TurnSections<T>::Section& section,
           const T& begin, const T& end, const F& f) {
  if constexpr (std::is_same_v<T, Interval>) {
    const auto terms = [&](const Interval& c, const Interval& box) {
      using Terms = Series<Interval, kTaylorTerms>;
      const TaylorTerms torque = turn.terms(section, c, box);
      return TaylorTerms{f(torque.at, Terms::variable(c, Interval(1.0))),
                         f(torque.over, Terms::variable(box, Interval(1.0)))};
    };
    const int steps = turn_steps(section.rate, value_of(end) - value_of(begin), kMeanBoxes);
    return enclosed_over(terms, begin, end, steps);
  } else {
    return turn_integral([&](const T& share) { return f(turn.at(section, share), share); }, begin,
                         end, section.rate);
  }
}

/// The torque itself, and the torque times 1/2 - share.
struct Plain {
  template <class X>
  X operator()(const X& torque, const X&) const {
    return torque;
  }
};
struct Levered {
  template <class X>
  X operator()(const X& torque, const X& share) const {
    return torque * (number<X>(0.5) - share);
  }
};

/// The mean torque over a turn, and where it is wanted its integral before each section.
template <class T>
T mean_of(const TurnSections<T>& turn, std::vector<T>* before = nullptr) {
  T sum = number<T>(0);
  for (const auto& section : turn.sections()) {
    if (before != nullptr) before->push_back(sum);
    sum = sum + weighted(turn, section, section.begin, section.end, Plain());
  }
  return sum;
}

/// What a turn adds up to: the mean torque, and the mean of its integral, less that of the mean.
template <class T>
struct Turned {
  T mean, level;
};
template <class T>
Turned<T> turned(const TurnSections<T>& turn, std::vector<T>* before = nullptr) {
  Turned<T> result{mean_of(turn, before), number<T>(0)};
  for (const auto& section : turn.sections()) {
    result.level = result.level + weighted(turn, section, section.begin, section.end, Levered());
  }
  return result;
}

/// From the integral of the torque over the share before a place.
template <class T>
T work_at(const Turned<T>& whole, const T& share, const T& before) {
  return number<T>(2) * pi<T>() * (before - share * whole.mean - whole.level);
}

/// A place within rounding of a section's end, as a share of the turn.
inline constexpr double kBesideEnd = 1e-14;

template <class T>
std::size_t section_at(const TurnSections<T>& turn, double share, bool from_left) {
  const auto& all = turn.sections();
  std::size_t k = 0;
  const auto is_beyond = [&](double end) {
    return from_left ? share > end + kBesideEnd : share >= end - kBesideEnd;
  };
  while (k + 1 < all.size() && is_beyond(value_of(all[k].end))) ++k;
  return k;
}

}  // namespace camlaw::problems::detail
