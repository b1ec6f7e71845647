// SPDX-License-Identifier: MIT
#include "fitting/motions/law_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <tuple>

#include "fitting/motions/jump_fit.h"
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

/// From the fit of other samples, within the bounds that it had.
Possible<optim::FitResult> fitted_near(const MotionSamples& samples, const LawFit& fit,
                                       const MotionGuess& guess, const LawFitOptions& options) {
  const LawResiduals residuals(samples, fit.law, fit.skew,
                               parameters_of(samples, fit.law, guess, fit.skew));
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
Jumps jumps_of(const Law<double>& law, int order) {
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

/// Whether a law that leaves this much where its fit begins, next to its minimum, is not behind the
/// samples, as another one leaves so little: its weight (LC2) is below e^-100.
bool is_out(const MotionSamples& samples, const optim::Residuals& residuals,
            const std::vector<double>& start, const LawFitOptions& options) {
  constexpr double kFar = 200;
  std::vector<double> r(residuals.count());
  if (!options.least_sum || !residuals.evaluate(start, r, {})) return false;
  const double least = std::max(*options.least_sum, least_sum_of_squares(samples));
  const double sum = std::inner_product(r.begin(), r.end(), r.begin(), 0.0);
  return sum > least * (1 + kFar / static_cast<double>(r.size()));
}

/// What a fit leaves, as laws are compared by it.
double sum_left(const MotionSamples& samples, const optim::FitResult& fit, optim::Loss loss) {
  // Under a loss what it sums, so that a far point does not decide which law is best.
  double sum = 0;
  for (const double r : fit.residuals) {
    sum +=
        loss == optim::Loss::None ? r * r : optim::loss_at(loss, fit.loss_scale.value_or(1), r).rho;
  }
  return std::max(sum, least_sum_of_squares(samples));
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
  if (const auto made = law.possible_law(); !made) return made.reason();
  const auto parameters = parameters_of(samples, law, guess, options.skew);
  const LawResiduals law_residuals(samples, law, options.skew, parameters);
  const optim::Residuals& residuals = law_residuals.residuals();
  const FitParameters own = law_residuals.own();
  const std::size_t first = law_residuals.first(), n = samples.value.size();
  optim::FitOptions near = fit_options(options, FitReach::Near);
  const auto member_of = [&](const optim::FitResult& fit) {
    return with_coefficients(law, law_residuals.told(fit, options.confidence), first, options.skew);
  };
  auto starts = law_starts(samples, law, parameters, options);
  if (!starts) return starts.reason();
  if (are_very_many(samples) && options.loss == optim::Loss::None) {
    starts = end_of_means(samples, law, parameters, options, *starts);
    if (!starts) return starts.reason();
    if (is_out(samples, residuals, starts->front(), options)) {
      near = fit_options(options, FitReach::Rough);
    }
  }
  auto best = best_fit(own, residuals, near, *starts);
  if (!best) return best.reason();
  const auto found = member_of(*best).possible_law();
  if (!found) return found.reason();
  const Jumps jumps = jumps_of(*found, samples.order);
  best = fit_with_jumps(samples, residuals, own, jumps, near, std::move(*best));
  LawFit result{member_of(*best), {}, options.skew, first};
  result.inflation = count_rounding(samples, residuals, own, options.confidence, *best);
  const double sum = sum_left(samples, *best, options.loss);
  const Occam occam = occam_of(residuals, own, first, size_of(samples, *best),
                               std::sqrt(sum / static_cast<double>(n)), *best);
  result.criterion = optim::evidence(n, best->rank, occam.count, sum, occam.logarithm);
  result.numbers =
      own.size() - static_cast<std::size_t>(std::count_if(own.begin(), own.end(), is_held));
  result.fit = law_residuals.told(std::move(*best), options.confidence);
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
  const LawResiduals residuals(samples, fit.law, fit.skew,
                               parameters_of(samples, fit.law, guess, fit.skew));
  const std::vector<double> found = values_of(fit.fit);
  const auto own = starting_at(residuals.own(), std::span(found).first(fit.base));
  profile_intervals(residuals.residuals(), own, fit.base, fit.inflation, options.confidence,
                    options.stop, fit.fit);
}

Possible<double> cross_validated(const MotionSamples& samples, const LawFit& fit,
                                 const MotionGuess& guess, const LawFitOptions& options) {
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
        const auto own = fitted_near(part(kept), fit, guess, options);
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
