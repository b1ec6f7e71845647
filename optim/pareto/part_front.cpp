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

bool lie_together(const Costs& a, const Costs& b, const Costs& range) {
  constexpr double kTogether = 1e-7;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::abs(a[i] - b[i]) > kTogether * range[i]) return false;
  }
  return true;
}

Costs range_of(const std::vector<Costs>& front) {
  const Costs best = ideal(front), worst = nadir(front);
  Costs range;
  for (std::size_t i = 0; i < best.size(); ++i) {
    const double width = worst[i] - best[i];
    const double size = std::abs(worst[i]) > 0 ? std::abs(worst[i]) : 1;
    range.push_back(width > 0 ? width : size);
  }
  return range;
}

}  // namespace

bool FrontSoFar::covers(const Costs& costs) const {
  return std::any_of(points.begin(), points.end(),
                     [&](const FrontPoint& p) { return none_greater(p.costs, costs); });
}

FrontSoFar front_of(const std::vector<FrontPoint>& points) {
  std::vector<Costs> all;
  for (const FrontPoint& p : points) all.push_back(p.costs);
  const std::vector<bool> kept = non_dominated(all);
  FrontSoFar front;
  std::vector<Costs> left;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!kept[i]) continue;
    front.points.push_back(points[i]);
    left.push_back(points[i].costs);
  }
  if (left.empty()) return front;
  front.ideal = ideal(left);
  front.range = range_of(left);
  std::stable_sort(front.points.begin(), front.points.end(),
                   [](const FrontPoint& a, const FrontPoint& b) { return a.costs < b.costs; });
  std::vector<FrontPoint> apart;
  for (FrontPoint& point : front.points) {
    const auto twin = std::find_if(apart.begin(), apart.end(), [&](const FrontPoint& p) {
      return lie_together(p.costs, point.costs, front.range);
    });
    if (twin == apart.end()) {
      apart.push_back(std::move(point));
    } else if (rank(point) < rank(*twin)) {
      *twin = std::move(point);
    }
  }
  front.points = std::move(apart);
  return front;
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
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    empty_ = empty_ || outcomes[i].infeasible;
    if (outcomes[i].points.empty()) continue;
    const FrontPoint& point = outcomes[i].points.front();
    alone_[i] = point;
    least_[i] = point.costs[i];
    insert(point);
  }
  if (points_.empty()) empty_ = true;
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
