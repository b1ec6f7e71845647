// SPDX-License-Identifier: MIT
#include "machines/cams/end_cam.h"

#include "machines/cams/buildable_checks.h"
#include "machines/cams/cam_tables.h"
#include "machines/cams/cams.h"
#include "machines/cams/drawn_responses.h"
#include "machines/cams/duty_responses.h"
#include "machines/cams/follower_responses.h"
#include "machines/cams/guide_response.h"
#include "machines/cams/roller_responses.h"
#include "machines/model/append.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {

template <>
struct MachineTraits<EndCam> {
  static const std::vector<MechanismParameter>& parameters();
  template <class T>
  static constexpr std::array fields{
      &EndCam<T>::stroke,          &EndCam<T>::radius,        &EndCam<T>::roller_radius,
      &EndCam<T>::angular_speed,   &EndCam<T>::mass,          &EndCam<T>::spring_rate,
      &EndCam<T>::spring_preload,  &EndCam<T>::load,          &EndCam<T>::face_width,
      &EndCam<T>::youngs_modulus,  &EndCam<T>::poisson_ratio, &EndCam<T>::cutter_radius,
      &EndCam<T>::guide_friction,  &EndCam<T>::guide_length,  &EndCam<T>::overhang,
      &EndCam<T>::train_stiffness, &EndCam<T>::train_damping, &EndCam<T>::end_share};
  template <class T>
  static constexpr auto part = &EndCam<T>::duty;
};

const std::vector<MechanismParameter>& MachineTraits<EndCam>::parameters() {
  static const Parameters all =
      joined({stroke_parameter(),
              {{"radius", "R", "mm", "m", "mean radius of the roller's track", 50, 1e-3, 1e5}},
              roller_parameter(),
              speed_parameter(),
              sliding_load(0, 0),
              contact_parameters(),
              cutter_parameter(),
              guide_parameters(),
              sliding_train(),
              duty_parameters()});
  return all;
}

Mechanism end_cam_mechanism() {
  std::vector<MechanismResponse> responses = follower_responses<EndCam>(kSliding);
  append(responses, roller_responses<EndCam>());
  append(responses, duty_responses<EndCam>());
  responses.push_back(guide_response<EndCam>());
  responses.push_back(overhang_response<EndCam>());
  append(responses, drawn_responses<EndCam>(true));
  return checked(
      {.name = "end-cam",
       .title = "end or barrel cam with a roller that moves along its axis",
       .source = "docs/theory.md, Cams",
       .parameters = MachineTraits<EndCam>::parameters(),
       .responses = std::move(responses),
       .peaks = {peak_pressure_angle(), peak_undercut(), least_force(), peak_force(), peak_torque(),
                 peak_stress(), peak_outer_undercut(), peak_groove_stress(), peak_end_deviation(),
                 least_elastic(kSliding)},
       .moved_by = MovedBy::Program,
       .validity = {outside_guide()},
       .form = Form::EndRoller,
       .why_impossible = why_impossible_as<EndCam>},
      {roller_checks(), force_closure_checks(kSliding), roller_stress_checks(), guide_checks()});
}

}  // namespace camlaw::problems
