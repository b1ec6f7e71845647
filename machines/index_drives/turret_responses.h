// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/train_responses.h"
#include "machines/index_drives/index_load.h"
#include "machines/model/append.h"
#include "machines/model/listed_responses.h"
#include "machines/model/mean_number.h"
#include "numerics/scalar/by_side.h"

/// What the turret of every index drive does and asks for.
namespace camlaw::problems {

enum class TurretCurve {
  Displacement,
  Velocity,
  Acceleration,
  Jerk,
  Torque,
  InertiaTorque,
  DriveTorque,
  DrivePower
};

template <class Drive, class X>
X turret_curve(const Drive& drive, TurretCurve which, const FollowerMotion<X>& f) {
  const auto omega = drive.angular_speed;
  switch (which) {
    case TurretCurve::Displacement:
      return f.s;
    case TurretCurve::Velocity:
      return omega * f.ds;
    case TurretCurve::Acceleration:
      return omega * omega * f.dds;
    case TurretCurve::Jerk:
      return omega * omega * omega * f.ddds;
    case TurretCurve::Torque:
      return drive.follower().torque(f);
    case TurretCurve::InertiaTorque:
      return drive.follower().inertia_torque(f);
    case TurretCurve::DriveTorque:
      return drive.follower().drive_torque(f);
    case TurretCurve::DrivePower:
      break;
  }
  return omega * drive.follower().drive_torque(f);
}

/// (IX19) Rollers between two flanks are held without a spring: where the torque changes its sign
/// the other flank takes over.
inline TrainWords table_words() {
  return {.place = "deg",
          .place_stored = "rad",
          .acceleration = "rad/s2",
          .force = "N m",
          .load = "torque",
          .elastic =
              "torque that turret, elastic train and load require, without friction; below "
              "0 the holding flank bears",
          .lost =
              "lowest speed at which the holding flank bears, with the elastic train and no "
              "friction; undefined if none is found",
          .least =
              "least torque with the elastic train, without friction; above 0 the driving "
              "flank bears all round",
          .rigid = "turret_torque",
          .of_motion = {},
          .of_load = {"load_torque"}};
}

/// The responses of a machine M with over_angle(), follower(), angular_speed and what elastic_end()
/// takes.
template <template <class> class M>
std::vector<MechanismResponse> turret_responses() {
  using C = TurretCurve;
  std::vector<MechanismResponse> all;
  const auto add = [&](C which, const char* name, const char* unit, const char* stored,
                       const char* meaning) {
    all.push_back(listed_curve<M>({name, unit, stored, meaning}, turn_of_the_cam(), which,
                                  [](const auto& drive, C curve, const auto& motion) {
                                    return turret_curve(drive, curve, drive.over_angle(motion));
                                  }));
  };
  add(C::Displacement, "displacement", "deg", "rad", "angle through which the turret has turned");
  add(C::Velocity, "velocity", "rad/s", "rad/s", "angular velocity of the turret");
  add(C::Acceleration, "acceleration", "rad/s2", "rad/s2", "angular acceleration of the turret");
  add(C::Jerk, "jerk", "rad/s3", "rad/s3", "angular jerk of the turret");
  add(C::Torque, "turret_torque", "N m", "N m",
      "torque that turret, table and load require; below 0 they must be braked");
  add(C::InertiaTorque, "inertia_torque", "N m", "N m",
      "part of the turret torque that accelerates turret and table");
  add(C::DriveTorque, "drive_torque", "N m", "N m", "torque on the cam's shaft, without losses");
  add(C::DrivePower, "drive_power", "W", "W", "power into the cam, without losses");
  all.push_back(mean_number<M>(
      {"torque_rms", "N m", "N m", "root mean square of the drive torque"},
      [](const auto& drive, const auto& motion) {
        const auto torque = turret_curve(drive, C::DriveTorque, drive.over_angle(motion));
        return torque * torque;
      },
      [](const auto&, const auto& mean) { return root_of_squares(mean); }));
  all.push_back(number_response<M>(
      {"station_angle", "deg", "rad", "angle of the turret between two stations"},
      [](const auto& drive) { return station_angle(drive.stations); }));
  append(all, train_responses<M>(table_words()));
  return all;
}

}  // namespace camlaw::problems
