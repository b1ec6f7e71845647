// SPDX-License-Identifier: MIT
#include "optim/search/without_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "optim/cycle/extremes.h"
#include "optim/problem/starts.h"

namespace camlaw::optim {
namespace {

constexpr int kPlaces = 128;  // of each of two sequences

bool has_value(const Response& response, Design x) {
  return !std::isnan(response.is_curve() ? response.curve().largest(x)
                                         : response.function().value(x));
}

/// In words; empty where the response cannot tell.
std::string why_none(const Response& response, Design x) {
  return response.is_curve() ? response.curve().trace(x)->why_unbounded()
                             : response.function().why_undefined(x);
}

/// Whether a design meets the limits beyond which other responses may have no value.
bool is_within_edges(const Problem& problem, Design x) {
  return std::ranges::all_of(problem.constraints, [&](const Constraint& c) {
    if (!c.is_edge) return true;
    if (!c.response.is_curve()) {
      const double value = c.response.function().value(x);
      return value >= c.lower.value_or(-kInfinity) && value <= c.upper.value_or(kInfinity);
    }
    const auto trace = c.response.curve().trace(x);
    return (!c.upper || highest(*trace, 1).value <= *c.upper) &&
           (!c.lower || highest(*trace, -1).value >= *c.lower);
  });
}

/// The start, and places of the box.
std::vector<std::vector<double>> places_of(const Problem& problem, std::uint64_t seed) {
  std::vector<std::vector<double>> all = starts(problem, kPlaces, seed);
  for (auto& x : starts_by_magnitude(problem, kPlaces, seed)) all.push_back(std::move(x));
  return all;
}

/// What is said of a response without a value at the start, nor at any of these places.
std::string nowhere(const Response& response, Design start, std::size_t places) {
  const std::string why = why_none(response, start);
  return fmt::format(
      "it has no value at the start nor at any of {} other designs of the variables' ranges that "
      "were looked at{}{}",
      places - 2, why.empty() ? "" : ": ", why);
}

}  // namespace

std::optional<Hopeless> limit_without_value(const Problem& problem, std::uint64_t seed,
                                            Asked asked) {
  constexpr int kEnough = 8;  // places at which nothing else can be to blame
  const std::vector<double> start = problem.start();
  std::optional<std::vector<std::vector<double>>> places;
  for (const Constraint& c : problem.constraints) {
    if (has_value(c.response, start)) continue;
    if (!places) places = places_of(problem, seed);
    const bool is_anywhere = std::ranges::any_of(
        *places, [&](const std::vector<double>& x) { return has_value(c.response, x); });
    if (is_anywhere) continue;
    if (asked == Asked::Before) {
      int alone = 0;
      for (auto x = places->begin(); x != places->end() && alone < kEnough; ++x) {
        alone += has_value(problem.objective().response, *x) && is_within_edges(problem, *x);
      }
      if (alone < kEnough) continue;
    }
    return Hopeless{c.response.name, nowhere(c.response, start, places->size()), {}};
  }
  return {};
}

std::string objective_without_value(const Problem& problem, std::uint64_t seed) {
  const Response& response = problem.objective().response;
  const auto places = places_of(problem, seed);
  const bool is_anywhere = std::ranges::any_of(
      places, [&](const std::vector<double>& x) { return has_value(response, x); });
  if (is_anywhere) return {};
  return fmt::format("the objective {} is undefined: {}", response.name,
                     nowhere(response, problem.start(), places.size()));
}

}  // namespace camlaw::optim
