// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_motion.h"
#include "machines/contact/hertz.h"
#include "machines/contact/lubricant.h"
#include "machines/model/listed_responses.h"
#include "numerics/scalar/absolute.h"

/// What all flat-faced followers have in common, on a machine with profile_radius(),
/// contact_force(), contact_stress(), contact_half_width(), entrainment_speed() and lubricant().
namespace camlaw::problems {

enum class FaceCurve {
  ProfileRadius,
  ContactStress,
  ContactHalfWidth,
  MaxShear,
  ShearDepth,
  EntrainmentSpeed,
  FilmThickness,
  LambdaRatio
};

/// (RB7) Film between face and cam, m: 0 where the mean of both surfaces stands still beside
/// the contact.
template <class Cam, class X>
X film_of_face(const Cam& cam, const FollowerMotion<X>& f) {
  return cam.lubricant().film(X(cam.contact_force(f) / cam.face_width),
                              X(number<X>(1) / cam.profile_radius(f)),
                              X(absolute(cam.entrainment_speed(f))), cam.contact().plane_modulus());
}

template <class Cam, class X>
X face_curve(const Cam& cam, FaceCurve which, const FollowerMotion<X>& f) {
  switch (which) {
    case FaceCurve::ProfileRadius:
      return cam.profile_radius(f);
    case FaceCurve::ContactStress:
      return cam.contact_stress(f);
    case FaceCurve::ContactHalfWidth:
      return cam.contact_half_width(f);
    case FaceCurve::MaxShear:
      return max_shear(X(cam.contact_stress(f)));
    case FaceCurve::ShearDepth:
      return shear_depth(X(cam.contact_half_width(f)));
    case FaceCurve::EntrainmentSpeed:
      return cam.entrainment_speed(f);
    case FaceCurve::FilmThickness:
      return film_of_face(cam, f);
    case FaceCurve::LambdaRatio:
      break;
  }
  return film_of_face(cam, f) / cam.roughness;
}

template <template <class> class M>
MechanismResponse face_response(FaceCurve which, ResponseAbout about) {
  return listed_curve<M>(std::move(about), turn_of_the_cam(), which,
                         [](const auto& cam, FaceCurve curve, const auto& motion) {
                           return face_curve(cam, curve, cam.over_angle(motion));
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
                       {"contact_half_width", "mm", "m", "half the width of the contact"}),
      face_response<M>(FaceCurve::MaxShear,
                       {"max_shear", "MPa", "Pa",
                        "greatest shear stress below the surface, of face and cam in line contact "
                        "without friction"}),
      face_response<M>(
          FaceCurve::ShearDepth,
          {"shear_depth", "mm", "m", "depth of the greatest shear stress below the surface"}),
      face_response<M>(FaceCurve::EntrainmentSpeed,
                       {"entrainment_speed", "m/s", "m/s",
                        "mean speed of both surfaces towards the contact; where it changes its "
                        "sign nothing renews the film"}),
      face_response<M>(FaceCurve::FilmThickness,
                       {"film_thickness", "um", "m",
                        "least thickness of the lubricant film between face and cam"}),
      face_response<M>(FaceCurve::LambdaRatio,
                       {"lambda_ratio", "1", "1",
                        "film thickness over the roughness of both surfaces; below 1 they touch"})};
  for (const char* of_contact : {"contact_stress", "contact_half_width", "max_shear", "shear_depth",
                                 "film_thickness", "lambda_ratio"}) {
    set_defined_while(all, {of_contact}, {.response = "profile_radius", .lower = 0});
    set_defined_while(all, {of_contact}, {.response = "contact_force", .lower = 0});
  }
  return all;
}

}  // namespace camlaw::problems
