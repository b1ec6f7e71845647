// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "machines/model/mechanism.h"
#include "machines/model/turn_responses.h"

/// What every mechanism with a Geneva has in common.
namespace camlaw::problems {

/// The curves of a machine M with the members of GenevaDrive.
template <class M>
std::vector<MechanismResponse> drive_curves() {
  // From formula(drive, the wheel's motion, whether it moves, angle).
  const auto curve = [](ResponseAbout about, auto formula) {
    return turn_response<M>(std::move(about), [formula](const auto& drive) {
      return [formula, drive](std::size_t section, const auto& phi) {
        const bool moves = drive.moves(section);
        return formula(drive, drive.wheel(moves, phi), moves, phi);
      };
    });
  };
  return {curve({"wheel_angle", "deg", "rad", "angle of the wheel from the middle of its step"},
                [](const auto&, const auto& beta, bool, const auto&) { return beta.angle; }),
          curve({"wheel_velocity", "rad/s", "rad/s", "angular velocity of the wheel"},
                [](const auto& drive, const auto& beta, bool, const auto&) {
                  return drive.angular_speed * beta.ratio;
                }),
          curve({"wheel_acceleration", "rad/s2", "rad/s2", "angular acceleration of the wheel"},
                [](const auto& drive, const auto& beta, bool, const auto&) {
                  return drive.angular_speed * drive.angular_speed * beta.second;
                }),
          curve({"wheel_torque", "N m", "N m",
                 "torque at the wheel while it moves, from inertia and friction"},
                [](const auto& drive, const auto& beta, bool moves, const Expression&) {
                  return moves ? drive.wheel_torque(beta) : 0;
                }),
          curve({"drive_torque", "N m", "N m", "torque on the driver"},
                [](const auto& drive, const auto& beta, bool, const auto&) {
                  return drive.torque(beta);
                }),
          curve({"surplus_torque", "N m", "N m", "torque on the driver minus its mean"},
                [](const auto& drive, const auto& beta, bool, const auto&) {
                  return drive.torque(beta) - drive.mean_torque();
                }),
          curve({"surplus_work", "J", "J",
                 "integral of the surplus torque since the pin entered the slot"},
                [](const auto& drive, const auto& beta, bool, const auto& phi) {
                  return drive.surplus_work(beta, phi);
                })};
}

}  // namespace camlaw::problems
