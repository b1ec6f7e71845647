// SPDX-License-Identifier: MIT
#include "fitting/motions/recorded_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "fitting/motions/fault_words.h"
#include "fitting/motions/law_ranking.h"
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

/// The laws of the record; where none can be found, and the lift does not come back to where it
/// began, that is why.
FittedCycle fitted(const MotionSamples& samples, double period, const std::vector<Member>& laws,
                   const LawFitOptions& options) {
  const auto fit = [&]() -> Possible<FittedCycle> {
    auto motions = possible_motions(samples);
    if (!motions) return motions.reason();
    return possible_cycle_fit(std::move(*motions), laws, options);
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

}  // namespace

void distrust_all(FittedCycle& cycle, const std::string& why) {
  for (MotionFit& fit : cycle.fits) fit.distrust = why;
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
  result.cycle =
      fitted(samples, period, laws, part_of(options.fit, options.fit_centre ? kCentre : 0, 1));
  if (result.centre) {
    widen_all(result.cycle, off_centre(), *result.centre);
    distrust_untried(result.cycle, result.centre->untried);
  }
  if (!are_tried(result.cycle)) return result;
  distrust_many_far(result, period);
  const RankedMotions motions = ranked_motions(result.cycle);
  std::vector<FaultTest> tests = tested(motions, possible_faults(samples, period));
  if (is_doubtful(result.cycle)) {
    const LawFitOptions own = without_deadline(options.fit);
    for (FaultTest& test : tests) {
      const FaultTest far = followed(test, motions, less_of(samples, test.fault), own);
      if (far.with_plain_laws && far.gain > test.gain) test = far;
    }
  }
  result.faults = seen_faults(std::move(tests));
  if (!result.faults.empty()) {
    distrust_all(result.cycle,
                 fault_words(result.faults, samples.unit, period > 0 && !options.fit_centre));
  }
  return result;
}

}  // namespace camlaw::problems
