// SPDX-License-Identifier: MIT
#include "fitting/motions/readings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "fitting/motions/sketches.h"
#include "numerics/linear/statistics.h"
#include "numerics/tables/turn.h"
#include "optim/fit/loss.h"

namespace camlaw::problems {
namespace {

bool are_alike(const std::vector<Departure>& a, const std::vector<Departure>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Departure& one, const Departure& other) {
                      return one.from == other.from && one.to == other.to;
                    });
}

/// A sketch fitted, without the windows and what departs around them. None where more stretches
/// depart from it than may be, or fewer than there were windows.
std::optional<Reading> fitted(const FoundMotion& motion, const LawFit& start,
                              const std::vector<Departure>& windows, LawFitOptions options,
                              const Scatter& scatter) {
  // Windows that do not settle go to and fro between two sets of samples.
  constexpr int kPasses = 6;
  options.skew = start.skew;
  options.like = start.motion();
  Reading reading{start, {}, 0};
  std::vector<Departure> left_out = windows;
  for (int pass = 0; pass < kPasses; ++pass) {
    auto law = possible_law_fit(without(motion.samples, left_out), reading.law.law,
                                reading.law.motion(), options);
    if (!law) return {};
    reading.law = std::move(*law);
    if (windows.empty()) break;
    std::vector<Departure> found = departures(motion.samples, reading.law, scatter.noise);
    const bool may_be = !found.empty() && found.size() <= kMostStretches &&
                        shows_motion(motion.samples, reading.law, found);
    if (!may_be) return {};
    const bool is_settled = are_alike(found, reading.departures);
    reading.departures = std::move(found);
    if (is_settled) break;
    left_out = windows;
    left_out.insert(left_out.end(), reading.departures.begin(), reading.departures.end());
  }
  reading.score = score_of(reading.law, reading.departures, left_out, scatter);
  return reading;
}

bool overlap(const Departure& a, const Departure& b) { return a.from <= b.to && b.from <= a.to; }

}  // namespace

Ranking robust_ranking(const FoundMotion& motion, const std::vector<Member>& laws,
                       const LawFitOptions& options, double noise) {
  LawFitOptions robust = options;
  if (robust.loss == optim::Loss::None) robust.loss = optim::Loss::Huber;
  robust.loss_scale = noise * optim::efficient_scale(robust.loss);
  return rank_fits(motion.samples, laws, motion.guess, robust);
}

Scatter scatter_of(const FoundMotion& motion, const std::vector<LawFit>& ranking, double least) {
  const MotionSamples& samples = motion.samples;
  const std::size_t n = samples.place.size();
  Scatter result{least, samples.place, std::vector<double>(n, 1.0)};
  if (ranking.empty() || n < 3) return result;
  const std::vector<std::size_t> order = optim::order_of(samples.place);
  std::vector<double> left, bends;
  for (const std::size_t i : order) {
    left.push_back(samples.value[i] - ranking.front().value(samples.place[i], samples.order));
  }
  for (std::size_t i = 1; i + 1 < n; ++i) {
    bends.push_back(left[i - 1] - 2 * left[i] + left[i + 1]);
  }
  constexpr double kFar = 4;     // deviations, beyond which a sample lies off
  constexpr double kOfBend = 6;  // squares of 1, -2 and 1
  const double most = kFar * optim::median_absolute_deviation(bends, 0.0);
  double sum = 0;
  for (double& bend : bends) {
    bend = std::min(std::abs(bend), most);
    sum += bend * bend;
  }
  result.noise = std::max(least, std::sqrt(sum / (kOfBend * static_cast<double>(bends.size()))));
  for (std::size_t i = 0; i < bends.size(); ++i) {
    const double own = bends[i] / result.noise;
    result.squares[order[i + 1]] = own * own / kOfBend;
  }
  return result;
}

double score_of(const LawFit& law, const std::vector<Departure>& departures,
                const std::vector<Departure>& left_out, const Scatter& scatter, double period) {
  constexpr double kHigher = 100;  // times as seldom: what is worn is lower
  double squares = law.fit.sum_of_squares / (scatter.noise * scatter.noise);
  for (std::size_t i = 0; i < scatter.place.size(); ++i) {
    if (departs(scatter.place[i], left_out, period)) squares += scatter.squares[i];
  }
  for (const Departure& d : departures) squares += d.most > 0 ? 2 * std::log(kHigher) : 0;
  return departure_score(squares, scatter.place.size(), law, departures.size());
}

std::vector<Reading> readings_of(const FoundMotion& motion, const std::vector<LawFit>& ranking,
                                 const LawFitOptions& options, const Scatter& scatter) {
  constexpr std::size_t kTried = 12;  // each is a fit of a law; the first order ranks them (WR3)
  constexpr double kNear = 80;        // what fitting may gain over the first order
  LawFitOptions plain = options;
  plain.loss = optim::Loss::None;
  plain.loss_scale.reset();
  std::vector<Reading> readings;
  const std::vector<Sketch> sketches = sketches_of(motion, ranking, scatter);
  for (std::size_t i = 0; i < std::min(kTried, sketches.size()); ++i) {
    const Sketch& sketch = sketches[i];
    if (!readings.empty() && sketch.score > sketches.front().score + kNear) break;
    auto reading = fitted(motion, ranking[sketch.law], sketch.windows, plain, scatter);
    if (reading) readings.push_back(std::move(*reading));
  }
  std::stable_sort(readings.begin(), readings.end(),
                   [](const Reading& a, const Reading& b) { return a.score < b.score; });
  return readings;
}

bool tell_other_wear(const Reading& a, const Reading& b) {
  // A depth is read off nine neighbours, with half of a sample's noise.
  constexpr double kDeeper = 1.0 / 6;
  return !std::equal(a.departures.begin(), a.departures.end(), b.departures.begin(),
                     b.departures.end(), [](const Departure& one, const Departure& other) {
                       return overlap(one, other) &&
                              std::abs(one.most - other.most) <= kDeeper * std::abs(one.most);
                     });
}

std::vector<Reading> rivals_of(const Reading& chosen, const std::vector<Reading>& readings) {
  std::vector<Reading> rivals;
  if (readings.empty()) return rivals;
  double own = chosen.score;
  for (const Reading& reading : readings) {
    if (!tell_other_wear(chosen, reading)) own = std::min(own, reading.score);
  }
  const double most = own + kAsLikely;
  for (const Reading& reading : readings) {
    if (reading.score > most || !tell_other_wear(chosen, reading)) continue;
    const bool is_known = std::any_of(rivals.begin(), rivals.end(), [&](const Reading& other) {
      return !tell_other_wear(other, reading);
    });
    if (!is_known) rivals.push_back(reading);
  }
  return rivals;
}

std::string reading_words(const Reading& reading, const MotionSamples& samples, double first) {
  const auto of_unit = [](const std::string& unit) { return unit == "1" ? "" : " " + unit; };
  std::vector<std::string> words;
  for (const Departure& d : reading.departures) {
    const double from =
        samples.place_unit == "deg" ? in_period(d.from, first, kTurnDegrees) : d.from;
    words.push_back(fmt::format("{:.3g}{} {} from {:.4g} to {:.4g}{}", std::abs(d.most),
                                of_unit(samples.unit), d.most < 0 ? "lower" : "higher", from,
                                from + d.to - d.from, of_unit(samples.place_unit)));
  }
  if (words.empty()) return fmt::format("{} without a worn stretch", reading.law.law.label());
  return fmt::format("{}, the lift being up to {}", reading.law.law.label(),
                     fmt::join(words, " and "));
}

}  // namespace camlaw::problems
