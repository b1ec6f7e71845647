// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_curve.h"
#include "machines/cams/train_responses.h"
#include "machines/index_drives/index_load.h"
#include "machines/model/append.h"
#include "machines/model/mean_number.h"
#include "numerics/formula/expression.h"

/// What the turret of every index drive does and asks for.
namespace camlaw::problems {

/// (IX19) Rollers between two flanks are held without a spring: where the torque changes its sign
/// the other flank takes over.
inline TrainWords table_words() {
  return {
      .place = "deg",
      .place_stored = "rad",
      .acceleration = "rad/s2",
      .force = "N m",
      .load = "torque",
      .elastic =
          "torque that turret, elastic train and load require, without friction; below "
          "0 the holding flank carries it",
      .lost =
          "lowest speed at which the holding flank carries load, with the elastic train, without "
          "friction; undefined if none",
      .least =
          "least torque with the elastic train, without friction; above 0 the driving "
          "flank carries the load all the time",
      .rigid = "turret_torque",
      .of_motion = {},
      .of_load = {"load_torque"}};
}

/// The responses of a machine M with over_angle(), follower(), angular_speed and what elastic_end()
/// takes.
template <class M>
std::vector<MechanismResponse> turret_responses() {
  const auto drive_torque = [](const auto& drive, const auto& f) {
    return drive.follower().drive_torque(f);
  };
  std::vector<MechanismResponse> all{
      cam_curve<M>({"displacement", "deg", "rad", "angle through which the turret has turned"},
                   [](const auto&, const auto& f) { return f.s; }),
      cam_curve<M>({"velocity", "rad/s", "rad/s", "angular velocity of the turret"},
                   [](const auto& drive, const auto& f) { return drive.angular_speed * f.ds; }),
      cam_curve<M>({"acceleration", "rad/s2", "rad/s2", "angular acceleration of the turret"},
                   [](const auto& drive, const auto& f) {
                     return drive.angular_speed * drive.angular_speed * f.dds;
                   }),
      cam_curve<M>({"jerk", "rad/s3", "rad/s3", "angular jerk of the turret"},
                   [](const auto& drive, const auto& f) {
                     const auto& omega = drive.angular_speed;
                     return omega * omega * omega * f.ddds;
                   }),
      cam_curve<M>({"turret_torque", "N m", "N m",
                    "torque that turret, table and load require; below 0 they must be braked"},
                   [](const auto& drive, const auto& f) { return drive.follower().torque(f); }),
      cam_curve<M>(
          {"inertia_torque", "N m", "N m",
           "part of the turret torque that accelerates turret and table"},
          [](const auto& drive, const auto& f) { return drive.follower().inertia_torque(f); }),
      cam_curve<M>({"drive_torque", "N m", "N m", "torque on the cam's shaft, without losses"},
                   drive_torque),
      cam_curve<M>({"drive_power", "W", "W", "power into the cam, without losses"},
                   [drive_torque](const auto& drive, const auto& f) {
                     return drive.angular_speed * drive_torque(drive, f);
                   })};
  all.push_back(mean_number<M>(
      {"torque_rms", "N m", "N m", "root mean square of the drive torque"},
      [drive_torque](const auto& drive, const auto& motion) {
        const auto torque = drive_torque(drive, drive.over_angle(motion));
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
