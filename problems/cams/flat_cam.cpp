// SPDX-License-Identifier: MIT
#include "kinematics/cams/flat_cam.h"

#include "problems/cams/cam_tables.h"
#include "problems/cams/cams.h"
#include "problems/cams/drawn_responses.h"
#include "problems/cams/follower_responses.h"

namespace camlaw::problems {

template <>
struct MachineTraits<FlatCam> {
  static const std::vector<MechanismParameter>& parameters();
  template <class T>
  static constexpr std::array fields{
      &FlatCam<T>::stroke,        &FlatCam<T>::base_radius, &FlatCam<T>::angular_speed,
      &FlatCam<T>::mass,          &FlatCam<T>::spring_rate, &FlatCam<T>::spring_preload,
      &FlatCam<T>::load,          &FlatCam<T>::face_width,  &FlatCam<T>::youngs_modulus,
      &FlatCam<T>::poisson_ratio, &FlatCam<T>::density,     &FlatCam<T>::bore_radius};
};

const std::vector<MechanismParameter>& MachineTraits<FlatCam>::parameters() {
  static const Parameters all =
      joined({stroke_parameter(), base_parameter(), speed_parameter(), sliding_load(5, 50),
              contact_parameters(), blank_parameters()});
  return all;
}

namespace {

using optim::Part;
using S = optim::Shape;

enum class Curve { ContactOffset, ProfileRadius, ContactStress, ContactHalfWidth };

MechanismResponse curve(Curve which, ResponseAbout about) {
  return listed_curve<FlatCam>(std::move(about), turn_of_the_cam(), which,
                               [](const auto& cam, Curve wanted, const auto& motion) {
                                 const auto f = cam.over_angle(motion);
                                 switch (wanted) {
                                   case Curve::ContactOffset:
                                     return cam.contact_offset(f);
                                   case Curve::ProfileRadius:
                                     return cam.profile_radius(f);
                                   case Curve::ContactStress:
                                     return cam.contact_stress(f);
                                   case Curve::ContactHalfWidth:
                                     break;
                                 }
                                 return cam.contact_half_width(f);
                               });
}

}  // namespace

Mechanism flat_cam_mechanism() {
  std::vector<MechanismResponse> responses = follower_responses<FlatCam>(kSliding);
  responses.push_back(
      curve(Curve::ContactOffset, {"contact_offset",
                                   "mm",
                                   "m",
                                   "where the face touches, from the follower's axis",
                                   {{{"law"}, S::Linear}, {{"stroke"}, S::Linear}}}));
  responses.push_back(
      curve(Curve::ProfileRadius,
            {"profile_radius",
             "mm",
             "m",
             "radius of curvature of the profile; the cam can be made while it is above 0",
             {{{"law", "base_radius"}, S::Linear}, {{"stroke", "base_radius"}, S::Linear}}}));
  responses.push_back(
      curve(Curve::ContactStress,
            {"contact_stress", "MPa", "Pa", "greatest Hertz pressure between face and cam"}));
  responses.push_back(curve(Curve::ContactHalfWidth,
                            {"contact_half_width", "mm", "m", "half the width of the contact"}));
  append(responses, drawn_responses<FlatCam>(false));
  append(responses, blank_responses<FlatCam>());
  return {.name = "disc-cam-flat",
          .title = "disc cam with a translating flat-faced follower",
          .source = "docs/theory.md, Cams",
          .parameters = MachineTraits<FlatCam>::parameters(),
          .responses = std::move(responses),
          .peaks = {{"least_profile_radius", "profile_radius", Part::Lowest,
                     "least radius of curvature of the profile"},
                    {"face_half_width", "contact_offset", Part::Magnitude,
                     "how far the face must reach"},
                    least_force(),
                    peak_force(),
                    peak_torque(),
                    peak_stress()},
          .moved_by = MovedBy::Program};
}

}  // namespace camlaw::problems
