// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "machines/model/mechanism.h"
#include "machines/model/turn_responses.h"

/// What every mechanism with a Geneva has in common.
namespace camlaw::problems {

/// Slots, speed, inertia and friction: the fields of GenevaDrive, in that order.
std::vector<MechanismParameter> drive_parameters();

enum class DriveCurve {
  Angle,
  Velocity,
  Acceleration,
  WheelTorque,
  DriveTorque,
  SurplusTorque,
  SurplusWork
};

struct DriveRow {
  DriveCurve which;
  ResponseAbout about;
};
/// Names, units and shapes of the curves.
std::vector<DriveRow> drive_rows();

/// A curve of a machine with the members of GenevaDrive.
template <class Drive, class X>
X drive_curve(const Drive& drive, DriveCurve which, std::size_t section, const X& phi) {
  const bool moves = drive.moves(section);
  const auto beta = drive.wheel(moves, phi);
  const auto omega = drive.angular_speed;
  switch (which) {
    case DriveCurve::Angle:
      return beta.angle;
    case DriveCurve::Velocity:
      return omega * beta.ratio;
    case DriveCurve::Acceleration:
      return omega * omega * beta.second;
    case DriveCurve::WheelTorque:
      return moves ? drive.wheel_torque(beta) : number<X>(0);
    case DriveCurve::DriveTorque:
      return drive.torque(beta);
    case DriveCurve::SurplusTorque:
      return drive.torque(beta) - drive.mean_torque();
    case DriveCurve::SurplusWork:
      break;
  }
  return drive.surplus_work(beta, phi);
}

/// All of them for such a machine M.
template <template <class> class M>
std::vector<MechanismResponse> drive_curves() {
  std::vector<MechanismResponse> all;
  for (DriveRow& row : drive_rows()) {
    all.push_back(turn_response<M>(std::move(row.about), [which = row.which](const auto& drive) {
      return [which, drive](std::size_t section, const auto& phi) {
        return drive_curve(drive, which, section, phi);
      };
    }));
  }
  return all;
}

}  // namespace camlaw::problems
