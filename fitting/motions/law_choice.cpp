// SPDX-License-Identifier: MIT
#include "fitting/motions/law_choice.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "fitting/motions/motion_residuals.h"
#include "fitting/motions/same_motion.h"
#include "numerics/linear/statistics.h"

namespace camlaw::problems {

void weigh(std::vector<LawFit>& fits) {
  constexpr double kShare = 3;  // that laws without a number are tried more often than with it
  std::map<std::size_t, double> count;
  for (const LawFit& fit : fits) count[fit.numbers] += 1;
  double best = optim::kInfinity, sum = 0;
  for (LawFit& fit : fits) {
    fit.criterion += 2 * std::log(count[fit.numbers]) +
                     2 * std::log(kShare) * static_cast<double>(fit.numbers - count.begin()->first);
    best = std::min(best, fit.criterion);
  }
  for (LawFit& fit : fits) {
    // Equal ones count, be they infinite: nothing is known then, or all.
    fit.weight = fit.criterion == best ? 1 : std::exp(-(fit.criterion - best) / 2);
    sum += fit.weight;
  }
  for (LawFit& fit : fits) fit.weight /= sum;
}

void put_in_order(std::vector<LawFit>& fits) {
  if (fits.empty()) return;
  std::stable_sort(fits.begin(), fits.end(),
                   [](const LawFit& a, const LawFit& b) { return a.criterion < b.criterion; });
  constexpr double kAsWell = 4;  // a seventh of the weight
  const auto as_well = std::find_if(fits.begin(), fits.end(), [&](const LawFit& fit) {
    return fit.criterion > fits.front().criterion + kAsWell;
  });
  const auto simplest =
      std::min_element(fits.begin(), as_well,
                       [](const LawFit& a, const LawFit& b) { return a.numbers < b.numbers; });
  std::rotate(fits.begin(), simplest, simplest + 1);
}

namespace {

/// Whether b is the law of a with a crossover that its interval does not tell from no crossover.
bool is_hardly_skewed(const LawFit& a, const LawFit& b) {
  if (a.skew != Skew::Held || b.skew != Skew::Free || !(a.law.family == b.law.family)) return false;
  const auto& crossover = b.fit.parameters.back();
  return crossover.low <= 0.5 && crossover.high >= 0.5;
}

}  // namespace

AsGood as_good(const std::vector<LawFit>& ranking) {
  // Laws with all but one part in 2000 of the weight are named. Where those that are told have less
  // than 99 % of it, noise leaves the law open (LC2).
  constexpr double kEnough = 0.9995, kTold = 0.99;
  AsGood result;
  double sum = ranking.front().weight;
  for (std::size_t i = 1; i < ranking.size() && sum < kEnough; ++i) {
    const double before = sum;
    sum += ranking[i].weight;
    const auto is_same = [&](std::size_t k) {
      const LawFit &known = ranking[k], &other = ranking[i];
      return same_motion(known.law, other.law) || is_hardly_skewed(known, other);
    };
    if (is_same(0) || std::any_of(result.fits.begin(), result.fits.end(), is_same)) continue;
    if (result.fits.size() == kFewLaws) result.is_told = before >= kTold;
    result.fits.push_back(i);
  }
  return result;
}

namespace {

/// What the laws that determine the j-th number say of it, each by its weight.
std::vector<optim::StudentPart> said_of(std::size_t j, const std::vector<LawFit>& ranking,
                                        double confidence) {
  constexpr double kLeast = 1e-4;  // of the weight: less moves no interval
  std::vector<optim::StudentPart> parts;
  for (const LawFit& fit : ranking) {
    const optim::FittedParameter& p = fit.fit.parameters[j];
    // With as many numbers as samples there is no scatter that a deviation could follow from.
    const bool is_known =
        std::isfinite(p.low) && std::isfinite(p.high) && fit.fit.degrees_of_freedom > 0;
    if (fit.weight < kLeast || !is_known || !(p.standard_deviation > 0)) continue;
    const double t = optim::student_quantile(fit.fit.degrees_of_freedom, confidence);
    parts.push_back({fit.weight, p.value, (p.value - p.low) / t, (p.high - p.value) / t,
                     fit.fit.degrees_of_freedom});
  }
  return parts;
}

}  // namespace

void widen_by_others(std::vector<LawFit>& ranking, double confidence) {
  if (ranking.empty()) return;
  LawFit& named = ranking.front();
  for (std::size_t j = 0; j < named.base; ++j) {
    optim::FittedParameter& own = named.fit.parameters[j];
    const bool has_deviation = own.standard_deviation > 0 && std::isfinite(own.standard_deviation);
    if (!has_deviation || named.fit.degrees_of_freedom < 1) continue;
    const auto parts = said_of(j, ranking, confidence);
    if (parts.size() > 1) {
      own.low = std::min(own.value, optim::mixture_quantile(parts, (1 - confidence) / 2));
      own.high = std::max(own.value, optim::mixture_quantile(parts, (1 + confidence) / 2));
    }
    // A law that is hardly likely may lie far off: it has a part in the deviation of a mixture that
    // it does not have in what is between the quantiles.
    const double t = optim::student_quantile(named.fit.degrees_of_freedom, confidence);
    const double deviation = (own.high - own.low) / (2 * t);
    if (std::isfinite(deviation)) own.standard_deviation = deviation;
  }
}

}  // namespace camlaw::problems
