// SPDX-License-Identifier: MIT
#include "optim/problem/sizes.h"

#include <algorithm>
#include <cmath>

#include "optim/cycle/extremes.h"
#include "optim/problem/starts.h"

namespace camlaw::optim {
namespace {

double or_one(double size) { return size > 0 && std::isfinite(size) ? size : 1; }

/// Typical changes of what varies; zero of what is fixed.
std::vector<double> free_scales(const Problem& problem) {
  std::vector<double> scales = variable_scales(problem);
  for (std::size_t i = 0; i < scales.size(); ++i) {
    if (problem.variables[i].lower == problem.variables[i].upper) scales[i] = 0;
  }
  return scales;
}

/// What typical changes make of responses at one design and over the box.
class Changes {
 public:
  Changes(const Problem& problem, Design about)
      : scales_(free_scales(problem)), about_(about.begin(), about.end()) {
    constexpr std::size_t kSampled = 300;
    constexpr int kDesigns = 8;
    if (scales_.size() > kSampled) return;
    box_ = starts(problem, kDesigns + 1, 1);
    box_.erase(box_.begin());
  }

  /// Over the box: the median of what is a number and not zero; zero where there is none.
  double typical(const Response& response) const {
    // What is linear, and changes nowhere else, changes alike at every design.
    if (box_.empty()) return 0;
    if (is_alike(response)) return or_zero(typical_change(response, about_, scales_));
    std::vector<double> changes;
    for (const auto& x : box_) {
      const double change = typical_change(response, x, scales_);
      if (change > 0 && std::isfinite(change)) changes.push_back(change);
    }
    if (changes.empty()) return 0;
    const auto middle = changes.begin() + static_cast<std::ptrdiff_t>(changes.size() / 2);
    std::nth_element(changes.begin(), middle, changes.end());
    return *middle;
  }

  double at_design(const Response& response) const {
    constexpr double kFar = 100;
    const double here = typical_change(response, about_, scales_);
    const double usual = is_alike(response) ? 0 : typical(response);
    if (usual == 0) return here;
    return here > 0 ? std::clamp(here, usual / kFar, usual * kFar) : usual;
  }

 private:
  static bool is_alike(const Response& response) {
    const bool moves = response.is_curve() && response.curve().breaks_move();
    return response.shape() == Shape::Linear && !moves;
  }
  static double or_zero(double change) { return std::isfinite(change) ? change : 0; }

  std::vector<double> scales_, about_;
  std::vector<std::vector<double>> box_;
};

ConstraintSize constraint_size(const Constraint& c, const Changes& changes) {
  const double bound = std::max(std::abs(c.lower.value_or(0)), std::abs(c.upper.value_or(0)));
  const double size =
      c.scale ? *c.scale : or_one(std::max(changes.at_design(c.response), 1e-3 * bound));
  return {size, c.tolerance.value_or(1e-6 * (bound > 0 ? bound : size))};
}

/// Highest value of sign * number or curve at a design.
double peak_of(const Response& response, double sign, Design x) {
  if (!response.is_curve()) return sign * response.function().value(x);
  return sign * highest(*response.curve().trace(x), sign).value;
}

}  // namespace

double typical_change(const Function& function, Design x, const std::vector<double>& scales) {
  std::vector<double> g(function.inputs().size());
  function.gradient(x, g);
  double largest = 0;
  for (std::size_t k = 0; k < g.size(); ++k) {
    const double change = std::abs(g[k]) * scales[function.inputs()[k]];
    if (std::isfinite(change)) largest = std::max(largest, change);
  }
  return largest;
}

double typical_change(const Response& response, Design x, const std::vector<double>& scales) {
  if (!response.is_curve()) return typical_change(response.function(), x, scales);
  constexpr int kPlaces = 5;  // in each smooth stretch
  const auto breaks = response.curve().trace(x)->breaks();
  double largest = 0;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    for (int i = 0; i < kPlaces; ++i) {
      const double angle = breaks[k] + (breaks[k + 1] - breaks[k]) * (i + 0.5) / kPlaces;
      largest = std::max(largest, typical_change(response.curve().at({angle}), x, scales));
    }
  }
  return largest;
}

double objective_value(const Objective& objective, Design x) {
  if (!objective.response.is_curve()) return objective.response.function().value(x);
  const double value = extreme_of(*objective.response.curve().trace(x), objective.part).value;
  return objective.part == Part::Magnitude ? std::abs(value) : value;
}

double largest_violation(const Problem& problem, const Sizes& sizes, Design x) {
  double worst = -kInfinity;
  for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
    const Constraint& c = problem.constraints[i];
    const double size = sizes.constraints[i].size;
    if (c.upper) worst = std::max(worst, (peak_of(c.response, 1, x) - *c.upper) / size);
    if (c.lower) worst = std::max(worst, (peak_of(c.response, -1, x) + *c.lower) / size);
  }
  return worst;
}

Sizes sizes(const Problem& problem, Design about) {
  const Changes changes(problem, about);
  const Response& objective = problem.objective.response;
  Sizes result;
  result.variables = variable_scales(problem);
  result.objective = or_one(changes.at_design(objective));
  const double typical = changes.typical(objective);
  result.objective_typical = typical > 0 ? typical : result.objective;
  result.objective_tolerance = problem.objective.tolerance.value_or(1e-7 * result.objective);
  for (const Constraint& c : problem.constraints) {
    result.constraints.push_back(constraint_size(c, changes));
  }
  return result;
}

}  // namespace camlaw::optim
