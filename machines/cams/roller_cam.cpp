// SPDX-License-Identifier: MIT
#include "machines/cams/roller_cam.h"

#include "machines/cams/buildable_checks.h"
#include "machines/cams/cam_tables.h"
#include "machines/cams/cams.h"
#include "machines/cams/duty_responses.h"
#include "machines/cams/extent_responses.h"
#include "machines/cams/follower_responses.h"
#include "machines/cams/guide_response.h"
#include "machines/cams/roller_responses.h"
#include "machines/model/append.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {

template <>
struct MachineTraits<RollerCam> {
  static const std::vector<MechanismParameter>& parameters();
  template <class T>
  static constexpr std::array fields{
      &RollerCam<T>::stroke,          &RollerCam<T>::base_radius,    &RollerCam<T>::roller_radius,
      &RollerCam<T>::offset,          &RollerCam<T>::angular_speed,  &RollerCam<T>::mass,
      &RollerCam<T>::spring_rate,     &RollerCam<T>::spring_preload, &RollerCam<T>::load,
      &RollerCam<T>::face_width,      &RollerCam<T>::youngs_modulus, &RollerCam<T>::poisson_ratio,
      &RollerCam<T>::cutter_radius,   &RollerCam<T>::density,        &RollerCam<T>::bore_radius,
      &RollerCam<T>::guide_friction,  &RollerCam<T>::guide_length,   &RollerCam<T>::overhang,
      &RollerCam<T>::train_stiffness, &RollerCam<T>::train_damping,  &RollerCam<T>::end_share};
  template <class T>
  static constexpr auto part = &RollerCam<T>::duty;
};

const std::vector<MechanismParameter>& MachineTraits<RollerCam>::parameters() {
  static const Parameters all =
      joined({stroke_parameter(), base_parameter(), roller_parameter(), offset_parameter(),
              speed_parameter(), sliding_load(5, 50), contact_parameters(), cutter_parameter(),
              blank_parameters(), guide_parameters(), sliding_train(), duty_parameters()});
  return all;
}

Mechanism roller_cam_mechanism() {
  std::vector<MechanismResponse> responses = follower_responses<RollerCam>(kSliding);
  append(responses, roller_responses<RollerCam>());
  append(responses, duty_responses<RollerCam>());
  responses.push_back(guide_response<RollerCam>());
  responses.push_back(overhang_response<RollerCam>());
  append(responses, drawn_responses<RollerCam>(true));
  append(responses, blank_responses<RollerCam>());
  append(responses, extent_responses<RollerCam>());
  return checked(
      {.name = "disc-cam-roller",
       .title = "disc cam with a translating roller follower",
       .source = "docs/theory.md, Cams",
       .parameters = MachineTraits<RollerCam>::parameters(),
       .responses = std::move(responses),
       .peaks = {peak_pressure_angle(), peak_undercut(), least_force(), peak_force(), peak_torque(),
                 peak_stress(), peak_outer_undercut(), peak_groove_stress(), outer_radius(),
                 least_wall(), peak_end_deviation(), least_elastic(kSliding)},
       .moved_by = MovedBy::Program,
       .validity = {outside_guide()},
       .form = Form::DiscRoller,
       .why_impossible = why_impossible_as<RollerCam>},
      {roller_checks(), force_closure_checks(kSliding), wall_checks(), roller_stress_checks(),
       guide_checks()});
}

}  // namespace camlaw::problems
