// SPDX-License-Identifier: MIT
#pragma once

#include "machines/contact/crowned_roller.h"
#include "machines/model/listed_responses.h"

/// Shear below the surface of a roller's contact, the contact of a crowned roller, and the films
/// of both.
namespace camlaw::problems {

/// Of a machine M with over_angle(), from formula(machine, CrownCurve, motion of the follower).
/// They count while these undercuts are at most 1.
template <template <class> class M, class F>
std::vector<MechanismResponse> crown_responses(const std::vector<std::string>& undercuts,
                                               F formula) {
  std::vector<MechanismResponse> all;
  const auto add = [&](CrownCurve which, ResponseAbout about) {
    all.push_back(listed_curve<M>(std::move(about), turn_of_the_cam(), which,
                                  [formula](const auto& cam, CrownCurve curve, const auto& motion) {
                                    return formula(cam, curve, cam.over_angle(motion));
                                  }));
    for (const std::string& undercut : undercuts) {
      all.back().defined_while.push_back({.response = undercut, .upper = 1});
    }
  };
  using C = CrownCurve;
  add(C::MaxShear, {"max_shear", "MPa", "Pa",
                    "greatest shear stress below the surface, of roller and "
                    "cam in line contact"});
  add(C::ShearDepth,
      {"shear_depth", "mm", "m", "depth of the greatest shear stress below the surface"});
  add(C::Stress, {"crown_stress", "MPa", "Pa",
                  "greatest Hertz pressure between a crowned roller and the cam"});
  add(C::Shear, {"crown_shear", "MPa", "Pa",
                 "greatest shear stress below the surface, on the axis of a crowned roller's "
                 "contact"});
  add(C::DepthOfShear, {"crown_shear_depth", "mm", "m",
                        "depth of the greatest shear stress below a crowned roller's contact"});
  add(C::HalfLength, {"crown_half_length", "mm", "m",
                      "half the length of the ellipse in which a crowned roller touches the cam"});
  add(C::Fraction, {"crown_fraction", "1", "1",
                    "length of a crowned roller's contact over the face width; above 1 the "
                    "roller's edges carry load"});
  add(C::Elongation,
      {"crown_elongation", "1", "1",
       "length over width of the ellipse in which a crowned roller touches the cam"});
  return all;
}

/// Of a machine M with over_angle(), from formula(machine, FilmCurve, motion of the follower), the
/// roller on its cam by the name given.
template <template <class> class M, class F>
std::vector<MechanismResponse> film_responses(const std::vector<std::string>& undercuts,
                                              const std::string& cam_name, F formula) {
  std::vector<MechanismResponse> all;
  const auto add = [&](FilmCurve which, ResponseAbout about) {
    all.push_back(listed_curve<M>(std::move(about), turn_of_the_cam(), which,
                                  [formula](const auto& cam, FilmCurve curve, const auto& motion) {
                                    return formula(cam, curve, cam.over_angle(motion));
                                  }));
    for (const std::string& undercut : undercuts) {
      all.back().defined_while.push_back({.response = undercut, .upper = 1});
    }
  };
  using C = FilmCurve;
  add(C::Thickness, {"film_thickness", "um", "m",
                     "least thickness of the lubricant film between roller and " + cam_name +
                         ", in line contact"});
  add(C::Lambda, {"lambda_ratio", "1", "1",
                  "film thickness of the line contact over the roughness of both surfaces; below "
                  "1 they touch"});
  add(C::CrownThickness,
      {"crown_film", "um", "m",
       "least thickness of the lubricant film between a crowned roller and the " + cam_name});
  add(C::CrownLambda, {"crown_lambda", "1", "1",
                       "film thickness of a crowned roller over the roughness of both surfaces; "
                       "below 1 they touch"});
  return all;
}

}  // namespace camlaw::problems
