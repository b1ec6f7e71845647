// SPDX-License-Identifier: MIT
#include "machines/cams/flat_cam.h"

#include "machines/cams/buildable_checks.h"
#include "machines/cams/cam_tables.h"
#include "machines/cams/cams.h"
#include "machines/cams/extent_responses.h"
#include "machines/cams/face_responses.h"
#include "machines/cams/follower_responses.h"
#include "machines/cams/guide_response.h"
#include "machines/cams/sliding_responses.h"
#include "machines/model/append.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {

template <>
struct MachineTraits<FlatCam> {
  static const std::vector<MechanismParameter>& parameters();
  template <class T>
  static constexpr std::array fields{&FlatCam<T>::stroke,
                                     &FlatCam<T>::base_radius,
                                     &FlatCam<T>::angular_speed,
                                     &FlatCam<T>::mass,
                                     &FlatCam<T>::spring_rate,
                                     &FlatCam<T>::spring_preload,
                                     &FlatCam<T>::load,
                                     &FlatCam<T>::face_width,
                                     &FlatCam<T>::youngs_modulus,
                                     &FlatCam<T>::poisson_ratio,
                                     &FlatCam<T>::density,
                                     &FlatCam<T>::bore_radius,
                                     &FlatCam<T>::wear_coefficient,
                                     &FlatCam<T>::guide_friction,
                                     &FlatCam<T>::guide_length,
                                     &FlatCam<T>::train_stiffness,
                                     &FlatCam<T>::train_damping,
                                     &FlatCam<T>::end_share,
                                     &FlatCam<T>::viscosity,
                                     &FlatCam<T>::pressure_viscosity,
                                     &FlatCam<T>::roughness};
};

const std::vector<MechanismParameter>& MachineTraits<FlatCam>::parameters() {
  static const Parameters all =
      joined({stroke_parameter(), base_parameter(), speed_parameter(), sliding_load(5, 50),
              contact_parameters(), blank_parameters(), wear_parameter(), friction_parameters(),
              sliding_train(), lubricant_parameters()});
  return all;
}

namespace {

using optim::Part;

enum class FlatCurve { ContactOffset, ContactForce };

MechanismResponse flat_curve(FlatCurve which, ResponseAbout about) {
  return listed_curve<FlatCam>(std::move(about), turn_of_the_cam(), which,
                               [](const auto& cam, FlatCurve wanted, const auto& motion) {
                                 const auto f = cam.over_angle(motion);
                                 return wanted == FlatCurve::ContactOffset ? cam.contact_offset(f)
                                                                           : cam.contact_force(f);
                               });
}

}  // namespace

Mechanism flat_cam_mechanism() {
  std::vector<MechanismResponse> responses = follower_responses<FlatCam>(kSliding);
  responses.push_back(flat_curve(
      FlatCurve::ContactOffset, {"contact_offset", "mm", "m",
                                 "position of the contact on the face, from the follower's axis"}));
  responses.push_back(flat_curve(FlatCurve::ContactForce,
                                 {"contact_force", "N", "N", "force between face and cam"}));
  responses.push_back(profile_radius_response<FlatCam>());
  append(responses, face_contact_responses<FlatCam>());
  append(responses, sliding_responses<FlatCam>({"follower_force", "profile_radius"}));
  responses.push_back(guide_response<FlatCam>());
  append(responses, drawn_responses<FlatCam>(false));
  append(responses, blank_responses<FlatCam>());
  append(responses, extent_responses<FlatCam>());
  return checked({.name = "disc-cam-flat",
                  .title = "disc cam with a translating flat-faced follower",
                  .source = "docs/theory.md, Cams",
                  .parameters = MachineTraits<FlatCam>::parameters(),
                  .responses = std::move(responses),
                  .peaks = {{"least_profile_radius", "profile_radius", Part::Lowest,
                             "least radius of curvature of the profile"},
                            {"face_half_width", "contact_offset", Part::Magnitude,
                             "how far the face must extend from the follower's axis"},
                            least_force(),
                            peak_force(),
                            peak_torque(),
                            peak_stress(),
                            outer_radius(),
                            least_wall(),
                            peak_end_deviation(),
                            least_elastic(kSliding)},
                  .moved_by = MovedBy::Program,
                  .form = Form::DiscFlat,
                  .why_impossible = why_impossible_as<FlatCam>},
                 {face_checks(), force_closure_checks(kSliding), wall_checks(), stress_checks(),
                  guide_checks()});
}

}  // namespace camlaw::problems
