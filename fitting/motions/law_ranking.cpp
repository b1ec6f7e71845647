// SPDX-License-Identifier: MIT
#include "fitting/motions/law_ranking.h"

#include <algorithm>

#include "fitting/motions/coefficients.h"
#include "fitting/motions/law_choice.h"
#include "fitting/samples/lift_samples.h"
#include "optim/fit/loss.h"

namespace camlaw::problems {
namespace {

/// Losses of one scale for all laws: sums of different losses cannot be compared. By the noise that
/// neighbours show; where there is none, or too few neighbours, each law by its own.
LawFitOptions with_one_scale(const MotionSamples& samples, LawFitOptions options) {
  if (options.loss == optim::Loss::None || options.loss_scale) return options;
  const auto lift = lift_samples(samples.place, samples.value, {}, {});
  if (!lift) return options;
  const double floor = std::max(lift->sample_noise, rounding_deviation(samples));
  if (floor > 0) options.loss_scale = floor * optim::efficient_scale(options.loss);
  return options;
}

constexpr std::size_t kEnds = 4;  ///< numbers of a motion: begin, end, stroke, zero

/// One law to try.
struct Candidate {
  Member law;
  Skew skew;
  std::size_t coefficients;
};

/// Each law as it is and, where it can be, skewed; those of few coefficients first.
std::vector<Candidate> candidates_of(const std::vector<Member>& laws) {
  std::vector<Candidate> result;
  for (const Member& law : laws) {
    result.push_back({law, Skew::Held, coefficients_of(law).size()});
    if (!can_be_skewed(law)) continue;
    result.push_back({law, Skew::Free, coefficients_of(law, 0, Skew::Free).size()});
  }
  std::stable_sort(result.begin(), result.end(), [](const Candidate& a, const Candidate& b) {
    return a.coefficients < b.coefficients;
  });
  return result;
}

const LawFit* best_of(const std::vector<LawFit>& fits, std::size_t numbers) {
  const LawFit* best = nullptr;
  for (const LawFit& fit : fits) {
    if (fit.numbers > numbers) continue;
    if (best == nullptr || fit.fit.sum_of_squares < best->fit.sum_of_squares) best = &fit;
  }
  return best;
}

/// "cycloidal"; where that was tried as it is, "skewed cycloidal".
void add_untried(const Candidate& candidate, std::vector<std::string>& names) {
  const std::string& name = candidate.law.family->name;
  const bool is_untried = std::find(names.begin(), names.end(), name) != names.end();
  if (!is_untried) add_names({candidate.skew == Skew::Free ? "skewed " + name : name}, names);
}

MotionGuess motion_of(const LawFit& fit) { return {fit.begin, fit.end, fit.from, fit.to}; }

}  // namespace

void add_names(const std::vector<std::string>& names, std::vector<std::string>& others) {
  for (const std::string& name : names) {
    if (std::find(others.begin(), others.end(), name) == others.end()) others.push_back(name);
  }
}

Ranking rank_fits(const MotionSamples& samples, const std::vector<Member>& laws,
                  const MotionGuess& guess, const LawFitOptions& options) {
  return possible_ranking(samples, laws, guess, options).value();
}

Possible<Ranking> possible_ranking(const MotionSamples& samples, const std::vector<Member>& laws,
                                   const MotionGuess& guess, const LawFitOptions& options) {
  if (auto fault = bad_motion(samples, guess)) return std::move(*fault);
  const LawFitOptions alike = with_one_scale(samples, options);
  Ranking ranking;
  const std::vector<Candidate> candidates = candidates_of(laws);
  for (const Candidate& candidate : candidates) {
    if (alike.progress) {
      alike.progress(static_cast<double>(&candidate - candidates.data()) /
                     static_cast<double>(candidates.size()));
    }
    if (!ranking.fits.empty() && alike.is_late()) {
      add_untried(candidate, ranking.untried);
      continue;
    }
    LawFitOptions own = alike;
    own.skew = candidate.skew;
    if (candidate.coefficients > 0) {
      if (const LawFit* best = best_of(ranking.fits, candidate.coefficients + kEnds)) {
        own.like = motion_of(*best);
      }
    }
    auto fit = possible_law_fit(samples, candidate.law, guess, own);
    if (fit) ranking.fits.push_back(std::move(*fit));
  }
  weigh(ranking.fits);
  put_in_order(ranking.fits);
  return ranking;
}

}  // namespace camlaw::problems
