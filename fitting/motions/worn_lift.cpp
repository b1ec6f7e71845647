// SPDX-License-Identifier: MIT
#include "fitting/motions/worn_lift.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "fitting/motions/coefficients.h"
#include "fitting/motions/readings.h"

namespace camlaw::problems {
namespace {

/// Whether the law may have followed a worn stretch, or leaves one.
bool may_hide_wear(const MotionFit& fit) {
  constexpr std::size_t kLeast = 40;  // fewer samples show no stretch beside a motion
  if (fit.motion.samples.place.size() < kLeast || fit.unfinished.any()) return false;
  return fit.left.is_curve || (fit.distrust.empty() && fit.best().has_coefficients());
}

bool is_lower(const Reading& reading) {
  return std::all_of(reading.departures.begin(), reading.departures.end(),
                     [](const Departure& d) { return d.most < 0; });
}

/// Laws without coefficients.
std::vector<Member> plain_of(const std::vector<Member>& laws) {
  std::vector<Member> plain;
  std::copy_if(laws.begin(), laws.end(), std::back_inserter(plain),
               [](const Member& law) { return coefficients_of(law).empty(); });
  return plain;
}

/// The readings by plain laws that explain the samples best, if better than the law that was found
/// or as well. By other laws with a stretch almost any samples can be explained.
std::vector<Reading> better_readings(const MotionFit& fit, const std::vector<Member>& plain,
                                     const LawFitOptions& options, double noise) {
  Ranking ranking = robust_ranking(fit.motion, plain, options, noise);
  std::erase_if(ranking.fits, [](const LawFit& law) { return law.has_coefficients(); });
  if (!ranking.untried.empty() || ranking.fits.empty()) return {};
  const Scatter scatter = scatter_of(fit.motion, fit.ranking, noise);
  const std::vector<Reading> readings = readings_of(fit.motion, ranking.fits, options, scatter);
  const Reading chosen{fit.best(), {}, score_of(fit.best(), {}, {}, scatter)};
  std::vector<Reading> rivals = rivals_of(chosen, readings);
  if (rivals.empty()) return {};
  std::erase_if(rivals, [best = rivals.front().score](const Reading& reading) {
    return reading.score > best + kAsLikely;
  });
  // What no law follows may have other causes, which stand out to both sides.
  if (fit.left.is_curve && !is_lower(rivals.front())) return {};
  return rivals;
}

}  // namespace

void weigh_worn_stretches(const std::vector<Member>& laws, const LawFitOptions& options,
                          double first, FittedCycle& cycle) {
  if (options.loss != optim::Loss::None) return;
  const std::vector<Member> plain = plain_of(laws);
  if (plain.empty()) return;
  LawFitOptions own = options;
  own.progress = {};  // the laws have been tried
  for (MotionFit& fit : cycle.fits) {
    const MotionSamples& samples = fit.motion.samples;
    if (samples.order != 0 || !may_hide_wear(fit) || own.is_late()) continue;
    const double stroke = std::abs(fit.best().to - fit.best().from);
    const double noise =
        std::max({cycle.found.noise, rounding_deviation(samples), kLeastDeparture * stroke});
    const std::vector<Reading> others = better_readings(fit, plain, own, noise);
    if (others.empty()) continue;
    constexpr std::size_t kNamed = 3;
    std::vector<std::string> words;
    for (std::size_t i = 0; i < std::min(kNamed, others.size()); ++i) {
      words.push_back(reading_words(others[i], samples, first));
    }
    const bool is_better = !fit.distrust.empty();
    fit.distrust += fmt::format(
        "{}a worn stretch explains the samples {}: {}; measure the worn place, or leave "
        "its rows out",
        is_better ? "; " : "", is_better ? "better" : "as well", fmt::join(words, "; or "));
  }
}

}  // namespace camlaw::problems
