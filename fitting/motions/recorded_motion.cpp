// SPDX-License-Identifier: MIT
#include "fitting/motions/recorded_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "fitting/motions/fault_words.h"
#include "fitting/motions/law_ranking.h"
#include "fitting/motions/motion_residuals.h"
#include "fitting/motions/worn_lift.h"
#include "numerics/linear/statistics.h"
#include "numerics/tables/turn.h"

namespace camlaw::problems {
namespace {

void check_enough(const MotionSamples& samples) {
  const std::size_t count = samples.place.size();
  if (count >= kFewestOfMotion) return;
  throw std::invalid_argument(
      fmt::format("{} sample{} cannot determine a motion, which has begin, end, stroke and zero; "
                  "at least {} rows of numbers are needed",
                  count, count == 1 ? "" : "s", kFewestOfMotion));
}

std::vector<PossibleFault> possible_faults(const MotionSamples& samples, double period) {
  if (samples.order != 0) return {};
  const auto [low, high] = std::minmax_element(samples.place.begin(), samples.place.end());
  std::vector<PossibleFault> faults{drift(*low, *high - *low, period)};
  if (samples.place_unit == "deg") faults.push_back(off_centre());
  return faults;
}

/// What is left of a record where a fault that moves the values by so much of its own is taken out.
TakeOut less_of(const MotionSamples& samples, const PossibleFault& fault) {
  return [&samples, fault](const Eigen::VectorXd& size) {
    WithoutFault result{samples, fault};
    for (std::size_t i = 0; i < samples.place.size(); ++i) {
      for (std::size_t k = 0; k < fault.by.size(); ++k) {
        result.samples.value[i] -=
            size[static_cast<Eigen::Index>(k)] * fault.by[k](samples.place[i]);
      }
    }
    return result;
  };
}

/// Of each motion in which rows lie off, too many of them.
void distrust_many_far(RecordedMotion& found, double period) {
  for (MotionFit& fit : found.cycle.fits) {
    const auto& places = fit.motion.samples.place;
    const auto [low, high] = std::minmax_element(places.begin(), places.end());
    std::vector<FaultyRow> own;
    for (const FaultyRow& row : found.record.far) {
      const double at = period > 0 ? in_period(row.place, *low, period) : row.place;
      if (at <= *high) own.push_back(row);
    }
    if (are_few(own.size(), places.size() + own.size())) continue;
    fit.distrust = many_far(own, places.size() + own.size(), fit.motion.samples);
  }
}

/// Motions that follow each other without a rest, as one: a law may begin backwards, and go beyond
/// where it ends.
std::optional<FoundCycle> as_one(const FoundCycle& several, const MotionSamples& samples) {
  if (several.motions.size() < 2) return {};
  const auto moves = [](const FoundSegment& s) { return s.kind != SegmentKind::Dwell; };
  const auto& segments = several.segments;
  const auto first = std::find_if(segments.begin(), segments.end(), moves);
  const auto last = std::find_if(segments.rbegin(), segments.rend(), moves).base();
  if (!std::all_of(first, last, moves)) return {};
  const FoundSegment& end = *std::prev(last);
  FoundCycle one = several;
  one.segments.assign(segments.begin(), first);
  one.segments.push_back({end.to > first->from ? SegmentKind::Rise : SegmentKind::Return,
                          first->begin, end.end, first->from, end.to, first->begin_error,
                          end.end_error});
  one.segments.insert(one.segments.end(), last, segments.end());
  one.motions = {{{first->begin, end.end, first->from, end.to}, samples, true, true}};
  return one;
}

/// Whether one motion leaves no more than several do, but for chance and rounding.
bool follows_as_well(const FittedCycle& one, const FittedCycle& several,
                     const MotionSamples& samples) {
  constexpr double kNearly = 1.2;  // the deviation of a hundred samples is known to 7 %
  double least = rounding_deviation(samples);
  for (const MotionFit& fit : several.fits) least = std::max(least, fit.best().fit.rms);
  return one.fits.front().best().fit.rms <= kNearly * least;
}

/// The laws of the record; where none can be found, and the lift does not come back to where it
/// began, that is why.
FittedCycle fitted(const MotionSamples& samples, double period, const std::vector<Member>& laws,
                   const LawFitOptions& options) {
  const auto fit = [&]() -> Possible<FittedCycle> {
    auto motions = possible_motions(samples);
    if (!motions) return motions.reason();
    const auto whole = period > 0 ? std::nullopt : as_one(*motions, samples);
    if (!whole) return possible_cycle_fit(std::move(*motions), laws, options);
    constexpr double kFirst = 0.5;  // of the work
    auto several = possible_cycle_fit(std::move(*motions), laws, part_of(options, 0, kFirst));
    auto one = possible_cycle_fit(*whole, laws, part_of(options, kFirst, 1));
    return one && (!several || follows_as_well(*one, *several, samples)) ? one : several;
  };
  Possible<FittedCycle> found = fit();
  if (found) return std::move(*found);
  constexpr double kOpen = 0.02;  // of the whole lift
  const std::vector<std::size_t> order = optim::order_of(samples.place);
  const double first = samples.value[order.front()], last = samples.value[order.back()];
  const auto [low, high] = std::minmax_element(samples.value.begin(), samples.value.end());
  const bool is_open = period != 0 && !(std::abs(last - first) <= kOpen * (*high - *low));
  if (!is_open) throw std::invalid_argument(found.why());
  throw std::invalid_argument(
      fmt::format("the lift is {:.4g} {} where the turn begins and {:.4g} {} where it ends: it "
                  "drifted, or jumped, while it was measured",
                  first, samples.unit, last, samples.unit));
}

/// Whether a row lies on the motion that was fitted without it, no farther than chance explains;
/// beside a break as far as that may be from where it was found.
bool is_on_curve(const FaultyRow& row, const LawFit& law, const MotionSamples& samples) {
  constexpr double kFar = 5;  // standard deviations
  const double most = kFar * std::hypot(law.fit.sigma, rounding_deviation(samples));
  const double aside = kFar * std::max(law.fit.parameters[MotionLayout::kBegin].standard_deviation,
                                       law.fit.parameters[MotionLayout::kEnd].standard_deviation);
  for (const double place : {row.place, row.place - aside, row.place + aside}) {
    if (std::abs(row.value - law.value(place, samples.order)) <= most) return true;
  }
  return false;
}

/// A velocity or acceleration has breaks, over which the curve of neighbours that tells slips is
/// too smooth: rows that lie on the motion found without them are none. Fits again with them.
void fit_with_rows_at_breaks(RecordedMotion& found, double period, const std::vector<Member>& laws,
                             const LawFitOptions& options) {
  constexpr int kTimes = 2;  // the second fit has the first one's rows and may take back some more
  for (int k = 0; k < kTimes && are_tried(found.cycle) && found.cycle.fits.size() == 1; ++k) {
    const LawFit law = found.cycle.fits.front().best();
    const std::size_t count = put_back(found.record, [&](const FaultyRow& row) {
      return is_on_curve(row, law, found.record.samples);
    });
    if (count == 0) return;
    found.cycle = fitted(found.record.samples, period, laws, options);
  }
}

}  // namespace

void distrust_all(FittedCycle& cycle, const std::string& why) {
  for (MotionFit& fit : cycle.fits) {
    if (!fit.unfinished.any()) fit.distrust = why;
  }
}

void distrust_untried(FittedCycle& cycle, const std::vector<std::string>& names) {
  if (names.empty()) return;
  for (MotionFit& fit : cycle.fits) {
    add_names(names, fit.untried);
    fit.distrust = untried_words(fit.untried);
  }
}

bool are_tried(const FittedCycle& cycle) {
  return std::all_of(cycle.fits.begin(), cycle.fits.end(),
                     [](const MotionFit& fit) { return fit.untried.empty(); });
}

bool is_doubtful(const FittedCycle& cycle) {
  return std::any_of(cycle.fits.begin(), cycle.fits.end(), [](const MotionFit& fit) {
    if (fit.unfinished.any()) return false;  // it shows nothing of the others
    return !fit.distrust.empty() || fit.best().has_coefficients();
  });
}

void widen_all(FittedCycle& cycle, const PossibleFault& centre, const Centre& by) {
  for (MotionFit& fit : cycle.fits) {
    for (LawFit& law : fit.ranking) widen(law, fit.motion.samples, centre, by.covariance);
  }
}

RankedMotions ranked_motions(const FittedCycle& cycle) {
  RankedMotions result;
  for (const MotionFit& fit : cycle.fits) {
    if (fit.unfinished.any()) continue;
    result.rankings.push_back(fit.ranking);
    result.samples.push_back(fit.motion.samples);
  }
  return result;
}

std::vector<FaultTest> tested(const RankedMotions& motions, std::vector<PossibleFault> faults) {
  std::vector<FaultTest> tests;
  for (PossibleFault& fault : faults) {
    tests.push_back(test_fault(motions.rankings, motions.samples, std::move(fault)));
  }
  return tests;
}

RecordedMotion fit_recorded_motion(MotionRecord record, const std::vector<Member>& laws,
                                   const RecordedMotionOptions& options) {
  check_enough(record.samples);
  const double period = cycle_period(record.samples);
  if (options.fit_centre && !(period > 0 && record.samples.order == 0)) {
    throw std::invalid_argument(
        "--shift centre needs a lift over a whole turn, with angles in deg or rad");
  }
  if (options.fit.loss == optim::Loss::None) leave_out_far_values(record, period);
  RecordedMotion result{std::move(record), {}, {}};
  constexpr double kCentre = 0.6;  // of the work
  MotionSamples samples = result.record.samples;
  if (options.fit_centre) {
    const TakeOut at = less_of(samples, off_centre());
    result.centre = find_centre(at, laws, part_of(options.fit, 0, kCentre));
    const std::complex<double> centre = result.centre->place;
    samples = at(Eigen::Vector2d(centre.real(), centre.imag()))->samples;
  }
  const bool may_break = samples.order > 0 && !result.record.far.empty();
  constexpr double kFirst = 0.5;  // of the work, where breaks are looked at
  result.cycle =
      fitted(samples, period, laws,
             part_of(options.fit, options.fit_centre ? kCentre : 0, may_break ? kFirst : 1));
  if (may_break) {
    fit_with_rows_at_breaks(result, period, laws, part_of(options.fit, kFirst, 1));
    samples = result.record.samples;
  }
  if (result.centre) {
    widen_all(result.cycle, off_centre(), *result.centre);
    distrust_untried(result.cycle, result.centre->untried);
  }
  if (!are_tried(result.cycle)) return result;
  distrust_many_far(result, period);
  const RankedMotions motions = ranked_motions(result.cycle);
  if (motions.rankings.empty()) return result;
  std::vector<FaultTest> tests = tested(motions, possible_faults(samples, period));
  if (is_doubtful(result.cycle)) {
    const LawFitOptions own = without_deadline(options.fit);
    for (FaultTest& test : tests) {
      const FaultTest far = followed(test, motions, less_of(samples, test.fault), own);
      if (far.with_plain_laws && far.gain > test.gain) test = far;
    }
  }
  result.faults = seen_faults(std::move(tests));
  if (result.faults.empty()) {
    const double first = *std::min_element(samples.place.begin(), samples.place.end());
    weigh_worn_stretches(laws, options.fit, first, result.cycle);
  } else {
    distrust_all(result.cycle,
                 fault_words(result.faults, samples.unit, period > 0 && !options.fit_centre));
  }
  return result;
}

}  // namespace camlaw::problems
