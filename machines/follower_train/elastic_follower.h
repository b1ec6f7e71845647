// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "machines/model/given.h"
#include "machines/model/possibility.h"

namespace camlaw {

/// A follower train in a machine: a mass behind the stiffness of all between it and the cam, and a
/// damper, over one rise (docs/theory.md, "Elastic follower train"). Fields in SI units.
struct ElasticFollower {
  Given given = {};
  Expression mass = given({"mass", "m", "kg", "kg", "mass at the end of the train", 2, 1e-6, 1e6});
  Expression stiffness =
      given({"stiffness", "c_f", "N/mm", "N/m", "stiffness between cam and mass", 200, 1e-3, 1e9});
  Expression damping_ratio =
      given({"damping_ratio", "zeta", "1", "1", "damping over critical damping", 0.05, 0, 0.99});
  Expression stroke = given({"stroke", "h", "mm", "m", "stroke of the rise", 20, 1e-6, 1e5});
  Expression rise_angle =
      given({"rise_angle", "beta", "deg", "rad", "cam angle of the rise", 90, 1e-3, 360});
  Expression angular_speed =
      given({"speed", "n", "rpm", "rad/s", "speed of the cam", 300, 1e-3, 1e6});
  Expression slowest_speed = given({"slowest_speed", "n_1", "rpm", "rad/s",
                                    "speed at which a range of speeds begins", 240, 1e-3, 1e6});
  Expression fastest_speed = given(
      {"fastest_speed", "n_2", "rpm", "rad/s", "speed at which that range ends", 360, 1e-3, 1e6});

  auto conditions() const {
    return std::to_array<Condition>({{mass, "mass must be above 0"},
                                     {stiffness, "stiffness must be above 0"},
                                     {damping_ratio, "damping_ratio must be 0 or above", true},
                                     {1 - damping_ratio, "damping_ratio must be below 1"},
                                     {rise_angle, "rise_angle must be above 0"},
                                     {angular_speed, "speed must be above 0"}});
  }
  /// (U2) Undamped natural frequency, Hz: sqrt(c / m) / (2 pi).
  Expression natural_frequency() const { return sqrt(stiffness / mass) / (2 * pi()); }
  /// Time of the rise, s.
  Expression rise_time() const { return rise_angle / angular_speed; }
  /// (U3) tau, the rise's time over the natural period.
  Expression period_ratio() const { return rise_time() * natural_frequency(); }
};

}  // namespace camlaw
