// SPDX-License-Identifier: MIT
#include "problems/fits/motion_fit.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "optim/fit/smoothing_spline.h"
#include "problems/fits/fitted_law.h"
#include "problems/fits/law_ranking.h"
#include "problems/fits/motion_residuals.h"
#include "problems/fits/same_motion.h"

namespace camlaw::problems {
namespace {

bool is_exact(const LawFit& fit) {
  constexpr double kRounding = 1e-9;
  return fit.fit.rms < kRounding * std::abs(fit.to - fit.from);
}

FarOff far_off_of(const MotionFit& fit) {
  const LawFit& best = fit.best();
  constexpr double kRounding = 1e-6;
  double size = 0;
  for (const double y : fit.motion.samples.value) size = std::max(size, std::abs(y - best.from));
  const double least = std::max(kRounding * size, fit.motion.samples.resolution);
  return far_off(fit.motion.samples.place, best.fit.residuals, best.fit.rank, least);
}

std::string quantity(double value, const std::string& unit) {
  return fmt::format("{:.4g}{}", value, unit == "1" ? "" : " " + unit);
}

/// Samples that drew a fit in which all count alike.
std::string drawn_by(const MotionFit& fit) {
  const MotionSamples& samples = fit.motion.samples;
  const std::size_t worst = fit.far_off.samples.front();
  return fmt::format(
      "{} of {} samples lie farther off than chance explains, by {} at {} the most, and draw the "
      "fit; --loss huber or --loss cauchy bounds what they count",
      fit.far_off.samples.size(), samples.place.size(),
      quantity(std::abs(fit.best().fit.residuals[worst]), samples.unit),
      quantity(samples.place[worst], samples.place_unit));
}

bool shows_no_stroke(const LawFit& fit) {
  const optim::FittedParameter& stroke = fit.fit.parameters[MotionLayout::kStroke];
  return stroke.low <= 0 && stroke.high >= 0;
}

/// Whether what is left is as small as the rounding of the values.
bool is_rounding(const MotionFit& fit) {
  return fit.best().fit.rms < fit.motion.samples.resolution / 2;
}

std::vector<std::string> as_good(const MotionFit& fit) {
  constexpr double kAsWell = 2;
  const LawFit& best = fit.best();
  std::vector<std::string> names;
  for (const LawFit& other : fit.ranking) {
    if (&other == &best || other.criterion > best.criterion + kAsWell) continue;
    if (other.numbers > best.numbers || same_motion(other.law, best.law)) continue;
    names.push_back(other.law.label());
  }
  return names;
}

std::string not_told(const MotionFit& fit) {
  if (fit.as_good.empty()) return "";
  return fmt::format("values rounded to {} do not tell {} from {}",
                     quantity(fit.motion.samples.resolution, fit.motion.samples.unit),
                     fit.best().law.label(), fmt::join(fit.as_good, ", "));
}

/// What of the residuals is a curve, in words; empty where they may be noise.
std::string curve_left(const MotionFit& fit) {
  if (!fit.left.is_curve) return "";
  return fmt::format(
      "no law that was tried follows the samples: what {} leaves is no noise (neighbouring "
      "residuals have a correlation of {:.2f}, blocks of them {:.1f} times the squares of noise)",
      fit.best().law.label(), fit.left.correlation, fit.left.block_squares);
}

std::string distrust_of(const MotionFit& fit, const LawFitOptions& options) {
  const LawFit& best = fit.best();
  if (!best.fit.reason.empty()) return best.fit.reason;
  if (!std::isfinite(best.criterion) && best.criterion > 0) {
    return fmt::format("{} samples are too few to tell laws apart",
                       fit.motion.samples.place.size());
  }
  if (shows_no_stroke(best)) return "the samples show no motion: the stroke may as well be 0";
  if (is_exact(best)) return "";
  if (is_rounding(fit)) return not_told(fit);
  if (const std::string curve = curve_left(fit); !curve.empty()) return curve;
  const bool is_drawn = options.loss == optim::Loss::None && draws(fit.far_off, best.fit.residuals);
  return is_drawn ? drawn_by(fit) : "";
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
  try {
    return stretch_law(optim::smoothing_spline(inside.place, inside.value, options));
  } catch (const std::invalid_argument&) {  // too few samples for a curve
    return {};
  }
}

}  // namespace

MotionFit fit_motion(const FoundMotion& motion, const std::vector<Member>& laws,
                     const LawFitOptions& options) {
  MotionFit result{motion, rank_fits(motion.samples, laws, motion.guess, options)};
  if (result.ranking.empty()) {
    throw std::invalid_argument("none of the laws can be fitted to these samples");
  }
  result.prediction_error = cross_validated(motion.samples, result.best(), motion.guess, options);
  result.left =
      optim::residual_pattern(motion.samples.place, optim::counted_residuals(result.best().fit));
  result.far_off = far_off_of(result);
  result.as_good = as_good(result);
  result.distrust = distrust_of(result, options);
  const bool is_curve = motion.samples.order == 0 && !result.distrust.empty() &&
                        result.distrust == curve_left(result);
  if (is_curve) result.smooth = smoothed(result);
  return result;
}

}  // namespace camlaw::problems
