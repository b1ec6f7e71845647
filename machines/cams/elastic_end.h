// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "machines/cams/cam_motion.h"
#include "machines/follower_train/follower_train.h"
#include "numerics/formula/expression.h"

/// What is elastic behind a cam (docs/theory.md, "Elastic end of a follower").
namespace camlaw {

/// The end of a follower's train: a part of what the follower moves, behind the stiffness and the
/// damper of all that lies between it and the cam. Of an arm torques stand for forces. Fields in SI
/// units.
struct ElasticEnd {
  Expression mass;           ///< m_e = kappa m, kg
  Expression stiffness;      ///< c_t, N/m; 0: the follower is rigid, there is no such train
  Expression damping_ratio;  ///< zeta
  Expression angular_speed;  ///< omega, rad/s, of the cam

  /// Undamped natural frequency, Hz, as (U2). NaN where there is no such train.
  Expression natural_frequency() const {
    return where_positive(stiffness, sqrt(stiffness / mass) / (2 * pi()));
  }
  /// (U7) tau of a whole turn: how many natural periods it lasts.
  Expression period_ratio() const { return 2 * pi() * natural_frequency() / angular_speed; }
};

/// What moves with a rigid follower, and what bears on it besides: standing + rate s.
struct TrainLoads {
  Expression mass;      ///< m, kg
  Expression standing;  ///< N, at displacement 0
  Expression rate;      ///< N/m
};

/// (M2)
inline TrainLoads train_loads(const FollowerLoad& load) {
  return {load.mass, load.spring_preload + load.load, load.spring_rate};
}

/// That of a machine with train_stiffness, train_damping and end_share, whose follower() has
/// train_loads().
template <class Cam>
ElasticEnd elastic_end(const Cam& cam) {
  const Expression mass = train_loads(cam.follower()).mass;
  return ElasticEnd{cam.end_share * mass, cam.train_stiffness, cam.train_damping,
                    cam.angular_speed};
}

/// Displacement of a follower, or of a turret, at 1.
template <class Cam>
Expression stroke_of(const Cam& cam) {
  const Expression none = 0;
  return cam.over_angle(Motion<Expression>{1, none, none, none}).s;
}

}  // namespace camlaw
