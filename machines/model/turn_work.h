// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

#include "machines/model/turn_sections.h"

/// The work of a torque over a turn beyond that of its mean, (SH4), in any scalar.
namespace camlaw::problems::detail {

/// The torque over part of a section, step by step.
inline std::vector<EnclosedStep> enclosed_torque(const TurnSections<Interval>& turn,
                                                 const TurnSections<Interval>::Section& section,
                                                 const Interval& end) {
  const auto terms = [&](const Interval& c, const Interval& box) {
    return turn.terms(section, c, box);
  };
  const double length = value_of(end) - value_of(section.begin);
  const int steps = turn_steps(section.rate, length, kMeanBoxes);
  return EnclosedSteps(terms, section.begin, end, steps).all();
}

/// The integral over a step of the torque times 1/2 - share.
inline Interval levered(const EnclosedStep& step) {
  using Terms = Series<Interval, kTaylorTerms>;
  const Interval one(1.0), box = boost::numeric::hull(step.begin, step.end);
  const auto times_lever = [&](const Terms& torque, const Interval& share) {
    return torque * (number<Terms>(0.5) - Terms::variable(share, one));
  };
  const TaylorTerms product{times_lever(step.f.at, step.middle), times_lever(step.f.over, box)};
  return EnclosedStep{step.begin, step.end, step.middle, product}.to(step.end);
}

/// The torque at the places of a quadrature; `size` is the integral of its size over the turn.
template <Lever kLever = Lever::None, class T>
Quadrature<T, kLever> torque_over(const TurnSections<T>& turn,
                                  const std::vector<MeanStep<T>>& steps, double size = 0) {
  const auto torque = [&](std::size_t section, const T& share) {
    return turn.at(turn.sections()[section], share);
  };
  const auto evaluate = [&](std::span<const MeanStep<T>> at, const auto& take) {
    at_each_place(at, torque, take);
  };
  return Quadrature<T, kLever>(steps, evaluate, size);
}
template <Lever kLever = Lever::None, class T>
Quadrature<T, kLever> torque_over(const TurnSections<T>& turn) {
  std::vector<MeanStep<T>> steps;
  for (std::size_t k = 0; k < turn.sections().size(); ++k) {
    const auto& section = turn.sections()[k];
    add_turn_steps(section.begin, section.end, section.rate, k, steps);
  }
  return torque_over<kLever>(turn, steps);
}

/// The mean torque over a turn.
template <class T>
T mean_of(const TurnSections<T>& turn) {
  return torque_over(turn).sum();
}
inline Interval mean_of(const TurnSections<Interval>& turn) {
  Interval sum(0.0);
  for (const auto& section : turn.sections()) {
    for (const EnclosedStep& step : enclosed_torque(turn, section, section.end)) {
      sum = sum + step.integral;
    }
  }
  return sum;
}

/// What a turn adds up to: the mean torque, and the mean of its integral, less that of the mean;
/// the integral of the torque before each section; in plain and dual numbers that of its size over
/// the turn.
template <class T>
struct Turned {
  T mean, level;
  std::vector<T> before = {};
  double size = 0;
};
template <class T>
Turned<T> turned(const TurnSections<T>& turn) {
  Turned<T> result{number<T>(0), number<T>(0)};
  const auto torque = torque_over<Lever::AboutMiddle>(turn);
  for (const auto& [step, integral, levered, error, size] : torque.steps()) {
    while (result.before.size() <= step.section) result.before.push_back(result.mean);
    result.mean = result.mean + integral;
    result.level = result.level + (number<T>(0.5) - step.middle) * integral - levered;
  }
  result.size = torque.size();
  return result;
}
/// The steps of each section are added to `steps`.
inline Turned<Interval> turned(const TurnSections<Interval>& turn,
                               std::vector<std::vector<EnclosedStep>>& steps) {
  Turned<Interval> result{Interval(0.0), Interval(0.0)};
  for (const auto& section : turn.sections()) {
    result.before.push_back(result.mean);
    steps.push_back(enclosed_torque(turn, section, section.end));
    for (const EnclosedStep& step : steps.back()) {
      result.mean = result.mean + step.integral;
      result.level = result.level + levered(step);
    }
  }
  return result;
}
inline Turned<Interval> turned(const TurnSections<Interval>& turn) {
  std::vector<std::vector<EnclosedStep>> steps;
  return turned(turn, steps);
}

/// (R3) The integral of the torque from a section's beginning to a place in it.
template <class T>
T integral_to(const TurnSections<T>& turn, std::size_t section, const T& share, double size) {
  std::vector<MeanStep<T>> steps;
  const auto& own = turn.sections()[section];
  add_turn_steps(own.begin, share, own.rate, section, steps);
  return torque_over(turn, steps, size).sum();
}
inline Interval integral_to(const TurnSections<Interval>& turn, std::size_t section,
                            const Interval& share, double) {
  Interval sum(0.0);
  for (const EnclosedStep& step : enclosed_torque(turn, turn.sections()[section], share)) {
    sum = sum + step.integral;
  }
  return sum;
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
