// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "machines/follower_train/follower_train.h"
#include "machines/model/possibility.h"

namespace camlaw {

/// A follower train in a machine: a mass behind the stiffness of all between it and the cam, and a
/// damper, over one rise (docs/theory.md, "Elastic follower train"). Fields in SI units.
template <class T>
struct ElasticFollower {
  T mass = number<T>(2);                          ///< m, kg
  T stiffness = number<T>(200000);                ///< c, N/m
  T damping_ratio = number<T>(0.05);              ///< zeta
  T stroke = number<T>(0.020);                    ///< h, m
  T rise_angle = number<T>(1.5707963267949);      ///< beta, rad, of the cam
  T angular_speed = number<T>(31.4159265358979);  ///< omega, rad/s, of the cam
  T slowest_speed = number<T>(25.1327412287183);  ///< rad/s, where a range of speeds begins
  T fastest_speed = number<T>(37.6991118430775);  ///< rad/s, where it ends

  auto conditions() const {
    return std::to_array<Condition<T>>(
        {{mass, "mass must be above 0"},
         {stiffness, "stiffness must be above 0"},
         {damping_ratio, "damping_ratio must be 0 or above", true},
         {number<T>(1) - damping_ratio, "damping_ratio must be below 1"},
         {rise_angle, "rise_angle must be above 0"},
         {angular_speed, "speed must be above 0"}});
  }
  /// (U2) Undamped natural frequency, Hz: sqrt(c / m) / (2 pi).
  T natural_frequency() const {
    using std::sqrt;
    return sqrt(stiffness / mass) / (number<T>(2) * pi<T>());
  }
  /// Time of the rise, s.
  T rise_time() const { return rise_angle / angular_speed; }
  /// (U3) tau, the rise's time over the natural period.
  T period_ratio() const { return rise_time() * natural_frequency(); }
  FollowerTrain<T> train() const { return {period_ratio(), damping_ratio}; }
};

}  // namespace camlaw
