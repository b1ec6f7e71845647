// SPDX-License-Identifier: MIT
#include "optim/pareto/spacing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace camlaw::optim {
namespace {

/// Beyond so many nearest points of each nothing is looked for: it bounds the work for fronts of
/// thousands of points, and is all of them for fronts of hundreds.
constexpr std::size_t kNeighbours = 128;

struct Near {
  double distance;
  std::size_t point;
  bool operator<(const Near& other) const {
    return distance < other.distance || (distance == other.distance && point < other.point);
  }
};

/// Of each point the nearest others, nearest first.
std::vector<std::vector<Near>> nearest_of_each(std::span<const Costs> places) {
  std::vector<std::vector<Near>> result(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::vector<Near>& all = result[i];
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (k != i) all.push_back({distance(places[i], places[k]), k});
    }
    const auto end = all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), kNeighbours));
    std::partial_sort(all.begin(), end, all.end());
    all.erase(end, all.end());
    all.shrink_to_fit();
  }
  return result;
}

/// Whether a pair comes up at its other point too, which is then the one that tells.
bool is_seen_from_other(const std::vector<std::vector<Near>>& near, std::size_t point,
                        const Near& other) {
  return other.point < point && !(near[other.point].back() < Near{other.distance, point});
}

Costs mean_of(std::span<const Costs> places, const std::vector<std::size_t>& of) {
  Costs mean(places.front().size(), 0.0);
  for (const std::size_t p : of) {
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += places[p][i];
  }
  for (double& m : mean) m /= static_cast<double>(of.size());
  return mean;
}

/// The points about a place, nearest first, among those near a point, and itself.
std::vector<Near> nearest_to(const Costs& place, std::span<const Costs> places, std::size_t point,
                             const std::vector<Near>& near, std::size_t count) {
  std::vector<Near> all{{distance(place, places[point]), point}};
  for (const Near& n : near) {
    // Farther from the point than this it is farther from the place than the point is.
    if (n.distance > 4 * all.front().distance) break;
    all.push_back({distance(place, places[n.point]), n.point});
  }
  const auto end = all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), count));
  std::partial_sort(all.begin(), end, all.end());
  all.erase(end, all.end());
  return all;
}

/// The middle of two points, or the mean of up to as many as there are costs about it, whichever
/// is farthest from all.
Hole widest(Hole hole, std::span<const Costs> places, std::size_t point,
            const std::vector<Near>& near) {
  const std::size_t most = places.front().size();
  const std::vector<Near> about = nearest_to(hole.place, places, point, near, most);
  std::vector<std::size_t> of;
  Hole best = std::move(hole);
  for (const Near& n : about) {
    of.push_back(n.point);
    if (of.size() < 3) continue;
    const Costs mean = mean_of(places, of);
    const double size = nearest_to(mean, places, point, near, 1).front().distance;
    if (size > best.size) best = {mean, size, of, false};
  }
  return best;
}

void add_between(std::vector<Hole>& result, std::span<const Costs> places,
                 const std::vector<std::vector<Near>>& near) {
  constexpr double kEmpty = 0.5;  // of the ball over two points: what must be empty
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (const Near& other : near[i]) {
      if (is_seen_from_other(near, i, other)) continue;
      const Costs middle = mean_of(places, {i, other.point});
      const double half = other.distance / 2;
      double size = half;
      for (const Near& n : near[i]) {
        if (n.distance > other.distance) break;
        size = std::min(size, distance(middle, places[n.point]));
        if (size < kEmpty * half) break;
      }
      if (size < kEmpty * half) continue;
      result.push_back(widest({middle, size, {i, other.point}, false}, places, i, near[i]));
    }
  }
}

void add_beyond(std::vector<Hole>& result, std::span<const Costs> places,
                std::span<const Gap> gaps) {
  // The mean of neighbours is not aside inside an even mesh, 0.43 steps aside at the rim of one of
  // triangles and one step at the end of a row; a cost this near its minimum cannot be less.
  constexpr double kOneSided = 0.35, kLeast = 1e-3;
  std::vector<std::vector<std::size_t>> neighbours(places.size());
  std::vector<double> reach(places.size(), 0.0);
  for (const Gap& gap : gaps) {
    for (const auto& [from, to] : {std::pair(gap.a, gap.b), std::pair(gap.b, gap.a)}) {
      neighbours[from].push_back(to);
      reach[from] += gap.length;
    }
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (neighbours[i].empty()) continue;
    const double step = reach[i] / static_cast<double>(neighbours[i].size());
    const Costs mean = mean_of(places, neighbours[i]);
    const double aside = distance_aside(places[i], mean);
    if (!(aside > kOneSided * step)) continue;
    Costs place = places[i];
    double along = 0;
    for (std::size_t c = 0; c < place.size(); ++c) along += (places[i][c] - mean[c]);
    along /= static_cast<double>(place.size());
    bool is_possible = true;
    for (std::size_t c = 0; c < place.size(); ++c) {
      const double outwards = places[i][c] - mean[c];
      is_possible = is_possible && !(outwards < 0 && places[i][c] < kLeast);
      place[c] += step / aside * (outwards - along);
    }
    if (is_possible) result.push_back({std::move(place), step, {i}, true});
  }
}

std::vector<Gap> gaps_among(std::span<const Costs> places,
                            const std::vector<std::vector<Near>>& near) {
  std::vector<Gap> result;
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (const Near& other : near[i]) {
      if (is_seen_from_other(near, i, other)) continue;
      bool is_neighbour = true;
      for (const Near& n : near[i]) {
        if (n.distance >= other.distance) break;
        is_neighbour = distance(places[n.point], places[other.point]) >= other.distance;
        if (!is_neighbour) break;
      }
      if (is_neighbour) result.push_back({i, other.point, other.distance});
    }
  }
  return result;
}

}  // namespace

double distance(const Costs& a, const Costs& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

double distance_aside(const Costs& a, const Costs& b) {
  double sum = 0, squares = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += a[i] - b[i];
    squares += (a[i] - b[i]) * (a[i] - b[i]);
  }
  return std::sqrt(std::max(0.0, squares - sum * sum / static_cast<double>(a.size())));
}

std::vector<Gap> gaps(std::span<const Costs> places) {
  return gaps_among(places, nearest_of_each(places));
}

double mean_length(std::span<const Gap> gaps) {
  double sum = 0;
  for (const Gap& gap : gaps) sum += gap.length;
  return gaps.empty() ? 0 : sum / static_cast<double>(gaps.size());
}

std::vector<std::size_t> thinned(std::span<const Costs> places, std::size_t count,
                                 const std::vector<bool>& must_stay) {
  std::vector<std::size_t> kept(places.size());
  std::iota(kept.begin(), kept.end(), std::size_t{0});
  if (places.size() <= count) return kept;
  auto near = nearest_of_each(places);
  std::vector<bool> is_gone(places.size(), false);
  while (kept.size() > count) {
    std::size_t worst = places.size();
    std::pair<double, double> least{std::numeric_limits<double>::infinity(), 0};
    for (const std::size_t p : kept) {
      if (must_stay[p]) continue;
      std::erase_if(near[p], [&](const Near& n) { return is_gone[n.point]; });
      if (near[p].empty()) continue;
      // Of two that are nearest to each other that one which is nearer to a third.
      const std::pair<double, double> its{near[p][0].distance,
                                          near[p].size() > 1 ? near[p][1].distance : 0};
      if (!(its < least)) continue;
      least = its;
      worst = p;
    }
    if (worst == places.size()) break;
    is_gone[worst] = true;
    std::erase(kept, worst);
  }
  return kept;
}

Spacing spacing(std::span<const Costs> places) {
  const auto near = nearest_of_each(places);
  Spacing result{gaps_among(places, near), {}};
  add_between(result.holes, places, near);
  add_beyond(result.holes, places, result.gaps);
  return result;
}

}  // namespace camlaw::optim
