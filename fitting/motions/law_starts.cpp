// SPDX-License-Identifier: MIT
#include "fitting/motions/law_starts.h"

#include <algorithm>

#include "fitting/motions/law_residuals.h"
#include "kinematics/laws/free_ends.h"

namespace camlaw::problems {
namespace {

using RoughFit = std::function<Possible<optim::FitResult>(const FitParameters&)>;

/// A fit of everything but begin and end, which stay at these.
Possible<optim::FitResult> between_ends(const RoughFit& fit, const FitParameters& parameters,
                                        double begin, double end) {
  return fit(holding(starting_at(parameters, std::vector{begin, end}), 0, 2));
}

/// The same for the best of many ends around those of the parameters. With free values at its ends
/// a polynomial is the same curve over any stretch: only how it meets the rests tells them, and the
/// sum of squares has a valley at each of many places.
Possible<optim::FitResult> over_ends(const RoughFit& fit, const FitParameters& parameters) {
  constexpr double kAside[] = {-0.12, -0.06, -0.03, -0.01, 0, 0.01, 0.03, 0.06, 0.12};
  const double begin = parameters[MotionLayout::kBegin].start;
  const double end = parameters[MotionLayout::kEnd].start, length = end - begin;
  std::optional<optim::FitResult> best;
  for (const double before : kAside) {
    for (const double after : kAside) {
      auto one = between_ends(fit, parameters, begin + before * length, end + after * length);
      if (!one) return one;
      if (!best || one->merit < best->merit) best = std::move(*one);
    }
  }
  return *std::move(best);
}

/// Whether a lift goes beyond the levels that it rests at, by more than noise does.
bool goes_beyond(const MotionSamples& samples, const FitParameters& parameters) {
  constexpr double kBeyond = 0.01;  // of the stroke
  if (samples.order != 0) return false;
  const double from = parameters[MotionLayout::kZero].start,
               stroke = parameters[MotionLayout::kStroke].start;
  return std::any_of(samples.value.begin(), samples.value.end(), [&](double value) {
    const double share = (value - from) / stroke;
    return share < -kBeyond || share > 1 + kBeyond;
  });
}

Possible<std::vector<double>> where_it_ends(const Possible<optim::FitResult>& fit) {
  if (!fit) return fit.reason();
  return values_of(*fit);
}

/// Values of fits, the best first, without those of the same valley and without poor ones.
std::vector<std::vector<double>> best_of(std::vector<optim::FitResult> fits) {
  // Rough fits end within a thousandth of their valley's sum. A valley that is worse by half stays
  // worse with all samples.
  constexpr double kSame = 1e-3, kNearly = 1.5;
  std::stable_sort(fits.begin(), fits.end(),
                   [](const auto& a, const auto& b) { return a.merit < b.merit; });
  std::vector<std::vector<double>> result;
  double before = -1;
  for (const optim::FitResult& fit : fits) {
    if (fit.merit > kNearly * fits.front().merit) break;
    if (fit.merit <= before * (1 + kSame)) continue;
    before = fit.merit;
    result.push_back(values_of(fit));
  }
  return result;
}

}  // namespace

Possible<std::vector<std::vector<double>>> law_starts(const MotionSamples& means, const Member& law,
                                                      const FitParameters& parameters,
                                                      const LawFitOptions& options) {
  constexpr auto kBegin = MotionLayout::kBegin, kEnd = MotionLayout::kEnd;
  const LawResiduals few(means, law, options.skew, parameters);
  optim::FitOptions rough = fit_options(options, optim::FitReach::Rough);
  rough.loss_scale.reset();
  if (means.each > 1) rough.loss = optim::Loss::None;
  const RoughFit fit = [&](const FitParameters& from) {
    return optim::possible_fit(from, few.residuals(), rough);
  };
  const FitParameters own = few.own();
  // A fit of the law as it is tells where a fit of all finds the right valley.
  const auto as_it_is = fit(holding(own, few.first(), own.size()));
  if (!as_it_is) return as_it_is.reason();
  const std::vector<double> alone = values_of(*as_it_is);
  if (own.size() == few.first()) return std::vector<std::vector<double>>{alone};
  const FitParameters near = starting_at(own, std::span(alone).first(few.first()));
  std::vector<optim::FitResult> found;
  std::optional<Impossible> fault;  // the first of them
  const auto add = [&](const Possible<std::vector<double>>& values) {
    if (fault) return;
    auto one = values ? fit(starting_at(near, *values)) : values.reason();
    if (one) {
      found.push_back(std::move(*one));
    } else {
      fault = one.reason();
    }
  };
  add(std::vector<double>{});    // as it is near
  if (options.like && !fault) {  // where another law follows the samples
    add(where_it_ends(between_ends(fit, own, options.like->begin, options.like->end)));
  }
  // There the law as it is, which does not, is shorter: its ends are no start for the others.
  if (goes_beyond(means, parameters) && !fault) {
    add(where_it_ends(between_ends(fit, own, own[kBegin].start, own[kEnd].start)));
  }
  if (has_free_ends(*law.family) && !fault) add(where_it_ends(over_ends(fit, own)));
  if (fault) return std::move(*fault);
  // Where the samples do not determine the numbers no start helps.
  const bool is_single = own.size() < few.first() + 2 || !found.front().free_directions.empty();
  for (const double longer : {-0.1, 0.1}) {
    if (is_single) break;
    const double begin = near[kBegin].start, end = near[kEnd].start, by = longer * (end - begin);
    add(std::vector<double>{begin - by, end + by});
  }
  if (fault) return std::move(*fault);
  return best_of(std::move(found));
}

Possible<optim::FitResult> best_fit(const FitParameters& own, const optim::Residuals& residuals,
                                    const optim::FitOptions& options,
                                    const std::vector<std::vector<double>>& starts) {
  std::optional<optim::FitResult> best;
  for (const std::vector<double>& start : starts) {
    auto fit = optim::possible_fit(starting_at(own, start), residuals, options);
    if (!fit) return fit.reason();
    if (!best || fit->merit < best->merit) best = std::move(*fit);
  }
  return *std::move(best);
}

}  // namespace camlaw::problems
