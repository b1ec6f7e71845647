// SPDX-License-Identifier: MIT
#pragma once

#include "machines/follower_train/elastic_follower.h"
#include "machines/model/machine.h"

namespace camlaw::problems {

template <>
struct MachineTraits<ElasticFollower> {
  static const std::vector<MechanismParameter>& parameters();
  template <class T>
  static constexpr std::array fields{
      &ElasticFollower<T>::mass,          &ElasticFollower<T>::stiffness,
      &ElasticFollower<T>::damping_ratio, &ElasticFollower<T>::stroke,
      &ElasticFollower<T>::rise_angle,    &ElasticFollower<T>::angular_speed,
      &ElasticFollower<T>::slowest_speed, &ElasticFollower<T>::fastest_speed};
};

}  // namespace camlaw::problems
