// SPDX-License-Identifier: MIT
#include "fitting/motions/motion_fit.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "fitting/motions/fitted_law.h"
#include "fitting/motions/law_choice.h"
#include "fitting/motions/law_ranking.h"
#include "fitting/motions/motion_residuals.h"
#include "numerics/spline/smoothing_spline.h"

namespace camlaw::problems {
namespace {

/// Chances of a sample in normal noise that is called far off: where such ones are listed, and
/// where the fit is distrusted for them.
constexpr double kListed = 0.05, kDistrusted = 1e-4;

bool is_exact(const LawFit& fit) {
  constexpr double kRounding = 1e-9;  // of the stroke: samples with nine exact digits have no noise
  return fit.fit.rms < kRounding * std::abs(fit.to - fit.from);
}

/// `chance`: of one in normal noise.
Outliers outliers_of(const MotionFit& fit, double chance) {
  const LawFit& best = fit.best();
  // Of the range: a sample that is as near is off by its last printed digit.
  constexpr double kRounding = 1e-6;
  double size = 0;
  for (const double y : fit.motion.samples.value) size = std::max(size, std::abs(y - best.from));
  const double least = std::max(kRounding * size, fit.motion.samples.resolution);
  return find_outliers(fit.motion.samples.place, best.fit.residuals, best.fit.rank, least, chance);
}

std::string in_unit(double value, const std::string& unit) {
  return fmt::format("{:.4g}{}", value, unit == "1" ? "" : " " + unit);
}

/// Samples that drew a fit in which all count alike.
std::string drawn_by(const MotionFit& fit) {
  const MotionSamples& samples = fit.motion.samples;
  const std::size_t worst = fit.outliers.samples.front();
  return fmt::format(
      "{} of {} samples lie farther off than chance explains, by up to {} at {}, and distort the "
      "fit; --loss huber or --loss cauchy limits their weight",
      fit.outliers.samples.size(), samples.place.size(),
      in_unit(std::abs(fit.best().fit.residuals[worst]), samples.unit),
      in_unit(samples.place[worst], samples.place_unit));
}

bool shows_no_stroke(const LawFit& fit) {
  const optim::FittedParameter& stroke = fit.fit.parameters[MotionLayout::kStroke];
  return stroke.low <= 0 && stroke.high >= 0;
}

/// What of the residuals is a curve, in words; empty where they may be noise.
std::string curve_left(const MotionFit& fit) {
  if (!fit.left.is_curve) return "";
  return fmt::format(
      "no law that was tried follows the samples: the residuals of {} are not noise (neighbouring "
      "residuals have a correlation of {:.2f}, blocks of them {:.1f} times the squares of noise)",
      fit.best().law.label(), fit.left.correlation, fit.left.block_squares);
}

std::string distrust_of(const MotionFit& fit, const LawFitOptions& options) {
  const LawFit& best = fit.best();
  if (fit.unfinished.any()) return unfinished_words(fit.unfinished, fit.motion.samples);
  if (!best.fit.reason_but_bounds.empty()) return best.fit.reason_but_bounds;
  if (!std::isfinite(best.criterion) && best.criterion > 0) {
    return fmt::format("{} samples are too few to tell laws apart",
                       fit.motion.samples.place.size());
  }
  if (shows_no_stroke(best)) return "the samples show no motion: the stroke could as well be 0";
  if (is_exact(best)) return "";
  if (!fit.untried.empty()) return untried_words(fit.untried);
  if (const std::string curve = curve_left(fit); !curve.empty()) return curve;
  if (std::string edge = edge_words(best); !edge.empty()) return edge;
  const bool is_drawn =
      options.loss == optim::Loss::None && draws(outliers_of(fit, kDistrusted), best.fit.residuals);
  if (is_drawn) return drawn_by(fit);
  if (!fit.is_told) {
    return fmt::format("with noise of {} the law cannot be identified; these are possible: {}, {}",
                       in_unit(best.fit.sigma, fit.motion.samples.unit), best.law.label(),
                       first_names(fit.as_good));
  }
  return "";
}

/// A smooth curve from rest to rest between the ends that the samples show: those of a law that
/// does not follow them are no better.
std::optional<Law<double>> smoothed(const MotionFit& fit) {
  const MotionGuess& shown = fit.motion.guess;
  const MotionSamples inside = between(fit.motion.samples, shown.begin, shown.end);
  optim::SmoothingOptions options;
  options.range = std::pair(shown.begin, shown.end);
  options.begin = {shown.from, 0.0, {}};
  options.end = {shown.to, 0.0, {}};
  const auto spline = optim::possible_smoothing_spline(inside.place, inside.value, options);
  if (!spline) return {};  // too few samples for a curve
  return possible_stretch_law(*spline).if_any();
}

/// Intervals by profiles of the first law and others that count.
void profile_likely(const FoundMotion& motion, const LawFitOptions& options,
                    std::vector<LawFit>& ranking) {
  // Of all weight: laws with less hardly move a quantile of the mixture (LC3).
  constexpr double kCounts = 0.01;
  for (LawFit& fit : ranking) {
    if (&fit != &ranking.front() && fit.weight < kCounts) continue;
    profile_ends(motion.samples, motion.guess, options, fit);
  }
}

}  // namespace

std::string untried_words(const std::vector<std::string>& names) {
  return fmt::format("the time limit left no time to try these laws: {}", first_names(names));
}

std::string first_names(const std::vector<std::string>& names) {
  const std::size_t shown = std::min(names.size(), kFewLaws);
  const std::string text = fmt::format("{}", fmt::join(names.begin(), names.begin() + shown, ", "));
  return shown == names.size() ? text : fmt::format("{} and {} more", text, names.size() - shown);
}

MotionFit fit_motion(const FoundMotion& motion, const std::vector<Member>& laws,
                     const LawFitOptions& options) {
  return possible_motion_fit(motion, laws, options).value();
}

Possible<MotionFit> possible_motion_fit(const FoundMotion& motion, const std::vector<Member>& laws,
                                        const LawFitOptions& options) {
  auto ranking = possible_ranking(motion.samples, laws, motion.guess, options);
  if (!ranking) return ranking.reason();
  MotionFit result{motion, std::move(ranking->fits), std::move(ranking->untried)};
  if (result.ranking.empty()) {
    return Impossible{"none of the laws can be fitted to these samples"};
  }
  const auto error = cross_validated(motion.samples, result.best(), motion.guess, options);
  if (!error) return error.reason();
  result.prediction_error = *error;
  result.left =
      optim::residual_pattern(motion.samples.place, optim::counted_residuals(result.best().fit));
  result.outliers = outliers_of(result, kListed);
  result.unfinished = unfinished_ends(motion, result.ranking);
  const AsGood others = as_good(result.ranking);
  for (const std::size_t i : others.fits) result.as_good.push_back(result.ranking[i].law.label());
  result.is_told = others.is_told;
  profile_likely(motion, options, result.ranking);
  widen_by_others(result.ranking, options.confidence);
  result.distrust = distrust_of(result, options);
  const bool is_curve = motion.samples.order == 0 && !result.distrust.empty() &&
                        result.distrust == curve_left(result);
  if (is_curve) result.smooth = smoothed(result);
  return result;
}

}  // namespace camlaw::problems
