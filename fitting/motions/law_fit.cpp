// SPDX-License-Identifier: MIT
#include "fitting/motions/law_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "fitting/motions/jump_fit.h"
#include "fitting/motions/law_limits.h"
#include "fitting/motions/motion_residuals.h"
#include "fitting/motions/occam.h"
#include "fitting/motions/profile_intervals.h"
#include "fitting/motions/rounding_errors.h"
#include "fitting/samples/condensed.h"
#include "numerics/linear/statistics.h"
#include "optim/fit/loss.h"

namespace camlaw::problems {
namespace {

using optim::FitReach;

std::vector<optim::FitParameter> parameters_of(const MotionSamples& samples, const Member& law,
                                               const MotionGuess& guess, MotionLayout layout,
                                               Skew skew) {
  const double length = guess.end - guess.begin, stroke = guess.to - guess.from;
  constexpr double kBeyond = 0.3;  // of the length: an end is looked for that far off its guess
  std::vector<optim::FitParameter> result;
  const std::string& unit = samples.place_unit;
  result.push_back({"begin", unit, guess.begin - kBeyond * length, guess.begin + kBeyond * length,
                    guess.begin, length});
  result.push_back(
      {"end", unit, guess.end - kBeyond * length, guess.end + kBeyond * length, guess.end, length});
  result.push_back({"stroke", samples.length_unit, -optim::kInfinity, optim::kInfinity, stroke,
                    std::abs(stroke)});
  if (layout.with_zero) {
    result.push_back({"zero", samples.length_unit, -optim::kInfinity, optim::kInfinity, guess.from,
                      std::abs(stroke)});
  }
  for (const Coefficient& c : coefficients_of(law, 0, skew)) {
    const bool is_held = is_end_value(law, c);
    result.push_back(
        {c.name, c.unit, is_held ? c.value : c.low, is_held ? c.value : c.high, c.value});
  }
  return result;
}

/// The residuals of one law as they are fitted: with what its coefficients must meet together.
class LawResiduals {
 public:
  LawResiduals(const MotionSamples& samples, const Member& law, Skew skew,
               const std::vector<optim::FitParameter>& parameters)
      : motion_(samples, law, skew), has_free_ends_(problems::has_free_ends(law)) {
    const auto limit = limit_of(law);
    if (!limit) return;
    std::vector<double> start;
    for (const auto& p : parameters) start.push_back(p.start);
    limited_.emplace(motion_, *limit, motion_.layout().first(), start);
  }
  LawResiduals(const LawResiduals&) = delete;
  LawResiduals& operator=(const LawResiduals&) = delete;

  std::size_t first() const { return motion_.layout().first(); }
  bool has_free_ends() const { return has_free_ends_; }
  const optim::Residuals& residuals() const {
    if (limited_) return *limited_;
    return motion_;
  }
  /// The parameters as they are fitted.
  std::vector<optim::FitParameter> fitted(std::vector<optim::FitParameter> parameters) const {
    return limited_ ? limited_->limited(std::move(parameters)) : parameters;
  }
  optim::FitResult fit(const std::vector<optim::FitParameter>& fitted,
                       const optim::FitOptions& options) const {
    return optim::fit(fitted, residuals(), options);
  }
  /// A fit of the fitted ones told of the parameters.
  optim::FitResult told(optim::FitResult result, const std::vector<optim::FitParameter>& parameters,
                        double confidence) const {
    return limited_ ? limited_->of_coefficients(std::move(result), parameters, confidence) : result;
  }

 private:
  MotionResiduals motion_;
  bool has_free_ends_;
  std::optional<LimitedResiduals> limited_;
};

std::vector<double> values_of(const optim::FitResult& fit) {
  std::vector<double> result;
  for (const auto& p : fit.parameters) result.push_back(p.value);
  return result;
}

std::vector<optim::FitParameter> from(std::vector<optim::FitParameter> parameters,
                                      const std::vector<double>& values, std::size_t count) {
  for (std::size_t j = 0; j < count; ++j) {
    parameters[j].start = std::clamp(values[j], parameters[j].lower, parameters[j].upper);
  }
  return parameters;
}

/// Held where they start: a fit of begin, end, stroke and zero with the law as it is tells where a
/// fit of all finds the right valley.
std::vector<optim::FitParameter> with_held(std::vector<optim::FitParameter> parameters,
                                           std::size_t first) {
  for (std::size_t j = first; j < parameters.size(); ++j) {
    parameters[j].lower = parameters[j].upper = parameters[j].start;
  }
  return parameters;
}

/// As few means of neighbours as tell where a fit may begin, of where the motion may be: from
/// `low` to `high`. Under a loss of three at least: a far-off one is left out then, and no loss is
/// needed, which from far off would let no sample count.
MotionSamples few_of(const MotionSamples& samples, double low, double high, optim::Loss loss) {
  constexpr std::size_t kMeans = 100, kLeast = 3, kEnough = 90;
  MotionSamples few = between(samples, low, high);
  const std::size_t count = few.value.size();
  std::size_t each = count / kMeans;
  if (loss != optim::Loss::None && count >= kEnough) each = std::max(each, kLeast);
  Condensed means =
      means_of_neighbours(std::move(few.place), std::move(few.value), each, samples.resolution);
  few.place = std::move(means.place);
  few.value = std::move(means.value);
  few.each = means.each;
  return few;
}

optim::FitOptions how(const LawFitOptions& options, FitReach reach) {
  optim::FitOptions fit;
  fit.loss = options.loss;
  fit.loss_scale = options.loss_scale;
  fit.confidence = options.confidence;
  fit.reach = reach;
  fit.max_iterations = reach == FitReach::Rough ? 20 : 200;
  return fit;
}

/// A rough fit of everything but begin and end, which stay at these.
optim::FitResult between_ends(const LawResiduals& few, std::vector<optim::FitParameter> parameters,
                              double begin, double end, const optim::FitOptions& rough) {
  const std::vector<double> ends{begin, end};
  parameters = from(std::move(parameters), ends, ends.size());
  for (std::size_t j = 0; j < ends.size(); ++j) {
    parameters[j].lower = parameters[j].upper = parameters[j].start;
  }
  return few.fit(parameters, rough);
}

/// The same for the best of many ends around those of the parameters, then all. With free values at
/// its ends a polynomial is the same curve over any stretch: only how it meets the rests tells
/// them, and the sum of squares has a valley at each of many places.
optim::FitResult over_ends(const LawResiduals& few,
                           const std::vector<optim::FitParameter>& parameters,
                           const optim::FitOptions& rough) {
  constexpr double kAside[] = {-0.12, -0.06, -0.03, -0.01, 0, 0.01, 0.03, 0.06, 0.12};
  const double begin = parameters[MotionLayout::kBegin].start,
               end = parameters[MotionLayout::kEnd].start;
  std::optional<optim::FitResult> best;
  for (const double before : kAside) {
    for (const double after : kAside) {
      const double length = end - begin;
      optim::FitResult fit =
          between_ends(few, parameters, begin + before * length, end + after * length, rough);
      if (!best || fit.merit < best->merit) best = std::move(fit);
    }
  }
  const std::vector<double> found = values_of(*best);
  return few.fit(from(parameters, found, found.size()), rough);
}

/// Where fits of all samples should begin, as values of the fitted parameters, the best first; by
/// rough fits to a few. Laws of several coefficients have valleys in which longer motions with
/// other coefficients nearly do as well: such fits begin at shorter and longer motions too.
std::vector<std::vector<double>> starts(const LawResiduals& few,
                                        const std::vector<optim::FitParameter>& parameters,
                                        const LawFitOptions& options) {
  constexpr double kLonger[] = {-0.1, 0.1};
  constexpr double kSame = 1e-3, kNearly = 1.5;
  const std::size_t first = few.first();
  const optim::FitOptions rough = how(options, FitReach::Rough);
  const optim::FitResult alone = few.fit(with_held(parameters, first), rough);
  if (parameters.size() == first) return {values_of(alone)};
  const auto begin = from(parameters, values_of(alone), first);
  std::vector<optim::FitResult> ends{few.fit(begin, rough)};
  if (options.like) {  // where another law follows the samples
    const std::vector<double> found =
        values_of(between_ends(few, parameters, options.like->begin, options.like->end, rough));
    ends.push_back(few.fit(from(parameters, found, found.size()), rough));
  }
  if (few.has_free_ends()) ends.push_back(over_ends(few, parameters, rough));
  // Where the samples do not determine the numbers no start helps.
  const bool is_single = parameters.size() < first + 2 || !ends.front().free_directions.empty();
  for (const double longer : kLonger) {
    if (is_single) break;
    const double from_place = begin[MotionLayout::kBegin].start,
                 to = begin[MotionLayout::kEnd].start;
    const double by = longer * (to - from_place);
    const std::vector<double> ways{from_place - by, to + by};
    ends.push_back(few.fit(from(begin, ways, 2), rough));
  }
  std::stable_sort(ends.begin(), ends.end(),
                   [](const auto& a, const auto& b) { return a.merit < b.merit; });
  std::vector<std::vector<double>> result;
  double before = -1;
  for (const optim::FitResult& end : ends) {
    if (end.merit > kNearly * ends.front().merit) break;
    if (end.merit <= before * (1 + kSame)) continue;  // the same valley
    before = end.merit;
    result.push_back(values_of(end));
  }
  return result;
}

/// From the fit of other samples, within the bounds that it had.
optim::FitResult fitted_near(const MotionSamples& samples, const LawFit& fit,
                             const MotionGuess& guess, const LawFitOptions& options) {
  const auto parameters = parameters_of(samples, fit.law, guess, {samples.order == 0}, fit.skew);
  const LawResiduals residuals(samples, fit.law, fit.skew, parameters);
  const std::size_t first = residuals.first();
  const auto own = from(residuals.fitted(parameters), values_of(fit.fit), first);
  return residuals.told(residuals.fit(own, how(options, FitReach::Near)), parameters,
                        options.confidence);
}

/// How many of them are free.
std::size_t count_of_free(const std::vector<optim::FitParameter>& parameters) {
  return static_cast<std::size_t>(
      std::count_if(parameters.begin(), parameters.end(),
                    [](const optim::FitParameter& p) { return p.lower < p.upper; }));
}

/// The member with the coefficients of a fit.
Member with_coefficients(const Member& law, const optim::FitResult& told, MotionLayout layout,
                         Skew skew) {
  Member result = law;
  for (const Coefficient& c : coefficients_of(law, layout.first(), skew)) {
    result.arguments.values()[c.at.parameter][c.at.element] = told.parameters[c.at.variable].value;
  }
  return result;
}

/// At which ends samples of a law's derivative jump.
Jumps jumps_of(const Law<double>& law, int order) {
  constexpr double kLeast = 0.01;  // of a motion of length and stroke one
  if (order == 0) return {};
  const auto k = static_cast<std::size_t>(order);
  return {std::abs(law.derivatives<3>(0.0, Side::Right)[k]) > kLeast,
          std::abs(law.derivatives<3>(1.0, Side::Left)[k]) > kLeast};
}

/// The stroke, or of a derivative the greatest value.
double size_of(const MotionSamples& samples, const optim::FitResult& fit) {
  if (samples.order == 0) return std::abs(fit.parameters[MotionLayout::kStroke].value);
  double size = 0;
  for (const double y : samples.value) size = std::max(size, std::abs(y));
  return size;
}

/// What a fit leaves, as laws are compared by it.
double sum_left(const MotionSamples& samples, const optim::FitResult& fit, optim::Loss loss) {
  // Under a loss what it sums, so that a far point does not decide which law is best.
  double sum = 0;
  for (const double r : fit.residuals) {
    sum +=
        loss == optim::Loss::None ? r * r : optim::loss_at(loss, fit.loss_scale.value_or(1), r).rho;
  }
  // What is left at the size of rounding, of doubles or of the values as written, tells no laws
  // apart.
  constexpr double kRounding = 1e-10;
  double size = 0;
  for (const double y : samples.value) size = std::max(size, std::abs(y));
  const double floor = std::max(kRounding * size, rounding_deviation(samples));
  return std::max(sum, static_cast<double>(samples.value.size()) * floor * floor);
}

struct FittedAll {
  optim::FitResult fit;
  std::size_t numbers;  ///< that were free
  double criterion;     ///< (S1), without what the law was worth before
  std::vector<double> inflation;
};

FittedAll fitted(const MotionSamples& samples, const Member& law, const MotionGuess& guess,
                 const LawFitOptions& options) {
  const auto parameters = parameters_of(samples, law, guess, {samples.order == 0}, options.skew);
  const LawResiduals residuals(samples, law, options.skew, parameters);
  const auto own = residuals.fitted(parameters);
  const MotionSamples means = few_of(samples, parameters[MotionLayout::kBegin].lower,
                                     parameters[MotionLayout::kEnd].upper, options.loss);
  const LawResiduals few(means, law, options.skew, parameters);
  LawFitOptions of_means = options;
  of_means.loss_scale.reset();
  if (means.each > 1) of_means.loss = optim::Loss::None;
  std::optional<optim::FitResult> best;
  for (const std::vector<double>& start : starts(few, own, of_means)) {
    optim::FitResult fit =
        residuals.fit(from(own, start, start.size()), how(options, FitReach::Near));
    if (!best || fit.merit < best->merit) best = std::move(fit);
  }
  const MotionLayout layout{samples.order == 0};
  const Member found = with_coefficients(law, residuals.told(*best, parameters, options.confidence),
                                         layout, options.skew);
  const Jumps jumps = jumps_of(found.law(), samples.order);
  best = fit_with_jumps(samples, residuals.residuals(), own, jumps, how(options, FitReach::Near),
                        std::move(*best));
  std::vector<double> inflation =
      count_rounding(samples, residuals.residuals(), own, options.confidence, *best);
  const std::size_t n = samples.value.size();
  const double sum = sum_left(samples, *best, options.loss);
  const Occam occam = occam_of(residuals.residuals(), own, layout.first(), size_of(samples, *best),
                               std::sqrt(sum / static_cast<double>(n)), *best);
  const double criterion = optim::evidence(n, best->rank, occam.count, sum, occam.logarithm);
  return {residuals.told(std::move(*best), parameters, options.confidence), count_of_free(own),
          criterion, std::move(inflation)};
}

}  // namespace

LawFitOptions part_of(LawFitOptions options, double from, double to) {
  if (options.deadline) {
    const auto now = LawFitOptions::Clock::now();
    const std::chrono::duration<double> left = *options.deadline - now;
    const double share = from < 1 ? (to - from) / (1 - from) : 1;
    options.deadline =
        now + std::chrono::duration_cast<LawFitOptions::Clock::duration>(share * left);
  }
  if (!options.progress) return options;
  options.progress = [whole = options.progress, from, to](double share) {
    whole(from + (to - from) * share);
  };
  return options;
}

LawFitOptions without_deadline(LawFitOptions options) {
  options.deadline.reset();
  return options;
}

bool LawFit::has_coefficients() const { return !coefficients_of(law, 0, skew).empty(); }

double LawFit::value(double place, int order) const {
  const double length = end - begin;
  const double u = (place - begin) / length;
  const auto k = static_cast<std::size_t>(order);
  if (k > 0 && !(u >= 0 && u <= 1)) return 0;
  const auto d =
      law.law().derivatives<4>(std::clamp(u, 0.0, 1.0), u < 1 ? Side::Right : Side::Left);
  return (k == 0 ? from : 0) + (to - from) * d[k] * std::pow(length, -order);
}

void check_motion(const MotionSamples& samples, const MotionGuess& guess) {
  if (samples.place.size() != samples.value.size()) {
    throw std::invalid_argument("samples: as many values as places are wanted");
  }
  if (samples.place.size() < 2) throw std::invalid_argument("samples: two at least are wanted");
  for (std::size_t i = 0; i < samples.place.size(); ++i) {
    if (std::isfinite(samples.place[i]) && std::isfinite(samples.value[i])) continue;
    throw std::invalid_argument(fmt::format("sample {} is not a finite number", i + 1));
  }
  if (!(guess.end > guess.begin) || guess.to == guess.from) {
    throw std::invalid_argument("samples: they show no motion");
  }
}

LawFit fit_law(const MotionSamples& samples, const Member& law, const MotionGuess& guess,
               const LawFitOptions& options) {
  check_motion(samples, guess);
  const MotionLayout layout{samples.order == 0};
  FittedAll all = fitted(samples, law, guess, options);
  LawFit result{law, std::move(all.fit), options.skew, layout.first(), all.numbers};
  const std::vector<double> x = values_of(result.fit);
  result.law = with_coefficients(law, result.fit, layout, options.skew);
  result.criterion = all.criterion;
  result.inflation = std::move(all.inflation);
  result.begin = x[MotionLayout::kBegin];
  result.end = x[MotionLayout::kEnd];
  result.from = layout.with_zero ? x[MotionLayout::kZero] : 0;
  result.to = result.from + x[MotionLayout::kStroke];
  return result;
}

void profile_ends(const MotionSamples& samples, const MotionGuess& guess,
                  const LawFitOptions& options, LawFit& fit) {
  if (options.loss != optim::Loss::None) return;
  const auto parameters = parameters_of(samples, fit.law, guess, {samples.order == 0}, fit.skew);
  const LawResiduals residuals(samples, fit.law, fit.skew, parameters);
  const auto own = from(residuals.fitted(parameters), values_of(fit.fit), fit.base);
  profile_intervals(residuals.residuals(), own, fit.base, fit.inflation, options.confidence,
                    fit.fit);
}

double cross_validated(const MotionSamples& samples, const LawFit& fit, const MotionGuess& guess,
                       const LawFitOptions& options) {
  constexpr std::size_t kFolds = 10;
  const std::size_t n = samples.place.size();
  const auto part = [&](const std::vector<std::size_t>& which) {
    MotionSamples result = samples.none();
    for (const std::size_t i : which) {
      result.place.push_back(samples.place[i]);
      result.value.push_back(samples.value[i]);
    }
    return result;
  };
  return optim::cross_validated_error(
      n, std::min(kFolds, n), [&](const auto& kept, const auto& left_out) {
        const auto own = fitted_near(part(kept), fit, guess, options);
        const MotionResiduals others(part(left_out), fit.law, fit.skew);
        std::vector<double> r(left_out.size());
        if (!others.evaluate(values_of(own), r, {})) return std::nan("");
        return std::inner_product(r.begin(), r.end(), r.begin(), 0.0);
      });
}

}  // namespace camlaw::problems
