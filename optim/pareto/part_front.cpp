// SPDX-License-Identifier: MIT
#include "optim/pareto/part_front.h"

#include <algorithm>
#include <cmath>

#include "optim/pareto/dominance.h"

namespace camlaw::optim {
namespace {

bool none_greater(const Costs& a, const Costs& b) {
  return std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) { return x <= y; });
}

/// Smaller is better.
int rank(const FrontPoint& point) {
  if (point.verdict == Verdict::Certified) return point.is_global ? 0 : 1;
  return 2;
}

bool lie_together(const Costs& a, const Costs& b, const FrontSoFar& front) {
  constexpr double kTogether = 1e-7;  // of the range: as near as an optimum is known (SC3)
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double same = std::max(kTogether * front.range[i], front.tolerances[i]);
    if (std::abs(a[i] - b[i]) > same) return false;
  }
  return true;
}

/// Of points that lie together one, the soundest.
std::vector<FrontPoint> apart(std::vector<FrontPoint> points, const FrontSoFar& front) {
  const auto sooner = [](const FrontPoint& a, const FrontPoint& b) { return a.costs < b.costs; };
  std::stable_sort(points.begin(), points.end(), [&](const FrontPoint& a, const FrontPoint& b) {
    return rank(a) < rank(b) || (rank(a) == rank(b) && sooner(a, b));
  });
  std::vector<FrontPoint> result;
  for (FrontPoint& point : points) {
    const bool has_twin = std::any_of(result.begin(), result.end(), [&](const FrontPoint& p) {
      return lie_together(p.costs, point.costs, front);
    });
    if (!has_twin) result.push_back(std::move(point));
  }
  std::stable_sort(result.begin(), result.end(), sooner);
  return result;
}

}  // namespace

bool FrontSoFar::covers(const Costs& costs) const {
  for (const FrontPoint& p : points) {  // by the first cost
    if (p.costs[0] > costs[0] + tolerances[0]) return false;
    bool is_as_good = true;
    for (std::size_t i = 0; i < costs.size() && is_as_good; ++i) {
      is_as_good = p.costs[i] <= costs[i] + tolerances[i];
    }
    if (is_as_good) return true;
  }
  return false;
}

Costs FrontSoFar::place(const Costs& costs) const {
  Costs result;
  for (std::size_t i = 0; i < costs.size(); ++i) result.push_back((costs[i] - ideal[i]) / range[i]);
  return result;
}

Costs FrontSoFar::costs_at(const Costs& place) const {
  Costs result;
  for (std::size_t i = 0; i < place.size(); ++i) result.push_back(ideal[i] + place[i] * range[i]);
  return result;
}

std::vector<Costs> FrontSoFar::places() const {
  std::vector<Costs> result;
  for (const FrontPoint& p : points) result.push_back(place(p.costs));
  return result;
}

bool FrontSoFar::varies(std::size_t cost) const {
  return nadir[cost] - ideal[cost] > tolerances[cost];
}

bool FrontSoFar::are_equal(const Costs& place, const Costs& other) const {
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (std::abs(place[i] - other[i]) * range[i] > tolerances[i]) return false;
  }
  return true;
}

FrontSoFar front_of(const std::vector<FrontPoint>& points, const Costs& tolerances,
                    const Costs& sizes) {
  constexpr double kRounding = 1e-9;  // where no tolerance is known, rounding makes costs differ
  const std::vector<bool> kept = non_dominated(costs_of(points), kRounding, tolerances);
  FrontSoFar front;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (kept[i]) front.points.push_back(points[i]);
  }
  if (front.points.empty()) return front;
  const std::vector<Costs> left = costs_of(front.points);
  front.ideal = ideal(left);
  front.nadir = nadir(left);
  front.range = ranges(left, tolerances);
  front.tolerances = tolerances;
  front.tolerances.resize(front.ideal.size(), 0.0);
  front.sizes = sizes;
  front.sizes.resize(front.ideal.size(), 0.0);
  if (front.ideal.size() == 2) front.scales = cost_scales(left, tolerances, sizes);
  front.points = apart(std::move(front.points), front);
  return front;
}

double measure_of(double range, double size) { return size > 0 ? std::min(range, size) : range; }

double ease(double cost, double range, double size) {
  // Searches miss a limit by less than kShare, so that the known point stays possible. Of a cost
  // whose range is small beside its value, solvers tell no more than kTold.
  constexpr double kShare = 1e-6, kTold = 1e-8;
  return std::max(kShare * measure_of(range, size), kTold * std::abs(cost));
}

FrontPoint doubted(FrontPoint point) {
  if (point.verdict != Verdict::Certified) return point;
  point.verdict = Verdict::Feasible;
  point.is_global = false;
  point.reason =
      "every limit is met and the conditions of optimality hold, but not for all objectives: the "
      "search for the best of another one among designs as good as this was not certified";
  return point;
}

double worth(const FrontPoint& beside_end) {
  // Of the range: what is certified is given up only for a clear gain.
  constexpr double kCertified = 1e-3, kElse = 1e-2;
  return beside_end.verdict == Verdict::Certified ? kCertified : kElse;
}

std::vector<double> halfway(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = a[i] + (b[i] - a[i]) / 2;
  return result;
}

std::vector<Task> PartFront::first_tasks(
    const std::vector<std::vector<double>>& starts_of_each) const {
  std::vector<Task> tasks;
  for (std::size_t i = 0; i < objectives_; ++i) {
    Task task;
    task.part = part_;
    task.sought = i;
    if (i < starts_of_each.size()) task.starts = {starts_of_each[i]};
    tasks.push_back(std::move(task));
  }
  return tasks;
}

void PartFront::take_first(const std::vector<Outcome>& outcomes) {
  least_.assign(objectives_, -kInfinity);
  alone_.resize(objectives_);
  for (std::size_t i = 0; i < outcomes.size(); ++i) take_alone(i, outcomes[i]);
  empty_ = std::none_of(alone_.begin(), alone_.end(), [](const auto& p) { return p.has_value(); });
}

void PartFront::take_alone(std::size_t objective, const Outcome& outcome) {
  if (outcome.points.empty()) return;
  const FrontPoint& point = outcome.points.front();
  alone_[objective] = point;
  least_[objective] = point.costs[objective];
  insert(point);
}

std::vector<Task> PartFront::repeated_tasks() const {
  std::vector<Task> tasks;
  const auto found =
      std::find_if(alone_.begin(), alone_.end(), [](const auto& p) { return p.has_value(); });
  if (found == alone_.end()) return tasks;
  for (std::size_t i = 0; i < objectives_; ++i) {
    if (alone_[i]) continue;
    Task task;
    task.part = part_;
    task.sought = i;
    task.starts = {(*found)->x};
    tasks.push_back(std::move(task));
  }
  return tasks;
}

void PartFront::take_repeated(const Task& task, const Outcome& outcome) {
  take_alone(task.sought, outcome);
}

bool PartFront::has_ends() const {
  return std::all_of(alone_.begin(), alone_.end(), [](const auto& p) { return p.has_value(); });
}

void PartFront::doubt(const Costs& costs) {
  for (FrontPoint& point : points_) {
    if (point.costs == costs) point = doubted(std::move(point));
  }
}

void PartFront::insert(const FrontPoint& point) {
  if (!std::all_of(point.costs.begin(), point.costs.end(),
                   [](double c) { return std::isfinite(c); })) {
    return;
  }
  const auto as_good = std::find_if(points_.begin(), points_.end(), [&](const FrontPoint& p) {
    return none_greater(p.costs, point.costs);
  });
  if (as_good != points_.end()) {
    if (as_good->costs == point.costs && rank(point) < rank(*as_good)) *as_good = point;
    return;
  }
  std::erase_if(points_, [&](const FrontPoint& p) { return none_greater(point.costs, p.costs); });
  const auto after = std::find_if(points_.begin(), points_.end(),
                                  [&](const FrontPoint& p) { return point.costs < p.costs; });
  points_.insert(after, point);
}

}  // namespace camlaw::optim
