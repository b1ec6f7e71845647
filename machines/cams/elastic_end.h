// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "machines/cams/cam_motion.h"
#include "machines/follower_train/follower_train.h"
#include "numerics/scalar/where_positive.h"

/// What is elastic behind a cam (docs/theory.md, "Elastic end of a follower").
namespace camlaw {

/// The end of a follower's train: a part of what the follower moves, behind the stiffness and the
/// damper of all that lies between it and the cam. Of an arm torques stand for forces. Fields in SI
/// units.
template <class T>
struct ElasticEnd {
  T mass;           ///< m_e = kappa m, kg
  T stiffness;      ///< c_t, N/m; 0: the follower is rigid, there is no such train
  T damping_ratio;  ///< zeta
  T angular_speed;  ///< omega, rad/s, of the cam

  /// Undamped natural frequency, Hz, as (U2). NaN where there is no such train.
  T natural_frequency() const {
    using std::sqrt;
    return where_positive(stiffness, T(sqrt(stiffness / mass) / (number<T>(2) * pi<T>())));
  }
  /// (U7) tau of a whole turn: how many natural periods it lasts.
  T period_ratio() const { return number<T>(2) * pi<T>() * natural_frequency() / angular_speed; }
};

/// What moves with a rigid follower, and what bears on it besides: standing + rate s.
template <class T>
struct TrainLoads {
  T mass;      ///< m, kg
  T standing;  ///< N, at displacement 0
  T rate;      ///< N/m
};

/// (M2)
template <class T>
TrainLoads<T> train_loads(const FollowerLoad<T>& load) {
  return {load.mass, load.spring_preload + load.load, load.spring_rate};
}

/// That of a machine with train_stiffness, train_damping and end_share, whose follower() has
/// train_loads().
template <class Cam>
auto elastic_end(const Cam& cam) {
  const auto mass = train_loads(cam.follower()).mass;
  return ElasticEnd<std::decay_t<decltype(mass)>>{cam.end_share * mass, cam.train_stiffness,
                                                  cam.train_damping, cam.angular_speed};
}

/// Displacement of a follower, or of a turret, at 1.
template <class Cam>
auto stroke_of(const Cam& cam) {
  using T = std::decay_t<decltype(cam.angular_speed)>;
  const T none = number<T>(0);
  return cam.over_angle(Motion<T>{number<T>(1), none, none, none}).s;
}

}  // namespace camlaw
