// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "machines/model/machine.h"
#include "machines/model/mechanism.h"
#include "machines/spine_cutter/spine_cutter.h"

/// The spine cutter as problem files and the study see it.
namespace camlaw::problems {

/// Its parameters; everything that reads or lists one goes by this list.
const std::vector<MechanismParameter>& spine_cutter_parameters();

template <>
struct MachineTraits<SpineCutter> {
  static const std::vector<MechanismParameter>& parameters() { return spine_cutter_parameters(); }
  template <class T>
  static constexpr std::array fields{&SpineCutter<T>::cutter_diameter, &SpineCutter<T>::blades,
                                     &SpineCutter<T>::stroke,          &SpineCutter<T>::block_speed,
                                     &SpineCutter<T>::depth,           &SpineCutter<T>::mass,
                                     &SpineCutter<T>::pressure_angle,  &SpineCutter<T>::cam_radius};
};

/// "spine-cutter". Curves run over the cam angle, 0 to 360 degrees: the stroke and its return.
Mechanism spine_cutter_mechanism();

}  // namespace camlaw::problems
