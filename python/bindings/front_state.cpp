// SPDX-License-Identifier: MIT
#include "python/bindings/front_state.h"

namespace camlaw::python {
namespace {

PointState point_state(const optim::FrontPoint& point) {
  std::vector<StandingState> limits;
  for (const optim::Standing& l : point.limits) {
    limits.emplace_back(l.name, l.unit, l.margin, l.angle, l.met, l.proved, l.price);
  }
  return {point.part,   point.x,         point.objectives,
          point.costs,  point.weights,   static_cast<int>(point.verdict),
          point.reason, point.is_global, std::move(limits),
          point.solver};
}

optim::FrontPoint point_of(const PointState& state) {
  const auto& [part, x, objectives, costs, weights, verdict, reason, global, limits, solver] =
      state;
  optim::FrontPoint point{.part = part,
                          .x = x,
                          .objectives = objectives,
                          .costs = costs,
                          .weights = weights,
                          .verdict = static_cast<optim::Verdict>(verdict),
                          .reason = reason,
                          .is_global = global,
                          .limits = {},
                          .solver = solver};
  for (const auto& [name, unit, margin, angle, met, proved, price] : limits) {
    point.limits.push_back({name, unit, margin, angle, met, proved, price});
  }
  return point;
}

}  // namespace

FrontState state_of(const optim::Front& front) {
  std::vector<ObjectiveState> objectives;
  for (const optim::ObjectiveName& o : front.objectives) {
    objectives.emplace_back(o.name, o.unit, static_cast<int>(o.sense), static_cast<int>(o.part));
  }
  std::vector<PointState> points;
  for (const optim::FrontPoint& point : front.points) points.push_back(point_state(point));
  std::vector<FailureState> failures;
  for (const optim::FailedTask& f : front.failures) failures.emplace_back(f.number, f.part, f.why);
  return {std::move(objectives),
          std::move(points),
          {front.ideal, front.nadir, front.reference, front.tolerances, front.sizes},
          {front.hypervolume, front.hypervolume_at_most, front.hypervolume_of_mixtures,
           front.largest_gap},
          {front.parts, front.empty_parts, front.without_end, front.tasks, front.evaluations},
          std::move(failures),
          {front.each_is_global, front.stopped, front.complete, front.ideal_certified},
          front.remark};
}

optim::Front front_of(const FrontState& state) {
  const auto& [objectives, points, costs, sizes, counts, failures, flags, remark] = state;
  optim::Front front;
  for (const auto& [name, unit, sense, part] : objectives) {
    front.objectives.push_back(
        {name, unit, static_cast<optim::Sense>(sense), static_cast<optim::Part>(part)});
  }
  for (const PointState& point : points) front.points.push_back(point_of(point));
  front.ideal = costs.at(0);
  front.nadir = costs.at(1);
  front.reference = costs.at(2);
  front.tolerances = costs.at(3);
  front.sizes = costs.at(4);
  std::tie(front.hypervolume, front.hypervolume_at_most, front.hypervolume_of_mixtures,
           front.largest_gap) = sizes;
  std::tie(front.parts, front.empty_parts, front.without_end, front.tasks, front.evaluations) =
      counts;
  for (const auto& [number, part, why] : failures) front.failures.push_back({number, part, why});
  std::tie(front.each_is_global, front.stopped, front.complete, front.ideal_certified) = flags;
  front.remark = remark;
  return front;
}

}  // namespace camlaw::python
