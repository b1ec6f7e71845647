// SPDX-License-Identifier: MIT
#include "optim/pareto/round.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "optim/pareto/pareto.h"

namespace camlaw::optim {
namespace {

constexpr std::size_t kRound = 16;  ///< tasks of a round

/// Of many points that are missing a quarter, as each round looks at the whole front.
std::size_t round_of(std::size_t missing) {
  return std::min(missing, std::max(kRound, missing / 4));
}

std::vector<OpenPlace> open_places(const PartFronts& parts, const FrontSoFar& front) {
  std::vector<OpenPlace> places;
  for (const auto& part : parts) {
    if (part->is_empty()) continue;
    for (OpenPlace& place : part->open(front)) places.push_back(std::move(place));
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const OpenPlace& a, const OpenPlace& b) { return a.size > b.size; });
  return places;
}

/// Before the front grows, what is on it must be there by right.
std::vector<Task> challenges(const std::vector<OpenPlace>& places) {
  std::vector<Task> tasks;
  for (const OpenPlace& place : places) {
    if (place.is_challenge && tasks.size() < kRound) tasks.push_back(place.task);
  }
  return tasks;
}

/// Places at least half as large as the largest.
std::vector<Task> largest(const std::vector<OpenPlace>& places, std::size_t count) {
  std::vector<Task> tasks;
  for (const OpenPlace& place : places) {
    if (tasks.size() == count || place.size < places.front().size / 2) break;
    tasks.push_back(place.task);
  }
  return tasks;
}

/// Places larger than a front is left with, however many points it has.
std::vector<Task> too_large(const std::vector<OpenPlace>& places, double most) {
  std::vector<Task> tasks;
  for (const OpenPlace& place : places) {
    if (place.size > most && tasks.size() < kRound) tasks.push_back(place.task);
  }
  return tasks;
}

/// Between neighbours of a front of two objectives.
double mean_step(const FrontSoFar& front) {
  const std::vector<double> all = steps(costs_of(front.points), front.tolerances, front.sizes);
  if (all.empty()) return 0;
  return std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
}

/// Whether a place is near one that this part is to look at already.
bool is_taken(const OpenPlace& place, const std::vector<const OpenPlace*>& taken) {
  // Of the size: searches in two holes that are nearer lead to the same points.
  constexpr double kApart = 0.8;
  return std::any_of(taken.begin(), taken.end(), [&](const OpenPlace* other) {
    return other->task.part == place.task.part &&
           distance_aside(place.place, other->place) < kApart * std::min(place.size, other->size);
  });
}

/// As largest(), apart from each other, and so many of places between points and beyond them;
/// none smaller than `least`.
std::vector<Task> largest_apart(const std::vector<OpenPlace>& places,
                                const std::array<std::size_t, 2>& count, double least) {
  std::array<double, 2> greatest{0, 0};
  std::array<std::vector<const OpenPlace*>, 2> taken;
  for (const OpenPlace& place : places) {
    greatest[place.is_beyond] = std::max(greatest[place.is_beyond], place.size);
  }
  std::vector<Task> tasks;
  for (const OpenPlace& place : places) {
    auto& of_kind = taken[place.is_beyond];
    const bool is_large = place.size >= std::max(least, greatest[place.is_beyond] / 2);
    if (!is_large || of_kind.size() == count[place.is_beyond]) continue;
    if (is_taken(place, taken[0]) || is_taken(place, taken[1])) continue;
    of_kind.push_back(&place);
    tasks.push_back(place.task);
  }
  return tasks;
}

/// How often a search beyond the points finds something: before any, half the time.
double beyond_rate(const PartFronts& parts) {
  Beyond all;
  for (const auto& part : parts) {
    all.tried += part->beyond().tried;
    all.found += part->beyond().found;
  }
  return (1.0 + static_cast<double>(all.found)) / (2.0 + static_cast<double>(all.tried));
}

/// How many points are nearly others: they do not make a front longer.
std::size_t count_twins(const std::vector<Costs>& places, std::span<const Gap> gaps) {
  constexpr double kNear = 0.3;  // of the mean gap
  const double near = kNear * mean_length(gaps);
  // Points joined by such gaps are one: gaps join all points, so that each leaves one less.
  std::vector<std::size_t> group(places.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  std::size_t twins = 0;
  for (const Gap& gap : gaps) {
    const std::size_t a = group[gap.a], b = group[gap.b];
    if (!(gap.length < near) || a == b) continue;
    std::replace(group.begin(), group.end(), b, a);
    ++twins;
  }
  return twins;
}

/// Of three objectives or more.
std::vector<Task> even_round(const PartFronts& parts, FrontSoFar front, std::size_t wanted) {
  // What the front is made to be at the end of the sweep: a margin within kLargestGap, of the
  // distances to nearest points, which are shorter than gaps.
  constexpr double kAim = 2.3;
  constexpr double kWorth = 0.25;      // of searches beyond the front: what must find something
  constexpr double kBeyondMost = 0.7;  // of a round, if all of them did
  constexpr std::size_t kLast = 8;     // tasks of a round when there are points enough
  const std::vector<Costs> all = front.places();
  Spacing its = spacing(all);
  front.holes = std::move(its.holes);
  const std::vector<OpenPlace> places = open_places(parts, front);
  if (std::vector<Task> tasks = challenges(places); !tasks.empty()) return tasks;
  const double rate = beyond_rate(parts);
  const bool any_beyond =
      std::any_of(places.begin(), places.end(), [](const auto& place) { return place.is_beyond; });
  const auto shares = [&](std::size_t count) {
    const auto share = static_cast<std::size_t>(kBeyondMost * rate * static_cast<double>(count));
    const std::size_t beyond = any_beyond ? std::max<std::size_t>(1, share) : 0;
    return std::array<std::size_t, 2>{std::max(count, beyond + 1) - beyond, beyond};
  };
  const std::size_t apart = all.size() - count_twins(all, its.gaps);
  if (apart < wanted) return largest_apart(places, shares(round_of(wanted - apart)), 0);
  const Evenness even = evenness(parts, spread(front, wanted));
  std::array<std::size_t, 2> count = shares(kLast);
  const bool is_even = even.largest <= kAim * even.mean_to_nearest;
  if (is_even) count[0] = 0;
  if (!any_beyond || rate < kWorth) count[1] = 0;
  return largest_apart(places, count, even.mean);
}

Evenness evenness_of_pair(const PartFronts& parts, const FrontSoFar& front) {
  Evenness result;
  result.mean = result.mean_to_nearest = mean_step(front);
  const std::vector<OpenPlace> places = open_places(parts, front);
  if (!places.empty()) result.largest = places.front().size;
  return result;
}

}  // namespace

std::vector<Task> next_round(const PartFronts& parts, FrontSoFar front, std::size_t wanted) {
  if (front.ideal.size() > 2) return even_round(parts, std::move(front), wanted);
  const std::size_t missing = wanted - std::min(wanted, front.points.size());
  const std::vector<OpenPlace> places = open_places(parts, front);
  if (std::vector<Task> tasks = challenges(places); !tasks.empty()) return tasks;
  if (missing > 0) return largest(places, round_of(missing));
  return too_large(places, kLargestGap * mean_step(front));
}

double Evenness::ratio() const { return mean > 0 ? largest / mean : 1; }

Evenness evenness(const PartFronts& parts, const FrontSoFar& front) {
  constexpr double kAbout = 0.3;  // of a gap: how near its middle a search must have been
  Evenness result;
  if (front.ideal.size() == 2) return evenness_of_pair(parts, front);
  const std::vector<Costs> all = front.places();
  const std::vector<Gap> its = gaps(all);
  std::vector<double> nearest(all.size(), kInfinity);
  for (const Gap& gap : its) {
    nearest[gap.a] = std::min(nearest[gap.a], gap.length);
    nearest[gap.b] = std::min(nearest[gap.b], gap.length);
  }
  for (const double d : nearest) {
    if (std::isfinite(d)) result.mean_to_nearest += d / static_cast<double>(all.size());
  }
  result.mean = mean_length(its);
  for (const Gap& gap : its) {
    if (gap.length <= result.largest) continue;
    Costs middle = all[gap.a];
    for (std::size_t i = 0; i < middle.size(); ++i) middle[i] = (middle[i] + all[gap.b][i]) / 2;
    const bool is_empty = std::all_of(parts.begin(), parts.end(), [&](const auto& part) {
      const bool is_about =
          part->part() == front.points[gap.a].part || part->part() == front.points[gap.b].part;
      return !is_about || part->is_known_empty(middle, kAbout * gap.length, front);
    });
    if (!is_empty) result.largest = gap.length;
  }
  return result;
}

FrontSoFar spread(FrontSoFar front, std::size_t wanted) {
  constexpr double kAsGood = 1e-4;  // of the range
  const std::vector<Costs> all = front.places();
  if (all.size() <= wanted) return front;
  std::vector<bool> must_stay(all.size(), false);
  for (std::size_t i = 0; i < front.ideal.size(); ++i) {
    const auto best = std::min_element(all.begin(), all.end(),
                                       [i](const Costs& a, const Costs& b) { return a[i] < b[i]; });
    // One that stays already may be as good as the best.
    bool has_one = false;
    for (std::size_t p = 0; p < all.size(); ++p) {
      has_one = has_one || (must_stay[p] && all[p][i] <= (*best)[i] + kAsGood);
    }
    if (!has_one) must_stay[static_cast<std::size_t>(best - all.begin())] = true;
  }
  std::vector<FrontPoint> kept;
  for (const std::size_t k : thinned(all, wanted, must_stay)) {
    kept.push_back(std::move(front.points[k]));
  }
  front.points = std::move(kept);
  front.holes.clear();
  return front;
}

}  // namespace camlaw::optim
