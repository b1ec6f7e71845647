// SPDX-License-Identifier: MIT
#include "fitting/cams/cam_fit.h"

#include <algorithm>
#include <optional>

#include "fitting/cams/cam_faults.h"
#include "fitting/motions/fault_words.h"
#include "fitting/motions/law_ranking.h"
#include "fitting/motions/recorded_motion.h"
#include "numerics/tables/turn.h"
#include "optim/fit/loss.h"

namespace camlaw::problems {
namespace {

/// A law with what departs from it.
struct Explanation {
  LawFit law;
  std::vector<Departure> departures;
  double cost = 0;
};

/// What it takes to tell the samples by the law: squares in units of the noise, two for each number
/// of the law and each end of a stretch, and for a sample that departs as much as for one that lies
/// 2.5 deviations off.
double cost_of(const Explanation& told, double noise) {
  constexpr double kOff = 2.5;
  double cost =
      told.law.fit.sum_of_squares / (noise * noise) + 2 * static_cast<double>(told.law.numbers);
  for (const Departure& d : told.departures) {
    cost += 4 + kOff * kOff * static_cast<double>(d.count);
  }
  return cost;
}

/// Departures from a law, which is fitted again without them until no more do.
Explanation explained(const FoundMotion& motion, LawFit law, LawFitOptions options, double noise) {
  options.skew = law.skew;
  constexpr int kPasses = 4;
  Explanation told{std::move(law), {}, 0};
  for (int pass = 0; pass < kPasses; ++pass) {
    const std::size_t before = told.departures.size();
    told.departures = departures(motion.samples, told.law, noise);
    if (pass > 0 && told.departures.size() == before) break;
    const MotionGuess guess{told.law.begin, told.law.end, told.law.from, told.law.to};
    told.law = fit_law(without(motion.samples, told.departures), told.law.law, guess, options);
  }
  told.cost = cost_of(told, noise);
  return told;
}

/// The law that tells one motion best, with what departs from it.
std::optional<Explanation> best_explanation(const FoundMotion& motion,
                                            const std::vector<LawFit>& ranking,
                                            const LawFitOptions& options, double noise) {
  constexpr std::size_t kTried = 8;
  std::optional<Explanation> best;
  for (std::size_t i = 0; i < std::min(kTried, ranking.size()); ++i) {
    Explanation told = explained(motion, ranking[i], options, noise);
    if (!best || told.cost < best->cost) best = std::move(told);
  }
  return best;
}

/// All laws, so that what departs does not pull them to itself.
Ranking robust_ranking(const FoundMotion& motion, const std::vector<Member>& laws,
                       const LawFitOptions& options, double noise) {
  LawFitOptions robust = options;
  if (robust.loss == optim::Loss::None) robust.loss = optim::Loss::Huber;
  robust.loss_scale = noise * optim::efficient_scale(robust.loss);
  return rank_fits(motion.samples, laws, motion.guess, robust);
}

/// What it takes to tell all samples with a fault of the record, as cost_of() counts.
FaultScore by_cost(double noise) {
  return {[noise](std::size_t, std::size_t numbers, double squares) {
            return squares / (noise * noise) + 2 * static_cast<double>(numbers);
          },
          false};
}

struct Departed {
  std::vector<Departure> stretches;
  std::vector<std::string> untried;  ///< laws that the deadline left no time for
};

/// Stretches that depart, of all motions; none where a fault of the record tells the samples
/// better, or where a law that was not tried might.
Departed departures_of(const MeasuredCam& cam, const FoundCycle& cycle,
                       const std::vector<Member>& laws, const LawFitOptions& options,
                       double noise) {
  std::vector<Departure> departed;
  std::vector<std::string> untried;
  std::vector<std::vector<LawFit>> rankings;
  std::vector<MotionSamples> samples;
  double cost = 0;
  const auto count = static_cast<double>(cycle.motions.size());
  for (const FoundMotion& motion : cycle.motions) {
    const auto before = static_cast<double>(samples.size());
    const auto part = part_of(options, before / count, (before + 1) / count);
    samples.push_back(motion.samples);
    Ranking ranking = robust_ranking(motion, laws, part, noise);
    rankings.push_back(std::move(ranking.fits));
    add_names(ranking.untried, untried);
    if (!untried.empty()) continue;
    auto best = best_explanation(motion, rankings.back(), options, noise);
    if (!best) continue;
    cost += best->cost;
    departed.insert(departed.end(), best->departures.begin(), best->departures.end());
  }
  if (!untried.empty() || departed.empty()) return {{}, std::move(untried)};
  for (PossibleFault& fault : possible_faults(cam)) {
    const FaultTest test = test_fault(rankings, samples, std::move(fault), by_cost(noise));
    if (test.score < cost) return {};
  }
  return {std::move(departed), {}};
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
  constexpr int kQuarters = 2;
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
  Departed departed = departures_of(cam, cycle, laws, part_of(options, 0, kFirst), noise);
  if (!departed.stretches.empty()) {
    cycle = find_motions(without(cam.samples, departed.stretches, kTurnDegrees));
  }
  CamFit fit{std::move(cam), fit_cycle(std::move(cycle), laws, part_of(options, kFirst, 1)),
             std::move(departed.stretches)};
  if (centre) add_names(centre->untried, departed.untried);
  distrust_untried(fit.cycle, departed.untried);
  if (are_tried(fit.cycle)) fit.faults = faults_of(fit, without_deadline(options));
  if (!fit.faults.empty()) {
    distrust_all(fit.cycle, fault_words(fit.faults, fit.cam.samples.unit, !centre));
  }
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
