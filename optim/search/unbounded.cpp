// SPDX-License-Identifier: MIT
#include "optim/search/unbounded.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "optim/cycle/scales.h"

namespace camlaw::optim {
namespace {

bool is_far_better(const Problem& problem, Design x) {
  constexpr double kFar = 1e6;  // typical changes: no design of a sound problem gains so much
  const std::vector<double> start = problem.start();
  const Objective& objective = problem.objective();
  const double sign = objective.sense == Sense::Minimize ? 1 : -1;
  const double before = objective_value(objective, start);
  const double gain = sign * (before - objective_value(objective, x));
  const double typical = scales(problem, start).objective_typical;
  return std::isfinite(typical) && gain > kFar * std::max(std::abs(before), typical);
}

/// Whether no bound of the better values is known close to a design, though one is known there.
bool has_no_bound_beside(const Problem& problem, Design x) {
  // Typical changes: within them a pole beside the design shows, and no other does.
  constexpr double kBeside = 1e-6;
  const Objective& objective = problem.objective();
  const Function& f = objective.response.function();
  if (!f.is_enclosed()) return false;
  const std::vector<double> scales = typical_scales(problem, x);
  std::vector<Bounds> point, beside;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Variable& v = problem.variables[i];
    point.push_back({x[i], x[i]});
    beside.push_back({std::max(v.lower, x[i] - kBeside * scales[i]),
                      std::min(v.upper, x[i] + kBeside * scales[i])});
  }
  const auto better_end = [&](const std::vector<Bounds>& box) {
    const Bounds value = f.range(box).value;
    return objective.sense == Sense::Minimize ? value.lower : value.upper;
  };
  return std::isfinite(better_end(point)) && !std::isfinite(better_end(beside));
}

/// "p = 1e-13, q = 2": of the variables that change the objective there.
std::string place_words(const Problem& problem, Design x) {
  constexpr double kMatters = 1e-3;  // of the largest change
  const Function& f = problem.objective().response.function();
  const std::vector<double> scales = typical_scales(problem, x);
  std::vector<double> slopes(f.inputs().size());
  f.gradient(x, slopes);
  double largest = 0;
  for (std::size_t k = 0; k < slopes.size(); ++k) {
    slopes[k] = std::abs(slopes[k]) * scales[f.inputs()[k]];
    largest = std::max(largest, slopes[k]);
  }
  std::vector<std::string> places;
  for (std::size_t k = 0; k < slopes.size(); ++k) {
    if (slopes[k] < kMatters * largest) continue;
    const Variable& v = problem.variables[f.inputs()[k]];
    places.push_back(
        fmt::format("{} = {:.6g}{}", v.name, x[f.inputs()[k]], v.unit == "1" ? "" : " " + v.unit));
  }
  return fmt::format("{}", fmt::join(places, ", "));
}

}  // namespace

std::string unbounded_words(const Problem& problem, Design x) {
  if (problem.objective().response.is_curve() || x.size() != problem.variables.size()) return {};
  if (!is_far_better(problem, x) && !has_no_bound_beside(problem, x)) return {};
  return fmt::format("{} seems to be unbounded near {}", problem.objective().response.name,
                     place_words(problem, x));
}

}  // namespace camlaw::optim
