// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "optim/pareto/part_front.h"

/// The sweep of three objectives or more (docs/optimisation.md, "Directions").
namespace camlaw::optim {
namespace {

using Edge = std::pair<std::size_t, std::size_t>;

class DirectionFront final : public PartFront {
 public:
  using PartFront::PartFront;

  /// At the optimum of each cost alone the others need not be least: they are sought there, one
  /// after the other. Then the corners of the simplex of directions.
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
      for (std::size_t i = 0; i < objectives_; ++i) {
        std::vector<double> corner(objectives_, 0.0);
        corner[i] = 1;
        tasks.push_back(toward(corner, {alone_[i]->x}));
      }
    }
    return tasks;
  }

  void take(const Task& task, const Outcome& outcome) override {
    if (stage_ > 0 && stage_ < objectives_) {
      move_ends(task, outcome);
      return;
    }
    for (const FrontPoint& point : outcome.points) insert(point);
    if (task.kind != Task::Kind::Toward) {
      challenged_.insert(task.bounds);
      return;
    }
    const std::size_t vertex = vertices_.size();
    vertices_.push_back({asked_.at(task.direction), std::nullopt});
    if (!outcome.points.empty()) vertices_.back().point = outcome.points.front();
    if (vertex < objectives_) {
      if (vertex + 1 == objectives_) add_first_simplex();
      return;
    }
    divide(parents_.at(task.direction), vertex);
  }

  std::vector<OpenPlace> open(const FrontSoFar& front) const override {
    std::map<Edge, double> edges;
    for (const auto& simplex : simplices_) {
      if (const auto edge = first_edge(simplex)) {
        edges.insert({*edge, 1.0});
        continue;
      }
      const auto longest = longest_edge(simplex, front);
      if (longest && !front.covers(corner(simplex))) edges.insert(*longest);
    }
    std::vector<OpenPlace> places = challenges(front);
    for (const auto& [edge, length] : edges) {
      constexpr double kClosed = 1e-4;
      if (length > kClosed) places.push_back({length, halving(edge)});
    }
    return places;
  }

  std::optional<Task> task_for(const FrontPoint& scouted, const FrontSoFar& front) const override {
    constexpr double kNoticed = 1e-3;
    if (!improves(scouted, front, kNoticed)) return {};
    Task task = as_good_as(scouted, part_, 0);
    task.starts = {scouted.x};
    return task;
  }

 private:
  struct Vertex {
    std::vector<double> direction;  ///< not negative, adds up to one
    std::optional<FrontPoint> point;
  };
  using Simplex = std::vector<std::size_t>;  ///< vertices

  /// Whether the scout is better than one of the front in everything, and by enough in something.
  static bool improves(const FrontPoint& scouted, const FrontSoFar& front, double share) {
    return std::any_of(front.points.begin(), front.points.end(), [&](const FrontPoint& p) {
      bool by_enough = false;
      for (std::size_t i = 0; i < p.costs.size(); ++i) {
        if (scouted.costs[i] > p.costs[i]) return false;
        by_enough = by_enough || scouted.costs[i] < p.costs[i] - share * front.range[i];
      }
      return by_enough;
    });
  }

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
      task.starts = {nearest(rival, front).x};
      places.push_back({1, std::move(task), true});
    }
    return places;
  }

  const FrontPoint& nearest(const FrontPoint& point, const FrontSoFar& front) const {
    return *std::min_element(
        points_.begin(), points_.end(), [&](const FrontPoint& a, const FrontPoint& b) {
          return square_of_distance(a, point, front) < square_of_distance(b, point, front);
        });
  }

  /// By the range of each cost.
  static double square_of_distance(const FrontPoint& a, const FrontPoint& b,
                                   const FrontSoFar& front) {
    double sum = 0;
    for (std::size_t i = 0; i < a.costs.size(); ++i) {
      const double step = (a.costs[i] - b.costs[i]) / front.range[i];
      sum += step * step;
    }
    return sum;
  }

  /// How far each cost goes on the front, as far as the ends tell.
  void measure() {
    scale_.clear();
    for (std::size_t i = 0; i < objectives_; ++i) {
      double worst = least_[i];
      for (const auto& point : alone_) {
        if (std::isfinite(point->costs[i])) worst = std::max(worst, point->costs[i]);
      }
      const double range = worst - least_[i];
      scale_.push_back(range > 0 ? range : std::max(std::abs(worst), 1.0));
    }
  }

  /// The least of another cost where one is at its own, which is eased so that there is room.
  Task beside(std::size_t end, std::size_t sought) const {
    Task task = as_good_as(*alone_[end], part_, sought);
    for (std::size_t i = 0; i < objectives_; ++i) task.bounds[i] += ease(task.bounds[i], scale_[i]);
    task.starts = {alone_[end]->x};
    return task;
  }

  /// An end at which another cost falls steeply is left for the point beside it, which is better by
  /// a part of the range there. A point that gains less is none of its own.
  void move_ends(const Task& task, const Outcome& outcome) {
    constexpr double kWorth = 1e-3;
    if (outcome.points.empty()) return;
    const FrontPoint& point = outcome.points.front();
    FrontPoint& end = *alone_[(task.sought + objectives_ - stage_) % objectives_];
    const double gain = end.costs[task.sought] - point.costs[task.sought];
    if (!(gain > kWorth * scale_[task.sought]) || !is_as_sound(point, end)) return;
    std::erase_if(points_, [&](const FrontPoint& p) { return p.costs == end.costs; });
    end = point;
    insert(end);
  }

  Task toward(const std::vector<double>& direction, std::vector<std::vector<double>> starts) const {
    // No cost may be held at its least alone: there are hardly any designs there.
    constexpr double kLeast = 1e-5;
    Task task;
    task.kind = Task::Kind::Toward;
    task.part = part_;
    task.origin = least_;
    for (std::size_t i = 0; i < objectives_; ++i) {
      task.direction.push_back(scale_[i] * std::max(direction[i], kLeast));
    }
    task.starts = std::move(starts);
    asked_[task.direction] = direction;
    return task;
  }

  void add_first_simplex() {
    Simplex all;
    for (std::size_t i = 0; i < objectives_; ++i) all.push_back(i);
    simplices_.push_back(all);
  }

  double length(const Edge& edge, const FrontSoFar& front) const {
    const auto &a = vertices_[edge.first].point, &b = vertices_[edge.second].point;
    return a && b ? std::sqrt(square_of_distance(*a, *b, front)) : 0;
  }

  /// An edge of the simplex that was the first. Each of those is halved, even where its ends have
  /// come to one point: between them others may lie.
  std::optional<Edge> first_edge(const Simplex& simplex) const {
    std::vector<std::size_t> corners;
    for (const std::size_t v : simplex) {
      if (v < objectives_ && vertices_[v].point) corners.push_back(v);
    }
    std::sort(corners.begin(), corners.end());
    if (corners.size() < 2) return {};
    return Edge(corners[0], corners[1]);
  }

  std::optional<std::pair<Edge, double>> longest_edge(const Simplex& simplex,
                                                      const FrontSoFar& front) const {
    std::optional<std::pair<Edge, double>> result;
    for (std::size_t i = 0; i < simplex.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const Edge edge = std::minmax(simplex[i], simplex[k]);
        const double its = length(edge, front);
        if (!result || its > result->second) result = {edge, its};
      }
    }
    return result;
  }

  /// The least of each cost over a simplex's corners.
  Costs corner(const Simplex& simplex) const {
    std::vector<Costs> ends;
    for (const std::size_t v : simplex) {
      if (vertices_[v].point) ends.push_back(vertices_[v].point->costs);
    }
    return ends.empty() ? least_ : ideal(ends);
  }

  Task halving(const Edge& edge) const {
    const Vertex &a = vertices_[edge.first], &b = vertices_[edge.second];
    std::vector<double> middle(objectives_);
    for (std::size_t i = 0; i < objectives_; ++i) {
      middle[i] = (a.direction[i] + b.direction[i]) / 2;
    }
    Task task = toward(middle, {halfway(a.point->x, b.point->x), a.point->x});
    parents_[task.direction] = edge;
    return task;
  }

  /// Every simplex with the edge becomes two.
  void divide(const Edge& edge, std::size_t middle) {
    std::vector<Simplex> result;
    for (const Simplex& simplex : simplices_) {
      const auto has = [&](std::size_t v) {
        return std::find(simplex.begin(), simplex.end(), v) != simplex.end();
      };
      if (!has(edge.first) || !has(edge.second)) {
        result.push_back(simplex);
        continue;
      }
      for (const std::size_t end : {edge.first, edge.second}) {
        Simplex half = simplex;
        std::replace(half.begin(), half.end(), end, middle);
        result.push_back(std::move(half));
      }
    }
    simplices_ = std::move(result);
  }

  std::size_t stage_ = 0;  ///< of setting up; `objectives_`: the corners
  Costs scale_;
  std::set<std::vector<double>> challenged_;  ///< bounds of searches against other combinations
  std::vector<Vertex> vertices_;
  std::vector<Simplex> simplices_;
  // Of each direction that was asked for: where it lies on the simplex, and the edge it halves.
  mutable std::map<std::vector<double>, std::vector<double>> asked_;
  mutable std::map<std::vector<double>, Edge> parents_;
};

}  // namespace

std::unique_ptr<PartFront> direction_front(std::size_t part, std::size_t objectives) {
  return std::make_unique<DirectionFront>(part, objectives);
}

}  // namespace camlaw::optim
