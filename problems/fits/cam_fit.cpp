// SPDX-License-Identifier: MIT
#include "problems/fits/cam_fit.h"

#include <algorithm>
#include <optional>

#include "problems/fits/law_ranking.h"
#include "problems/fits/turn.h"

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

/// Stretches of one motion that depart from the law that tells it best.
std::vector<Departure> departures_of(const FoundMotion& motion, const std::vector<Member>& laws,
                                     const LawFitOptions& options, double noise) {
  constexpr std::size_t kTried = 8;
  LawFitOptions robust = options;  // what departs must not pull the law to itself
  if (robust.loss == optim::Loss::None) robust.loss = optim::Loss::Huber;
  robust.loss_scale = noise * optim::efficient_scale(robust.loss);
  std::vector<LawFit> ranking = rank_fits(motion.samples, laws, motion.guess, robust);
  std::optional<Explanation> best;
  for (std::size_t i = 0; i < std::min(kTried, ranking.size()); ++i) {
    Explanation told = explained(motion, std::move(ranking[i]), options, noise);
    if (!best || told.cost < best->cost) best = std::move(told);
  }
  return best ? std::move(best->departures) : std::vector<Departure>{};
}

}  // namespace

CamFit fit_cam(MeasuredCam cam, const std::vector<Member>& laws, const LawFitOptions& options) {
  FoundCycle cycle = find_motions(cam.samples);
  const double noise = std::max(cycle.noise, kLeastDeparture * cam.lift.stroke() *
                                                 (cam.samples.unit == "deg" ? 1 / kDegree : 1));
  std::vector<Departure> departed;
  constexpr double kFirst = 0.5;  // of the work
  const auto count = static_cast<double>(cycle.motions.size());
  double before = 0;
  for (const FoundMotion& motion : cycle.motions) {
    const auto part = part_of(options, kFirst * before / count, kFirst * (before + 1) / count);
    const auto found = departures_of(motion, laws, part, noise);
    ++before;
    departed.insert(departed.end(), found.begin(), found.end());
  }
  if (!departed.empty()) cycle = find_motions(without(cam.samples, departed, kTurnDegrees));
  return {std::move(cam), fit_cycle(std::move(cycle), laws, part_of(options, kFirst, 1)),
          std::move(departed)};
}

}  // namespace camlaw::problems
