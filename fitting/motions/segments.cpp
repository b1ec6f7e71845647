// SPDX-License-Identifier: MIT
#include "fitting/motions/segments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "fitting/motions/corner.h"
#include "fitting/samples/lift_samples.h"
#include "numerics/linear/statistics.h"
#include "numerics/spline/smoothing_spline.h"

namespace camlaw::problems {
namespace {

[[noreturn]] void refuse(const std::string& why) {
  throw std::invalid_argument("segments: " + why);
}

void check(const SegmentOptions& options) {
  for (const double share : {options.least_dwell, options.least_motion}) {
    if (share > 0 && share < 0.5) continue;
    refuse(fmt::format("the least share, {:.6g}, is not between 0 and 0.5", share));
  }
}

/// Where a motion begins, ends or turns, before and after it is looked at closely.
struct Node {
  double place, level;
  double error = 0;
};

/// Motions between nodes that follow one another without a dwell.
using Chain = std::vector<Node>;

/// A stretch in which nothing moves.
struct Rest {
  double begin, end, level;
};

/// Finds the segments of one lift.
class Segmenter {
 public:
  Segmenter(const LiftSamples& lift, const SegmentOptions& options)
      : options_(options), noise_(lift.noise), curve_(smooth_lift(lift, options.period)) {
    samples_.x = lift.phi, samples_.s = lift.s;
    for (std::size_t i = 0; i < samples_.x.size(); ++i) {
      samples_.curve.push_back(samples_.s[i] - curve_.samples()[i].residual);
      samples_.leverage.push_back(curve_.samples()[i].leverage);
    }
    const auto [low, high] = std::minmax_element(samples_.s.begin(), samples_.s.end());
    const double whole = *high - *low;
    least_ = std::max(options_.least_motion * whole, 5 * noise_);
    // Digits that samples without noise have.
    floor_ = std::max(noise_, 1e-9 * whole);
    begin_ = options_.period ? 0 : samples_.x.front();
    end_ = options_.period ? *options_.period : samples_.x.back();
    length_ = end_ - begin_;
  }

  std::vector<FoundSegment> run() {
    std::vector<Chain> rough = chains_between(rests());
    if (rough.empty()) {
      refuse(fmt::format("the lift does not move by more than {:.6g}", least_));
    }
    std::vector<Chain> chains = refined(rough);
    while (join_short_dwell(rough, chains)) chains = refined(rough);
    put_in_order(rough, chains);
    if (!options_.period) drop_short_ends(chains);
    return in_order(segments_of(chains));
  }

 private:
  static constexpr int kGrid = 2000;
  double grid(int i) const { return std::min(begin_ + length_ * i / kGrid, end_); }

  /// Places on a grid where neither velocity nor acceleration is more than noise makes of it.
  std::vector<bool> still() const {
    std::vector<double> v(kGrid + 1), a(kGrid + 1);
    for (int i = 0; i <= kGrid; ++i) {
      v[i] = std::abs(curve_(grid(i), 1));
      a[i] = std::abs(curve_(grid(i), 2));
    }
    // A dwell's neighbours are left within some percent of the peaks; turning takes more.
    const double most_v = 0.03 * *std::max_element(v.begin(), v.end());
    const double most_a = 0.15 * *std::max_element(a.begin(), a.end());
    std::vector<bool> result;
    for (int i = 0; i <= kGrid; ++i) {
      result.push_back(v[i] <= std::max(most_v, 4 * curve_.standard_error(grid(i), 1)) &&
                       a[i] <= std::max(most_a, 4 * curve_.standard_error(grid(i), 2)));
    }
    return result;
  }

  /// Dwells, roughly; periodic ones may begin before 0.
  std::vector<Rest> rests() const {
    const std::vector<bool> is_still = still();
    std::vector<Rest> found;
    for (int i = 0; i <= kGrid; ++i) {
      if (!is_still[i]) continue;
      int end = i;
      while (end < kGrid && is_still[end + 1]) ++end;
      found.push_back({grid(i), grid(end), 0});
      i = end;
    }
    if (options_.period && found.size() > 1 && is_still[0] && is_still[kGrid]) {
      found.front().begin = found.back().begin - length_;
      found.pop_back();
    }
    join_near(found);
    std::erase_if(found,
                  [&](const Rest& r) { return r.end - r.begin < options_.least_dwell * length_; });
    for (Rest& rest : found) rest.level = level_of(rest);
    return found;
  }

  /// A wave that noise left in a dwell does not part it.
  void join_near(std::vector<Rest>& found) const {
    for (std::size_t i = 0; i + 1 < found.size();) {
      const bool near = found[i + 1].begin - found[i].end < 0.01 * length_;
      const bool level = std::abs(curve_(found[i + 1].begin) - curve_(found[i].end)) < 0.5 * least_;
      if (near && level) {
        found[i].end = found[i + 1].end;
        found.erase(found.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      } else {
        ++i;
      }
    }
  }

  double level_of(const Rest& rest) const {
    const CornerSamples inside = between(rest.begin, rest.end);
    return inside.s.empty() ? curve_(std::midpoint(rest.begin, rest.end)) : optim::median(inside.s);
  }

  /// The samples from `low` to `high`, periodic ones as often as they come.
  CornerSamples between(double low, double high) const {
    CornerSamples result;
    const double turns = options_.period ? std::floor((low - begin_) / length_) : 0;
    for (int turn = 0; turn < (options_.period ? 3 : 1); ++turn) {
      const double shift = (turns + turn) * length_;
      for (std::size_t i = 0; i < samples_.x.size(); ++i) {
        const double x = samples_.x[i] + shift;
        if (x < low || x > high) continue;
        result.x.push_back(x), result.s.push_back(samples_.s[i]);
        result.curve.push_back(samples_.curve[i]);
        result.leverage.push_back(samples_.leverage[i]);
      }
    }
    return result;
  }

  /// The motions from the end of each dwell to the next.
  std::vector<Chain> chains_between(const std::vector<Rest>& rests) const {
    std::vector<Chain> chains;
    if (rests.empty()) {
      Chain whole = chain_without_dwells();
      if (whole.size() > 1) chains.push_back(std::move(whole));
      return chains;
    }
    for (std::size_t i = 0; i + 1 < rests.size(); ++i) {
      chains.push_back(chain(rests[i].end, rests[i + 1].begin, rests[i].level, rests[i + 1].level));
    }
    if (options_.period) {
      const Rest &last = rests.back(), &first = rests.front();
      chains.push_back(chain(last.end, first.begin + length_, last.level, first.level));
    } else {
      if (rests.front().begin > begin_) {
        chains.insert(chains.begin(),
                      chain(begin_, rests.front().begin, curve_(begin_), rests.front().level));
      }
      if (rests.back().end < end_) {
        chains.push_back(chain(rests.back().end, end_, rests.back().level, curve_(end_)));
      }
    }
    std::erase_if(chains, [](const Chain& c) { return c.size() < 2; });
    return chains;
  }

  Chain chain_without_dwells() const {
    if (!options_.period) return chain(begin_, end_, curve_(begin_), curve_(end_));
    double from = begin_;
    for (int i = 0; i < kGrid; ++i) {
      if (curve_(grid(i)) < curve_(from)) from = grid(i);
    }
    return chain(from, from + length_, curve_(from), curve_(from));
  }

  /// Places where the lift turns: it goes back from there by more than what counts as a motion.
  Chain chain(double begin, double end, double from, double to) const {
    Chain nodes{{begin, from}};
    Node high{begin, from}, low{begin, from};
    int direction = 0;
    const auto look = [&](double x, double s) {
      if (s > high.level) high = {x, s};
      if (s < low.level) low = {x, s};
      if (direction >= 0 && s < high.level - least_) {
        if (direction > 0) nodes.push_back(high);
        direction = -1;
        low = {x, s};
      } else if (direction <= 0 && s > low.level + least_) {
        if (direction < 0) nodes.push_back(low);
        direction = 1;
        high = {x, s};
      }
    };
    const int steps = std::max(2, static_cast<int>(kGrid * (end - begin) / length_));
    for (int i = 1; i < steps; ++i) {
      const double x = begin + (end - begin) * i / steps;
      look(x, curve_(x));
    }
    look(end, to);
    if (direction == 0) return {};
    nodes.push_back({end, to});
    return nodes;
  }

  /// Where dwells stand between the chains.
  bool has_dwell_before(const std::vector<Chain>& chains, std::size_t i) const {
    if (i > 0) return true;
    if (!options_.period) return chains[0].front().place > begin_;
    return !is_closed(chains);
  }
  bool has_dwell_after(const std::vector<Chain>& chains, std::size_t i) const {
    if (i + 1 < chains.size()) return true;
    if (!options_.period) return chains.back().back().place < end_;
    return !is_closed(chains);
  }
  /// One chain that goes all the way round.
  bool is_closed(const std::vector<Chain>& chains) const {
    return chains.size() == 1 &&
           chains[0].back().place - chains[0].front().place > (1 - 1e-9) * length_;
  }

  /// All nodes, looked at closely.
  std::vector<Chain> refined(const std::vector<Chain>& rough) const {
    std::vector<Chain> chains = rough;
    for (std::size_t i = 0; i < rough.size(); ++i) {
      for (std::size_t k = 0; k < rough[i].size(); ++k) chains[i][k] = refined(rough, i, k);
      if (is_closed(rough)) {
        const Node& first = chains[0].front();
        chains[0].back() = {first.place + length_, first.level, first.error};
      }
    }
    return chains;
  }

  /// Looks closely at the k-th node of the i-th chain.
  Node refined(const std::vector<Chain>& rough, std::size_t i, std::size_t k) const {
    const Chain& chain = rough[i];
    const std::size_t last = chain.size() - 1;
    const Node& node = chain[k];
    const bool is_edge =
        (k == 0 && !has_dwell_before(rough, i)) || (k == last && !has_dwell_after(rough, i));
    if (is_edge && !is_closed(rough)) return node;  // the samples end in a motion
    const auto length = [&](std::size_t j) { return chain[j + 1].place - chain[j].place; };
    const CornerSides sides{k > 0              ? length(k - 1)
                            : is_closed(rough) ? length(last - 1)
                                               : 0,
                            k < last           ? length(k)
                            : is_closed(rough) ? length(0)
                                               : 0};
    const double from = sides.before > 0 ? node.place - 0.75 * sides.before : dwell_begin(rough, i);
    const double to = sides.after > 0 ? node.place + 0.75 * sides.after : dwell_end(rough, i);
    const double reach = 0.3 * std::max(sides.before, sides.after);
    const Corner corner =
        find_corner(between(from, to), sides, node.place, std::max(from, node.place - reach),
                    std::min(to, node.place + reach), floor_);
    return {corner.place, corner.level, corner.place_error};
  }

  /// What is seen of the dwell before a chain, or after it: the nearer half, if another motion
  /// follows.
  double dwell_begin(const std::vector<Chain>& chains, std::size_t i) const {
    const double here = chains[i].front().place;
    if (i > 0) return std::midpoint(chains[i - 1].back().place, here);
    return options_.period ? std::midpoint(chains.back().back().place - length_, here) : begin_;
  }
  double dwell_end(const std::vector<Chain>& chains, std::size_t i) const {
    const double here = chains[i].back().place;
    if (i + 1 < chains.size()) return std::midpoint(here, chains[i + 1].front().place);
    return options_.period ? std::midpoint(here, chains[0].front().place + length_) : end_;
  }

  /// Whether between these the lift only turns: opposite motions after too short a dwell, or one
  /// that its ends' errors leave open.
  bool is_turn(const Chain& a, const Chain& b, double gap) const {
    const auto rises = [](const Node& from, const Node& to) { return to.level > from.level; };
    const double doubt = 2 * std::hypot(a.back().error, b.front().error);
    return gap < std::max(options_.least_dwell * length_, doubt) &&
           rises(a[a.size() - 2], a.back()) != rises(b[0], b[1]);
  }

  /// A dwell that turns out too short to be one is where the follower turns. Joins one such pair of
  /// rough chains; false where there is none.
  bool join_short_dwell(std::vector<Chain>& rough, const std::vector<Chain>& fine) const {
    const std::size_t n = rough.size();
    for (std::size_t i = 0; i < n; ++i) {
      const bool last = i + 1 == n;
      if (last && (!options_.period || is_closed(rough))) return false;
      const std::size_t next = last ? 0 : i + 1;
      const double turn = last ? length_ : 0;
      if (!is_turn(fine[i], fine[next], fine[next].front().place + turn - fine[i].back().place)) {
        continue;
      }
      Node joint = fine[i].back();
      joint.place = std::midpoint(joint.place, fine[next].front().place + turn);
      rough[i].back() = joint;
      if (n == 1) {
        rough[0].front() = {joint.place - length_, joint.level};
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
  void put_in_order(const std::vector<Chain>& rough, std::vector<Chain>& chains) const {
    const auto before = [](const Node& a, const Node& b) { return a.place < b.place; };
    for (std::size_t i = 0; i < chains.size(); ++i) {
      const Chain& chain = chains[i];
      if (std::adjacent_find(chain.begin(), chain.end(), [&](const Node& a, const Node& b) {
            return !before(a, b);
          }) == chain.end()) {
        continue;
      }
      chains[i] = rough[i];
      const double length = rough[i].back().place - rough[i].front().place;
      for (Node& node : chains[i]) node.error = 0.5 * length;
    }
  }

  /// Where samples begin or end in a motion a dwell there is too short to be one, or its error
  /// leaves it open.
  void drop_short_ends(std::vector<Chain>& chains) const {
    const auto is_short = [&](double dwell, const Node& node) {
      return dwell < std::max(options_.least_dwell * length_, 2 * node.error);
    };
    Node &first = chains.front().front(), &last = chains.back().back();
    if (is_short(first.place - begin_, first)) first = {begin_, curve_(begin_)};
    if (is_short(end_ - last.place, last)) last = {end_, curve_(end_)};
  }

  /// Motions of the chains, with dwells between them.
  std::vector<FoundSegment> segments_of(const std::vector<Chain>& chains) const {
    std::vector<FoundSegment> result;
    const auto dwell = [&](const Node& a, const Node& b) {
      if (!(b.place > a.place)) return;
      const double level = std::midpoint(a.level, b.level);
      result.push_back({SegmentKind::Dwell, a.place, b.place, level, level, a.error, b.error});
    };
    if (!options_.period) dwell({begin_, chains[0][0].level}, chains[0][0]);
    for (std::size_t i = 0; i < chains.size(); ++i) {
      const Chain& chain = chains[i];
      for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
        const Node &a = chain[k], &b = chain[k + 1];
        result.push_back({SegmentKind::Rise, a.place, b.place, a.level, b.level, a.error, b.error});
      }
      const bool last = i + 1 == chains.size();
      Node next = chains[last ? 0 : i + 1].front();
      if (last && !options_.period) next = {end_, chain.back().level};
      if (last && options_.period) next.place += length_;
      dwell(chain.back(), next);
    }
    level_dwells(result);
    return result;
  }

  /// Neighbours of a dwell end where it lies: its samples' mean. What goes down is a return.
  void level_dwells(std::vector<FoundSegment>& segments) const {
    const std::size_t n = segments.size();
    for (std::size_t i = 0; i < n; ++i) {
      FoundSegment& dwell = segments[i];
      if (dwell.kind != SegmentKind::Dwell) continue;
      const CornerSamples inside = between(dwell.begin, dwell.end);
      if (inside.s.size() > 2) {
        dwell.from = std::accumulate(inside.s.begin(), inside.s.end(), 0.0) /
                     static_cast<double>(inside.s.size());
      }
      dwell.to = dwell.from;
      if (i > 0 || options_.period) segments[(i + n - 1) % n].to = dwell.from;
      if (i + 1 < n || options_.period) segments[(i + 1) % n].from = dwell.from;
    }
    for (FoundSegment& segment : segments) {
      if (segment.kind == SegmentKind::Dwell) continue;
      segment.kind = segment.to > segment.from ? SegmentKind::Rise : SegmentKind::Return;
    }
  }

  /// Periodic ones begin within the period that starts at 0.
  std::vector<FoundSegment> in_order(std::vector<FoundSegment> segments) const {
    if (!options_.period) return segments;
    for (FoundSegment& segment : segments) {
      const double turns = std::floor(segment.begin / length_);
      segment.begin -= turns * length_;
      segment.end -= turns * length_;
    }
    std::sort(segments.begin(), segments.end(),
              [](const auto& a, const auto& b) { return a.begin < b.begin; });
    return segments;
  }

  const SegmentOptions& options_;
  CornerSamples samples_;
  double noise_;
  optim::SmoothingSpline curve_;
  double least_ = 0, floor_ = 0, begin_ = 0, end_ = 0, length_ = 0;
};

}  // namespace

std::string to_string(SegmentKind kind) {
  return kind == SegmentKind::Dwell ? "dwell" : kind == SegmentKind::Rise ? "rise" : "return";
}

FoundSegments motion_segments(std::span<const double> phi, std::span<const double> s,
                              const SegmentOptions& options) {
  check(options);
  LiftSamples lift = lift_samples(phi, s, options.period, options.noise, options.least_noise);
  const double noise = lift.sample_noise;
  return {Segmenter(lift, options).run(), noise, std::move(lift.outlying)};
}

}  // namespace camlaw::problems
