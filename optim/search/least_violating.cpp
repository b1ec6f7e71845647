// SPDX-License-Identifier: MIT
#include "optim/search/least_violating.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "optim/problem/starts.h"
#include "optim/search/interruptible.h"

namespace camlaw::optim {
namespace {

/// Whether two places are so near that searches from them lead to the same, as a rule.
bool are_near(const Problem& problem, const Scales& scales, Design a, Design b) {
  constexpr double kNear = 0.1;  // of the range, or of ten typical changes
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double range = problem.variables[i].upper - problem.variables[i].lower;
    const double whole = std::isfinite(range) ? range : 10 * scales.variables[i];
    if (std::abs(a[i] - b[i]) > kNear * whole) return false;
  }
  return true;
}

/// Infinite where the model gives no number, or throws.
double violation_at(const Problem& problem, const Scales& scales, Design x) {
  try {
    return largest_violation(problem, scales, x);
  } catch (...) {
    if (is_interruption(std::current_exception())) throw;
    return kInfinity;
  }
}

/// Each of the places moved onto a face of the box, of all faces in turn. A side without a bound
/// has no face.
std::vector<std::vector<double>> on_faces(const Problem& problem,
                                          std::vector<std::vector<double>> places) {
  std::vector<std::pair<std::size_t, double>> faces;
  for (std::size_t i = 0; i < problem.variables.size(); ++i) {
    const Variable& v = problem.variables[i];
    if (v.lower == v.upper || v.integer) continue;
    for (const double bound : {v.lower, v.upper}) {
      if (std::isfinite(bound)) faces.emplace_back(i, bound);
    }
  }
  if (faces.empty()) return {};
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto& [variable, bound] = faces[k % faces.size()];
    places[k][variable] = bound;
  }
  return places;
}

}  // namespace

std::vector<std::vector<double>> least_violating(const Problem& problem, const Scales& scales,
                                                 Design known, std::size_t count,
                                                 std::uint64_t seed) {
  // So many places at random miss a fiftieth of the box once in thirteen times.
  constexpr int kPlaces = 128;
  const auto even = starts(problem, kPlaces, seed);
  auto by_magnitude = starts_by_magnitude(problem, kPlaces, seed);
  by_magnitude.erase(by_magnitude.begin());  // the start, once more
  std::vector<std::pair<double, std::vector<double>>> places;
  for (const auto& all : {even, by_magnitude, on_faces(problem, even)}) {
    for (const std::vector<double>& x : all) {
      const double violation = violation_at(problem, scales, x);
      if (std::isfinite(violation)) places.emplace_back(violation, x);
    }
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::vector<double>> result;
  for (const auto& [violation, x] : places) {
    if (result.size() == count) break;
    const bool is_new = !are_near(problem, scales, known, x) &&
                        std::none_of(result.begin(), result.end(), [&, &place = x](const auto& r) {
                          return are_near(problem, scales, r, place);
                        });
    if (is_new) result.push_back(x);
  }
  return result;
}

}  // namespace camlaw::optim
