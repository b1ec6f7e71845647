// SPDX-License-Identifier: MIT
#include "problems/fits/motion_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "problems/fits/fitted_law.h"

namespace camlaw::problems {
namespace {

/// Neighbours alike to this degree are no noise; below this many residuals chance makes it.
constexpr double kAlike = 0.5;
constexpr std::size_t kEnough = 20;

bool is_exact(const LawFit& fit) {
  constexpr double kRounding = 1e-9;
  return fit.fit.rms < kRounding * std::abs(fit.to - fit.from);
}

FarOff far_off_of(const MotionFit& fit) {
  const LawFit& best = fit.best();
  constexpr double kRounding = 1e-6;
  double size = 0;
  for (const double y : fit.motion.samples.value) size = std::max(size, std::abs(y - best.from));
  return far_off(fit.motion.samples.place, best.fit.residuals, best.fit.rank, kRounding * size);
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

std::string distrust_of(const MotionFit& fit, const LawFitOptions& options) {
  const LawFit& best = fit.best();
  if (!best.fit.reason.empty()) return best.fit.reason;
  if (is_exact(best) || fit.motion.samples.place.size() < kEnough) return "";
  if (fit.correlation >= kAlike) {
    return fmt::format(
        "no law that was tried follows the samples: what {} leaves is no noise (neighbouring "
        "residuals have a correlation of {:.2f})",
        best.law.label(), fit.correlation);
  }
  const bool is_drawn = options.loss == optim::Loss::None && !fit.far_off.samples.empty();
  return is_drawn ? drawn_by(fit) : "";
}

/// A smooth curve from rest to rest between the ends that the samples show: those of a law that
/// does not follow them are no better.
std::optional<Law<double>> smoothed(const MotionFit& fit) {
  const LawFit& best = fit.best();
  const MotionGuess& shown = fit.motion.guess;
  const MotionSamples inside = between(fit.motion.samples, shown.begin, shown.end);
  optim::SmoothingOptions options;
  options.range = std::pair(shown.begin, shown.end);
  options.begin = {best.from, 0.0, {}};
  options.end = {best.to, 0.0, {}};
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
  result.prediction_error = cross_validated(motion.samples, result.best(), options);
  result.correlation = neighbour_correlation(motion.samples, result.best());
  result.far_off = far_off_of(result);
  result.distrust = distrust_of(result, options);
  const bool is_curve =
      motion.samples.order == 0 && result.correlation >= kAlike && !result.distrust.empty();
  if (is_curve && result.best().fit.reason.empty()) result.smooth = smoothed(result);
  return result;
}

namespace {

/// Where a fitted law has an end of a motion, seen from where the segment had it.
struct FittedEnd {
  double shift, error;
};

FittedEnd fitted_end(const MotionFit& fit, bool begin) {
  const MotionGuess& guess = fit.motion.guess;
  const double shift = begin ? fit.best().begin - guess.begin : fit.best().end - guess.end;
  return {shift, fit.best().fit.parameters[begin ? 0 : 1].standard_deviation};
}

}  // namespace

std::vector<FoundSegment> fitted_segments(const FoundCycle& cycle,
                                          const std::vector<MotionFit>& fits) {
  std::vector<FoundSegment> result = cycle.segments;
  const std::size_t count = result.size();
  std::size_t motion = 0;
  for (std::size_t i = 0; i < count && motion < fits.size(); ++i) {
    if (cycle.segments[i].kind == SegmentKind::Dwell) continue;
    const MotionFit& fit = fits[motion++];
    if (!fit.distrust.empty()) continue;
    const FittedEnd begin = fitted_end(fit, true), end = fitted_end(fit, false);
    result[i].begin = cycle.segments[i].begin + begin.shift;
    result[i].begin_error = begin.error;
    result[i].end = cycle.segments[i].end + end.shift;
    result[i].end_error = end.error;
    FoundSegment &before = result[(i + count - 1) % count], &after = result[(i + 1) % count];
    if (before.kind == SegmentKind::Dwell && before.end_error > 0) {
      before.end += begin.shift;
      before.end_error = begin.error;
    }
    if (after.kind == SegmentKind::Dwell && after.begin_error > 0) {
      after.begin += end.shift;
      after.begin_error = end.error;
    }
  }
  return result;
}

}  // namespace camlaw::problems
