// SPDX-License-Identifier: MIT
#include "fitting/motions/law_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <tuple>

#include "fitting/motions/jump_fit.h"
#include "fitting/motions/law_fit_samples.h"
#include "fitting/motions/law_residuals.h"
#include "fitting/motions/law_starts.h"
#include "fitting/motions/occam.h"
#include "fitting/motions/profile_intervals.h"
#include "fitting/motions/rounding_errors.h"
#include "numerics/linear/statistics.h"
#include "optim/fit/loss.h"

namespace camlaw::problems {
namespace {

using optim::FitReach;

/// Of a law that was fitted, with stand-ins that are for the law as it was found.
LawResiduals residuals_near(const LawFitSamples& samples, const LawFit& fit) {
  const auto breaks = breaks_of(fit.law.law(), fit.begin, fit.end);
  return {samples.standing_for(breaks), fit.law, fit.skew,
          parameters_of(samples.all(), fit.law, samples.guess(), fit.skew)};
}

/// From the fit of other samples, within the bounds that it had.
Possible<optim::FitResult> fitted_near(const LawFitSamples& samples, const LawFit& fit,
                                       const LawFitOptions& options) {
  const LawResiduals residuals = residuals_near(samples, fit);
  const std::vector<double> found = values_of(fit.fit);
  const auto own = starting_at(residuals.own(), std::span(found).first(residuals.first()));
  auto refit =
      optim::possible_fit(own, residuals.residuals(), fit_options(options, FitReach::Near));
  if (!refit) return refit;
  return residuals.told(std::move(*refit), options.confidence);
}

/// The member with the coefficients of a fit.
Member with_coefficients(const Member& law, const optim::FitResult& told, std::size_t first,
                         Skew skew) {
  Member result = law;
  for (const Coefficient& c : coefficients_of(law, first, skew)) {
    result.arguments.values()[c.at.parameter][c.at.element] = told.parameters[c.at.variable].value;
  }
  return result;
}

/// At which ends samples of a law's derivative jump.
EndJumps jumps_of(const Law<double>& law, int order) {
  constexpr double kLeast = 0.01;  // of a motion of length and stroke one
  if (order == 0) return {};
  const auto k = static_cast<std::size_t>(order);
  return {std::abs(law.derivatives<3>(0.0, Side::Right)[k]) > kLeast,
          std::abs(law.derivatives<3>(1.0, Side::Left)[k]) > kLeast};
}

/// The stroke, or of a derivative the greatest value.
double size_of(const MotionSamples& samples, const optim::FitResult& fit) {
  if (samples.order == 0) return std::abs(fit.parameters[MotionLayout::kStroke].value);
  double size = 0;
  for (const double y : samples.value) size = std::max(size, std::abs(y));
  return size;
}

/// Whether a law that leaves this much is not behind the samples, as another one leaves so little:
/// its weight (LC2) is below e^-100.
bool is_out(const MotionSamples& samples, double sum, const LawFitOptions& options) {
  constexpr double kFar = 200;  // twice 100, as the weight is exp(-E / 2)
  if (!options.least_sum) return false;
  const double least = std::max(*options.least_sum, least_sum_of_squares(samples));
  return sum > least * (1 + kFar / static_cast<double>(samples.value.size()));
}

/// What a fit leaves of all samples; none where that is undefined.
std::optional<std::vector<double>> left_of(const LawResiduals& all, const optim::FitResult& fit) {
  std::vector<double> r(all.residuals().count());
  if (!all.residuals().evaluate(values_of(fit), r, {})) return {};
  return r;
}

/// The sum by which laws are compared.
double sum_left(const MotionSamples& samples, const optim::FitResult& fit,
                const std::vector<double>& left, optim::Loss loss) {
  // Under a loss what it sums, so that a far point does not decide which law is best.
  double sum = 0;
  for (const double r : left) {
    sum +=
        loss == optim::Loss::None ? r * r : optim::loss_at(loss, fit.loss_scale.value_or(1), r).rho;
  }
  return std::max(sum, least_sum_of_squares(samples));
}

using Starts = std::vector<std::vector<double>>;

/// A fit of all samples or of their stand-ins.
struct FitOf {
  std::unique_ptr<const LawResiduals> stand_ins;  ///< none: of all
  optim::FitResult fit;
  std::vector<double> left = {};  ///< of all samples
};

/// The law with the coefficients of a fit of own(), where they make one.
Possible<Law<double>> law_of(const LawResiduals& residuals, const optim::FitResult& fit,
                             const Member& law, const LawFitOptions& options) {
  const optim::FitResult told = residuals.told(fit, options.confidence);
  return with_coefficients(law, told, residuals.first(), options.skew).possible_law();
}

/// The best fit of these residuals, of all samples or of their stand-ins, with what jumps of the
/// samples at the motion's ends tell.
Possible<optim::FitResult> best_with_jumps(const LawFitSamples& samples, const Member& law,
                                           const LawResiduals& residuals,
                                           const LawFitOptions& options, const Starts& starts) {
  const auto near = fit_options(options, FitReach::Near);
  auto best = best_fit(residuals.own(), residuals.residuals(), near, starts);
  if (!best) return best;
  const auto found = law_of(residuals, *best, law, options);
  if (!found) return found.reason();
  return fit_with_jumps(samples.all(), residuals.residuals(), residuals.own(),
                        jumps_of(*found, samples.all().order), near, std::move(*best));
}

/// The best fit of the samples' stand-ins, which are those for the law that was found; none where
/// they do not settle.
Possible<std::optional<FitOf>> fit_of_stand_ins(const LawFitSamples& samples, const Member& law,
                                                const FitParameters& parameters,
                                                const LawFitOptions& options,
                                                const LawResiduals& all, Starts starts) {
  // Blocks with a break that two fits in turn move to and fro need all samples.
  constexpr int kRounds = 5;
  std::vector<double> breaks = all.breaks(starts.front());
  for (int round = 0; round < kRounds; ++round) {
    FitOf found{
        std::make_unique<LawResiduals>(samples.standing_for(breaks), law, options.skew, parameters),
        {}};
    auto fit = best_with_jumps(samples, law, *found.stand_ins, options, starts);
    if (!fit) return fit.reason();
    const std::vector<double> values = values_of(*fit), now = all.breaks(values);
    found.fit = std::move(*fit);
    if (samples.blocks()->are_for(breaks, now)) return std::optional(std::move(found));
    starts = {values};
    // Where they were too, so that two places do not take turns.
    breaks.insert(breaks.end(), now.begin(), now.end());
  }
  return std::optional<FitOf>();
}

/// Whether a fit of stand-ins is that of all samples: they leave as much of it. Of a law that is
/// not behind the samples that need not be so.
bool is_of_all(const MotionSamples& samples, const optim::FitResult& fit,
               const std::vector<double>& left, const LawFitOptions& options) {
  constexpr double kSame = 1e-5;  // stand-ins tell laws to 1e-5 of the sum (FS10)
  const double sum = std::inner_product(left.begin(), left.end(), left.begin(), 0.0);
  return std::abs(fit.sum_of_squares - sum) <= kSame * sum || is_out(samples, sum, options);
}

/// The best fit of all samples from these starts; by stand-ins where these tell the same.
Possible<FitOf> best_of_all(const LawFitSamples& samples, const Member& law,
                            const FitParameters& parameters, const LawFitOptions& options,
                            const LawResiduals& all, Starts starts) {
  if (samples.blocks()) {
    auto few = fit_of_stand_ins(samples, law, parameters, options, all, starts);
    if (!few) return few.reason();
    if (*few) {
      auto left = left_of(all, (*few)->fit);
      if (left && is_of_all(samples.all(), (*few)->fit, *left, options)) {
        (*few)->left = std::move(*left);
        return std::move(**few);
      }
      starts = {values_of((*few)->fit)};
    }
  }
  auto best = best_with_jumps(samples, law, all, options, starts);
  if (!best) return best.reason();
  FitOf result{nullptr, std::move(*best)};
  result.left = result.fit.residuals;
  return result;
}

/// Tells of all samples what a fit of their stand-ins leaves.
void tell_left(std::vector<double> left, optim::FitResult& fit) {
  fit.sum_of_squares = std::inner_product(left.begin(), left.end(), left.begin(), 0.0);
  fit.rms = std::sqrt(fit.sum_of_squares / static_cast<double>(left.size()));
  const auto largest = std::max_element(
      left.begin(), left.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  fit.largest = static_cast<std::size_t>(largest - left.begin());
  if (fit.weights.size() != left.size()) fit.weights.assign(left.size(), 1.0);
  fit.residuals = std::move(left);
}

}  // namespace

LawFitOptions part_of(LawFitOptions options, double from, double to) {
  if (options.deadline) {
    const auto now = LawFitOptions::Clock::now();
    const std::chrono::duration<double> left = *options.deadline - now;
    const double share = from < 1 ? (to - from) / (1 - from) : 1;
    options.deadline =
        now + std::chrono::duration_cast<LawFitOptions::Clock::duration>(share * left);
  }
  std::tie(options.from, options.to) = std::pair(options.share_at(from), options.share_at(to));
  return options;
}

LawFitOptions without_deadline(LawFitOptions options) {
  options.deadline.reset();
  return options;
}

bool LawFit::has_coefficients() const { return !coefficients_of(law, 0, skew).empty(); }

double LawFit::value(double place, int order) const {
  const double length = end - begin;
  const double u = (place - begin) / length;
  const auto k = static_cast<std::size_t>(order);
  if (k > 0 && !(u >= 0 && u <= 1)) return 0;
  const auto d =
      law.law().derivatives<4>(std::clamp(u, 0.0, 1.0), u < 1 ? Side::Right : Side::Left);
  return (k == 0 ? from : 0) + (to - from) * d[k] * std::pow(length, -order);
}

std::optional<Impossible> bad_motion(const MotionSamples& samples, const MotionGuess& guess) {
  if (samples.place.size() != samples.value.size()) {
    return Impossible{"samples: there must be as many values as abscissas"};
  }
  if (samples.place.size() < 2) return Impossible{"samples: at least two are needed"};
  for (std::size_t i = 0; i < samples.place.size(); ++i) {
    if (std::isfinite(samples.place[i]) && std::isfinite(samples.value[i])) continue;
    return Impossible{fmt::format("sample {} is not a finite number", i + 1)};
  }
  if (!(guess.end > guess.begin) || guess.to == guess.from) {
    return Impossible{"samples: they show no motion"};
  }
  return {};
}

LawFit fit_law(const MotionSamples& samples, const Member& law, const MotionGuess& guess,
               const LawFitOptions& options) {
  if (const auto fault = bad_motion(samples, guess)) throw std::invalid_argument(fault->why);
  return possible_law_fit(samples, law, guess, options).value();
}

Possible<LawFit> possible_law_fit(const MotionSamples& samples, const Member& law,
                                  const MotionGuess& guess, const LawFitOptions& options) {
  return possible_law_fit(LawFitSamples(samples, guess, options.loss), law, options);
}

Possible<LawFit> possible_law_fit(const LawFitSamples& of, const Member& law,
                                  const LawFitOptions& options) {
  if (const auto made = law.possible_law(); !made) return made.reason();
  const MotionSamples& samples = of.all();
  const auto parameters = parameters_of(samples, law, of.guess(), options.skew);
  auto starts = law_starts(of.means(), law, parameters, options);
  if (!starts) return starts.reason();
  const LawResiduals all(samples, law, options.skew, parameters);
  auto found = best_of_all(of, law, parameters, options, all, std::move(*starts));
  if (!found) return found.reason();
  auto& [few, best, left] = *found;
  const optim::Residuals& residuals = (few ? *few : all).residuals();
  const FitParameters own = all.own();
  const std::size_t first = all.first(), n = samples.value.size();
  LawFit result{law, {}, options.skew, first};
  result.inflation =
      count_rounding(samples, residuals, all.residuals(), own, options.confidence, best);
  const double sum = sum_left(samples, best, left, options.loss);
  const Occam occam = occam_of(residuals, own, first, size_of(samples, best),
                               std::sqrt(sum / static_cast<double>(n)), best);
  result.criterion = optim::evidence(n, best.rank, occam.count, sum, occam.logarithm);
  result.numbers =
      own.size() - static_cast<std::size_t>(std::count_if(own.begin(), own.end(), is_held));
  tell_left(std::move(left), best);
  result.fit = all.told(std::move(best), options.confidence);
  result.law = with_coefficients(law, result.fit, first, options.skew);
  const std::vector<double> x = values_of(result.fit);
  result.begin = x[MotionLayout::kBegin];
  result.end = x[MotionLayout::kEnd];
  result.from = samples.order == 0 ? x[MotionLayout::kZero] : 0;
  result.to = result.from + x[MotionLayout::kStroke];
  return result;
}

void profile_ends(const MotionSamples& samples, const MotionGuess& guess,
                  const LawFitOptions& options, LawFit& fit) {
  if (options.loss != optim::Loss::None) return;
  const LawFitSamples of(samples, guess, options.loss);
  const LawResiduals residuals = residuals_near(of, fit);
  const std::vector<double> found = values_of(fit.fit);
  const auto own = starting_at(residuals.own(), std::span(found).first(fit.base));
  profile_intervals(residuals.residuals(), own, fit.base, fit.inflation, options.confidence,
                    options.stop, fit.fit);
}

Possible<double> cross_validated(const MotionSamples& samples, const LawFit& fit,
                                 const MotionGuess& guess, const LawFitOptions& options) {
  // The usual ten folds: each fit has nine tenths of the samples.
  constexpr std::size_t kFolds = 10;
  const std::size_t n = samples.place.size();
  const auto part = [&](const std::vector<std::size_t>& which) {
    MotionSamples result = samples.none();
    for (const std::size_t i : which) {
      result.place.push_back(samples.place[i]);
      result.value.push_back(samples.value[i]);
    }
    return result;
  };
  std::optional<Impossible> fault;
  const double error = optim::cross_validated_error(
      n, std::min(kFolds, n), [&](const auto& kept, const auto& left_out) {
        if (fault) return std::nan("");
        const auto own = fitted_near({part(kept), guess, options.loss}, fit, options);
        if (!own) {
          fault = own.reason();
          return std::nan("");
        }
        const MotionResiduals others(part(left_out), fit.law, fit.skew);
        std::vector<double> r(left_out.size());
        if (!others.evaluate(values_of(*own), r, {})) return std::nan("");
        return std::inner_product(r.begin(), r.end(), r.begin(), 0.0);
      });
  if (fault) return std::move(*fault);
  return error;
}

}  // namespace camlaw::problems
