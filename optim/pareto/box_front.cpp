// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include "optim/pareto/part_front.h"

/// The sweep of two objectives (docs/optimisation.md, "Boxes").
namespace camlaw::optim {
namespace {

/// What a search has told: no design whose other cost is at most `bound` has less of the cost that
/// was sought than `value`.
struct Fact {
  std::size_t sought;
  double bound, value;
};

/// Between two neighbours: whatever else the front has there lies right of and above the corner.
struct Between {
  const FrontPoint *left, *right;
  Costs corner;

  double far(std::size_t objective) const {
    return (objective == 0 ? *right : *left).costs[objective];
  }
  double width(std::size_t objective) const { return far(objective) - corner[objective]; }
  /// As the front counts differences.
  double width(std::size_t objective, const FrontSoFar& front) const {
    const CostScale& scale = front.scales[objective];
    return scale.place(far(objective)) - scale.place(corner[objective]);
  }
};

class BoxFront final : public PartFront {
 public:
  explicit BoxFront(std::size_t part) : PartFront(part, 2) {}

  /// The other cost's least where one is at its own: the ends of the front.
  std::vector<Task> next_tasks() override {
    std::vector<Task> tasks;
    if (std::exchange(set_up_, true) || !alone_[0] || !alone_[1]) return tasks;
    for (std::size_t i = 0; i < 2; ++i) {
      const double range = std::abs(alone_[1 - i]->costs[i] - alone_[i]->costs[i]);
      if (range <= slack(i)) continue;  // the other end is as good
      Task task = bounded(1 - i, alone_[i]->costs[i] + slack(i));
      task.starts = {alone_[i]->x};
      for (const FrontPoint& point : scouted_near(i, range)) task.starts.push_back(point.x);
      tasks.push_back(std::move(task));
    }
    return tasks;
  }

  void take(const Task& task, const Outcome& outcome) override {
    const std::size_t other = 1 - task.sought;
    const double bound = task.bounds.empty() ? kInfinity : task.bounds[other];
    double value = kInfinity;
    const bool is_beside = is_beside_end(task);
    for (const FrontPoint& point : outcome.points) {
      std::erase_if(facts_, [&](const Fact& fact) { return contradicts(point, fact); });
      if (!is_beside || leaves_end(task, point)) insert(point);
      value = std::min(value, point.costs[task.sought]);
    }
    // A search that came to less than what is known already was stuck.
    for (const FrontPoint& known : points_) {
      if (known.costs[other] <= bound) value = std::min(value, known.costs[task.sought]);
    }
    if (std::isfinite(bound)) facts_.push_back({task.sought, bound, value});
  }

  std::vector<OpenPlace> open(const FrontSoFar& front) const override {
    std::vector<OpenPlace> places;
    for (const Between& between : rooms_between()) {
      if (front.covers(between.corner)) continue;
      const double w = between.width(0, front), h = between.width(1, front);
      constexpr double kClosed = 1e-5;  // of the ranges: ten times what a search is eased by (ease)
      if (!(std::hypot(w, h) > kClosed)) continue;
      // Of equal costs the better end has the rest.
      const bool is_thin =
          !(between.width(0) > front.tolerances[0]) || !(between.width(1) > front.tolerances[1]);
      if (is_thin) continue;
      if (const FrontPoint* rival = find_rival(between, front)) {
        Task task = bounded(1, rival->costs[0]);
        task.starts = {halfway(between.left->x, between.right->x), between.left->x};
        places.push_back({std::hypot(w, h), std::move(task), true});
        continue;
      }
      places.push_back({std::hypot(w, h), split(between, w >= h ? 0 : 1, front)});
    }
    return places;
  }

  std::optional<Task> task_for(const FrontPoint& scouted, const FrontSoFar& front) const override {
    if (front.points.empty()) return {};
    const bool missed = std::any_of(facts_.begin(), facts_.end(), [&](const Fact& fact) {
      return contradicts(scouted, fact) &&
             is_noticed(scouted.costs[fact.sought], fact.value, front.scales[fact.sought]);
    });
    for (std::size_t i = 0; i < 2; ++i) {
      if (is_noticed(scouted.costs[i], least_[i], front.scales[i])) {
        Task task;
        task.part = part_;
        task.sought = i;
        task.starts = {scouted.x};
        return task;
      }
    }
    if (!missed || front.covers(scouted.costs)) return {};
    Task task = bounded(1, scouted.costs[0]);
    task.starts = {scouted.x};
    return task;
  }

  std::vector<Costs> corners() const override {
    std::vector<Costs> result;
    for (const Between& between : rooms_between()) result.push_back(between.corner);
    result.insert(result.end(), left_.begin(), left_.end());
    return result;
  }

 private:
  /// Whether a cost of a scout is less than another by enough to look.
  static bool is_noticed(double scouted, double known, const CostScale& scale) {
    constexpr double kNoticed = 1e-3;  // of the range
    return scouted < known && scale.place(known) - scale.place(scouted) > kNoticed;
  }

  /// Scouted designs near an end that are the best in the other cost: a cost may have several
  /// optima that are equal, from one of which a search does not come to the other.
  std::vector<FrontPoint> scouted_near(std::size_t end, double range) const {
    constexpr double kNear = 0.05;  // of the range
    constexpr std::size_t kMost = 2;
    std::vector<FrontPoint> near;
    for (const FrontPoint& point : scouted_) {
      if (point.costs[end] - alone_[end]->costs[end] <= kNear * range) near.push_back(point);
    }
    std::ranges::stable_sort(near, {}, [&](const FrontPoint& p) { return p.costs[1 - end]; });
    if (near.size() > kMost) near.resize(kMost);
    return near;
  }

  double slack(std::size_t objective) const {
    const double here = alone_[objective]->costs[objective];
    const double range = std::abs(alone_[1 - objective]->costs[objective] - here);
    return ease(here, std::isfinite(range) ? range : sizes_[objective], sizes_[objective]);
  }

  Task bounded(std::size_t sought, double bound) const {
    Task task;
    task.part = part_;
    task.sought = sought;
    task.bounds.assign(2, kInfinity);
    task.bounds[1 - sought] = bound;
    return task;
  }

  /// Halves the room between two neighbours along one cost.
  Task split(const Between& between, std::size_t along, const FrontSoFar& front) const {
    const double middle = front.scales[along].middle(between.corner[along], between.far(along));
    Task task = bounded(1 - along, middle);
    const FrontPoint& inside = along == 0 ? *between.left : *between.right;
    task.starts = {halfway(between.left->x, between.right->x), inside.x};
    return task;
  }

  static bool contradicts(const FrontPoint& point, const Fact& fact) {
    return point.costs[1 - fact.sought] <= fact.bound && point.costs[fact.sought] < fact.value;
  }

  /// Whether a task is for the least of one cost where the other is at its own.
  bool is_beside_end(const Task& task) const {
    const std::size_t end = 1 - task.sought;
    if (task.bounds.empty() || !alone_[end] || !alone_[task.sought]) return false;
    const Costs& at_end = alone_[end]->costs;
    return std::isfinite(at_end[task.sought]) && task.bounds[end] == at_end[end] + slack(end);
  }

  /// An end at which the other cost falls steeply is left for the point beside it, which is better
  /// by a part of the range there, whether that is certified or not. A point that gains less is
  /// none of its own.
  bool leaves_end(const Task& task, const FrontPoint& point) {
    const std::size_t end = 1 - task.sought;
    const Costs at_end = alone_[end]->costs, opposite = alone_[task.sought]->costs;
    const double gain = at_end[task.sought] - point.costs[task.sought];
    if (!(gain > worth(point) * (at_end[task.sought] - opposite[task.sought]))) return false;
    Costs corner = at_end;
    corner[task.sought] = point.costs[task.sought];
    left_.push_back(std::move(corner));
    std::erase_if(points_, [&](const FrontPoint& p) { return p.costs == at_end; });
    return true;
  }

  /// A point of another combination that this one may beat, as far as it has been looked at.
  const FrontPoint* find_rival(const Between& between, const FrontSoFar& front) const {
    const auto same = [&](const FrontPoint& p, std::size_t i) {  // what a search is eased by
      return ease(p.costs[i], front.range[i], front.sizes[i]);
    };
    const auto is_rival = [&](const FrontPoint& p) {
      if (p.part == part_) return false;
      for (std::size_t i = 0; i < 2; ++i) {
        const double room = p.costs[i] - between.corner[i];
        if (!(room > same(p, i)) || !(room < between.width(i))) return false;
      }
      return std::none_of(facts_.begin(), facts_.end(), [&](const Fact& fact) {
        return fact.sought == 1 && std::abs(fact.bound - p.costs[0]) <= same(p, 0);
      });
    };
    const auto at = std::find_if(front.points.begin(), front.points.end(), is_rival);
    return at == front.points.end() ? nullptr : &*at;
  }

  std::vector<Between> rooms_between() const {
    std::vector<Between> result;
    for (std::size_t i = 1; i < points_.size(); ++i) {
      Between between{&points_[i - 1], &points_[i], {points_[i - 1].costs[0], points_[i].costs[1]}};
      for (const Fact& fact : facts_) narrow(between, fact);
      result.push_back(std::move(between));
    }
    return result;
  }

  /// A search in the room between them that came to no less than one of its ends: nothing is on its
  /// side.
  static void narrow(Between& between, const Fact& fact) {
    constexpr double kSame = 1e-6;  // of the width: what a search is eased by (ease)
    const std::size_t along = 1 - fact.sought;
    const FrontPoint& near = along == 0 ? *between.left : *between.right;
    const FrontPoint& far = along == 0 ? *between.right : *between.left;
    if (!(fact.bound > between.corner[along] && fact.bound < far.costs[along])) return;
    const double width = far.costs[fact.sought] - near.costs[fact.sought];
    if (fact.value < near.costs[fact.sought] - kSame * std::abs(width)) return;
    between.corner[along] = fact.bound;
  }

  bool set_up_ = false;
  std::vector<Fact> facts_;
  std::vector<Costs> left_;  ///< beside ends that were left: what there may be between them
};

}  // namespace

std::unique_ptr<PartFront> box_front(std::size_t part) { return std::make_unique<BoxFront>(part); }

}  // namespace camlaw::optim
