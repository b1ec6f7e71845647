// SPDX-License-Identifier: MIT
#include "problems/fits/law_ranking.h"

#include <algorithm>
#include <stdexcept>

#include "problems/fits/lift_samples.h"

namespace camlaw::problems {
namespace {

/// Losses of one scale for all laws: sums of different losses cannot be compared. By the noise that
/// neighbours show; where there is none, or too few neighbours, each law by its own.
LawFitOptions with_one_scale(const MotionSamples& samples, LawFitOptions options) {
  if (options.loss == optim::Loss::None || options.loss_scale) return options;
  try {
    const double noise = lift_samples(samples.place, samples.value, {}, {}).sample_noise;
    const double floor = std::max(noise, rounding_deviation(samples));
    if (floor > 0) options.loss_scale = floor * optim::efficient_scale(options.loss);
  } catch (const std::invalid_argument&) {  // too few
  }
  return options;
}

/// Those within two of the best explain the samples as well: of them the simplest comes first.
void put_simplest_first(std::vector<LawFit>& ranking) {
  constexpr double kAsWell = 2;
  const auto as_well = std::find_if(ranking.begin(), ranking.end(), [&](const LawFit& fit) {
    return fit.criterion > ranking.front().criterion + kAsWell;
  });
  const auto simplest =
      std::min_element(ranking.begin(), as_well,
                       [](const LawFit& a, const LawFit& b) { return a.numbers < b.numbers; });
  if (simplest != as_well) std::rotate(ranking.begin(), simplest, simplest + 1);
}

}  // namespace

std::vector<LawFit> rank_fits(const MotionSamples& samples, const std::vector<Member>& laws,
                              const MotionGuess& guess, const LawFitOptions& options) {
  check_motion(samples, guess);
  const LawFitOptions alike = with_one_scale(samples, options);
  std::vector<LawFit> ranking;
  for (const Member& law : laws) {
    if (alike.progress) {
      alike.progress(static_cast<double>(&law - laws.data()) / static_cast<double>(laws.size()));
    }
    try {
      ranking.push_back(fit_law(samples, law, guess, alike));
    } catch (const std::invalid_argument&) {  // its acceleration jumps to infinity, and the like
    }
  }
  std::stable_sort(ranking.begin(), ranking.end(),
                   [](const LawFit& a, const LawFit& b) { return a.criterion < b.criterion; });
  if (!ranking.empty()) put_simplest_first(ranking);
  return ranking;
}

}  // namespace camlaw::problems
