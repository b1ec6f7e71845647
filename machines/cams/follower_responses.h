// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_curve.h"
#include "machines/cams/cam_motion.h"
#include "machines/cams/follower_words.h"
#include "machines/cams/train_responses.h"
#include "machines/model/append.h"
#include "machines/model/mean_number.h"
#include "machines/model/peak_number.h"
#include "numerics/formula/expression.h"

/// What all followers that a program moves have in common.
namespace camlaw::problems {

/// The cam's own torque where friction makes it differ from the follower's.
template <class Cam>
Expression drive_torque(const Cam& cam, const FollowerMotion& f) {
  if constexpr (requires { cam.drive_torque(f); }) {
    return cam.drive_torque(f);
  } else {
    return cam.follower().torque(f);
  }
}

template <class Cam>
Expression drive_power(const Cam& cam, const FollowerMotion& f) {
  return cam.angular_speed * drive_torque(cam, f);
}

template <class M>
std::vector<MechanismResponse> follower_curves(const FollowerWords& w) {
  return {
      cam_curve<M>({"displacement", w.place, w.place_stored, "displacement of the follower"},
                   [](const auto&, const auto& f) { return f.s; }),
      cam_curve<M>({"velocity", w.velocity, w.velocity, "velocity of the follower"},
                   [](const auto& cam, const auto& f) { return cam.angular_speed * f.ds; }),
      cam_curve<M>({"acceleration", w.acceleration, w.acceleration, "acceleration of the follower"},
                   [](const auto& cam, const auto& f) {
                     return cam.angular_speed * cam.angular_speed * f.dds;
                   }),
      cam_curve<M>({"jerk", w.jerk, w.jerk, "jerk of the follower"},
                   [](const auto& cam, const auto& f) {
                     return cam.angular_speed * cam.angular_speed * cam.angular_speed * f.ddds;
                   }),
      cam_curve<M>({w.force_name, w.force, w.force,
                    std::string(w.effort) + "; below 0 a spring-loaded follower leaves the cam"},
                   [](const auto& cam, const auto& f) { return cam.follower().force(f); }),
      cam_curve<M>({"drive_torque", "N m", "N m", "torque on the cam's shaft"},
                   [](const auto& cam, const auto& f) { return drive_torque(cam, f); }),
      cam_curve<M>(
          {"static_torque", "N m", "N m",
           "part of the drive torque due to spring and load, without friction"},
          [](const auto& cam, const auto& f) { return cam.follower().static_force(f) * f.ds; }),
      cam_curve<M>(
          {"dynamic_torque", "N m", "N m",
           "part of the drive torque due to the moving masses, without friction"},
          [](const auto& cam, const auto& f) { return cam.follower().inertia_force(f) * f.ds; }),
      cam_curve<M>({"drive_power", "W", "W", "power into the cam"},
                   [](const auto& cam, const auto& f) { return drive_power(cam, f); }),
      cam_curve<M>({"inertia_fraction", "1", "1",
                    std::string("inertia ") + w.load + " over the " + w.load +
                        " of spring and load; at 1 a spring-loaded follower leaves the cam"},
                   [](const auto& cam, const auto& f) {
                     return cam.angular_speed * cam.angular_speed * cam.follower().lift_ratio(f);
                   }),
      cam_curve<M>(
          {"spring_deflection", w.place, w.place_stored,
           "deflection of the spring from its unloaded length"},
          [](const auto& cam, const auto& f) { return cam.follower().spring_deflection(f); })};
}

/// Root of the mean square over the turn of formula(cam, motion of the follower).
template <class M, class F>
MechanismResponse follower_rms(ResponseAbout about, F formula) {
  return mean_number<M>(
      std::move(about),
      [formula](const auto& cam, const auto& motion) {
        const auto value = formula(cam, cam.over_angle(motion));
        return value * value;
      },
      [](const auto&, const auto& mean) { return root_of_squares(mean); });
}

/// Numbers of the whole cycle.
template <class M>
std::vector<MechanismResponse> follower_numbers() {
  return {
      follower_rms<M>({"torque_rms", "N m", "N m", "root mean square of the drive torque"},
                      [](const auto& cam, const auto& f) { return drive_torque(cam, f); }),
      follower_rms<M>({"power_rms", "W", "W", "root mean square of the drive power"},
                      [](const auto& cam, const auto& f) { return drive_power(cam, f); }),
      peak_number<M>(
          {"contact_loss_speed", "rpm", "rad/s",
           "speed above which a spring-loaded follower jumps; undefined if nothing "
           "holds it down or nothing lifts it off"},
          cam_curve<M>({"lift_ratio", "s2", "s2", ""},
                       [](const auto& cam, const auto& f) { return cam.follower().lift_ratio(f); }),
          optim::Part::Highest,
          [](const auto&, const auto& ratio) { return where_positive(ratio, 1 / sqrt(ratio)); })};
}

/// The responses of a machine M with over_angle(), follower() and angular_speed.
template <class M>
std::vector<MechanismResponse> follower_responses(const FollowerWords& words) {
  std::vector<MechanismResponse> all = follower_curves<M>(words);
  append(all, follower_numbers<M>());
  append(all, train_responses<M>(train_words(words)));
  return all;
}

}  // namespace camlaw::problems
