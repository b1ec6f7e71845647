// SPDX-License-Identifier: MIT
#include "fitting/motions/law_ranking.h"

#include <algorithm>
#include <stdexcept>

#include "fitting/motions/coefficients.h"
#include "fitting/motions/law_choice.h"
#include "fitting/motions/law_fit_service.h"
#include "fitting/samples/lift_samples.h"
#include "optim/fit/loss.h"
#include "optim/problem/deadline.h"
#include "problems/statement/law_names.h"

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
struct RankedLaw {
  Member law;
  Skew skew;
  std::size_t coefficients;
};

/// Each law as it is and, where it can be, skewed; those of few coefficients first.
std::vector<RankedLaw> candidates_of(const std::vector<Member>& laws) {
  std::vector<RankedLaw> result;
  for (const Member& law : laws) {
    result.push_back({law, Skew::Held, coefficients_of(law).size()});
    if (!can_be_skewed(law)) continue;
    result.push_back({law, Skew::Free, coefficients_of(law, 0, Skew::Free).size()});
  }
  std::stable_sort(result.begin(), result.end(), [](const RankedLaw& a, const RankedLaw& b) {
    return a.coefficients < b.coefficients;
  });
  return result;
}

/// "cycloidal"; where that was tried as it is, "skewed cycloidal".
void add_untried(const RankedLaw& candidate, std::vector<std::string>& names) {
  const std::string& name = candidate.law.family->name;
  const bool is_untried = std::find(names.begin(), names.end(), name) != names.end();
  if (!is_untried) add_names({candidate.skew == Skew::Free ? "skewed " + name : name}, names);
}

/// Fits of all candidates. Those of as many coefficients are a step: each begins where the best
/// law of the steps before has led, whatever came of the others of its own.
class LawFits final : public optim::Errands {
 public:
  LawFits(const MotionSamples& samples, const std::vector<RankedLaw>& candidates,
          const MotionGuess& guess, const LawFitOptions& options)
      : samples_(samples_of_orders(samples, guess, options)),
        candidates_(candidates),
        options_(options),
        fits_(candidates.size()) {}

  std::optional<std::size_t> next() override {
    if (next_ == candidates_.size()) return {};
    const RankedLaw& candidate = candidates_[next_];
    if (candidate.coefficients > step_) {
      if (under_way_ > 0) return {};
      step_ = candidate.coefficients;
      if (const LawFit* best = best_so_far()) {
        like_ = best->motion();
        least_sum_ = best->fit.sum_of_squares;
      }
    }
    if (options_.is_late() && (has_fit() || under_way_ > 0)) return {};
    if (options_.progress) options_.progress(share());
    ++under_way_;
    return next_++;
  }
  std::optional<std::string> order(std::size_t number) override {
    const RankedLaw& candidate = candidates_[number];
    LawFitOptions own = options_;
    own.skew = candidate.skew;
    own.like = like_;
    own.least_sum = least_sum_;
    return law_fit_order(samples_, candidate.law, own);
  }
  void answered(std::size_t number, const std::string& answer) override {
    --under_way_;
    fits_[number] = law_fit_answer(answer, candidates_[number].law);
  }
  void lost(std::size_t, const std::string& why) override { throw std::runtime_error(why); }
  double share() const override {
    return options_.share_at(static_cast<double>(next_) / static_cast<double>(candidates_.size()));
  }
  const std::atomic<bool>* stop() const override { return options_.stop; }
  std::string confined() const override {
    for (const RankedLaw& candidate : candidates_) {
      if (is_of_catalogue(candidate.law)) continue;
      return "other processes do not know the law " + candidate.law.family->name;
    }
    return "";
  }

  Ranking ranking() {
    Ranking result;
    for (auto& fit : fits_) {
      if (fit) result.fits.push_back(std::move(*fit));
    }
    for (std::size_t i = next_; i < candidates_.size(); ++i) {
      add_untried(candidates_[i], result.untried);
    }
    return result;
  }

 private:
  bool has_fit() const {
    return std::any_of(fits_.begin(), fits_.end(), [](const auto& fit) { return bool(fit); });
  }
  const LawFit* best_so_far() const {
    const LawFit* best = nullptr;
    for (const auto& fit : fits_) {
      if (!fit || fit->numbers > step_ + kEnds) continue;
      if (best == nullptr || fit->fit.sum_of_squares < best->fit.sum_of_squares) best = &*fit;
    }
    return best;
  }

  const std::string samples_;
  const std::vector<RankedLaw>& candidates_;
  const LawFitOptions& options_;
  std::vector<std::optional<LawFit>> fits_;
  std::size_t next_ = 0, under_way_ = 0;
  std::size_t step_ = 0;  ///< coefficients
  std::optional<MotionGuess> like_;
  std::optional<double> least_sum_;
};

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
  const std::vector<RankedLaw> candidates = candidates_of(laws);
  LawFits fits(samples, candidates, guess, alike);
  optim::Crew here({.workers = 1});
  optim::Crew& crew = alike.crew != nullptr ? *alike.crew : here;
  crew.run(fits, law_fit_service(laws));
  if (alike.stop != nullptr && *alike.stop) throw optim::Interrupted();
  Ranking ranking = fits.ranking();
  weigh(ranking.fits);
  put_in_order(ranking.fits);
  return ranking;
}

}  // namespace camlaw::problems
