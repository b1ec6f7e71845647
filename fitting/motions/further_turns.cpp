// SPDX-License-Identifier: MIT
#include "fitting/motions/further_turns.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "fitting/samples/lift_samples.h"
#include "fitting/samples/lone_samples.h"
#include "numerics/linear/statistics.h"

namespace camlaw::problems {
namespace {

/// Of a turn: angles that are so far off do no harm.
constexpr double kSlack = 1e-3;

/// The first turn of a record, by place; of rows at one place the mean.
struct FirstTurn {
  std::vector<double> place, value;
};

FirstTurn first_turn(const MotionSamples& samples, double first) {
  constexpr double kOne = 1e-9 * kTurnDegrees;  // places of one row differ by rounding
  FirstTurn turn;
  std::size_t alike = 0;
  for (const std::size_t i : optim::order_of(samples.place)) {
    const double place = samples.place[i];
    if (place >= first + kTurnDegrees) break;
    if (turn.place.empty() || place - turn.place.back() > kOne) {
      turn.place.push_back(place), turn.value.push_back(samples.value[i]);
      alike = 1;
      continue;
    }
    ++alike;
    turn.value.back() += (samples.value[i] - turn.value.back()) / static_cast<double>(alike);
  }
  return turn;
}

/// How rows beyond the first turn lie to those a turn before.
struct Repetition {
  std::size_t rows = 0;
  double squares = 0;            ///< of the differences in their deviations
  double most = 0, most_at = 0;  ///< the largest difference in its deviation, and its place
  double most_by = 0;            ///< that difference
  double information = 0;        ///< about a shift of the places, 1 / deg^2
};

constexpr std::size_t kPoints = 4;  // of a cubic

Repetition repetition(const MotionSamples& samples, double first, FirstTurn turn, double noise) {
  Repetition found;
  const std::size_t n = turn.place.size();
  turn.place.push_back(0), turn.value.push_back(0);  // for the row that is looked at
  double slopes = 0;
  for (std::size_t i = 0; i < samples.place.size(); ++i) {
    if (samples.place[i] < first + kTurnDegrees) continue;
    const double place = in_period(samples.place[i], first, kTurnDegrees);
    const auto next = static_cast<std::size_t>(
        std::lower_bound(turn.place.begin(), turn.place.begin() + static_cast<std::ptrdiff_t>(n),
                         place) -
        turn.place.begin());
    const std::size_t from = std::clamp<std::size_t>(next, 2, n - 2) - 2;
    turn.place[n] = place, turn.value[n] = samples.value[i];
    const std::array<std::size_t, kPoints> at{from, from + 1, from + 2, from + 3};
    const CubicMiss miss = cubic_miss(turn.place, turn.value, at, n);
    const double deviation = noise * miss.noise, own = miss.by / deviation;
    ++found.rows;
    found.squares += own * own;
    if (std::abs(own) > found.most) {
      found.most = std::abs(own), found.most_by = std::abs(miss.by);
      found.most_at = samples.place[i];
    }
    // What noise makes of a slope is no motion.
    const double wide = turn.place[from + 3] - turn.place[from],
                 slope = (turn.value[from + 3] - turn.value[from]) / wide;
    slopes += (slope * slope - 2 * noise * noise / (wide * wide)) / (deviation * deviation);
  }
  found.information = std::max(slopes, 0.0);
  return found;
}

bool repeats(const Repetition& found) {
  constexpr double kOne = 5, kAll = 5;  // deviations: noise passes them once in two million cases
  const auto n = static_cast<double>(found.rows);
  return found.most <= kOne && found.squares <= n + kAll * std::sqrt(2 * n);
}

/// Whether a turn that is longer or shorter by kSlack would show.
bool tells_turn(const Repetition& found) {
  constexpr double kBeyondChance = 3;  // deviations
  return kSlack * kTurnDegrees * std::sqrt(found.information) >= kBeyondChance;
}

std::string beyond_words(double range, std::size_t rows) {
  return fmt::format("the angles go over {:.6g} deg, and the {} beyond a turn of 360 deg", range,
                     rows == 1 ? "row" : fmt::format("{} rows", rows));
}

[[noreturn]] void refuse_other(double range, const Repetition& found,
                               const MotionSamples& samples) {
  const std::string unit = samples.unit == "1" ? "" : " " + samples.unit;
  throw std::invalid_argument(fmt::format(
      "{} {} not repeat those a turn before (by {:.3g}{} at {:.6g} deg): the scale of the angles "
      "is "
      "probably off, or they are of another shaft than the cam's, or the lift drifted; correct the "
      "angles, or give at most one turn of 360 deg",
      beyond_words(range, found.rows), found.rows == 1 ? "does" : "do", found.most_by, unit,
      found.most_at));
}

[[noreturn]] void refuse_rest(double range, const Repetition& found) {
  throw std::invalid_argument(fmt::format(
      "{} {} at rest: nothing tells whether {} come round again or the scale of the angles is off; "
      "if the angles are right, give at most one turn of 360 deg, without {}",
      beyond_words(range, found.rows), found.rows == 1 ? "is" : "are",
      found.rows == 1 ? "it has" : "they have", found.rows == 1 ? "it" : "them"));
}

}  // namespace

void fold_further_turns(MotionRecord& record) {
  MotionSamples& samples = record.samples;
  if (samples.place_unit != "deg" || samples.order != 0 || samples.place.empty()) return;
  const auto [low, high] = std::minmax_element(samples.place.begin(), samples.place.end());
  const double first = *low, range = *high - *low;
  if (range <= kLongestTurn) return;
  const FirstTurn turn = first_turn(samples, first);
  const auto noise = possible_noise(turn.place, turn.value);
  if (!noise) return;  // too few rows to tell: possible_motions() refuses them
  const double size =
      std::abs(*std::max_element(turn.value.begin(), turn.value.end(),
                                 [](double a, double b) { return std::abs(a) < std::abs(b); }));
  constexpr double kExact = 1e-9;  // of the lift: digits of an exact table
  const double least = std::max(rounding_deviation(samples), kExact * size);
  const Repetition found = repetition(samples, first, turn, std::max(*noise, least));
  const bool is_short = range <= kTurnDegrees * (1 + kSlack);
  if (!is_short && !repeats(found)) refuse_other(range, found, samples);
  if (!is_short && !tells_turn(found)) refuse_rest(range, found);
  for (double& place : samples.place) {
    if (place >= first + kTurnDegrees) place = in_period(place, first, kTurnDegrees);
  }
  record.notes.push_back(fmt::format("{} {} those a turn before: counted there",
                                     beyond_words(range, found.rows),
                                     is_short          ? "come round to"
                                     : found.rows == 1 ? "repeats"
                                                       : "repeat"));
}

}  // namespace camlaw::problems
