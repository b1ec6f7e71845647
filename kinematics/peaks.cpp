// SPDX-License-Identifier: MIT
#include "kinematics/peaks.h"

#include "kinematics/breaks.h"
#include "kinematics/peak_search.h"

namespace camlaw {
namespace detail {
namespace {

/// The stationary point or piece end where there is one as high as any sample, else the sample.
/// `size` is the quantity's largest.
Extremum settled(const Question& question, double size) {
  const bool sampled = question.sample.value > question.peak.value + 1e-13 * size;
  Extremum e = sampled ? question.sample : question.peak;
  e.value = question.sign * e.value + 0.0;  // no negative zero
  return e;
}

}  // namespace

Extrema<Extremum> extrema(const Law<double>& law) {
  constexpr std::array kPlaces{0.25, 0.5, 0.75};  // where peaks of symmetric laws tend to lie
  const Questions answers = search_peaks(law, law, 1e-13, kPlaces);
  Extrema<Extremum> result;
  for (std::size_t i = 0; i < kQuantities; ++i) {
    const auto finite = [](double x) { return std::isfinite(x) ? std::abs(x) : 0.0; };
    const double size = std::max(finite(answers[2 * i].known), finite(answers[2 * i + 1].known));
    result.highest[i] = settled(answers[2 * i], size);
    result.lowest[i] = settled(answers[2 * i + 1], size);
  }
  return result;
}

Extrema<Interval> enclose_extrema(const Law<Interval>& law, const Law<double>& plain,
                                  const Extrema<Extremum>& seeds) {
  std::array<double, 2 * kQuantities> places;
  for (std::size_t i = 0; i < kQuantities; ++i) {
    places[2 * i] = seeds.highest[i].position;
    places[2 * i + 1] = seeds.lowest[i].position;
  }
  const Questions answers = search_peaks(law, plain, 1e-10, places);
  Extrema<Interval> result;
  for (std::size_t i = 0; i < kQuantities; ++i) {
    const Question& up = answers[2 * i];
    const Question& down = answers[2 * i + 1];
    result.highest[i] = Interval(up.known, up.ceiling);
    result.lowest[i] = Interval(-down.ceiling, -down.known);
  }
  return result;
}

}  // namespace detail

namespace {

Peaks<double> peaks_of(const Law<double>& law, const detail::Extrema<detail::Extremum>& found) {
  Peaks<double> result;
  result.ends = law.ends();
  for (std::size_t i = 0; i < kQuantities; ++i) {
    result.highest[i] = {found.highest[i].value, found.highest[i].position};
    result.lowest[i] = {found.lowest[i].value, found.lowest[i].position};
  }
  result.jerk_inside_highest = result.high(Quantity::Jerk);
  result.jerk_inside_lowest = result.low(Quantity::Jerk);
  detail::count_jumps(result, jumps(law));
  return result;
}

}  // namespace

template <>
Peaks<double> peaks(const Law<double>& law) {
  return peaks_of(law, detail::extrema(law));
}

template <>
Peaks<Interval> peaks(const Law<Interval>& law) {
  const Law<double> plain = law.as<double>();
  const auto seeds = detail::extrema(plain);
  const Peaks<double> positions = peaks_of(plain, seeds);
  const auto found = detail::enclose_extrema(law, plain, seeds);
  Peaks<Interval> result;
  result.ends = law.ends();
  const auto proved = [](const Interval& enclosure, const Peak<double>& peak) {
    // A peak without bound is known from the formula at the end; no enclosure narrows it.
    return Peak<Interval>{std::isinf(peak.value) ? Interval(peak.value) : enclosure,
                          Interval(peak.position)};
  };
  for (std::size_t i = 0; i < kQuantities; ++i) {
    result.highest[i] = proved(found.highest[i], positions.highest[i]);
    result.lowest[i] = proved(found.lowest[i], positions.lowest[i]);
  }
  constexpr auto kJerk = static_cast<std::size_t>(Quantity::Jerk);
  result.jerk_inside_highest = proved(found.highest[kJerk], positions.jerk_inside_highest);
  result.jerk_inside_lowest = proved(found.lowest[kJerk], positions.jerk_inside_lowest);
  detail::count_jumps(result, jumps(plain));
  return result;
}

Jumps jumps(const Law<double>& law) {
  Jumps result;
  for (const detail::Break& at : detail::breaks(law)) {
    if (!result.velocity && detail::differs(at.left, at.right, 1)) result.velocity = at.x;
    if (!result.acceleration && detail::differs(at.left, at.right, 2)) result.acceleration = at.x;
  }
  return result;
}

}  // namespace camlaw
