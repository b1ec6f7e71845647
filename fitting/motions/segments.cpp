// SPDX-License-Identifier: MIT
#include "fitting/motions/segments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "fitting/motions/motion_chains.h"

namespace camlaw::problems {
namespace {

using Node = MotionNode;
using Chain = MotionChain;

[[noreturn]] void refuse_segments(const std::string& why) {
  throw std::invalid_argument("segments: " + why);
}

void check(const SegmentOptions& options) {
  for (const double share : {options.least_dwell, options.least_motion}) {
    if (share > 0 && share < 0.5) continue;
    refuse_segments(fmt::format("the least fraction, {:.6g}, is not between 0 and 0.5", share));
  }
}

/// Whether one chain goes all the way round.
bool is_closed(const LiftCurve& lift, const std::vector<Chain>& chains) {
  constexpr double kRounding = 1e-9;  // of the turn: the sum of the motions' lengths rounds
  return lift.is_periodic && chains.size() == 1 &&
         chains[0].back().place - chains[0].front().place > (1 - kRounding) * lift.length();
}

/// Where that begins which is seen of the dwell before a chain, and where that ends which is seen
/// of the dwell after it: the nearer half, if another motion follows.
double dwell_begin(const LiftCurve& lift, const std::vector<Chain>& chains, std::size_t i) {
  const double here = chains[i].front().place;
  if (i > 0) return std::midpoint(chains[i - 1].back().place, here);
  return lift.is_periodic ? std::midpoint(chains.back().back().place - lift.length(), here)
                          : lift.begin;
}
double dwell_end(const LiftCurve& lift, const std::vector<Chain>& chains, std::size_t i) {
  const double here = chains[i].back().place;
  if (i + 1 < chains.size()) return std::midpoint(here, chains[i + 1].front().place);
  return lift.is_periodic ? std::midpoint(here, chains[0].front().place + lift.length()) : lift.end;
}

/// The k-th node of the i-th chain, looked at closely.
Node refined(const LiftCurve& lift, const std::vector<Chain>& rough, std::size_t i, std::size_t k) {
  const Chain& chain = rough[i];
  const std::size_t last = chain.size() - 1;
  const Node& node = chain[k];
  const bool closed = is_closed(lift, rough);
  const bool is_first = i == 0 && k == 0, is_last = i + 1 == rough.size() && k == last;
  if (!lift.is_periodic &&
      ((is_first && node.place <= lift.begin) || (is_last && node.place >= lift.end))) {
    return node;  // the samples begin or end in a motion
  }
  const auto length = [&](std::size_t j) { return chain[j + 1].place - chain[j].place; };
  const CornerSides sides{k > 0    ? length(k - 1)
                          : closed ? length(last - 1)
                                   : 0,
                          k < last ? length(k)
                          : closed ? length(0)
                                   : 0};
  const double from =
      sides.before > 0 ? node.place - 0.75 * sides.before : dwell_begin(lift, rough, i);
  const double to = sides.after > 0 ? node.place + 0.75 * sides.after : dwell_end(lift, rough, i);
  const double reach = 0.3 * std::max(sides.before, sides.after);
  const Corner corner =
      find_corner(samples_between(lift, from, to), sides, node.place,
                  std::max(from, node.place - reach), std::min(to, node.place + reach), lift.noise);
  return {corner.place, corner.level, corner.place_error};
}

/// All nodes, looked at closely.
std::vector<Chain> refined(const LiftCurve& lift, const std::vector<Chain>& rough) {
  std::vector<Chain> chains = rough;
  for (std::size_t i = 0; i < rough.size(); ++i) {
    for (std::size_t k = 0; k < rough[i].size(); ++k) chains[i][k] = refined(lift, rough, i, k);
  }
  if (is_closed(lift, rough)) {
    chains[0].back() = chains[0].front();
    chains[0].back().place += lift.length();
  }
  return chains;
}

/// Whether between these the lift only turns: opposite motions after too short a dwell, or one that
/// its ends' errors leave open.
bool is_turn(const LiftCurve& lift, const Chain& a, const Chain& b, double gap) {
  const auto rises = [](const Node& from, const Node& to) { return to.level > from.level; };
  const double doubt = 2 * std::hypot(a.back().error, b.front().error);
  return gap < std::max(lift.least_dwell, doubt) &&
         rises(a[a.size() - 2], a.back()) != rises(b[0], b[1]);
}

/// A dwell that turns out too short to be one is where the follower turns. Joins one such pair of
/// rough chains; false where there is none.
bool join_short_dwell(const LiftCurve& lift, std::vector<Chain>& rough,
                      const std::vector<Chain>& fine) {
  const std::size_t n = rough.size();
  for (std::size_t i = 0; i < n; ++i) {
    const bool last = i + 1 == n;
    if (last && (!lift.is_periodic || is_closed(lift, rough))) return false;
    const std::size_t next = last ? 0 : i + 1;
    const double turn = last ? lift.length() : 0;
    const double begin = fine[next].front().place + turn;
    if (!is_turn(lift, fine[i], fine[next], begin - fine[i].back().place)) continue;
    Node joint = fine[i].back();
    joint.place = std::midpoint(joint.place, begin);
    rough[i].back() = joint;
    if (n == 1) {
      rough[0].front() = {joint.place - lift.length(), joint.level};
      return true;
    }
    for (std::size_t k = 1; k < rough[next].size(); ++k) {
      rough[i].push_back(rough[next][k]);
      rough[i].back().place += turn;
    }
    rough.erase(rough.begin() + static_cast<std::ptrdiff_t>(next));
    return true;
  }
  return false;
}

/// Where noise has carried nodes past one another the rough ones stand, with an error as long as
/// their motion.
void put_in_order(const std::vector<Chain>& rough, std::vector<Chain>& chains) {
  const auto is_past = [](const Node& a, const Node& b) { return !(a.place < b.place); };
  for (std::size_t i = 0; i < chains.size(); ++i) {
    Chain& chain = chains[i];
    if (std::adjacent_find(chain.begin(), chain.end(), is_past) == chain.end()) continue;
    chain = rough[i];
    const double length = chain.back().place - chain.front().place;
    for (Node& node : chain) node.error = 0.5 * length;
  }
}

/// Where samples begin or end in a motion a dwell there is too short to be one, or its error leaves
/// it open.
void drop_short_ends(const LiftCurve& lift, std::vector<Chain>& chains) {
  const auto drop = [&](Node& node, double end, double dwell) {
    if (dwell < std::max(lift.least_dwell, 2 * node.error)) node = {end, lift.curve(end)};
  };
  Node &first = chains.front().front(), &last = chains.back().back();
  drop(first, lift.begin, first.place - lift.begin);
  drop(last, lift.end, lift.end - last.place);
}

/// Neighbours of a dwell end where it lies: its samples' mean. What goes down is a return.
void level_dwells(const LiftCurve& lift, std::vector<FoundSegment>& segments) {
  const std::size_t n = segments.size();
  for (std::size_t i = 0; i < n; ++i) {
    FoundSegment& dwell = segments[i];
    if (dwell.kind != SegmentKind::Dwell) continue;
    const CornerSamples inside = samples_between(lift, dwell.begin, dwell.end);
    if (inside.s.size() > 2) {
      dwell.from = std::accumulate(inside.s.begin(), inside.s.end(), 0.0) /
                   static_cast<double>(inside.s.size());
    }
    dwell.to = dwell.from;
    if (i > 0 || lift.is_periodic) segments[(i + n - 1) % n].to = dwell.from;
    if (i + 1 < n || lift.is_periodic) segments[(i + 1) % n].from = dwell.from;
  }
  for (FoundSegment& segment : segments) {
    if (segment.kind == SegmentKind::Dwell) continue;
    segment.kind = segment.to > segment.from ? SegmentKind::Rise : SegmentKind::Return;
  }
}

/// Motions of the chains, with dwells between them.
std::vector<FoundSegment> segments_of(const LiftCurve& lift, const std::vector<Chain>& chains) {
  std::vector<FoundSegment> result;
  const auto dwell = [&](const Node& a, const Node& b) {
    if (!(b.place > a.place)) return;
    const double level = std::midpoint(a.level, b.level);
    result.push_back({SegmentKind::Dwell, a.place, b.place, level, level, a.error, b.error});
  };
  if (!lift.is_periodic) dwell({lift.begin, chains[0][0].level}, chains[0][0]);
  for (std::size_t i = 0; i < chains.size(); ++i) {
    const Chain& chain = chains[i];
    for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
      const Node &a = chain[k], &b = chain[k + 1];
      result.push_back({SegmentKind::Rise, a.place, b.place, a.level, b.level, a.error, b.error});
    }
    const bool last = i + 1 == chains.size();
    Node next = chains[last ? 0 : i + 1].front();
    if (last && !lift.is_periodic) next = {lift.end, chain.back().level};
    if (last && lift.is_periodic) next.place += lift.length();
    dwell(chain.back(), next);
  }
  level_dwells(lift, result);
  return result;
}

/// Periodic ones begin within the period that starts at 0.
void put_in_period(double period, std::vector<FoundSegment>& segments) {
  for (FoundSegment& segment : segments) {
    const double turns = std::floor(segment.begin / period);
    segment.begin -= turns * period;
    segment.end -= turns * period;
  }
  std::sort(segments.begin(), segments.end(),
            [](const auto& a, const auto& b) { return a.begin < b.begin; });
}

Possible<std::vector<FoundSegment>> segments_in(const LiftCurve& lift) {
  std::vector<Chain> rough = rough_chains(lift);
  if (rough.empty()) {
    return Impossible{
        fmt::format("segments: the lift does not vary by more than {:.6g}", lift.least)};
  }
  std::vector<Chain> chains = refined(lift, rough);
  while (join_short_dwell(lift, rough, chains)) chains = refined(lift, rough);
  put_in_order(rough, chains);
  if (!lift.is_periodic) drop_short_ends(lift, chains);
  std::vector<FoundSegment> segments = segments_of(lift, chains);
  if (lift.is_periodic) put_in_period(lift.length(), segments);
  return segments;
}

}  // namespace

std::string to_string(SegmentKind kind) {
  return kind == SegmentKind::Dwell ? "dwell" : kind == SegmentKind::Rise ? "rise" : "return";
}

Possible<FoundSegments> possible_segments(std::span<const double> phi, std::span<const double> s,
                                          const SegmentOptions& options) {
  check(options);
  auto lift = lift_samples(phi, s, options.period, options.noise, options.least_noise);
  if (!lift) return lift.reason();
  const auto curve = lift_curve(*lift, options);
  if (!curve) return curve.reason();
  auto segments = segments_in(*curve);
  if (!segments) return segments.reason();
  return FoundSegments{std::move(*segments), lift->sample_noise, std::move(lift->outlying)};
}

FoundSegments motion_segments(std::span<const double> phi, std::span<const double> s,
                              const SegmentOptions& options) {
  return possible_segments(phi, s, options).value();
}

}  // namespace camlaw::problems
