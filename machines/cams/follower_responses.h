// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_motion.h"
#include "machines/cams/follower_words.h"
#include "machines/cams/train_responses.h"
#include "machines/model/append.h"
#include "machines/model/listed_responses.h"
#include "machines/model/mean_number.h"
#include "machines/model/peak_number.h"
#include "numerics/scalar/by_side.h"
#include "numerics/scalar/where_positive.h"

/// What all followers that a program moves have in common.
namespace camlaw::problems {

enum class FollowerCurve {
  Displacement,
  Velocity,
  Acceleration,
  Jerk,
  Force,
  Torque,
  StaticTorque,
  DynamicTorque,
  Power,
  InertiaShare,
  SpringDeflection,
  LiftRatio
};

/// The cam's own torque where friction makes it differ from the follower's.
template <class Cam, class X>
X drive_torque(const Cam& cam, const FollowerMotion<X>& f) {
  if constexpr (requires { cam.drive_torque(f); }) {
    return cam.drive_torque(f);
  } else {
    return cam.follower().torque(f);
  }
}

template <class Cam, class X>
X follower_curve(const Cam& cam, FollowerCurve which, const FollowerMotion<X>& f) {
  const auto omega = cam.angular_speed;
  switch (which) {
    case FollowerCurve::Displacement:
      return f.s;
    case FollowerCurve::Velocity:
      return omega * f.ds;
    case FollowerCurve::Acceleration:
      return omega * omega * f.dds;
    case FollowerCurve::Jerk:
      return omega * omega * omega * f.ddds;
    case FollowerCurve::Force:
      return cam.follower().force(f);
    case FollowerCurve::Torque:
      return drive_torque(cam, f);
    case FollowerCurve::StaticTorque:
      return cam.follower().static_force(f) * f.ds;
    case FollowerCurve::DynamicTorque:
      return cam.follower().inertia_force(f) * f.ds;
    case FollowerCurve::Power:
      return omega * drive_torque(cam, f);
    case FollowerCurve::InertiaShare:
      return omega * omega * cam.follower().lift_ratio(f);
    case FollowerCurve::SpringDeflection:
      return cam.follower().spring_deflection(f);
    case FollowerCurve::LiftRatio:
      break;
  }
  return cam.follower().lift_ratio(f);
}

inline std::vector<MechanismResponse> follower_responses_of(
    const FollowerWords& w,
    const std::function<MechanismResponse(ResponseAbout, FollowerCurve)>& make) {
  using C = FollowerCurve;
  std::vector<MechanismResponse> all;
  const auto add = [&](C which, const char* name, const char* listed, const char* stored,
                       std::string meaning) {
    all.push_back(make({name, listed, stored, std::move(meaning)}, which));
  };
  add(C::Displacement, "displacement", w.place, w.place_stored, "displacement of the follower");
  add(C::Velocity, "velocity", w.velocity, w.velocity, "velocity of the follower");
  add(C::Acceleration, "acceleration", w.acceleration, w.acceleration,
      "acceleration of the follower");
  add(C::Jerk, "jerk", w.jerk, w.jerk, "jerk of the follower");
  add(C::Force, w.force_name, w.force, w.force,
      std::string(w.effort) + "; below 0 a spring-loaded follower leaves the cam");
  add(C::Torque, "drive_torque", "N m", "N m", "torque on the cam's shaft");
  add(C::StaticTorque, "static_torque", "N m", "N m",
      "part of the drive torque due to spring and load, without friction");
  add(C::DynamicTorque, "dynamic_torque", "N m", "N m",
      "part of the drive torque due to the moving masses, without friction");
  add(C::Power, "drive_power", "W", "W", "power into the cam");
  add(C::InertiaShare, "inertia_fraction", "1", "1",
      std::string("inertia ") + w.load + " over the " + w.load +
          " of spring and load; at 1 a spring-loaded follower leaves the cam");
  add(C::SpringDeflection, "spring_deflection", w.place, w.place_stored,
      "deflection of the spring from its unloaded length");
  return all;
}

template <template <class> class M>
MechanismResponse follower_response(ResponseAbout about, FollowerCurve which) {
  return listed_curve<M>(std::move(about), turn_of_the_cam(), which,
                         [](const auto& cam, FollowerCurve curve, const auto& motion) {
                           return follower_curve(cam, curve, cam.over_angle(motion));
                         });
}

/// Root of the mean square of a curve over the turn.
template <template <class> class M>
MechanismResponse follower_rms(ResponseAbout about, FollowerCurve which) {
  return mean_number<M>(
      std::move(about),
      [which](const auto& cam, const auto& motion) {
        const auto value = follower_curve(cam, which, cam.over_angle(motion));
        return value * value;
      },
      [](const auto&, const auto& mean) { return root_of_squares(mean); });
}

/// Numbers of the whole cycle.
template <template <class> class M>
std::vector<MechanismResponse> follower_numbers() {
  using C = FollowerCurve;
  return {follower_rms<M>({"torque_rms", "N m", "N m", "root mean square of the drive torque"},
                          C::Torque),
          follower_rms<M>({"power_rms", "W", "W", "root mean square of the drive power"}, C::Power),
          peak_number<M>({"contact_loss_speed", "rpm", "rad/s",
                          "speed above which a spring-loaded follower jumps; undefined if nothing "
                          "holds it down or nothing lifts it off"},
                         follower_response<M>({"lift_ratio", "s2", "s2", ""}, C::LiftRatio),
                         optim::Part::Highest, [](const auto&, const auto& ratio) {
                           using std::sqrt;
                           using X = std::decay_t<decltype(ratio)>;
                           return where_positive(ratio, X(number<X>(1) / sqrt(ratio)));
                         })};
}

/// The responses of a machine M with over_angle(), follower() and angular_speed.
template <template <class> class M>
std::vector<MechanismResponse> follower_responses(const FollowerWords& words) {
  std::vector<MechanismResponse> all = follower_responses_of(words, follower_response<M>);
  append(all, follower_numbers<M>());
  append(all, train_responses<M>(train_words(words)));
  return all;
}

}  // namespace camlaw::problems
