// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/listed_responses.h"

/// What all flat-faced followers have in common, on a machine with profile_radius(),
/// contact_stress() and contact_half_width().
namespace camlaw::problems {

enum class FaceCurve { ProfileRadius, ContactStress, ContactHalfWidth };

template <template <class> class M>
MechanismResponse face_response(FaceCurve which, ResponseAbout about) {
  return listed_curve<M>(std::move(about), turn_of_the_cam(), which,
                         [](const auto& cam, FaceCurve curve, const auto& motion) {
                           const auto f = cam.over_angle(motion);
                           if (curve == FaceCurve::ProfileRadius) return cam.profile_radius(f);
                           return curve == FaceCurve::ContactStress ? cam.contact_stress(f)
                                                                    : cam.contact_half_width(f);
                         });
}

template <template <class> class M>
MechanismResponse profile_radius_response() {
  return face_response<M>(
      FaceCurve::ProfileRadius,
      {"profile_radius", "mm", "m",
       "radius of curvature of the profile; the cam can be made while it is above 0"});
}

template <template <class> class M>
std::vector<MechanismResponse> face_contact_responses() {
  std::vector<MechanismResponse> all{
      face_response<M>(FaceCurve::ContactStress, {"contact_stress", "MPa", "Pa",
                                                  "greatest Hertz pressure between face and cam"}),
      face_response<M>(FaceCurve::ContactHalfWidth,
                       {"contact_half_width", "mm", "m", "half the width of the contact"})};
  set_defined_while(all, {"contact_stress", "contact_half_width"},
                    {.response = "profile_radius", .lower = 0});
  return all;
}

}  // namespace camlaw::problems
