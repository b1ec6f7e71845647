// SPDX-License-Identifier: MIT
#include "machines/cams/elastic_contact.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "machines/cams/cam_curve.h"
#include "machines/model/recorded_response.h"
#include "machines/model/shaft_curve.h"
#include "numerics/formula/expression.h"

namespace camlaw::problems {
namespace {

using Parameters = std::vector<MechanismParameter>;

/// What a formula of the elastic contact holds, behind the angle.
enum Held : std::size_t { kAngle, kPlace, kVelocity, kAcceleration, kForce };

/// s, v or a of the program, as a curve of the machine.
HeldCurve of_motion(std::size_t which, const Parameters& parameters) {
  MechanismResponse motion;
  motion.name = kPlaceNames[which];
  motion.unit = "1";
  motion.write = [which](std::span<const Expression>, std::span<const Expression> place) {
    return place[which];
  };
  HeldCurve held;
  held.response = std::make_shared<const MechanismResponse>(
      recorded_curve(std::move(motion), parameters, turn_of_the_cam()));
  return held;
}

std::optional<std::size_t> index_of(const Parameters& parameters, const std::string& name) {
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const MechanismParameter& p) { return p.name == name; });
  if (found == parameters.end()) return {};
  return static_cast<std::size_t>(found - parameters.begin());
}

/// The formula of a rigid machine where a force is given: nothing moves but for that load.
Write under_force(const Write& rigid, const Parameters& parameters) {
  std::vector<std::size_t> none;
  for (const char* const name : {"mass", "inertia", "spring_rate", "spring_preload"}) {
    if (const auto i = index_of(parameters, name)) none.push_back(*i);
  }
  const auto own = index_of(parameters, "load");
  const auto load = own ? own : index_of(parameters, "load_torque");  // of a turret
  return [=](std::span<const Expression> machine, std::span<const Expression> held) {
    std::vector<Expression> all(machine.begin(), machine.end());
    for (const std::size_t i : none) all[i] = 0;
    all[*load] = held[kForce];
    const Expression jerk = kNaN;  // no force follows it
    const Expression turn = 2 * pi();
    const std::array place{held[kPlace], held[kVelocity], held[kAcceleration], jerk,
                           held[kAngle] / turn};
    return rigid(all, place);
  };
}

/// (U20)
MechanismResponse with_train(const MechanismResponse& rigid, const MechanismResponse& elastic,
                             const Parameters& parameters) {
  MechanismResponse result;
  result.name = "elastic_" + rigid.name;
  result.unit = rigid.unit;
  result.meaning = rigid.meaning + ", with the elastic train";
  result.possible_by = rigid.possible_by;
  result.is_possible = rigid.is_possible;
  result.defined_while = rigid.defined_while;
  for (ValidityLimit& limit : result.defined_while) {
    if (limit.response == "contact_force") limit.response = elastic.name;
  }
  for (const std::size_t which : {0, 1, 2}) result.held.push_back(of_motion(which, parameters));
  HeldCurve force;
  force.response = std::make_shared<const MechanismResponse>(elastic);
  result.held.push_back(std::move(force));
  result.write = under_force(rigid.write, parameters);
  return shaft_curve_response(std::move(result), parameters);
}

const MechanismResponse* named(const std::vector<MechanismResponse>& responses,
                               const std::string& name) {
  const auto found = std::find_if(responses.begin(), responses.end(),
                                  [&](const auto& response) { return response.name == name; });
  return found == responses.end() ? nullptr : &*found;
}

/// The force that the cam must give to the elastic follower; null without a train.
const MechanismResponse* elastic_load(const Mechanism& mechanism) {
  for (const char* const name : {"elastic_force", "elastic_torque"}) {
    if (const auto* found = named(mechanism.responses, name)) return found;
  }
  return nullptr;
}

/// Whether the masses decide a check: such a one needs the speed.
bool is_of_forces(const BuildableCheck& check) {
  return std::find(check.needs.begin(), check.needs.end(), "speed") != check.needs.end();
}

}  // namespace

void add_elastic_checks(Mechanism& mechanism) {
  const MechanismResponse* found = elastic_load(mechanism);
  if (found == nullptr) return;
  const MechanismResponse elastic = *found;
  std::vector<BuildableCheck> all;
  for (const BuildableCheck& rigid : mechanism.checks) {
    all.push_back(rigid);
    if (!is_of_forces(rigid)) continue;
    all.back().only_without = kTrainStiffness;
    BuildableCheck own = rigid;
    own.only_with = kTrainStiffness;
    own.needs.emplace_back(kTrainStiffness);
    const bool is_force = rigid.response.starts_with("follower_");
    own.response = is_force ? elastic.name : "elastic_" + rigid.response;
    if (!is_force) {
      const MechanismResponse stress = *named(mechanism.responses, rigid.response);
      mechanism.responses.push_back(with_train(stress, elastic, mechanism.parameters));
    }
    all.push_back(std::move(own));
  }
  mechanism.checks = std::move(all);
  if (const MechanismResponse* crown = named(mechanism.responses, "crown_stress")) {
    mechanism.responses.push_back(
        with_train(MechanismResponse(*crown), elastic, mechanism.parameters));
  }
}

}  // namespace camlaw::problems
