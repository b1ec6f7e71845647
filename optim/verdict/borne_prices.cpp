// SPDX-License-Identifier: MIT
#include "optim/verdict/borne_prices.h"

#include <algorithm>
#include <cmath>

namespace camlaw::optim {
namespace {

constexpr double kTrialStep = 1e-6;  // of a limit's size
constexpr double kPriced = 1e-4;     // multipliers over the scales: less is as good as nothing

/// Steps along one limit's gradient after the other. What a step moves is looked up, so that each
/// costs what its own variables touch, and the gradient of an objective that is not linear.
class PriceTrial {
 public:
  PriceTrial(const Problem& problem, const Scales& scales, Design x, const Layout& layout,
             const Weighed& weighed)
      : problem_(problem),
        scales_(scales),
        x_(x),
        weighed_(weighed),
        pushing_on_(problem.variables.size()),
        y_(x.begin(), x.end()),
        change_(x.size(), 0.0) {
    for (std::size_t k = 0; k < weighed.limits.size(); ++k) {
      if (weighed.multipliers[k] == 0) continue;
      for (const std::size_t variable : variables_of(weighed.limits[k]))
        pushing_on_[variable].push_back(k);
    }
    if (layout.auxiliary >= 0) return;
    objective_ = problem.objective().response.function();
    std::vector<double> slopes(objective_.inputs().size());
    objective_.gradient(x, slopes);
    objective_slopes_.assign(x.size(), 0.0);
    for (std::size_t k = 0; k < slopes.size(); ++k)
      objective_slopes_[objective_.inputs()[k]] = slopes[k];
  }

  bool is_borne_out(std::size_t j) {
    const ActiveLimit& limit = weighed_.limits[j];
    const double square = square_of(limit);
    const double room = limit.constraint
                            ? scales_.constraints[*limit.constraint].tolerance / limit.size
                            : kTrialStep;
    const double step = std::min(kTrialStep, room) / square;
    // A price has to hold for a step that is shorter than a typical change.
    constexpr double kLong = 1;
    if (!(step * std::sqrt(square) <= kLong)) return false;
    for (const double signed_step : {step, -step}) {
      go_along(limit, signed_step);
      const bool holds = holds_there(j, signed_step * square);
      go_back();
      if (!holds) return false;
    }
    return true;
  }

 private:
  static std::vector<std::size_t> variables_of(const ActiveLimit& limit) {
    return limit.function ? limit.function->inputs() : std::vector{*limit.variable};
  }
  static double square_of(const ActiveLimit& limit) {
    double square = 0;
    for (const auto& entry : limit.gradient) square += entry.second * entry.second;
    return square;
  }

  void go_along(const ActiveLimit& limit, double step) {
    for (const auto& [variable, slope] : limit.gradient) {
      const Variable& v = problem_.variables[variable];
      double& y = y_[variable];
      y += step * slope * scales_.variables[variable];
      if (!limit.variable) y = std::clamp(y, v.lower, v.upper);
      change_[variable] = y - x_[variable];
      if (change_[variable] == 0) continue;
      moved_.push_back(variable);
      const auto& pushing = pushing_on_[variable];
      touched_.insert(touched_.end(), pushing.begin(), pushing.end());
    }
    std::sort(touched_.begin(), touched_.end());
    touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
  }
  void go_back() {
    for (const std::size_t variable : moved_) {
      y_[variable] = x_[variable];
      change_[variable] = 0;
    }
    moved_.clear();
    touched_.clear();
  }

  /// Whether slopes after the step are like those before it, of limit j and of all others.
  bool holds_there(std::size_t j, double wanted_rise) const {
    // A square root has half the slope where its argument is four times as large.
    constexpr double kMuch = 0.5;
    const ActiveLimit& limit = weighed_.limits[j];
    double rise = 0;
    for (const auto& [variable, slope] : limit.gradient)
      rise += slope * change_[variable] / scales_.variables[variable];
    // Other bounds leave the step no room.
    if (!(std::abs(rise) > kMuch * std::abs(wanted_rise))) return true;
    const auto is_like = [](double there, double here) {
      return std::abs(there - here) <= kMuch * std::abs(here);
    };
    if (limit.function && !is_like(limit_slope(limit, y_), rise)) return false;
    return is_like(slope_of_others(j, y_), slope_of_others(j, x_));
  }

  /// The slope of a function at a design, along the step.
  double slope_along(const Function& f, Design at) const {
    const auto& inputs = f.inputs();
    std::vector<double> g(inputs.size());
    f.gradient(at, g);
    double sum = 0;
    for (std::size_t k = 0; k < g.size(); ++k) {
      if (change_[inputs[k]] != 0) sum += g[k] * change_[inputs[k]];
    }
    return sum;
  }
  double limit_slope(const ActiveLimit& limit, Design at) const {
    return limit.sign * slope_along(*limit.function, at) / limit.size;
  }

  /// Of the objective, zero where it is a limit of its own.
  double objective_slope(Design at) const {
    if (objective_slopes_.empty()) return 0;
    const double sign = problem_.objective().sense == Sense::Minimize ? 1 : -1;
    const bool is_known = at.data() == x_.data() ||  // at x itself
                          objective_.shape() == Shape::Linear;
    double slope = 0;
    if (is_known) {
      for (const std::size_t variable : moved_)
        slope += objective_slopes_[variable] * change_[variable];
    } else {
      slope = slope_along(objective_, at);
    }
    return sign * slope / scales_.objective;
  }

  /// The slope of the Lagrangian without limit j.
  double slope_of_others(std::size_t j, Design at) const {
    double sum = objective_slope(at);
    for (const std::size_t k : touched_) {
      if (k == j) continue;
      const ActiveLimit& other = weighed_.limits[k];
      const double slope = other.function ? limit_slope(other, at)
                                          : other.sign * change_[*other.variable] / other.size;
      sum += weighed_.multipliers[k] * slope;
    }
    return sum;
  }

  const Problem& problem_;
  const Scales& scales_;
  Design x_;
  const Weighed& weighed_;
  std::vector<std::vector<std::size_t>> pushing_on_;  ///< limits with a multiplier, by variable
  Function objective_;
  std::vector<double> objective_slopes_;  ///< at x, by variable
  // The step that is tried:
  std::vector<double> y_, change_;
  std::vector<std::size_t> moved_;    ///< variables
  std::vector<std::size_t> touched_;  ///< limits with a multiplier that depend on them
};

}  // namespace

std::vector<std::size_t> unborne_prices(const Problem& problem, const Scales& scales, Design x,
                                        const Layout& layout, const Weighed& weighed) {
  PriceTrial trial(problem, scales, x, layout, weighed);
  std::vector<std::size_t> result;
  for (std::size_t j = 0; j < weighed.limits.size(); ++j) {
    const ActiveLimit& limit = weighed.limits[j];
    const bool is_number =
        limit.constraint && !problem.constraints[*limit.constraint].response.is_curve();
    if (!is_number && !limit.variable) continue;
    if (!(std::abs(weighed.multipliers[j]) > kPriced)) continue;
    if (!trial.is_borne_out(j)) result.push_back(j);
  }
  return result;
}

}  // namespace camlaw::optim
