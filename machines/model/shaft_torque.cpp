// SPDX-License-Identifier: MIT
#include "machines/model/shaft_torque.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "machines/model/balancing_lift.h"
#include "machines/model/recorded_response.h"
#include "machines/model/shaft.h"
#include "machines/model/shaft_curve.h"
#include "machines/model/shaft_rms.h"
#include "machines/model/stated_response.h"
#include "machines/model/surplus_work.h"
#include "numerics/formula/expression.h"

namespace camlaw::problems {
namespace {

constexpr const char* kDriveTorque = "drive_torque";
constexpr const char* kShaftTorque = "shaft_torque";
constexpr const char* kSurplusWork = "surplus_work";
constexpr const char* kSpringRate = "balancing_spring_rate";
constexpr const char* kSpringPreload = "balancing_spring_preload";

/// The drive torques of all cams; none where one has none that runs over the turn.
std::vector<std::string> drive_torques(const Mechanism& shaft) {
  std::vector<std::string> torques;
  for (const ShaftCam& cam : shaft.cams) {
    const auto& all = cam.mechanism->responses;
    const bool has = std::any_of(all.begin(), all.end(), [](const MechanismResponse& r) {
      return r.name == kDriveTorque && runs_over_turn(r);
    });
    if (!has) return {};
    torques.push_back(cam.name + "." + kDriveTorque);
  }
  return torques;
}

void add_stated(const char* name, const char* unit, const std::string& formula, const char* meaning,
                Mechanism& shaft) {
  shaft.responses.push_back(stated_response(shaft, {name, unit, meaning, parse_formula(formula)}));
}

/// "press.surplus_work" of the cam whose curve is held.
std::string of_cam(const Mechanism& shaft, const HeldCurve& held, const char* name) {
  return shaft.cams[held.cam].name + "." + name;
}

Expression sum_from(std::span<const Expression> others, std::size_t first) {
  Expression sum = others[first];
  for (std::size_t k = first + 1; k < others.size(); ++k) sum = sum + others[k];
  return sum;
}

void add_parameters(Mechanism& shaft) {
  const auto add = [&](const char* name, const char* symbol, const char* unit, const char* stored,
                       const char* meaning, double value, double low, double high) {
    shaft.parameters.push_back({name, symbol, unit, stored, meaning, value, low, high});
  };
  add("speed_fluctuation", "delta", "1", "1",
      "coefficient of speed fluctuation for which a flywheel is sized: difference of highest and "
      "lowest speed over the mean speed",
      0.02, 1e-6, 1);
  add(kSpringRate, "k_B", "N/mm", "N/m", "rate of the balancing cam's spring", 10, 1e-6, 1e9);
  add(kSpringPreload, "F_B", "N", "N", "force of the balancing cam's spring at its least lift", 100,
      1e-6, 1e9);
}

/// (SH3) The mean of a sum is that of its parts, wherever their phases are.
MechanismResponse mean_torque(const Mechanism& shaft, const MechanismResponse& torque) {
  MechanismResponse mean{.name = "mean_torque",
                         .unit = "N m",
                         .meaning = "mean torque of the shaft over its turn",
                         .possible_by = torque.possible_by,
                         .sees_law = torque.sees_law,
                         .defined_while = torque.defined_while};
  for (const HeldCurve& held : torque.held) {
    mean.inner.push_back(turn_mean(of_cam(shaft, held, "mean_torque"), *held.response));
  }
  mean.write = [](std::span<const Expression>, std::span<const Expression> means) {
    return sum_from(means, 0);
  };
  return recorded_number(std::move(mean), shaft.parameters);
}

/// (SH4) Likewise the surplus work, each cam's at its phase.
MechanismResponse shaft_work(const Mechanism& shaft, const MechanismResponse& torque) {
  MechanismResponse work{.name = kSurplusWork,
                         .unit = "J",
                         .meaning =
                             "work that the shaft has taken in excess of that of its mean torque, "
                             "less the mean of this over the turn",
                         .possible_by = torque.possible_by,
                         .defined_while = torque.defined_while};
  for (HeldCurve held : torque.held) {
    held.response = std::make_shared<const MechanismResponse>(
        surplus_work(of_cam(shaft, held, kSurplusWork), *held.response));
    work.held.push_back(std::move(held));
  }
  work.write = [](std::span<const Expression>, std::span<const Expression> others) {
    return sum_from(others, 1);  // behind the angle
  };
  return shaft_curve_response(std::move(work), shaft.parameters);
}

const MechanismResponse& response(const Mechanism& shaft, const char* name) {
  return *find_response(shaft, name).response;
}

void add_balancing(Mechanism& shaft) {
  shaft.responses.push_back(balancing_lift(
      {.name = "balancing_lift",
       .unit = "mm",
       .meaning = "lift of a spring-loaded balancing cam that makes the shaft's torque constant"},
      response(shaft, kSurplusWork), shaft.parameter(kSpringRate),
      shaft.parameter(kSpringPreload)));
  add_stated("balancing_force", "N",
             fmt::format("sqrt({1}^2 + 2 * {0} * energy_fluctuation)", kSpringRate, kSpringPreload),
             "greatest force of the balancing cam's spring", shaft);
  add_stated("balancing_stroke", "mm",
             fmt::format("(balancing_force - {1}) / {0}", kSpringRate, kSpringPreload),
             "greatest lift of the balancing cam", shaft);
}

}  // namespace

void add_shaft_torque(Mechanism& shaft) {
  const std::vector<std::string> torques = drive_torques(shaft);
  if (torques.empty()) return;
  add_parameters(shaft);
  add_stated(kShaftTorque, "N m", fmt::format("{}", fmt::join(torques, " + ")),
             "torque that turns the shaft: the drive torques of its cams, each at its phase",
             shaft);
  add_stated("shaft_power", "W", "shaft_torque * speed", "power that turns the shaft", shaft);
  add_stated("torque_ripple", "N m", "highest shaft_torque - lowest shaft_torque",
             "range of the shaft's torque in a turn", shaft);
  const MechanismResponse torque = response(shaft, kShaftTorque);
  shaft.responses.push_back(mean_torque(shaft, torque));
  shaft.responses.push_back(shaft_rms(
      {.name = "torque_rms", .unit = "N m", .meaning = "root mean square of the shaft's torque"},
      torque.held));
  shaft.responses.push_back(shaft_work(shaft, torque));
  add_stated("energy_fluctuation", "J", "highest surplus_work - lowest surplus_work",
             "range of the surplus work in a turn", shaft);
  add_stated("flywheel_inertia", "kg m2", "energy_fluctuation / (speed_fluctuation * speed^2)",
             "moment of inertia on the shaft that keeps its speed within the speed fluctuation",
             shaft);
  add_balancing(shaft);
}

}  // namespace camlaw::problems
