// SPDX-License-Identifier: MIT
#include "fitting/motions/fitted_cycle.h"

#include "fitting/motions/motion_residuals.h"

namespace camlaw::problems {
namespace {

/// Where a fitted law has an end of a motion, seen from where the segment had it.
struct FittedEnd {
  double shift, error;
};

FittedEnd fitted_end(const MotionFit& fit, bool begin) {
  const MotionGuess& guess = fit.motion.guess;
  const double shift = begin ? fit.best().begin - guess.begin : fit.best().end - guess.end;
  const std::size_t end = begin ? MotionLayout::kBegin : MotionLayout::kEnd;
  return {shift, fit.best().fit.parameters[end].standard_deviation};
}

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
  // A motion may end where the samples do, or beyond.
  std::erase_if(result, [](const FoundSegment& segment) {
    return segment.kind == SegmentKind::Dwell && segment.end <= segment.begin;
  });
  return result;
}

}  // namespace

FittedCycle fit_cycle(FoundCycle cycle, const std::vector<Member>& laws,
                      const LawFitOptions& options) {
  return possible_cycle_fit(std::move(cycle), laws, options).value();
}

Possible<FittedCycle> possible_cycle_fit(FoundCycle cycle, const std::vector<Member>& laws,
                                         const LawFitOptions& options) {
  FittedCycle result{std::move(cycle), {}, {}};
  const auto count = static_cast<double>(result.found.motions.size());
  for (const FoundMotion& motion : result.found.motions) {
    const auto before = static_cast<double>(result.fits.size());
    auto fit =
        possible_motion_fit(motion, laws, part_of(options, before / count, (before + 1) / count));
    if (!fit) return fit.reason();
    result.fits.push_back(std::move(*fit));
  }
  result.segments = fitted_segments(result.found, result.fits);
  return result;
}

}  // namespace camlaw::problems
