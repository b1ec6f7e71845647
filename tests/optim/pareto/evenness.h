// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "optim/pareto/pareto.h"
#include "optim/pareto/scout.h"
#include "tests/sets/fronts/surfaces.h"

/// How even a front is, measured by the definitions alone and with nothing of the library's own
/// measures but the hypervolume.
namespace camlaw::optim::even_tests {

inline double apart(const Costs& a, const Costs& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::pow(a[i] - b[i], 2);
  return std::sqrt(sum);
}

/// Places by the range of each cost over `range_of`.
inline std::vector<Costs> by_range(std::vector<Costs> points, const std::vector<Costs>& range_of) {
  for (std::size_t i = 0; i < points.front().size(); ++i) {
    double least = kInfinity, most = -kInfinity;
    for (const Costs& p : range_of) {
      least = std::min(least, p[i]);
      most = std::max(most, p[i]);
    }
    for (Costs& p : points) p[i] = most > least ? (p[i] - least) / (most - least) : 0;
  }
  return points;
}

struct Even {
  double gap = 0;      ///< the largest edge of the relative neighbourhood graph over the mean one
  double nearest = 0;  ///< the largest distance to a nearest point over the mean one
  double crowded = 0;  ///< the least of them over the mean one
  double mean_nearest = 0;
};

inline Even evenness_of(const std::vector<Costs>& places) {
  const std::size_t n = places.size();
  double sum = 0, most = 0, count = 0, of_nearest = 0, farthest = 0, least = kInfinity;
  for (std::size_t i = 0; i < n; ++i) {
    double nearest = kInfinity;
    for (std::size_t k = 0; k < n; ++k) {
      if (k == i) continue;
      const double d = apart(places[i], places[k]);
      nearest = std::min(nearest, d);
      bool is_edge = true;
      for (std::size_t r = 0; r < n && is_edge; ++r) {
        is_edge = r == i || r == k ||
                  std::max(apart(places[r], places[i]), apart(places[r], places[k])) >= d;
      }
      if (!is_edge) continue;
      sum += d;
      ++count;
      most = std::max(most, d);
    }
    of_nearest += nearest;
    farthest = std::max(farthest, nearest);
    least = std::min(least, nearest);
  }
  const double mean = of_nearest / static_cast<double>(n);
  return {most / (sum / count), farthest / mean, least / mean, mean};
}

inline bool is_dominated(const Costs& by, const Costs& point) {
  bool is_less = false;
  for (std::size_t i = 0; i < point.size(); ++i) {
    if (by[i] > point[i]) return false;
    is_less = is_less || by[i] < point[i];
  }
  return is_less;
}

/// Random points of the front that is known.
inline std::vector<Costs> samples_of(const sets::KnownSurface& surface, std::size_t count) {
  std::mt19937_64 generator(7);
  std::vector<Costs> all;
  while (all.size() < count) {
    std::vector<double> u(surface.parameters);
    for (double& x : u) x = static_cast<double>(generator() >> 11) * 0x1p-53;
    all.push_back(surface.costs(u));
  }
  return all;
}

/// How far a point of the front can be from the nearest that was found.
inline double farthest(const std::vector<Costs>& samples, const std::vector<Costs>& found) {
  double most = 0;
  for (const Costs& s : samples) {
    double least = kInfinity;
    for (const Costs& f : found) least = std::min(least, apart(s, f));
    most = std::max(most, least);
  }
  return most;
}

/// The greatest hypervolume of NSGA-II's fronts by five seeds, each of `points` designs for each
/// combination of choices.
inline double best_of_nsga2(const ProblemSpace& space, std::size_t points, std::size_t generations,
                            const Costs& reference) {
  double best = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    std::vector<Costs> all;
    for (std::size_t part = 0; part < space.parts(); ++part) {
      Task task;
      task.kind = Task::Kind::Scout;
      task.part = part;
      task.population = points;
      task.generations = generations;
      task.seed = seed;
      for (const FrontPoint& p : scout(task, space.problem(space.options(part))).points) {
        all.push_back(p.costs);
      }
    }
    best = std::max(best, hypervolume(all, reference));
  }
  return best;
}

}  // namespace camlaw::optim::even_tests
