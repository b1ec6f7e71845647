// SPDX-License-Identifier: MIT
#include "fitting/motions/motion_chains.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "numerics/linear/statistics.h"

namespace camlaw::problems {
namespace {

/// A stretch in which nothing moves.
struct Rest {
  double begin, end, level;
};

constexpr int kGrid = 2000;  // places: 0.18 deg of a turn, less than an end of a motion is known to
double grid(const LiftCurve& lift, int i) {
  return std::min(lift.begin + lift.length() * i / kGrid, lift.end);
}

/// Places on a grid where neither velocity nor acceleration is more than noise makes of it.
std::vector<bool> still_places(const LiftCurve& lift) {
  // A dwell's neighbours are left within some percent of the peaks; turning takes more.
  constexpr double kOfPeaks[] = {0.03, 0.15};
  std::vector<bool> still(kGrid + 1, true);
  for (const int order : {1, 2}) {
    std::vector<double> sizes;
    for (int i = 0; i <= kGrid; ++i) sizes.push_back(std::abs(lift.curve(grid(lift, i), order)));
    const double most = kOfPeaks[order - 1] * *std::max_element(sizes.begin(), sizes.end());
    for (int i = 0; i <= kGrid; ++i) {
      still[i] = still[i] &&
                 sizes[i] <= std::max(most, 4 * lift.curve.standard_error(grid(lift, i), order));
    }
  }
  return still;
}

/// A wave that noise left in a dwell does not part it.
void join_near(const LiftCurve& lift, std::vector<Rest>& rests) {
  for (std::size_t i = 0; i + 1 < rests.size();) {
    const double end = rests[i].end, begin = rests[i + 1].begin;
    if (begin - end < 0.01 * lift.length() &&
        std::abs(lift.curve(begin) - lift.curve(end)) < 0.5 * lift.least) {
      rests[i].end = rests[i + 1].end;
      rests.erase(rests.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    } else {
      ++i;
    }
  }
}

/// Dwells, roughly; periodic ones may begin before 0.
std::vector<Rest> rests_of(const LiftCurve& lift) {
  const std::vector<bool> still = still_places(lift);
  std::vector<Rest> rests;
  for (int i = 0; i <= kGrid; ++i) {
    if (!still[i]) continue;
    const int begin = i;
    while (i < kGrid && still[i + 1]) ++i;
    rests.push_back({grid(lift, begin), grid(lift, i), 0});
  }
  if (lift.is_periodic && rests.size() > 1 && still[0] && still[kGrid]) {
    rests.front().begin = rests.back().begin - lift.length();
    rests.pop_back();
  }
  join_near(lift, rests);
  std::erase_if(rests, [&](const Rest& r) { return r.end - r.begin < lift.least_dwell; });
  for (Rest& rest : rests) {
    const CornerSamples inside = samples_between(lift, rest.begin, rest.end);
    rest.level = inside.s.empty() ? lift.curve(std::midpoint(rest.begin, rest.end))
                                  : optim::median(inside.s);
  }
  return rests;
}

/// Places where the lift turns: it goes back from there by more than what counts as a motion.
MotionChain chain_between(const LiftCurve& lift, const MotionNode& begin, const MotionNode& end) {
  MotionChain nodes{begin};
  MotionNode high = begin, low = begin;
  int direction = 0;
  const auto look = [&](double x, double s) {
    if (s > high.level) high = {x, s};
    if (s < low.level) low = {x, s};
    if (direction >= 0 && s < high.level - lift.least) {
      if (direction > 0) nodes.push_back(high);
      direction = -1;
      low = {x, s};
    } else if (direction <= 0 && s > low.level + lift.least) {
      if (direction < 0) nodes.push_back(low);
      direction = 1;
      high = {x, s};
    }
  };
  const double length = end.place - begin.place;
  const int steps = std::max(2, static_cast<int>(kGrid * length / lift.length()));
  for (int i = 1; i < steps; ++i) {
    const double x = begin.place + length * i / steps;
    look(x, lift.curve(x));
  }
  look(end.place, end.level);
  if (direction == 0) return {};
  nodes.push_back(end);
  return nodes;
}

MotionNode node_at(const LiftCurve& lift, double place) { return {place, lift.curve(place)}; }

/// Periodic ones without dwells begin at the lowest place.
MotionChain chain_without_dwells(const LiftCurve& lift) {
  MotionNode from = node_at(lift, lift.begin);
  if (!lift.is_periodic) return chain_between(lift, from, node_at(lift, lift.end));
  for (int i = 0; i < kGrid; ++i) {
    const MotionNode here = node_at(lift, grid(lift, i));
    if (here.level < from.level) from = here;
  }
  return chain_between(lift, from, {from.place + lift.length(), from.level});
}

}  // namespace

Possible<LiftCurve> lift_curve(const LiftSamples& lift, const SegmentOptions& options) {
  auto curve = smooth_lift(lift, options.period);
  if (!curve) return curve.reason();
  const auto [low, high] = std::minmax_element(lift.s.begin(), lift.s.end());
  const double whole = *high - *low;
  constexpr double kLeastNoise = 1e-9;  // of the whole travel: exact samples have their rounding
  constexpr double kAboveNoise = 5;     // a travel that is surely none of it
  LiftCurve result{.samples = {.x = lift.phi, .s = lift.s, .curve = {}, .leverage = {}},
                   .curve = std::move(*curve),
                   .is_periodic = options.period.has_value(),
                   .begin = options.period ? 0 : lift.phi.front(),
                   .end = options.period.value_or(lift.phi.back()),
                   .least = std::max(options.least_motion * whole, kAboveNoise * lift.noise),
                   .least_dwell = 0,
                   .noise = std::max(lift.noise, kLeastNoise * whole)};
  result.least_dwell = options.least_dwell * result.length();
  for (std::size_t i = 0; i < lift.s.size(); ++i) {
    const optim::SmoothedSample& smoothed = result.curve.samples()[i];
    result.samples.curve.push_back(lift.s[i] - smoothed.residual);
    result.samples.leverage.push_back(smoothed.leverage);
  }
  return result;
}

CornerSamples samples_between(const LiftCurve& lift, double low, double high) {
  CornerSamples result;
  const CornerSamples& all = lift.samples;
  const double turns = lift.is_periodic ? std::floor((low - lift.begin) / lift.length()) : 0;
  for (int turn = 0; turn < (lift.is_periodic ? 3 : 1); ++turn) {
    const double shift = (turns + turn) * lift.length();
    for (std::size_t i = 0; i < all.x.size(); ++i) {
      const double x = all.x[i] + shift;
      if (x < low || x > high) continue;
      result.x.push_back(x), result.s.push_back(all.s[i]);
      result.curve.push_back(all.curve[i]), result.leverage.push_back(all.leverage[i]);
    }
  }
  return result;
}

std::vector<MotionChain> rough_chains(const LiftCurve& lift) {
  const std::vector<Rest> rests = rests_of(lift);
  std::vector<MotionChain> chains;
  const auto add = [&](MotionChain chain) {
    if (!chain.empty()) chains.push_back(std::move(chain));
  };
  if (rests.empty()) {
    add(chain_without_dwells(lift));
    return chains;
  }
  const Rest &first = rests.front(), &last = rests.back();
  if (!lift.is_periodic && first.begin > lift.begin) {
    add(chain_between(lift, node_at(lift, lift.begin), {first.begin, first.level}));
  }
  for (std::size_t i = 0; i + 1 < rests.size(); ++i) {
    const Rest &rest = rests[i], &next = rests[i + 1];
    add(chain_between(lift, {rest.end, rest.level}, {next.begin, next.level}));
  }
  if (lift.is_periodic) {
    add(chain_between(lift, {last.end, last.level}, {first.begin + lift.length(), first.level}));
  } else if (last.end < lift.end) {
    add(chain_between(lift, {last.end, last.level}, node_at(lift, lift.end)));
  }
  return chains;
}

}  // namespace camlaw::problems
