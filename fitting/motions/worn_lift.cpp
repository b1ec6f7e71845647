// SPDX-License-Identifier: MIT
#include "fitting/motions/worn_lift.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "fitting/motions/readings.h"

namespace camlaw::problems {
namespace {

/// Whether the law may have followed a worn stretch, or leaves one.
bool may_hide_wear(const MotionFit& fit) {
  constexpr std::size_t kLeast = 40;  // fewer samples show no stretch beside a motion
  if (fit.motion.samples.place.size() < kLeast || fit.unfinished.any()) return false;
  return fit.left.is_curve || (fit.distrust.empty() && fit.best().has_coefficients());
}

/// The readings that explain the samples best, if better than the law that was found or as well.
std::vector<Reading> better_readings(const MotionFit& fit, const std::vector<Member>& laws,
                                     const LawFitOptions& options, double noise) {
  constexpr double kAsWell = 15;  // as rivals_of() has it
  const Ranking ranking = robust_ranking(fit.motion, laws, options, noise);
  if (!ranking.untried.empty() || ranking.fits.empty()) return {};
  const Scatter scatter = scatter_of(fit.motion, ranking.fits, noise);
  const std::vector<Reading> readings = readings_of(fit.motion, ranking.fits, options, scatter);
  const Reading chosen{fit.best(), {}, score_of(fit.best(), {}, {}, scatter)};
  std::vector<Reading> rivals = rivals_of(chosen, readings);
  if (rivals.empty()) return {};
  std::erase_if(rivals, [best = rivals.front().score](const Reading& reading) {
    return reading.score > best + kAsWell;
  });
  return rivals;
}

}  // namespace

void weigh_worn_stretches(const std::vector<Member>& laws, const LawFitOptions& options,
                          double first, FittedCycle& cycle) {
  if (options.loss != optim::Loss::None) return;
  LawFitOptions own = options;
  own.progress = {};  // the laws have been tried
  for (MotionFit& fit : cycle.fits) {
    const MotionSamples& samples = fit.motion.samples;
    if (samples.order != 0 || !may_hide_wear(fit) || own.is_late()) continue;
    const double stroke = std::abs(fit.best().to - fit.best().from);
    const double noise =
        std::max({cycle.found.noise, rounding_deviation(samples), kLeastDeparture * stroke});
    const std::vector<Reading> others = better_readings(fit, laws, own, noise);
    if (others.empty()) continue;
    constexpr std::size_t kNamed = 3;
    std::vector<std::string> words;
    for (std::size_t i = 0; i < std::min(kNamed, others.size()); ++i) {
      words.push_back(reading_words(others[i], samples, first));
    }
    fit.distrust += fmt::format(
        "{}a worn stretch explains the samples as well: {}; measure the worn place, or leave its "
        "rows out",
        fit.distrust.empty() ? "" : "; ", fmt::join(words, "; or "));
  }
}

}  // namespace camlaw::problems
