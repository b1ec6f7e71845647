// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_curve.h"
#include "machines/cams/cam_motion.h"
#include "machines/contact/hertz.h"
#include "machines/contact/lubricant.h"
#include "numerics/formula/expression.h"

/// What all flat-faced followers have in common, on a machine with profile_radius(),
/// contact_force(), contact_stress(), contact_half_width(), entrainment_speed() and lubricant().
namespace camlaw::problems {

/// (RB7) Film between face and cam, m: 0 where the mean of both surfaces stands still beside
/// the contact.
template <class Cam>
Expression film_of_face(const Cam& cam, const FollowerMotion& f) {
  return cam.lubricant().film(cam.contact_force(f) / cam.face_width, 1 / cam.profile_radius(f),
                              absolute(cam.entrainment_speed(f)), cam.contact().plane_modulus());
}

template <class M>
MechanismResponse profile_radius_response() {
  return cam_curve<M>(
      {"profile_radius", "mm", "m",
       "radius of curvature of the profile; the cam can be made while it is above 0"},
      [](const auto& cam, const auto& f) { return cam.profile_radius(f); });
}

template <class M>
std::vector<MechanismResponse> face_contact_responses() {
  std::vector<MechanismResponse> all{
      cam_curve<M>({"contact_stress", "MPa", "Pa", "greatest Hertz pressure between face and cam"},
                   [](const auto& cam, const auto& f) { return cam.contact_stress(f); }),
      cam_curve<M>({"contact_half_width", "mm", "m", "half the width of the contact"},
                   [](const auto& cam, const auto& f) { return cam.contact_half_width(f); }),
      cam_curve<M>({"max_shear", "MPa", "Pa",
                    "greatest shear stress below the surface, of face and cam in line contact "
                    "without friction"},
                   [](const auto& cam, const auto& f) { return max_shear(cam.contact_stress(f)); }),
      cam_curve<M>(
          {"shear_depth", "mm", "m", "depth of the greatest shear stress below the surface"},
          [](const auto& cam, const auto& f) { return shear_depth(cam.contact_half_width(f)); }),
      cam_curve<M>({"entrainment_speed", "m/s", "m/s",
                    "mean speed of both surfaces towards the contact; where it changes sign, no "
                    "oil is drawn in"},
                   [](const auto& cam, const auto& f) { return cam.entrainment_speed(f); }),
      cam_curve<M>({"film_thickness", "um", "m",
                    "least thickness of the lubricant film between face and cam"},
                   [](const auto& cam, const auto& f) { return film_of_face(cam, f); }),
      cam_curve<M>(
          {"lambda_ratio", "1", "1",
           "film thickness over the roughness of both surfaces; below 1 they touch"},
          [](const auto& cam, const auto& f) { return film_of_face(cam, f) / cam.roughness; })};
  for (const char* of_contact : {"contact_stress", "contact_half_width", "max_shear", "shear_depth",
                                 "film_thickness", "lambda_ratio"}) {
    set_defined_while(all, {of_contact}, {.response = "profile_radius", .lower = 0});
    set_defined_while(all, {of_contact}, {.response = "contact_force", .lower = 0});
  }
  return all;
}

}  // namespace camlaw::problems
