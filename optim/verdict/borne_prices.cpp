// SPDX-License-Identifier: MIT
#include "optim/verdict/borne_prices.h"

#include <algorithm>
#include <cmath>

namespace camlaw::optim {
namespace {

constexpr double kTrialStep = 1e-6;  // of a limit's size
constexpr double kPriced = 1e-4;     // multipliers over the sizes: less is as good as nothing

class PriceTrial {
 public:
  PriceTrial(const Problem& problem, const Sizes& sizes, Design x, const Layout& layout,
             const Weighed& weighed)
      : problem_(problem), sizes_(sizes), x_(x), layout_(layout), weighed_(weighed) {}

  bool is_borne_out(std::size_t j) const {
    const ActiveLimit& limit = weighed_.limits[j];
    double square = 0;
    for (const auto& [variable, slope] : limit.gradient) square += slope * slope;
    const double room = limit.constraint
                            ? sizes_.constraints[*limit.constraint].tolerance / limit.size
                            : kTrialStep;
    const double step = std::min(kTrialStep, room) / square;
    constexpr double kLong = 1;
    if (!(step * std::sqrt(square) <= kLong)) return false;
    return holds_along(j, step) && holds_along(j, -step);
  }

 private:
  bool holds_along(std::size_t j, double step) const {
    constexpr double kMuch = 0.5;
    const ActiveLimit& limit = weighed_.limits[j];
    std::vector<double> y(x_.begin(), x_.end());
    for (const auto& [variable, slope] : limit.gradient) {
      const Variable& v = problem_.variables[variable];
      y[variable] += step * slope * sizes_.variables[variable];
      if (!limit.variable) y[variable] = std::clamp(y[variable], v.lower, v.upper);
    }
    double rise = 0;
    for (const auto& [variable, slope] : limit.gradient) {
      rise += slope * (y[variable] - x_[variable]) / sizes_.variables[variable];
    }
    // Other bounds leave the step no way.
    if (!(std::abs(rise) > kMuch * std::abs(step) * square_of(limit))) return true;
    const auto is_like = [&](double there, double here) {
      return std::abs(there - here) <= kMuch * std::abs(here);
    };
    if (limit.function && !is_like(limit_slope(limit, y, y), rise)) return false;
    return is_like(slope_of_others(j, y, y), slope_of_others(j, x_, y));
  }

  static double square_of(const ActiveLimit& limit) {
    double square = 0;
    for (const auto& entry : limit.gradient) square += entry.second * entry.second;
    return square;
  }

  /// The slope of a function at a design, along the step from x to `to`.
  double slope_along(const Function& f, Design at, Design to) const {
    const auto& inputs = f.inputs();
    const bool is_moved =
        std::any_of(inputs.begin(), inputs.end(), [&](std::size_t i) { return to[i] != x_[i]; });
    if (!is_moved) return 0;
    std::vector<double> g(inputs.size());
    f.gradient(at, g);
    double sum = 0;
    for (std::size_t k = 0; k < g.size(); ++k) {
      const double way = to[inputs[k]] - x_[inputs[k]];
      if (way != 0) sum += g[k] * way;
    }
    return sum;
  }

  double limit_slope(const ActiveLimit& limit, Design at, Design to) const {
    return limit.sign * slope_along(*limit.function, at, to) / limit.size;
  }

  /// The slope of the Lagrangian without limit j.
  double slope_of_others(std::size_t j, Design at, Design to) const {
    double sum = 0;
    if (layout_.auxiliary < 0) {
      const Objective& objective = problem_.objective();
      const double sign = objective.sense == Sense::Minimize ? 1 : -1;
      sum = sign * slope_along(objective.response.function(), at, to) / sizes_.objective;
    }
    for (std::size_t k = 0; k < weighed_.limits.size(); ++k) {
      const ActiveLimit& other = weighed_.limits[k];
      if (k == j || weighed_.multipliers[k] == 0) continue;
      const double slope =
          other.function ? limit_slope(other, at, to)
                         : other.sign * (to[*other.variable] - x_[*other.variable]) / other.size;
      sum += weighed_.multipliers[k] * slope;
    }
    return sum;
  }

  const Problem& problem_;
  const Sizes& sizes_;
  Design x_;
  const Layout& layout_;
  const Weighed& weighed_;
};

}  // namespace

std::vector<std::size_t> unborne_prices(const Problem& problem, const Sizes& sizes, Design x,
                                        const Layout& layout, const Weighed& weighed) {
  const PriceTrial trial(problem, sizes, x, layout, weighed);
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
