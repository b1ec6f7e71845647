// SPDX-License-Identifier: MIT
#include "output/answers/law_json.h"

#include "kinematics/limits.h"
#include "kinematics/shape.h"

namespace camlaw::cli {

namespace {

Json parameters_to_json(const Member& member) {
  Json result = Json::array();
  for (std::size_t i = 0; i < member.family->parameters.size(); ++i) {
    const Parameter& p = member.family->parameters[i];
    const auto& values = member.arguments.list(i);
    result.push_back(
        {{"name", p.name},
         {"unit", p.unit},
         {"low", to_json(p.low)},
         {"high", to_json(p.high)},
         {"default", p.list ? to_json(p.default_value) : to_json(p.default_value.front())},
         {"value", p.list ? to_json(values) : to_json(values.front())},
         {"list", p.list},
         {"meaning", p.meaning}});
  }
  return result;
}

Json place(const Peak<double>& peak) { return to_json(peak.position); }

void add_constants(Json& object, const Peaks<double>& peak) {
  const auto lambda = limit_index(peak);
  object["C_v"] = to_json(peak.max_velocity());
  object["C_a_max"] = to_json(peak.high(Quantity::Acceleration).value);
  object["C_a_min"] = to_json(peak.low(Quantity::Acceleration).value);
  object["C_j_max"] = to_json(peak.high(Quantity::Jerk).value);
  object["C_j_min"] = to_json(peak.low(Quantity::Jerk).value);
  object["C_Mdyn"] = to_json(peak.max_dynamic_moment());
  object["lambda"] = lambda ? to_json(*lambda) : Json(nullptr);
  object["C_j_inside_max"] = to_json(peak.jerk_inside_highest.value);
  object["C_j_inside_min"] = to_json(peak.jerk_inside_lowest.value);
  object["positions"] = {{"C_v", place(peak.absolute(Quantity::Velocity))},
                         {"C_a_max", place(peak.high(Quantity::Acceleration))},
                         {"C_a_min", place(peak.low(Quantity::Acceleration))},
                         {"C_j_max", place(peak.high(Quantity::Jerk))},
                         {"C_j_min", place(peak.low(Quantity::Jerk))},
                         {"C_Mdyn", place(peak.absolute(Quantity::Moment))}};
}

}  // namespace

Json law_to_json(const Member& member) {
  const Law<double> law = member.law();
  Json object{{"name", member.family->name},
              {"member", member.name()},
              {"aliases", member.family->aliases},
              {"formula", member.family->formula},
              {"parameters", parameters_to_json(member)}};
  add_constants(object, peaks(law));
  object["ends"] = to_string(law.ends());
  const int smooth = continuity(law);
  object["continuity"] = smooth == kSmooth ? Json("smooth") : Json(smooth);
  object["symmetric"] = is_symmetric(law);
  object["data"] = law.is_data();
  object["source"] = member.family->source;
  return object;
}

Json enclosures_to_json(const Peaks<Interval>& peak) {
  const auto both = [](const Interval& x) { return Json{to_json(x.lower()), to_json(x.upper())}; };
  return {{"C_v", both(peak.max_velocity())},
          {"C_a_max", both(peak.high(Quantity::Acceleration).value)},
          {"C_a_min", both(peak.low(Quantity::Acceleration).value)},
          {"C_j_max", both(peak.high(Quantity::Jerk).value)},
          {"C_j_min", both(peak.low(Quantity::Jerk).value)},
          {"C_Mdyn", both(peak.max_dynamic_moment())}};
}

}  // namespace camlaw::cli
