// SPDX-License-Identifier: MIT
#include "kinematics/peaks.h"

#include "kinematics/peak_search.h"

namespace camlaw {
namespace detail {
namespace {

/// The stationary point or piece end where there is one as high as any sample, else the sample.
Extremum settled(const Question& question) {
  const double slack = 4e-15 * std::abs(question.sample.value);
  Extremum e =
      question.peak.value >= question.sample.value - slack ? question.peak : question.sample;
  e.value = question.sign * e.value + 0.0;  // no negative zero
  return e;
}

}  // namespace

Extrema<Extremum> extrema(const Law<double>& law) {
  constexpr std::array kPlaces{0.25, 0.5, 0.75};  // where peaks of symmetric laws tend to lie
  const Questions answers = search_peaks(law, law, 1e-13, kPlaces);
  Extrema<Extremum> result;
  for (std::size_t i = 0; i < kQuantities; ++i) {
    result.highest[i] = settled(answers[2 * i]);
    result.lowest[i] = settled(answers[2 * i + 1]);
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

namespace {

/// Jumps smaller than this part of the law's own size are rounding.
constexpr double kJumpTolerance = 1e-10;

/// Derivatives beyond an end that its kind fixes: all zero but the velocity of G.
std::array<double, 3> beyond(End kind, const std::array<double, 3>& d) {
  switch (kind) {
    case End::Rest:
      return {d[0], 0, 0};
    case End::Velocity:
      return {d[0], d[1], 0};
    case End::Reversal:
      return {d[0], 0, d[2]};
    case End::Motion:
      return d;
  }
  return d;
}

}  // namespace

Jumps jumps(const Law<double>& law) {
  const auto& pieces = law.pieces();
  Jumps result;
  const auto inspect = [&](double x, const std::array<double, 3>& left,
                           const std::array<double, 3>& right) {
    // A velocity of a unit stretch is about 1, an acceleration at least 4.
    const double kick = std::abs(left[1] - right[1]);
    if (!result.velocity && !(kick <= kJumpTolerance)) result.velocity = x;
    const double step = std::abs(left[2] - right[2]);
    const double size = std::max({4.0, std::abs(left[2]), std::abs(right[2])});
    if (!result.acceleration && !(step <= kJumpTolerance * size && std::isfinite(step))) {
      result.acceleration = x;
    }
  };
  const auto at_begin = derivatives<3>(pieces.front(), 0.0);
  inspect(0, beyond(law.ends().begin, at_begin), at_begin);
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    inspect(pieces[i].end, derivatives<3>(pieces[i], pieces[i].end),
            derivatives<3>(pieces[i + 1], pieces[i + 1].begin));
  }
  const auto at_end = derivatives<3>(pieces.back(), 1.0);
  inspect(1, at_end, beyond(law.ends().end, at_end));
  return result;
}

}  // namespace camlaw
