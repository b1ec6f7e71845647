// SPDX-License-Identifier: MIT
#include "optim/fit/least_squares.h"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <stdexcept>

#include "numerics/linear/statistics.h"
#include "optim/fit/ceres_search.h"
#include "optim/fit/fit_report.h"
#include "optim/fit/gauss_newton_polish.h"
#include "optim/fit/identifiability.h"
#include "optim/fit/kinks.h"
#include "optim/fit/loss.h"
#include "optim/problem/deadline.h"
#include "optim/problem/starts.h"

namespace camlaw::optim {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Ends that agree to this share are as good as each other: the earlier one is taken.
constexpr double kSameFit = 1e-9;

[[noreturn]] void refuse(const std::string& why) { throw std::invalid_argument(why); }

std::optional<Impossible> fault_of(const FitParameter& p) {
  if (std::isnan(p.lower) || std::isnan(p.upper)) {
    return Impossible{fmt::format("parameter '{}': a bound is not a number", p.name)};
  }
  if (p.lower > p.upper) {
    return Impossible{
        fmt::format("parameter '{}': lower {} exceeds upper {}", p.name, p.lower, p.upper)};
  }
  if (!std::isfinite(p.start)) {
    return Impossible{fmt::format("parameter '{}': the start is not a finite number", p.name)};
  }
  if (p.start < p.lower || p.start > p.upper) {
    return Impossible{fmt::format("parameter '{}': the start {} lies outside the bounds {} and {}",
                                  p.name, p.start, p.lower, p.upper)};
  }
  if (p.scale && !(*p.scale > 0 && std::isfinite(*p.scale))) {
    return Impossible{
        fmt::format("parameter '{}': the scale {} is not above zero", p.name, *p.scale)};
  }
  return {};
}

void check_options(const FitOptions& options) {
  if (options.loss_scale && !(*options.loss_scale > 0 && std::isfinite(*options.loss_scale))) {
    refuse(fmt::format("the scale of the loss, {}, is not above zero", *options.loss_scale));
  }
  if (options.starts < 1) refuse(fmt::format("{} starts: at least 1 is needed", options.starts));
  if (options.time_limit && !(*options.time_limit > 0)) {
    refuse(fmt::format("the time limit of {} s is not above zero", *options.time_limit));
  }
  if (options.max_iterations < 1) {
    refuse(fmt::format("{} iterations: at least 1 is needed", options.max_iterations));
  }
  if (!(options.confidence > 0 && options.confidence < 1)) {
    refuse(fmt::format("the confidence {} is not between 0 and 1", options.confidence));
  }
}

/// Names the first residual or derivative that is not finite at the start.
std::optional<Impossible> bad_start(const std::vector<FitParameter>& parameters,
                                    const Residuals& residuals) {
  const std::size_t n = residuals.count(), m = parameters.size();
  std::vector<double> p, r(n), jacobian(n * m);
  for (const FitParameter& parameter : parameters) p.push_back(parameter.start);
  if (!residuals.evaluate(p, r, jacobian)) return Impossible{"the model is undefined at the start"};
  for (std::size_t i = 0; i < n; ++i) {
    if (!std::isfinite(r[i])) {
      return Impossible{fmt::format("residual {} (counted from 0) is not finite at the start", i)};
    }
    for (std::size_t j = 0; j < m; ++j) {
      if (std::isfinite(jacobian[i * m + j])) continue;
      return Impossible{fmt::format(
          "the derivative of residual {} (counted from 0) by '{}' is not finite at the start", i,
          parameters[j].name)};
    }
  }
  return {};
}

void check(const std::vector<FitParameter>& parameters, const FitOptions& options) {
  if (parameters.empty()) refuse("there are no parameters to fit");
  std::set<std::string> names;
  for (const FitParameter& p : parameters) {
    if (!names.insert(p.name).second) refuse(fmt::format("two parameters are called '{}'", p.name));
  }
  check_options(options);
}

/// Why no search can begin, if so.
std::optional<Impossible> fault_of(const std::vector<FitParameter>& parameters,
                                   const Residuals& residuals) {
  if (residuals.count() == 0) return Impossible{"there are no residuals to fit to"};
  for (const FitParameter& p : parameters) {
    if (auto fault = fault_of(p)) return fault;
  }
  return bad_start(parameters, residuals);
}

double size_of(const FitParameter& p) {
  if (p.scale) return *p.scale;
  if (p.start != 0) return std::abs(p.start);
  const double range = p.upper - p.lower;
  return range > 0 && std::isfinite(range) ? range : 1;
}

/// Where the search begins, in order.
std::vector<std::vector<double>> all_starts(const std::vector<FitParameter>& parameters,
                                            const FitOptions& options) {
  Problem box;
  for (const FitParameter& p : parameters) {
    box.variables.push_back({.name = p.name,
                             .lower = p.lower,
                             .upper = p.upper,
                             .start = p.start,
                             .scale = size_of(p)});
  }
  return starts(box, options.starts, options.seed);
}

/// The residuals until a deadline, after which they throw Interrupted, but for the first: then
/// there is an answer. Of the parameters that they were asked at those with the least sum are kept.
class TimedResiduals final : public ResidualsOf {
 public:
  TimedResiduals(const Residuals& residuals, const FitOptions& options)
      : ResidualsOf(residuals), deadline_(options.time_limit, options.stop, options.time_spent) {}

  bool evaluate(std::span<const double> p, std::span<double> r,
                std::span<double> jacobian) const override {
    if (!best_.empty() || deadline_.stopped()) deadline_.check();
    if (!residuals_.evaluate(p, r, jacobian)) return false;
    double sum = 0;
    for (const double each : r) sum += each * each;
    // Where slopes were asked for too: the report needs them. Not where one is not a number.
    const bool is_whole = std::all_of(jacobian.begin(), jacobian.end(),
                                      [](double slope) { return std::isfinite(slope); });
    if (!jacobian.empty() && is_whole && (best_.empty() || sum < least_)) {
      least_ = sum;
      best_.assign(p.begin(), p.end());
    }
    return true;
  }

  const Deadline& deadline() const { return deadline_; }
  double least() const { return least_; }
  const std::vector<double>& best() const { return best_; }

 private:
  Deadline deadline_;
  mutable double least_ = kInfinity;
  mutable std::vector<double> best_;
};

/// By Ceres's steps at a pace, or by those of Gauss and Newton alone.
struct Way {
  std::optional<Pace> pace;
};

/// What is tried in turn until an end is sound.
std::vector<Way> ways(FitReach reach) {
  switch (reach) {
    case FitReach::Rough:
      return {{Pace::Bold}};
    case FitReach::Near:
      return {{}, {Pace::Bold}, {Pace::Cautious}};
    case FitReach::Full:
      break;
  }
  return {{Pace::Bold}, {Pace::Cautious}};
}

/// The search of one fit, from one start at a time.
class Search {
 public:
  Search(const std::vector<FitParameter>& parameters, const Residuals& residuals,
         const FitOptions& options)
      : residuals_(residuals), options_(options) {
    const auto m = static_cast<Index>(parameters.size());
    box_ = {VectorXd(m), VectorXd(m)};
    scales_.resize(m);
    for (Index j = 0; j < m; ++j) {
      const FitParameter& p = parameters[static_cast<std::size_t>(j)];
      box_.lower[j] = p.lower;
      box_.upper[j] = p.upper;
      scales_[j] = size_of(p);
    }
  }

  /// Where it ends, and what ends are compared by: the sum of losses, or the estimated scale's
  /// square.
  struct End {
    FitEnd end;
    double merit = kInfinity;
    bool stationary = false;
    bool sound = false;  ///< stationary, and every parameter matters there
  };

  /// Nothing where the residuals are undefined at the start.
  std::optional<End> from(const VectorXd& start, Way way) {
    const bool estimated = options_.loss != Loss::None && !options_.loss_scale;
    if (!estimated) return with_scale(start, way, options_.loss, options_.loss_scale);
    const auto plain = with_scale(start, way, Loss::None, std::nullopt);
    return plain ? std::optional(with_estimated_scale(*plain, way)) : std::nullopt;
  }

  /// The minimum at kinks of the residuals to which an end leads that is not stationary; the end
  /// itself where there is none.
  End at_kinks(End end) const {
    const LossResiduals summed(residuals_, end.end.loss_scale ? options_.loss : Loss::None,
                               end.end.loss_scale.value_or(1));
    auto point = fit_point(summed, end.end.p);
    if (!point) return end;
    const auto minimum = minimum_at_kinks(summed, box_, std::move(*point));
    if (!minimum) return end;
    const bool is_estimated = options_.loss != Loss::None && !options_.loss_scale;
    end.end.p = minimum->p;
    end.end.is_at_kinks = true;
    if (!is_estimated) end.merit = minimum->sum();
    end.stationary = true;
    return end;
  }

  const FitBox& box() const { return box_; }
  int iterations() const { return iterations_; }
  int evaluations() const { return evaluations_; }

 private:
  std::optional<End> with_scale(const VectorXd& start, Way way, Loss loss,
                                std::optional<double> scale) {
    const LossResiduals summed(residuals_, loss, scale.value_or(1));
    std::optional<End> result;
    if (const auto first = fit_point(summed, start)) {
      const FitPoint end = found(summed, *first, way);
      const GaussNewton step = gauss_newton(end, box_, kRankTolerance);
      // Next to a minimum a parameter that does not matter does not matter there either.
      const bool stationary = is_stationary(end, step);
      result = {{end.p, loss == Loss::None ? std::nullopt : scale, {}},
                end.sum(),
                stationary,
                stationary && (step.full_rank || !way.pace)};
    }
    evaluations_ += summed.evaluations();
    return result;
  }

  /// Parameters that rounding has set beside a bound stand at it.
  VectorXd at_bounds(VectorXd p) const {
    constexpr double kBeside = 1e-12;  // of the parameter's size
    for (Index j = 0; j < p.size(); ++j) {
      if (p[j] - box_.lower[j] < kBeside * scales_[j]) p[j] = box_.lower[j];
      if (box_.upper[j] - p[j] < kBeside * scales_[j]) p[j] = box_.upper[j];
    }
    return p;
  }

  /// Where the search of the residuals with their loss ends.
  FitPoint found(const Residuals& summed, FitPoint start, Way way) {
    // Far below what is wanted: narrow valleys make little headway in many steps, and what ends too
    // early here the polish after it cannot mend.
    constexpr double kLastDigits = 1e-15, kRough = 1e-6;
    const bool is_rough = options_.reach == FitReach::Rough;
    if (way.pace) {
      const CeresSearch end = ceres_search(summed, box_, scales_, start.p, options_.max_iterations,
                                           is_rough ? kRough : kLastDigits, *way.pace);
      iterations_ += end.iterations;
      if (auto last = fit_point(summed, at_bounds(end.p))) start = std::move(*last);
    }
    if (is_rough) return start;
    // In units of their standard deviations parameters are then off by about as much.
    constexpr double kEnough = 1e-9;
    return polish(summed, box_, way.pace ? 0 : kEnough, std::move(start));
  }

  /// The loss's scale from the residuals at p.
  double scale_at(const VectorXd& p) {
    ++evaluations_;
    std::vector<double> r(residuals_.count());
    residuals_.evaluate({p.data(), static_cast<std::size_t>(p.size())}, r, {});
    return efficient_scale(options_.loss) * median_absolute_deviation(r, 0.0);
  }

  /// Fits and estimates in turn, from a fit without a loss.
  End with_estimated_scale(const End& plain, Way way) {
    // A scale that has not settled by then alternates, and the answer says so.
    constexpr int kRounds = 100;
    // The scale enters the fit smoothly, so its last digits move nothing; a rough fit only ranks.
    constexpr double kSettled = 1e-8, kRoughly = 1e-3;
    const double settled = options_.reach == FitReach::Rough ? kRoughly : kSettled;
    // Where more than half of the residuals vanish, so would the scale. This share of the first
    // fit's deviation is kept, and keeps the outliers' pull below what could be seen.
    constexpr double kLeast = 1e-6;
    const double least = kLeast * std::sqrt(plain.merit / static_cast<double>(residuals_.count()));
    if (least == 0) return {plain.end, 0, plain.stationary, plain.sound};
    End now = plain;
    double scale = std::max(least, scale_at(now.end.p));
    for (int round = 0; round < kRounds; ++round) {
      now = *with_scale(now.end.p, way, options_.loss, scale);
      const double next = std::max(least, scale_at(now.end.p));
      if (std::abs(next - scale) <= settled * scale) {
        if (scale == least) {
          now.end.doubt =
              "more than half of the residuals vanish: no scale can be estimated for the loss";
        }
        return {now.end, scale * scale, now.stationary, now.sound};
      }
      scale = next;
    }
    now.end.doubt = "the scale of the loss did not settle";
    return {now.end, scale * scale, now.stationary, now.sound};
  }

  const Residuals& residuals_;
  const FitOptions& options_;
  FitBox box_;
  VectorXd scales_;
  int iterations_ = 0, evaluations_ = 0;
};

}  // namespace

std::vector<double> counted_residuals(const FitResult& fit) {
  std::vector<double> counted = fit.residuals;
  for (std::size_t i = 0; i < counted.size(); ++i) counted[i] *= fit.weights[i];
  return counted;
}

namespace {

/// Searches from all starts, each in every way, until an end is sound; `best` is the best so far.
void search_all(const std::vector<FitParameter>& parameters, const FitOptions& options,
                Search& search, std::optional<Search::End>& best) {
  const auto starts = all_starts(parameters, options);
  for (const Way way : ways(options.reach)) {
    if (best && best->sound) break;
    for (const std::vector<double>& start : starts) {
      const Eigen::Map<const VectorXd> p(start.data(), static_cast<Index>(start.size()));
      const auto end = search.from(p, way);
      if (!end) continue;
      const bool is_better = !best || end->merit < best->merit * (1 - kSameFit);
      const bool is_sounder = best && end->stationary && !best->stationary &&
                              end->merit <= best->merit * (1 + kSameFit);
      if (is_better || is_sounder) best = end;
    }
  }
  if (best && !best->stationary && options.reach != FitReach::Rough) {
    best = search.at_kinks(*best);  // a copy: time may pass meanwhile
  }
}

/// Where a fit is that ran out of time: at the end of a search, or at what the search under way has
/// seen, where no search has ended.
Search::End unfinished(const TimedResiduals& seen, std::optional<Search::End> best,
                       const FitOptions& options) {
  if (!best) {
    const auto m = static_cast<Index>(seen.best().size());
    const VectorXd p = Eigen::Map<const VectorXd>(seen.best().data(), m);
    best = {{p, options.loss == Loss::None ? std::nullopt : options.loss_scale, {}}, seen.least()};
  }
  best->end.doubt = seen.deadline().reason() + " before the fit had ended";
  return *best;
}

}  // namespace

Possible<FitResult> possible_fit(const std::vector<FitParameter>& parameters,
                                 const Residuals& residuals, const FitOptions& options) {
  check(parameters, options);
  const TimedResiduals timed(residuals, options);
  if (auto fault = fault_of(parameters, timed)) return std::move(*fault);
  Search search(parameters, timed, options);
  std::optional<Search::End> best;
  try {
    search_all(parameters, options, search, best);
  } catch (const Interrupted&) {
    // The model's own, and a stop that is asked for, have no answer.
    if (timed.deadline().stopped() || !timed.deadline().passed()) throw;
    best = unfinished(timed, std::move(best), options);
  }
  FitResult result = fit_report(parameters, residuals, options, search.box(), best->end);
  result.merit = best->merit + residuals.rest();
  result.iterations = search.iterations();
  result.evaluations = search.evaluations();
  return result;
}

FitResult fit(const std::vector<FitParameter>& parameters, const Residuals& residuals,
              const FitOptions& options) {
  return possible_fit(parameters, residuals, options).value();
}

}  // namespace camlaw::optim
