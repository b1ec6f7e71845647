// SPDX-License-Identifier: MIT
#include "machines/cams/swinging_end_cam.h"

#include "machines/cams/cam_tables.h"
#include "machines/cams/cams.h"
#include "machines/cams/drawn_responses.h"
#include "machines/cams/follower_responses.h"
#include "machines/cams/roller_responses.h"
#include "machines/model/append.h"

namespace camlaw::problems {

template <>
struct MachineTraits<SwingingEndCam> {
  static const std::vector<MechanismParameter>& parameters();
  template <class T>
  static constexpr std::array fields{
      &SwingingEndCam<T>::swing,          &SwingingEndCam<T>::radius,
      &SwingingEndCam<T>::arm_length,     &SwingingEndCam<T>::tilt,
      &SwingingEndCam<T>::roller_radius,  &SwingingEndCam<T>::angular_speed,
      &SwingingEndCam<T>::inertia,        &SwingingEndCam<T>::spring_rate,
      &SwingingEndCam<T>::spring_preload, &SwingingEndCam<T>::load,
      &SwingingEndCam<T>::face_width,     &SwingingEndCam<T>::youngs_modulus,
      &SwingingEndCam<T>::poisson_ratio,  &SwingingEndCam<T>::cutter_radius};
};

const std::vector<MechanismParameter>& MachineTraits<SwingingEndCam>::parameters() {
  static const Parameters all = joined(
      {swing_parameter(),
       {{"radius", "R", "mm", "m", "mean radius of the roller's track", 50, 1e-3, 1e5},
        {"arm_length", "l", "mm", "m", "length of the arm", 80, 1e-3, 1e5},
        {"tilt", "beta", "deg", "rad",
         "angle of the arm at mid-swing to the circumference; at 0 it is square to the cam's axis",
         0, -89, 89}},
       roller_parameter(),
       speed_parameter(),
       swinging_load(0, 0),
       contact_parameters(),
       cutter_parameter()});
  return all;
}

Mechanism swinging_end_cam_mechanism() {
  using S = optim::Shape;
  std::vector<MechanismResponse> responses = follower_responses<SwingingEndCam>(kSwinging);
  append(responses, roller_responses<SwingingEndCam>(
                        {{{"radius"}, S::Quasilinear}, {{"arm_length"}, S::Quasilinear}}));
  append(responses, drawn_responses<SwingingEndCam>(true));
  return {.name = "end-cam-swinging",
          .title = "end or barrel cam with an oscillating roller arm",
          .source = "docs/theory.md, Cams",
          .parameters = MachineTraits<SwingingEndCam>::parameters(),
          .responses = std::move(responses),
          .peaks = {peak_pressure_angle(), peak_undercut(), peak_torque(), peak_stress(),
                    least_torque(), peak_outer_undercut(), peak_groove_stress()},
          .moved_by = MovedBy::Program};
}

}  // namespace camlaw::problems
