// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_curve.h"
#include "machines/contact/crowned_roller.h"

/// Shear below the surface of a roller's contact, the contact of a crowned roller, and the films
/// of both.
namespace camlaw::problems {

/// Of a machine M with over_angle(), from of_pressed(machine, f, formula), which is
/// formula(PressedRoller) of the roller that bears at the motion f. They count while these
/// undercuts are at most 1.
template <class M, class OfPressed>
std::vector<MechanismResponse> crown_responses(const std::vector<std::string>& undercuts,
                                               OfPressed of_pressed) {
  std::vector<MechanismResponse> all;
  const auto add = [&](ResponseAbout about, auto formula) {
    all.push_back(
        cam_curve<M>(std::move(about), [of_pressed, formula](const auto& cam, const auto& f) {
          return of_pressed(cam, f, formula);
        }));
    for (const std::string& undercut : undercuts) {
      all.back().defined_while.push_back({.response = undercut, .upper = 1});
    }
  };
  add({"max_shear", "MPa", "Pa",
       "greatest shear stress below the surface, of roller and cam in line contact"},
      [](const auto& roller) { return roller.line_shear(); });
  add({"shear_depth", "mm", "m", "depth of the greatest shear stress below the surface"},
      [](const auto& roller) { return roller.line_shear_depth(); });
  add({"crown_stress", "MPa", "Pa", "greatest Hertz pressure between a crowned roller and the cam"},
      [](const auto& roller) { return roller.ellipse().pressure; });
  add({"crown_shear", "MPa", "Pa",
       "greatest shear stress below the surface, on the axis of a crowned roller's contact"},
      [](const auto& roller) { return roller.shear(); });
  add({"crown_shear_depth", "mm", "m",
       "depth of the greatest shear stress below a crowned roller's contact"},
      [](const auto& roller) { return roller.depth_of_shear(); });
  add({"crown_half_length", "mm", "m",
       "half the length of the ellipse in which a crowned roller touches the cam"},
      [](const auto& roller) { return roller.ellipse().half_length; });
  add({"crown_fraction", "1", "1",
       "length of a crowned roller's contact over the face width; above 1 the roller's edges carry "
       "load"},
      [](const auto& roller) { return roller.crown_fraction(); });
  add({"crown_elongation", "1", "1",
       "length over width of the ellipse in which a crowned roller touches the cam"},
      [](const auto& roller) { return roller.ellipse().elongation; });
  return all;
}

/// Of a machine M with over_angle(), from of_film(machine, f, formula), which is
/// formula(RollerFilm) of the roller that bears at the motion f, on its cam by the name given.
template <class M, class OfFilm>
std::vector<MechanismResponse> film_responses(const std::vector<std::string>& undercuts,
                                              const std::string& cam_name, OfFilm of_film) {
  std::vector<MechanismResponse> all;
  const auto add = [&](ResponseAbout about, auto formula) {
    all.push_back(cam_curve<M>(
        std::move(about),
        [of_film, formula](const auto& cam, const auto& f) { return of_film(cam, f, formula); }));
    for (const std::string& undercut : undercuts) {
      all.back().defined_while.push_back({.response = undercut, .upper = 1});
    }
  };
  add({"film_thickness", "um", "m",
       "least thickness of the lubricant film between roller and " + cam_name +
           ", in line contact"},
      [](const auto& between) { return between.of_line(); });
  add({"lambda_ratio", "1", "1",
       "film thickness of the line contact over the roughness of both surfaces; below 1 they "
       "touch"},
      [](const auto& between) { return between.of_line() / between.oil.roughness; });
  add({"crown_film", "um", "m",
       "least thickness of the lubricant film between a crowned roller and the " + cam_name},
      [](const auto& between) { return between.of_crown(); });
  add({"crown_lambda", "1", "1",
       "film thickness of a crowned roller over the roughness of both surfaces; below 1 they "
       "touch"},
      [](const auto& between) { return between.of_crown() / between.oil.roughness; });
  return all;
}

}  // namespace camlaw::problems
