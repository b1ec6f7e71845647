// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/cams/cam_motion.h"
#include "problems/mechanism/listed_responses.h"

/// What all followers that a program moves have in common.
namespace camlaw::problems {

enum class FollowerCurve { Displacement, Velocity, Acceleration, Jerk, Force, Torque, Power };

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
      return cam.follower().torque(f);
    case FollowerCurve::Power:
      break;
  }
  return omega * cam.follower().torque(f);
}

/// Units and names of a follower's motion and load: millimetres and newtons, or degrees and
/// newton metres.
struct FollowerWords {
  const char* stroke;                          ///< its parameter
  const char *place, *place_stored;            ///< units of displacement, listed and stored
  const char *velocity, *acceleration, *jerk;  ///< units, listed and stored
  const char* force;                           ///< unit
  const char *mass, *force_name;               ///< parameter and response
};

inline constexpr FollowerWords kSliding{"stroke", "mm", "m",    "m/s",           "m/s2",
                                        "m/s3",   "N",  "mass", "follower_force"};
inline constexpr FollowerWords kSwinging{"swing",  "deg", "rad",     "rad/s",          "rad/s2",
                                         "rad/s3", "N m", "inertia", "follower_torque"};

inline std::vector<MechanismResponse> follower_responses_of(
    const FollowerWords& w,
    const std::function<MechanismResponse(ResponseAbout, FollowerCurve)>& make) {
  using optim::Shape;
  const std::vector<std::string> loads{w.mass, "spring_rate", "spring_preload", "load"};
  const auto linear = [&](std::vector<std::string> more = {}) {
    std::vector<ShapeStatement> shapes{{{"law"}, Shape::Linear}, {{w.stroke}, Shape::Linear}};
    if (!more.empty()) shapes.push_back({std::move(more), Shape::Linear});
    return shapes;
  };
  using C = FollowerCurve;
  std::vector<MechanismResponse> all;
  const auto add = [&](C which, const char* name, const char* listed, const char* stored,
                       const char* meaning, std::vector<ShapeStatement> shapes) {
    all.push_back(make({name, listed, stored, meaning, std::move(shapes)}, which));
  };
  const ShapeStatement speed{{"speed"}, Shape::Quasilinear};
  add(C::Displacement, "displacement", w.place, w.place_stored, "displacement of the follower",
      linear());
  add(C::Velocity, "velocity", w.velocity, w.velocity, "velocity of the follower",
      linear({"speed"}));
  auto shapes = linear();
  shapes.push_back(speed);
  add(C::Acceleration, "acceleration", w.acceleration, w.acceleration,
      "acceleration of the follower", shapes);
  add(C::Jerk, "jerk", w.jerk, w.jerk, "jerk of the follower", shapes);
  auto force_shapes = linear(loads);
  force_shapes.push_back(speed);
  add(C::Force, w.force_name, w.force, w.force,
      "what the cam must give along the follower's way; below 0 a spring-closed follower leaves "
      "the "
      "cam",
      force_shapes);
  add(C::Torque, "drive_torque", "N m", "N m", "torque on the cam's shaft, without friction",
      {{loads, Shape::Linear}, speed});
  add(C::Power, "drive_power", "W", "W", "power into the cam, without friction",
      {{loads, Shape::Linear}});
  return all;
}

/// The responses of a machine M with over_angle(), follower() and angular_speed.
template <template <class> class M>
std::vector<MechanismResponse> follower_responses(const FollowerWords& words) {
  return follower_responses_of(words, [](ResponseAbout about, FollowerCurve which) {
    return listed_curve<M>(std::move(about), turn_of_the_cam(), which,
                           [](const auto& cam, FollowerCurve curve, const auto& motion) {
                             return follower_curve(cam, curve, cam.over_angle(motion));
                           });
  });
}

}  // namespace camlaw::problems
