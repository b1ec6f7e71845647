// SPDX-License-Identifier: MIT
#include <cmath>

#include "output/answers/front_output.h"
#include "output/answers/warnings.h"

namespace camlaw::cli {
namespace {

using optim::Front;
using optim::FrontPoint;

Json costs_json(const FrontAnswer& answer, const optim::Costs& costs) {
  Json result = Json::array();
  for (std::size_t i = 0; i < costs.size(); ++i) {
    result.push_back(to_json(answer.value(i, costs[i])));
  }
  return result;
}

Json point_object(const FrontAnswer& answer, std::size_t k) {
  const FrontPoint& point = answer.front.points[k];
  Json objectives = Json::object(), variables = Json::object(), slopes = Json::array();
  for (std::size_t i = 0; i < point.objectives.size(); ++i) {
    objectives[answer.front.objectives[i].name] = to_json(point.objectives[i]);
  }
  for (const auto& value : answer.values(point)) {
    variables[value.name] = std::isnan(value.number) ? Json(value.text) : to_json(value.number);
  }
  for (std::size_t i = 1; i < point.objectives.size(); ++i) {
    slopes.push_back({{"of", answer.front.objectives[i].name},
                      {"per", answer.front.objectives[0].name},
                      {"value", to_json(answer.front.slope(point, i, 0))}});
  }
  const auto law = answer.study.law(point);
  Json limits = Json::array();
  for (const optim::Standing& limit : point.limits) {
    limits.push_back({{"name", limit.name},
                      {"margin", to_json(limit.margin)},
                      {"unit", limit.unit},
                      {"worst_angle", limit.angle ? to_json(*limit.angle) : Json(nullptr)},
                      {"met", limit.met},
                      {"proved", limit.proved},
                      {"price", to_json(answer.front.price(point, limit))}});
  }
  return {{"objectives", std::move(objectives)},
          {"variables", std::move(variables)},
          {"law", law ? Json(law->name()) : Json(nullptr)},
          {"verdict", to_string(point.verdict)},
          {"reason", point.reason},
          {"global", point.is_global},
          {"slopes", std::move(slopes)},
          {"limits", std::move(limits)},
          {"lambda",
           answer.ruler ? to_json(answer.ruler->limit_index(point.objectives)) : Json(nullptr)},
          {"solver", point.solver}};
}

Json next_json(const FrontAnswer& answer, std::size_t point) {
  constexpr double kTenth = 0.1;
  Json next = Json::array();
  const auto all = answer.costs();
  for (std::size_t i = 0; i < 2 && answer.front.objectives.size() == 2; ++i) {
    const auto other = optim::cost_of_next(all, point, i, kTenth);
    next.push_back({{"better", answer.front.objectives[i].name},
                    {"by", kTenth},
                    {"other", answer.front.objectives[1 - i].name},
                    {"value", other ? to_json(answer.value(1 - i, *other)) : Json(nullptr)}});
  }
  return next;
}

Json record_json(const FrontAnswer& answer) {
  Json faults = Json::array();
  for (const optim::RecordFault& fault : answer.faults) {
    faults.push_back({{"task", fault.task},
                      {"what", fault.is_damaged ? "damaged" : "wrong"},
                      {"why", fault.is_damaged ? Json(nullptr) : Json(fault.why)}});
  }
  return {{"faults", std::move(faults)}, {"notes", answer.notes}};
}

}  // namespace

Json front_json(const FrontAnswer& answer) {
  const Front& front = answer.front;
  Json objectives = Json::array(), points = Json::array(), failures = Json::array();
  for (std::size_t i = 0; i < front.objectives.size(); ++i) {
    const auto& o = front.objectives[i];
    objectives.push_back({{"name", o.name},
                          {"unit", o.unit},
                          {"sense", o.sense == optim::Sense::Minimize ? "minimize" : "maximize"},
                          {"tolerance", i < front.tolerances.size() ? to_json(front.tolerances[i])
                                                                    : Json(nullptr)}});
  }
  for (std::size_t k = 0; k < front.points.size(); ++k) points.push_back(point_object(answer, k));
  for (const optim::FailedTask& failed : front.failures) {
    failures.push_back({{"search", failed.number + 1}, {"why", failed.why}});
  }
  const auto all = answer.costs();
  const auto knee = optim::knee(all, answer.front.tolerances);
  Json knee_object(nullptr);
  if (knee) {
    knee_object = {{"point", knee->point},
                   {"factor_low", to_json(knee->low)},
                   {"factor_high", to_json(knee->high)},
                   {"next", next_json(answer, knee->point)}};
  }
  const auto& limit = answer.ruler;
  return {{"title", answer.study.bound().statement().title},
          {"objectives", std::move(objectives)},
          {"points", std::move(points)},
          {"ideal", costs_json(answer, front.ideal)},
          {"nadir", costs_json(answer, front.nadir)},
          {"reference", costs_json(answer, front.reference)},
          {"hypervolume", to_json(front.hypervolume)},
          {"hypervolume_at_most",
           front.hypervolume_at_most ? to_json(*front.hypervolume_at_most) : Json(nullptr)},
          {"hypervolume_at_most_proved", front.hypervolume_at_most && front.each_is_global},
          {"hypervolume_of_mixtures",
           front.hypervolume_of_mixtures ? to_json(*front.hypervolume_of_mixtures) : Json(nullptr)},
          {"limit_hypervolume", limit && !front.reference.empty()
                                    ? to_json(limit->hypervolume(front.reference))
                                    : Json(nullptr)},
          {"knee", std::move(knee_object)},
          {"complete", front.complete},
          {"finished", !front.stopped},
          {"largest_gap", front.largest_gap ? to_json(*front.largest_gap) : Json(nullptr)},
          {"warnings", answer.warnings},
          {"record", record_json(answer)},
          {"searches", front.tasks},
          {"evaluations", front.evaluations},
          {"combinations", front.parts},
          {"empty_combinations", front.empty_parts},
          {"combinations_without_end", front.without_end},
          {"failures", std::move(failures)},
          {"seed", answer.study.options().seed}};
}

Json point_json(const FrontAnswer& answer, std::size_t k) {
  Json object = point_object(answer, k);
  object["point"] = k;
  object["next"] = next_json(answer, k);
  object["warnings"] = warnings_of(answer.study.design(answer.front.points[k]));
  return object;
}

}  // namespace camlaw::cli
