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

std::string distrust_of(const MotionFit& fit) {
  const LawFit& best = fit.best();
  if (!best.fit.reason.empty()) return best.fit.reason;
  if (is_exact(best) || fit.motion.samples.place.size() < kEnough || fit.correlation < kAlike) {
    return "";
  }
  return fmt::format(
      "no law that was tried follows the samples: what {} leaves is no noise (neighbouring "
      "residuals have a correlation of {:.2f})",
      best.law.label(), fit.correlation);
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
  result.distrust = distrust_of(result);
  const bool is_curve = motion.samples.order == 0 && !result.distrust.empty();
  if (is_curve && result.best().fit.reason.empty()) result.smooth = smoothed(result);
  return result;
}

}  // namespace camlaw::problems
