// SPDX-License-Identifier: MIT
#include "optim/fit/least_squares.h"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <stdexcept>

#include "optim/fit/ceres_search.h"
#include "optim/fit/fit_report.h"
#include "optim/fit/gauss_newton_polish.h"
#include "optim/fit/identifiability.h"
#include "optim/fit/statistics.h"
#include "optim/problem/starts.h"

namespace camlaw::optim {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Ends that agree to this share are as good as each other: the earlier one is taken.
constexpr double kSame = 1e-9;

[[noreturn]] void refuse(const std::string& why) { throw std::invalid_argument(why); }

void check_parameter(const FitParameter& p) {
  if (std::isnan(p.lower) || std::isnan(p.upper)) {
    refuse(fmt::format("parameter '{}': a bound is not a number", p.name));
  }
  if (p.lower > p.upper) {
    refuse(fmt::format("parameter '{}': lower {} exceeds upper {}", p.name, p.lower, p.upper));
  }
  if (!std::isfinite(p.start)) {
    refuse(fmt::format("parameter '{}': the start is not a finite number", p.name));
  }
  if (p.start < p.lower || p.start > p.upper) {
    refuse(fmt::format("parameter '{}': the start {} lies outside the bounds {} and {}", p.name,
                       p.start, p.lower, p.upper));
  }
  if (p.scale && !(*p.scale > 0 && std::isfinite(*p.scale))) {
    refuse(fmt::format("parameter '{}': the scale {} is not above zero", p.name, *p.scale));
  }
}

void check_options(const FitOptions& options) {
  if (options.loss_scale && !(*options.loss_scale > 0 && std::isfinite(*options.loss_scale))) {
    refuse(fmt::format("the scale of the loss, {}, is not above zero", *options.loss_scale));
  }
  if (options.starts < 1) refuse(fmt::format("{} starts: at least 1 is needed", options.starts));
  if (options.max_iterations < 1) {
    refuse(fmt::format("{} iterations: at least 1 is needed", options.max_iterations));
  }
  if (!(options.confidence > 0 && options.confidence < 1)) {
    refuse(fmt::format("the confidence {} is not between 0 and 1", options.confidence));
  }
}

/// Names the first residual or derivative that is not finite at the start.
void check_start(const std::vector<FitParameter>& parameters, const Residuals& residuals) {
  const std::size_t n = residuals.count(), m = parameters.size();
  std::vector<double> p, r(n), jacobian(n * m);
  for (const FitParameter& parameter : parameters) p.push_back(parameter.start);
  if (!residuals.evaluate(p, r, jacobian)) refuse("the model is undefined at the start");
  for (std::size_t i = 0; i < n; ++i) {
    if (!std::isfinite(r[i])) {
      refuse(fmt::format("residual {} (counted from 0) is not finite at the start", i));
    }
    for (std::size_t j = 0; j < m; ++j) {
      if (std::isfinite(jacobian[i * m + j])) continue;
      refuse(fmt::format(
          "the derivative of residual {} (counted from 0) by '{}' is not finite at the start", i,
          parameters[j].name));
    }
  }
}

void check(const std::vector<FitParameter>& parameters, const Residuals& residuals,
           const FitOptions& options) {
  if (parameters.empty()) refuse("there are no parameters to fit");
  if (residuals.count() == 0) refuse("there are no residuals to fit to");
  std::set<std::string> names;
  for (const FitParameter& p : parameters) {
    check_parameter(p);
    if (!names.insert(p.name).second) refuse(fmt::format("two parameters are called '{}'", p.name));
  }
  check_options(options);
  check_start(parameters, residuals);
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

  /// Where it ends, and what ends are compared by: the sum of losses, or the estimated scale.
  struct End {
    FitEnd end;
    double merit = kInfinity;
    bool sound = false;  ///< stationary, and every parameter matters there
  };

  /// Nothing where the residuals are undefined at the start.
  std::optional<End> from(const VectorXd& start, Pace pace) {
    const bool estimated = options_.loss != Loss::None && !options_.loss_scale;
    if (!estimated) return with_scale(start, pace, options_.loss, options_.loss_scale);
    const auto plain = with_scale(start, pace, Loss::None, std::nullopt);
    return plain ? std::optional(with_estimated_scale(*plain, pace)) : std::nullopt;
  }

  const FitBox& box() const { return box_; }
  int iterations() const { return iterations_; }
  int evaluations() const { return evaluations_; }

 private:
  std::optional<End> with_scale(const VectorXd& start, Pace pace, Loss loss,
                                std::optional<double> scale) {
    const LossResiduals summed(residuals_, loss, scale.value_or(1));
    std::optional<End> result;
    if (const auto first = fit_point(summed, start)) {
      const CeresSearch found =
          ceres_search(summed, box_, scales_, start, options_.max_iterations, pace);
      iterations_ += found.iterations;
      const auto last = fit_point(summed, found.p);
      const FitPoint end = polish(summed, box_, last ? *last : *first);
      const GaussNewton step = gauss_newton(end, box_, kRankTolerance);
      result = {{end.p, loss == Loss::None ? std::nullopt : scale, {}},
                end.sum(),
                step.full_rank && is_stationary(end, step)};
    }
    evaluations_ += summed.evaluations();
    return result;
  }

  /// The loss's scale from the residuals at p.
  double scale_at(const VectorXd& p) {
    ++evaluations_;
    std::vector<double> r(residuals_.count());
    residuals_.evaluate({p.data(), static_cast<std::size_t>(p.size())}, r, {});
    return efficient_scale(options_.loss) * median_absolute_deviation(r, 0.0);
  }

  /// Fits and estimates in turn, from a fit without a loss.
  End with_estimated_scale(const End& plain, Pace pace) {
    constexpr int kRounds = 100;
    constexpr double kSettled = 1e-8;
    // Where more than half of the residuals vanish, so would the scale. This share of the first
    // fit's deviation is kept, and keeps the outliers' pull below what could be seen.
    constexpr double kLeast = 1e-6;
    const double least = kLeast * std::sqrt(plain.merit / static_cast<double>(residuals_.count()));
    if (least == 0) return {plain.end, 0, plain.sound};
    End now = plain;
    double scale = std::max(least, scale_at(now.end.p));
    for (int round = 0; round < kRounds; ++round) {
      now = *with_scale(now.end.p, pace, options_.loss, scale);
      const double next = std::max(least, scale_at(now.end.p));
      if (std::abs(next - scale) <= kSettled * scale) {
        if (scale == least) {
          now.end.doubt = "more than half of the residuals vanish: the loss has no scale to go by";
        }
        return {now.end, scale, now.sound};
      }
      scale = next;
    }
    now.end.doubt = "the scale of the loss did not settle";
    return {now.end, scale, now.sound};
  }

  const Residuals& residuals_;
  const FitOptions& options_;
  FitBox box_;
  VectorXd scales_;
  int iterations_ = 0, evaluations_ = 0;
};

}  // namespace

FitResult fit(const std::vector<FitParameter>& parameters, const Residuals& residuals,
              const FitOptions& options) {
  check(parameters, residuals, options);
  Search search(parameters, residuals, options);
  const auto starts = all_starts(parameters, options);
  std::optional<Search::End> best;
  for (const Pace pace : {Pace::Bold, Pace::Cautious}) {
    if (best && best->sound) break;
    for (const std::vector<double>& start : starts) {
      const Eigen::Map<const VectorXd> p(start.data(), static_cast<Index>(start.size()));
      const auto end = search.from(p, pace);
      if (end && (!best || end->merit < best->merit * (1 - kSame))) best = end;
    }
  }
  FitResult result = fit_report(parameters, residuals, options, search.box(), best->end);
  result.iterations = search.iterations();
  result.evaluations = search.evaluations();
  return result;
}

}  // namespace camlaw::optim
