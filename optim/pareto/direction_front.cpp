// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "optim/pareto/part_front.h"

/// The sweep of three objectives or more (docs/optimisation.md, "Gaps").
namespace camlaw::optim {
namespace {

/// A place that was asked for, and why.
struct AskedPlace {
  double size = 0;
  bool is_beyond = false;
  Costs from;          ///< of a place beyond: the point's costs
  Costs place, range;  ///< costs there, and what they were measured by
};
/// What came of it. `place` is in costs until empty_looks() makes it one by the ranges.
struct HoleLook {
  Costs place;
  double size = 0;
  bool is_beyond = false, failed = false, is_new = false, reached = false;
  Costs from = {}, result = {};
};

/// What is known, in places by the ranges of the front.
struct KnownPlaces {
  std::vector<HoleLook> empty;  ///< searches that tell where nothing is
  std::vector<Costs> looked;    ///< places that were searched from
  std::vector<Costs> points;    ///< of the front
};

/// Where was searched.
std::vector<Costs> places_of(const std::vector<HoleLook>& looks, const FrontSoFar& front) {
  std::vector<Costs> result;
  for (const HoleLook& look : looks) result.push_back(front.place(look.place));
  return result;
}

/// Whether the scout is better than one of the front in everything, and by enough in something.
bool improves(const FrontPoint& scouted, const FrontSoFar& front, double share) {
  return std::any_of(front.points.begin(), front.points.end(), [&](const FrontPoint& p) {
    bool by_enough = false;
    for (std::size_t i = 0; i < p.costs.size(); ++i) {
      if (scouted.costs[i] > p.costs[i]) return false;
      by_enough = by_enough || scouted.costs[i] < p.costs[i] - share * front.range[i];
    }
    return by_enough;
  });
}

/// Whether this very place was: what came of it is not on the front, or all that is about it.
bool was_asked_for(const Hole& hole, const std::vector<Costs>& looked) {
  // A hole's place moves by as much of its size when the front's ranges change.
  constexpr double kSame = 0.05;
  return std::any_of(looked.begin(), looked.end(), [&](const Costs& place) {
    return distance_aside(place, hole.place) <= kSame * hole.size;
  });
}

/// Of the angle between two steps, each without its part along (1, 1, ...).
double cosine_aside(const Costs& a, const Costs& b, const Costs& c, const Costs& d) {
  double first = 0, second = 0, product = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    first += b[i] - a[i];
    second += d[i] - c[i];
    product += (b[i] - a[i]) * (d[i] - c[i]);
  }
  const double lengths = distance_aside(a, b) * distance_aside(c, d);
  return lengths > 0 ? (product - first * second / static_cast<double>(a.size())) / lengths : 0;
}

/// Whether a search beyond the point, or one that led to it, has found nothing in the direction.
bool is_closed(const Hole& hole, const std::vector<HoleLook>& looks, const Costs& point) {
  // A point nearby stands for the one that was searched from, and a direction within 60 degrees
  // leads to the same empty region.
  constexpr double kSame = 0.3, kCosine = 0.5;
  return std::any_of(looks.begin(), looks.end(), [&](const HoleLook& look) {
    if (!look.is_beyond) return false;
    for (const Costs* at : {&look.from, &look.result}) {
      if (at->empty() || distance(*at, point) > kSame * hole.size) continue;
      if (cosine_aside(*at, look.place, point, hole.place) > kCosine) return true;
    }
    return false;
  });
}

/// Searches that tell where nothing is, by the ranges of the front: those that did not reach
/// their place, and those whose point something dominates.
std::vector<HoleLook> empty_looks(const std::vector<HoleLook>& looks, const FrontSoFar& front) {
  std::vector<HoleLook> result;
  const std::vector<Costs> all = front.places();
  for (HoleLook look : looks) {
    look.place = front.place(look.place);
    const bool is_there = look.reached && std::any_of(all.begin(), all.end(), [&](const auto& p) {
                            return distance_aside(p, look.place) <= look.size / 2;
                          });
    if (is_there) continue;
    if (!look.from.empty()) look.from = front.place(look.from);
    if (!look.result.empty()) look.result = front.place(look.result);
    result.push_back(std::move(look));
  }
  return result;
}

/// What a search has told, beside the points that are known: it has reached the place if it came to
/// a point that is new, not far aside from where it was sent.
HoleLook looked(const AskedPlace& asked, const Outcome& outcome,
                const std::vector<FrontPoint>& points) {
  // In units of the hole's size, which is its distance from the nearest point: farther aside a
  // point lies in another hole, and a point nearer than that to a known one fills no hole.
  constexpr double kReached = 0.5, kNew = 0.45;
  HoleLook look{.place = asked.place,
                .size = asked.size,
                .is_beyond = asked.is_beyond,
                .failed = outcome.points.empty() && !outcome.infeasible,
                .from = asked.from};
  if (outcome.points.empty()) return look;
  look.result = outcome.points.front().costs;
  const auto place = [&](const Costs& costs) {
    Costs result;
    for (std::size_t i = 0; i < costs.size(); ++i) {
      result.push_back((costs[i] - asked.place[i]) / asked.range[i]);
    }
    return result;
  };
  const Costs there = place(look.result);
  look.is_new = std::none_of(points.begin(), points.end(), [&](const FrontPoint& p) {
    return distance(place(p.costs), there) < kNew * asked.size;
  });
  const double aside = distance_aside(there, Costs(there.size(), 0.0));
  look.reached = look.is_new && aside <= kReached * asked.size;
  return look;
}

class DirectionFront final : public PartFront {
 public:
  using PartFront::PartFront;

  /// At the optimum of each cost alone the others need not be least: they are sought there, one
  /// after the other. Then the compromise of all costs but one, for each.
  std::vector<Task> next_tasks() override {
    std::vector<Task> tasks;
    if (std::any_of(alone_.begin(), alone_.end(), [](const auto& p) { return !p; })) return tasks;
    if (stage_ == 0) measure();
    ++stage_;
    if (stage_ < objectives_) {
      for (std::size_t i = 0; i < objectives_; ++i) {
        tasks.push_back(beside(i, (i + stage_) % objectives_));
      }
    } else if (stage_ == objectives_) {
      measure();
      for (std::size_t i = 0; i < objectives_; ++i) tasks.push_back(compromise_without(i));
    }
    return tasks;
  }

  void take(const Task& task, const Outcome& outcome) override {
    if (const auto end = beside_.find(task.bounds); end != beside_.end()) {
      move_end(end->second, task, outcome);
      return;
    }
    if (task.kind != Task::Kind::Toward) {
      challenged_.insert(task.bounds);
    } else if (const auto asked = asked_.find(task.origin); asked != asked_.end()) {
      looks_.push_back(looked(asked->second, outcome, points_));
      beyond_.tried += looks_.back().is_beyond;
      beyond_.found += looks_.back().is_beyond && looks_.back().is_new;
    }
    for (const FrontPoint& point : outcome.points) insert(point);
  }

  std::vector<OpenPlace> open(const FrontSoFar& front) const override {
    std::vector<OpenPlace> places = challenges(front);
    if (!has_ends() || front.points.empty()) return places;
    const KnownPlaces known{empty_looks(looks_, front), places_of(looks_, front), front.places()};
    for (const Hole& hole : front.holes) {
      const bool is_mine = std::any_of(hole.about.begin(), hole.about.end(), [&](std::size_t p) {
        return front.points[p].part == part_;
      });
      if (is_mine) add(places, hole, known, front);
    }
    for (const FrontPoint& scouted : scouted_) {
      if (front.covers(scouted.costs)) continue;
      Hole hole{front.place(scouted.costs), kInfinity, {}, false};
      for (const Costs& place : known.points) {
        hole.size = std::min(hole.size, distance_aside(hole.place, place));
      }
      add(places, hole, known, front);
      if (!places.empty() && places.back().place == hole.place) {
        places.back().task.starts = {scouted.x};
      }
    }
    return places;
  }

  std::optional<Task> task_for(const FrontPoint& scouted, const FrontSoFar& front) const override {
    constexpr double kNoticed = 1e-3;  // of the range, as where two costs are swept by boxes
    if (!improves(scouted, front, kNoticed)) return {};
    Task task = as_good_as(scouted, part_, 0);
    task.starts = {scouted.x};
    return task;
  }

  Beyond beyond() const override { return beyond_; }

  bool is_known_empty(const Costs& place, double within, const FrontSoFar& front) const override {
    for (const HoleLook& look : empty_looks(looks_, front)) {
      if (!look.failed && distance_aside(place, look.place) <= within) return true;
    }
    return false;
  }

 private:
  /// Searches for what beats points of other combinations.
  std::vector<OpenPlace> challenges(const FrontSoFar& front) const {
    std::vector<OpenPlace> places;
    for (const FrontPoint& rival : front.points) {
      if (rival.part == part_ || points_.empty()) continue;
      bool reachable = true;
      for (std::size_t i = 0; i < objectives_; ++i) {
        reachable = reachable && std::isfinite(least_[i]) && least_[i] < rival.costs[i];
      }
      Task task = as_good_as(rival, part_, objectives_ - 1);
      if (!reachable || challenged_.count(task.bounds) > 0) continue;
      task.starts = {nearest(front.place(rival.costs), front).x};
      places.push_back({1, std::move(task), true, {}, false});
    }
    return places;
  }

  const FrontPoint& nearest(const Costs& place, const FrontSoFar& front) const {
    const FrontPoint* best = &points_.front();
    double least = kInfinity;
    for (const FrontPoint& p : points_) {
      double its = 0;  // square of the distance
      for (std::size_t i = 0; i < place.size(); ++i) {
        const double step = (p.costs[i] - front.ideal[i]) / front.range[i] - place[i];
        its += step * step;
      }
      if (its < least) best = &p;
      least = std::min(least, its);
    }
    return *best;
  }

  /// How far each cost goes on the front, as far as the ends tell.
  void measure() {
    scale_.clear();
    for (std::size_t i = 0; i < objectives_; ++i) {
      double worst = least_[i];
      for (const auto& point : alone_) {
        if (std::isfinite(point->costs[i])) worst = std::max(worst, point->costs[i]);
      }
      // Where the ends have the same of a cost, it may vary between them.
      const double range = worst - least_[i];
      scale_.push_back(range > tolerances_[i] ? range : std::max(std::abs(worst), 1.0));
    }
  }

  /// The least of another cost where one is at its own, which is eased so that there is room.
  Task beside(std::size_t end, std::size_t sought) {
    Task task = as_good_as(*alone_[end], part_, sought);
    // Sizes: only a range that another end makes greater than the ends of most fronts is none.
    constexpr double kMost = 10;
    for (std::size_t i = 0; i < objectives_; ++i) {
      task.bounds[i] += ease(task.bounds[i], scale_[i], kMost * sizes_[i]);
    }
    task.starts = {alone_[end]->x};
    beside_[task.bounds] = end;
    return task;
  }

  /// An end at which another cost falls steeply is left for the point beside it, which is better by
  /// a part of the range there, whether that is certified or not. A point that gains less is none
  /// of its own.
  void move_end(std::size_t which, const Task& task, const Outcome& outcome) {
    FrontPoint& end = *alone_[which];
    if (!outcome.points.empty()) {
      const FrontPoint& point = outcome.points.front();
      const double gain = end.costs[task.sought] - point.costs[task.sought];
      if (gain > worth(point) * scale_[task.sought]) {
        if (point.verdict != Verdict::Certified) doubtful_.insert(which);
        std::erase_if(points_, [&](const FrontPoint& p) { return p.costs == end.costs; });
        end = point;
        insert(end);
      }
    }
    if (doubtful_.count(which) > 0) doubt(end.costs);
  }

  Task toward(Costs origin, Costs direction, std::vector<std::vector<double>> starts) const {
    Task task;
    task.kind = Task::Kind::Toward;
    task.part = part_;
    task.origin = std::move(origin);
    task.direction = std::move(direction);
    task.starts = std::move(starts);
    return task;
  }

  /// Where all costs but one are as near to their least as can be, by their ranges.
  Task compromise_without(std::size_t i) const {
    constexpr double kFar = 1e3;  // ranges: no cost on the front is there
    Costs origin = least_;
    origin[i] += kFar * scale_[i];
    return toward(std::move(origin), scale_, {alone_[(i + 1) % objectives_]->x});
  }

  /// A hole becomes a place to look at, as far as no search was near it.
  void add(std::vector<OpenPlace>& places, const Hole& hole, const KnownPlaces& known,
           const FrontSoFar& front) const {
    // In ranges: points of any front that can be shown lie farther apart.
    constexpr double kClosed = 1e-4;
    if (hole.is_beyond && is_closed(hole, known.empty, known.points[hole.about.front()])) return;
    double size = hole.size;
    for (const HoleLook& look : known.empty) {
      size = std::min(size, distance_aside(hole.place, look.place));
    }
    if (!(size > kClosed) || was_asked_for(hole, known.looked)) return;
    const bool is_one = std::any_of(hole.about.begin(), hole.about.end(), [&](std::size_t p) {
      return front.are_equal(known.points[p], hole.place);
    });
    if (is_one) return;
    Task task = search_from(front.costs_at(hole.place), front);
    task.starts = starts_about(hole, front);
    asked_[task.origin] = {hole.is_beyond ? hole.size : size, hole.is_beyond,
                           hole.is_beyond ? front.points[hole.about.front()].costs : Costs{},
                           front.costs_at(hole.place), front.range};
    places.push_back({size, std::move(task), false, hole.place, hole.is_beyond});
  }

  /// All costs by their ranges; one that does not vary is held within its tolerance.
  Task search_from(Costs origin, const FrontSoFar& front) const {
    constexpr double kRoom = 2, kLeast = 1e-9;  // tolerances; of the size
    Costs direction = front.range;
    for (std::size_t i = 0; i < objectives_; ++i) {
      if (front.varies(i)) continue;
      direction[i] = std::max(front.tolerances[i], kLeast * front.range[i]);
      origin[i] = front.nadir[i] + kRoom * direction[i];
    }
    return toward(std::move(origin), std::move(direction), {});
  }

  /// The mean of the designs that a hole lies between, and the nearest design.
  std::vector<std::vector<double>> starts_about(const Hole& hole, const FrontSoFar& front) const {
    const FrontPoint& near = nearest(hole.place, front);
    std::vector<double> mean(near.x.size(), 0.0);
    std::size_t count = 0;
    for (const std::size_t p : hole.about) {
      if (front.points[p].part != part_) continue;
      ++count;
      for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += front.points[p].x[i];
    }
    if (count < 2) return {near.x};
    for (double& m : mean) m /= static_cast<double>(count);
    return {std::move(mean), near.x};
  }

  std::size_t stage_ = 0;  ///< of setting up; `objectives_`: the compromises
  Costs scale_;
  std::map<std::vector<double>, std::size_t> beside_;  ///< by bounds: searches beside which end
  std::set<std::size_t> doubtful_;            ///< ends that a search moved without a certificate
  std::set<std::vector<double>> challenged_;  ///< bounds of searches against other combinations
  std::vector<HoleLook> looks_;
  Beyond beyond_;
  mutable std::map<Costs, AskedPlace> asked_;  ///< by the origin of the task
};

}  // namespace

std::unique_ptr<PartFront> direction_front(std::size_t part, std::size_t objectives) {
  return std::make_unique<DirectionFront>(part, objectives);
}

}  // namespace camlaw::optim
