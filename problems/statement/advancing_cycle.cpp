// SPDX-License-Identifier: MIT
#include "problems/statement/advancing_cycle.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "kinematics/peaks.h"
#include "problems/statement/shaft_cams.h"

namespace camlaw::problems {
namespace {

bool decides(const std::optional<AdvancingCycle>& cycle, std::string_view parameter) {
  return cycle && std::find(cycle->by.begin(), cycle->by.end(), parameter) != cycle->by.end();
}

bool decides_of(const ShaftCam& cam, std::string_view parameter) {
  const std::string owner = cam.name + ".";
  return parameter.starts_with(owner) &&
         decides(cam.mechanism->advances, parameter.substr(owner.size()));
}

}  // namespace

void check_may_vary(const Mechanism& mechanism, const std::string& parameter) {
  const bool is_of_cam =
      std::any_of(mechanism.cams.begin(), mechanism.cams.end(),
                  [&](const ShaftCam& cam) { return decides_of(cam, parameter); });
  if (!is_of_cam && !decides(mechanism.advances, parameter)) return;
  throw std::invalid_argument(
      fmt::format("{} cannot vary: with the motion it decides whether the cams close; state it "
                  "under [constants]",
                  parameter));
}

void check_advancing_cycle(const ProblemStatement& problem) {
  for (std::size_t i = 0; i < problem.cams.size(); ++i) {
    check_advancing_cycle(cam_alone(problem, i));
  }
  const Mechanism& mechanism = *problem.mechanism;
  if (!mechanism.advances) return;
  for (const VariableStatement& variable : problem.variables) {
    if (!variable.of_law) check_may_vary(mechanism, variable.name);
  }
  for (const Member& law : problem.laws) {
    const Law<double> motion = law.law();
    const double advance = motion(1.0).s - motion(0.0).s;
    const double slowest = peaks(motion).low(Quantity::Velocity).value;
    // Of the mean velocity: a rest's velocity is no more than rounding.
    constexpr double kRounding = 1e-9;
    if (slowest < -kRounding) {
      throw std::invalid_argument(
          fmt::format("{} takes motions that only advance, and this one turns back: its velocity "
                      "falls to {:.4g}",
                      mechanism.name, slowest));
    }
    const std::string why = mechanism.advances->why_open(problem.constants, advance);
    if (!why.empty()) throw std::invalid_argument(why);
  }
}

}  // namespace camlaw::problems
