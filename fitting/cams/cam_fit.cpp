// SPDX-License-Identifier: MIT
#include "fitting/cams/cam_fit.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "fitting/cams/cam_faults.h"
#include "fitting/motions/fault_words.h"
#include "fitting/motions/law_choice.h"
#include "fitting/motions/law_ranking.h"
#include "fitting/motions/recorded_motion.h"
#include "numerics/tables/turn.h"

namespace camlaw::problems {
namespace {

/// What it takes to tell all samples with a fault of the record, as (WR1) counts.
FaultScore by_score(double noise) {
  return {[noise](std::size_t n, std::size_t numbers, double squares) {
            return squares / (noise * noise) +
                   std::log(static_cast<double>(n)) * static_cast<double>(numbers);
          },
          false};
}

/// How the motions of a cam can be read.
struct CycleReadings {
  std::vector<std::vector<Reading>> of;  ///< of each motion, the best first
  std::vector<Departure> stretches;      ///< what departs, of all motions
  std::vector<Scatter> scatter;          ///< of each motion's samples
  std::vector<std::string> untried;      ///< laws that the deadline left no time for
};

/// Stretches around the turn, each once: what is worn where two motions meet departs from both.
std::vector<Departure> around_turn(std::vector<Departure> stretches) {
  constexpr double kBeside = 1;  // deg
  for (Departure& d : stretches) {
    const double from = in_period(d.from, 0, kTurnDegrees);
    d.to += from - d.from, d.from = from;
  }
  std::sort(stretches.begin(), stretches.end(),
            [](const Departure& a, const Departure& b) { return a.from < b.from; });
  std::vector<Departure> result;
  const auto join = [&](Departure& before, const Departure& after, double shift) {
    const bool is_same = (before.most > 0) == (after.most > 0);
    if (!is_same || after.from + shift > before.to + kBeside) return false;
    before.to = std::max(before.to, after.to + shift);
    before.count += after.count;
    if (std::abs(after.most) > std::abs(before.most)) before.most = after.most;
    return true;
  };
  for (const Departure& d : stretches) {
    if (result.empty() || !join(result.back(), d, 0)) result.push_back(d);
  }
  if (result.size() > 1 && join(result.back(), result.front(), kTurnDegrees)) {
    result.erase(result.begin());
  }
  return result;
}

/// Of all motions; none departs where a fault of the record tells the samples better, or where a
/// law that was not tried might.
CycleReadings readings_of_cycle(const MeasuredCam& cam, const FoundCycle& cycle,
                                const std::vector<Member>& laws, const LawFitOptions& options,
                                double noise) {
  CycleReadings result;
  std::vector<std::vector<LawFit>> rankings;
  std::vector<MotionSamples> samples;
  double score = 0, most = noise;
  const auto count = static_cast<double>(cycle.motions.size());
  for (const FoundMotion& motion : cycle.motions) {
    const auto before = static_cast<double>(samples.size());
    const auto part = part_of(options, before / count, (before + 1) / count);
    samples.push_back(motion.samples);
    Ranking ranking = robust_ranking(motion, laws, part, noise);
    rankings.push_back(std::move(ranking.fits));
    add_names(ranking.untried, result.untried);
    if (!result.untried.empty()) continue;
    result.scatter.push_back(scatter_of(motion, rankings.back(), noise));
    most = std::max(most, result.scatter.back().noise);
    result.of.push_back(readings_of(motion, rankings.back(), part, result.scatter.back()));
    if (result.of.back().empty()) continue;
    const Reading& best = result.of.back().front();
    score += best.score;
    result.stretches.insert(result.stretches.end(), best.departures.begin(), best.departures.end());
  }
  if (!result.untried.empty()) return {{}, {}, {}, std::move(result.untried)};
  if (result.stretches.empty()) return result;
  for (PossibleFault& fault : possible_faults(cam)) {
    const FaultTest test = test_fault(rankings, samples, std::move(fault), by_score(most));
    if (test.score < score) result.stretches.clear();
  }
  result.stretches = around_turn(std::move(result.stretches));
  return result;
}

/// What a motion was taken for, without the stretches that were left out; `all` are its samples
/// with these, maybe a turn apart.
Reading chosen_reading(const MotionFit& fit, const FoundMotion& all,
                       const std::vector<Departure>& stretches, const Scatter& scatter) {
  Reading chosen{fit.best(), {}, 0};
  const double shift =
      kTurnDegrees * std::round((chosen.law.begin - all.guess.begin) / kTurnDegrees);
  chosen.law.begin -= shift, chosen.law.end -= shift;
  for (const Departure& d : departures(all.samples, chosen.law, scatter.noise)) {
    if (departs(std::midpoint(d.from, d.to), stretches, kTurnDegrees)) {
      chosen.departures.push_back(d);
    }
  }
  chosen.score = score_of(chosen.law, chosen.departures, stretches, scatter, kTurnDegrees);
  return chosen;
}

/// Which of the motions of another division of the turn it is: where their middles are nearest.
std::size_t same_motion_of(const MotionFit& fit, const FoundCycle& all) {
  const auto middle = [](const FoundMotion& m) {
    return std::midpoint(m.guess.begin, m.guess.end);
  };
  const auto distance = [&](const FoundMotion& m) {
    return std::abs(std::remainder(middle(m) - middle(fit.motion), kTurnDegrees));
  };
  const auto nearest =
      std::min_element(all.motions.begin(), all.motions.end(),
                       [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  return static_cast<std::size_t>(nearest - all.motions.begin());
}

/// Trusts no motion that can be read in another way as well, and tells the stretches as what was
/// found for the motions has them.
void weigh_readings(const FoundCycle& all, const CycleReadings& readings, CamFit& fit) {
  if (readings.of.empty()) return;  // laws were not tried
  const MotionSamples& samples = fit.cam.samples;
  std::vector<Departure> named;
  for (std::size_t k = 0; k < fit.cycle.fits.size(); ++k) {
    MotionFit& motion = fit.cycle.fits[k];
    const std::size_t own = same_motion_of(motion, all);
    const Scatter& scatter = readings.scatter[own];
    const Reading chosen = chosen_reading(motion, all.motions[own], readings.stretches, scatter);
    named.insert(named.end(), chosen.departures.begin(), chosen.departures.end());
    const std::vector<Reading> rivals = rivals_of(chosen, readings.of[own]);
    if (rivals.empty()) continue;
    std::vector<std::string> words{reading_words(chosen, samples)};
    for (const Reading& rival : rivals) {
      if (words.size() <= kFewLaws) words.push_back(reading_words(rival, samples));
      fit.others.push_back({k, rival});
    }
    motion.distrust += fmt::format("{}the samples can be read in {} ways: {}",
                                   motion.distrust.empty() ? "" : "; or ", words.size(),
                                   fmt::join(words, "; or "));
  }
  for (const Departure& stretch : readings.stretches) {
    const double middle = std::midpoint(stretch.from, stretch.to);
    if (!departs(middle, named, kTurnDegrees)) named.push_back(stretch);
  }
  fit.departures = around_turn(std::move(named));
}

/// What is left of a cam where a size of its follower is as far off as that.
TakeOut other_size(const MeasuredCam& cam, const std::string& name) {
  return [&cam, name](const Eigen::VectorXd& size) -> Possible<WithoutFault> {
    const auto changed = with_follower(cam, with_less(cam.lift.follower(), name, size[0]));
    if (!changed) return changed.reason();
    for (PossibleFault& fault : possible_faults(*changed)) {
      if (fault.names.front() == name) return WithoutFault{changed->samples, std::move(fault)};
    }
    throw std::logic_error("a follower has lost a size");
  };
}

double offset_of(const MeasuredCam& cam) {
  return std::get<TranslatingRoller>(cam.lift.follower()).offset;
}

/// Other offsets from which steps may lead to the right one, as differences: none at all, the other
/// side, and quarters of the lowest pitch radius to both sides.
std::vector<double> less_offset(const MeasuredCam& cam) {
  constexpr int kQuarters = 2;  // offsets beyond half of the lowest pitch radius are not built
  const double stated = offset_of(cam), lowest = cam.lift.lowest();
  const double quarter = std::abs(cam.lift.coordinate(lowest)) / 4;
  std::vector<double> less;
  const auto add = [&](double offset) {
    const auto is_near = [&](double other) {
      return std::abs(stated - offset - other) < quarter / 4;
    };
    if (is_near(0) || std::any_of(less.begin(), less.end(), is_near)) return;
    less.push_back(stated - offset);
  };
  add(-stated);
  for (int k = 0; k <= kQuarters; ++k) add(k * quarter), add(-k * quarter);
  return less;
}

/// The laws without coefficients that were tried, as they fit a cam that was read with another
/// follower; none where it shows no motion.
std::optional<RankedMotions> with_plain_laws(const MeasuredCam& cam, const CamFit& fit,
                                             const LawFitOptions& options) {
  std::vector<Member> plain;
  for (const LawFit& law : fit.cycle.fits.front().ranking) {
    if (!law.has_coefficients()) plain.push_back(law.law);
  }
  const auto cycle = possible_motions(cam.samples);
  if (!cycle || plain.empty()) return {};
  RankedMotions result;
  for (const FoundMotion& motion : cycle->motions) {
    auto ranking = possible_ranking(motion.samples, plain, motion.guess, options);
    if (!ranking) return {};
    result.rankings.push_back(std::move(ranking->fits));
    result.samples.push_back(motion.samples);
  }
  return result;
}

/// The test of an offset that may be so far off that no steps from the stated one lead to it, as
/// where its sign is the wrong one: the likeliest of those to which steps from others lead.
FaultTest followed_from_elsewhere(const FaultTest& near, const FaultTest& test, const CamFit& fit,
                                  const LawFitOptions& options) {
  constexpr double kBeyondChance = 5;  // deviations
  const std::string& name = test.fault.names.front();
  FaultTest best = near;
  for (const double less : less_offset(fit.cam)) {
    const auto other = with_follower(fit.cam, with_less(fit.cam.lift.follower(), name, less));
    if (!other) continue;
    const auto motions = with_plain_laws(*other, fit, options);
    if (!motions) continue;
    FaultTest there = test;
    for (PossibleFault& fault : possible_faults(*other)) {
      if (fault.names == test.fault.names) there.fault = std::move(fault);
    }
    FaultTest found = followed(there, *motions, other_size(*other, name), options);
    found.size[0] += less;
    found.with_plain_laws =
        found.covariance.allFinite() &&
        std::abs(found.size[0]) > kBeyondChance * std::sqrt(found.covariance(0, 0));
    if (!found.with_plain_laws) continue;
    if (!best.with_plain_laws || found.gain > best.gain) best = std::move(found);
  }
  return best;
}

/// Faults that what the laws leave shows; where the laws are doubtful sizes of the follower are
/// followed as far as they lead.
std::vector<FaultTest> faults_of(const CamFit& fit, const LawFitOptions& options) {
  const RankedMotions motions = ranked_motions(fit.cycle);
  std::vector<FaultTest> tests = tested(motions, possible_faults(fit.cam));
  if (is_doubtful(fit.cycle)) {
    for (FaultTest& test : tests) {
      if (test.fault.kind != FaultKind::OwnSize) continue;
      const std::string& name = test.fault.names.front();
      FaultTest near = followed(test, motions, other_size(fit.cam, name), options);
      const bool is_told = near.with_plain_laws && near.gain > kGainWithPlainLaws;
      const bool is_lost = test.fault.may_be_far && !is_told;
      test = is_lost ? followed_from_elsewhere(near, test, fit, options) : near;
    }
  }
  return seen_faults(std::move(tests));
}

CamFit fitted_cam(MeasuredCam cam, const std::vector<Member>& laws, const LawFitOptions& options,
                  std::optional<Centre> centre) {
  FoundCycle cycle = find_motions(cam.samples);
  const double noise = std::max(cycle.noise, kLeastDeparture * cam.lift.stroke() / cam.unit());
  constexpr double kFirst = 0.5;  // of the work
  CycleReadings readings = readings_of_cycle(cam, cycle, laws, part_of(options, 0, kFirst), noise);
  const FoundCycle all = cycle;
  if (!readings.stretches.empty()) {
    cycle = find_motions(without(cam.samples, readings.stretches, kTurnDegrees));
  }
  CamFit fit{std::move(cam), fit_cycle(std::move(cycle), laws, part_of(options, kFirst, 1)),
             readings.stretches};
  if (centre) add_names(centre->untried, readings.untried);
  distrust_untried(fit.cycle, readings.untried);
  if (are_tried(fit.cycle)) fit.faults = faults_of(fit, without_deadline(options));
  if (!fit.faults.empty()) {
    distrust_all(fit.cycle, fault_words(fit.faults, fit.cam.samples.unit, !centre));
  }
  weigh_readings(all, readings, fit);
  // What a fault of the whole record makes of the laws looks worn too.
  if (!fit.faults.empty()) fit.departures.clear();
  fit.centre = centre;
  if (centre) widen_all(fit.cycle, centre_of(fit.cam), *centre);
  return fit;
}

}  // namespace

CamFit fit_cam(MeasuredCam cam, const std::vector<Member>& laws, const LawFitOptions& options) {
  return fitted_cam(std::move(cam), laws, options, {});
}

CamFit fit_centred_cam(const SampleTable& table, const ProblemStatement& machine,
                       const std::vector<Member>& laws, const LawFitOptions& options) {
  constexpr double kCentre = 0.4;  // of the work
  const Centre centre = find_centre(
      [&](const Eigen::VectorXd& at) {
        const MeasuredCam cam = measured_cam(table, machine, {at[0], at[1]});
        return WithoutFault{cam.samples, centre_of(cam)};
      },
      laws, part_of(options, 0, kCentre));
  return fitted_cam(measured_cam(table, machine, centre.place), laws, part_of(options, kCentre, 1),
                    centre);
}

}  // namespace camlaw::problems
