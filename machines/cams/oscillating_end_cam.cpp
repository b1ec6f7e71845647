// SPDX-License-Identifier: MIT
#include "machines/cams/oscillating_end_cam.h"

#include "machines/cams/buildable_checks.h"
#include "machines/cams/cam_tables.h"
#include "machines/cams/cams.h"
#include "machines/cams/drawn_responses.h"
#include "machines/cams/duty_responses.h"
#include "machines/cams/follower_responses.h"
#include "machines/cams/roller_responses.h"
#include "machines/model/append.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {

template <>
struct MachineTraits<OscillatingEndCam> {
  static const std::vector<MechanismParameter>& parameters();
  template <class T>
  static constexpr std::array fields{
      &OscillatingEndCam<T>::swing,           &OscillatingEndCam<T>::radius,
      &OscillatingEndCam<T>::arm_length,      &OscillatingEndCam<T>::tilt,
      &OscillatingEndCam<T>::roller_radius,   &OscillatingEndCam<T>::angular_speed,
      &OscillatingEndCam<T>::inertia,         &OscillatingEndCam<T>::spring_rate,
      &OscillatingEndCam<T>::spring_preload,  &OscillatingEndCam<T>::load,
      &OscillatingEndCam<T>::face_width,      &OscillatingEndCam<T>::youngs_modulus,
      &OscillatingEndCam<T>::poisson_ratio,   &OscillatingEndCam<T>::cutter_radius,
      &OscillatingEndCam<T>::train_stiffness, &OscillatingEndCam<T>::train_damping,
      &OscillatingEndCam<T>::end_share};
  template <class T>
  static constexpr auto part = &OscillatingEndCam<T>::duty;
};

const std::vector<MechanismParameter>& MachineTraits<OscillatingEndCam>::parameters() {
  static const Parameters all =
      joined({swing_parameter(),
              {{"radius", "R", "mm", "m", "mean radius of the roller's track", 50, 1e-3, 1e5},
               {"arm_length", "l", "mm", "m", "length of the arm", 80, 1e-3, 1e5},
               {"tilt", "beta", "deg", "rad",
                "angle between the arm at mid-swing and the circumferential direction; at 0 the "
                "arm is square to the cam's axis",
                0, -89, 89}},
              roller_parameter(),
              speed_parameter(),
              oscillating_load(0, 0),
              contact_parameters(),
              cutter_parameter(),
              oscillating_train(),
              duty_parameters()});
  return all;
}

Mechanism oscillating_end_cam_mechanism() {
  std::vector<MechanismResponse> responses = follower_responses<OscillatingEndCam>(kOscillating);
  append(responses, roller_responses<OscillatingEndCam>());
  append(responses, duty_responses<OscillatingEndCam>());
  append(responses, drawn_responses<OscillatingEndCam>(true));
  return checked({.name = "end-cam-oscillating",
                  .title = "end or barrel cam with an oscillating roller arm",
                  .source = "docs/theory.md, Cams",
                  .parameters = MachineTraits<OscillatingEndCam>::parameters(),
                  .responses = std::move(responses),
                  .peaks = {peak_pressure_angle(), peak_undercut(), peak_torque(), peak_stress(),
                            least_torque(), peak_outer_undercut(), peak_groove_stress(),
                            peak_end_deviation(), least_elastic(kOscillating)},
                  .moved_by = MovedBy::Program,
                  .form = Form::EndArm,
                  .why_impossible = why_impossible_as<OscillatingEndCam>},
                 {roller_checks(), force_closure_checks(kOscillating), roller_stress_checks()});
}

}  // namespace camlaw::problems
