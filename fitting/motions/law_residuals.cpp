// SPDX-License-Identifier: MIT
#include "fitting/motions/law_residuals.h"

#include <cmath>

namespace camlaw::problems {
namespace {

/// So far off its guess an end is looked for.
double beyond_of(const MotionGuess& guess) { return 0.3 * (guess.end - guess.begin); }

}  // namespace

MotionRange range_of(const MotionGuess& guess) {
  const double beyond = beyond_of(guess);
  return {guess.begin - beyond, guess.end + beyond};
}

FitParameters parameters_of(const MotionSamples& samples, const Member& law,
                            const MotionGuess& guess, Skew skew) {
  const double length = guess.end - guess.begin, stroke = guess.to - guess.from;
  const double beyond = beyond_of(guess);
  const std::string &unit = samples.place_unit, &size = samples.length_unit;
  const double free = optim::kInfinity;
  FitParameters result{
      {"begin", unit, guess.begin - beyond, guess.begin + beyond, guess.begin, length},
      {"end", unit, guess.end - beyond, guess.end + beyond, guess.end, length},
      {"stroke", size, -free, free, stroke, std::abs(stroke)}};
  if (samples.order == 0) {
    result.push_back({"zero", size, -free, free, guess.from, std::abs(stroke)});
  }
  for (const Coefficient& c : coefficients_of(law, 0, skew)) {
    const bool is_held = is_end_value(law, c);
    result.push_back(
        {c.name, c.unit, is_held ? c.value : c.low, is_held ? c.value : c.high, c.value});
  }
  return result;
}

LawResiduals::LawResiduals(StandIns samples, const Member& law, Skew skew, FitParameters parameters)
    : given_(std::move(parameters)), motion_(std::move(samples), law, skew) {
  if (const auto limit = limit_of(law)) {
    std::vector<double> start;
    for (const auto& p : given_) start.push_back(p.start);
    limited_.emplace(motion_, *limit, first(), start);
  }
  if (limited_) {
    remembered_.emplace(*limited_);
  } else {
    remembered_.emplace(motion_);
  }
}

FitParameters LawResiduals::own() const { return limited_ ? limited_->limited(given_) : given_; }

std::vector<double> LawResiduals::breaks(std::span<const double> values) const {
  return limited_ ? motion_.breaks(limited_->given(values)) : motion_.breaks(values);
}

optim::FitResult LawResiduals::told(optim::FitResult fit, double confidence) const {
  return limited_ ? limited_->of_coefficients(std::move(fit), given_, confidence) : fit;
}

optim::FitOptions fit_options(const LawFitOptions& options, optim::FitReach reach) {
  optim::FitOptions fit;
  fit.loss = options.loss;
  fit.loss_scale = options.loss_scale;
  fit.confidence = options.confidence;
  fit.reach = reach;
  fit.stop = options.stop;
  fit.max_iterations = reach == optim::FitReach::Rough ? 20 : 200;
  return fit;
}

}  // namespace camlaw::problems
