// SPDX-License-Identifier: MIT
#include "machines/cams/arm_clearance.h"
#include "machines/cams/buildable_checks.h"
#include "machines/cams/cam_tables.h"
#include "machines/cams/cams.h"
#include "machines/cams/duty_responses.h"
#include "machines/cams/extent_responses.h"
#include "machines/cams/follower_responses.h"
#include "machines/cams/leading_roller_cam.h"
#include "machines/cams/roller_responses.h"
#include "machines/model/append.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {

template <>
struct MachineTraits<OscillatingRollerCam> {
  static const std::vector<MechanismParameter>& parameters();
  template <class T>
  static constexpr std::array fields{
      &OscillatingRollerCam<T>::swing,           &OscillatingRollerCam<T>::base_radius,
      &OscillatingRollerCam<T>::roller_radius,   &OscillatingRollerCam<T>::arm_length,
      &OscillatingRollerCam<T>::pivot_distance,  &OscillatingRollerCam<T>::angular_speed,
      &OscillatingRollerCam<T>::inertia,         &OscillatingRollerCam<T>::spring_rate,
      &OscillatingRollerCam<T>::spring_preload,  &OscillatingRollerCam<T>::load,
      &OscillatingRollerCam<T>::face_width,      &OscillatingRollerCam<T>::youngs_modulus,
      &OscillatingRollerCam<T>::poisson_ratio,   &OscillatingRollerCam<T>::cutter_radius,
      &OscillatingRollerCam<T>::density,         &OscillatingRollerCam<T>::bore_radius,
      &OscillatingRollerCam<T>::train_stiffness, &OscillatingRollerCam<T>::train_damping,
      &OscillatingRollerCam<T>::end_share};
  template <class T>
  static constexpr auto part = &OscillatingRollerCam<T>::duty;
};

const std::vector<MechanismParameter>& MachineTraits<OscillatingRollerCam>::parameters() {
  static const Parameters all =
      joined({swing_parameter(),
              base_parameter(),
              roller_parameter(),
              {{"arm_length", "l", "mm", "m", "length of the arm", 80, 1e-3, 1e5},
               {"pivot_distance", "d", "mm", "m",
                "distance of the arm's pivot from the cam's centre", 100, 1e-3, 1e5}},
              speed_parameter(),
              oscillating_load(0.2, 3),
              contact_parameters(),
              cutter_parameter(),
              blank_parameters(),
              oscillating_train(),
              duty_parameters()});
  return all;
}

/// The same fields, as members of the derived machine.
template <>
struct MachineTraits<LeadingRollerCam> {
  static const std::vector<MechanismParameter>& parameters() {
    return MachineTraits<OscillatingRollerCam>::parameters();
  }
  template <class T>
  static constexpr auto fields = [] {
    constexpr auto& base = MachineTraits<OscillatingRollerCam>::fields<T>;
    std::array<T LeadingRollerCam<T>::*, base.size()> all{};
    for (std::size_t i = 0; i < base.size(); ++i) all[i] = base[i];
    return all;
  }();
  template <class T>
  static constexpr auto part = &LeadingRollerCam<T>::duty;
};

namespace {

template <template <class> class M>
Mechanism oscillating_mechanism(const char* name, const char* title, Form form) {
  std::vector<MechanismResponse> responses = follower_responses<M>(kOscillating);
  append(responses, roller_responses<M>());
  append(responses, duty_responses<M>());
  append(responses, drawn_responses<M>(true));
  append(responses, blank_responses<M>());
  append(responses, extent_responses<M>());
  responses.push_back(arm_clearance_response<M>());
  return checked({.name = name,
                  .title = title,
                  .source = "docs/theory.md, Cams",
                  .parameters = MachineTraits<M>::parameters(),
                  .responses = std::move(responses),
                  .peaks = {peak_pressure_angle(), peak_undercut(), peak_torque(), peak_stress(),
                            least_torque(), peak_outer_undercut(), peak_groove_stress(),
                            outer_radius(), least_wall(), pivot_clearance(), peak_end_deviation(),
                            least_elastic(kOscillating)},
                  .moved_by = MovedBy::Program,
                  .form = form,
                  .why_impossible = why_impossible_as<M>},
                 {roller_checks(), force_closure_checks(kOscillating), wall_checks(),
                  pivot_checks(), arm_checks(), roller_stress_checks()});
}

}  // namespace

Mechanism oscillating_roller_cam_mechanism() {
  return oscillating_mechanism<OscillatingRollerCam>(
      "disc-cam-oscillating-roller", "disc cam with an oscillating roller follower, trailing",
      Form::DiscTrailingRoller);
}

Mechanism leading_roller_cam_mechanism() {
  return oscillating_mechanism<LeadingRollerCam>(
      "disc-cam-leading-roller", "disc cam with an oscillating roller follower, leading",
      Form::DiscLeadingRoller);
}

}  // namespace camlaw::problems
