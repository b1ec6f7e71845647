// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "machines/cams/crown_responses.h"
#include "machines/cams/drawn_responses.h"
#include "machines/cams/roller_responses.h"

/// Two flanks of which one drives and the other holds: of a pair of conjugate cams, or of the cams
/// of an index drive.
namespace camlaw::problems {

enum class OfPair { Main, Second };
enum class Bearing { Force, Stress };

/// formula(flank), or, where rollers serve one after the other, formula(that which does).
template <class Flank, class X, class F>
X on_flank(const Flank& flank, const FollowerMotion<X>& f, F formula) {
  if constexpr (requires { flank.of_roller(f, formula); }) {
    return flank.of_roller(f, formula);
  } else {
    return formula(flank);
  }
}

/// Geometry of the main flank or, with its own motion, of the second one.
template <template <class> class M>
MechanismResponse pair_geometry(OfPair of, RollerCurve which, ResponseAbout about) {
  return listed_curve<M>(
      std::move(about), turn_of_the_cam(), std::pair(of, which),
      [](const auto& cam, std::pair<OfPair, RollerCurve> wanted, const auto& motion) {
        const auto f = cam.over_angle(motion);
        const auto geometry = [&](const auto& flank, const auto& own) {
          return on_flank(flank, own, [&](const auto& roller) {
            return roller_geometry(roller, wanted.second, own);
          });
        };
        return wanted.first == OfPair::Main ? geometry(cam.main(), f)
                                            : geometry(cam.second(), cam.second_motion(f));
      });
}

template <template <class> class M>
void add_pair_geometry(std::vector<MechanismResponse>& all, OfPair which, const std::string& name) {
  const std::string prefix = which == OfPair::Main ? "" : "second_", of = " of the " + name;
  const auto add = [&](RollerCurve curve, const char* short_name, const char* unit,
                       const char* stored, const std::string& meaning) {
    all.push_back(pair_geometry<M>(which, curve, {prefix + short_name, unit, stored, meaning}));
  };
  using C = RollerCurve;
  add(C::PressureAngle, "pressure_angle", "deg", "rad",
      "pressure angle" + of + ", with the sign of the slope of its own motion");
  add(C::Undercut, "undercut", "1", "1",
      "roller radius over the pitch curve's radius of curvature" + of + "; at 1 it is undercut");
  add(C::PitchCurvature, "pitch_curvature", "1/mm", "1/m",
      "curvature of the pitch curve" + of + ", positive where convex");
  add(C::ProfileCurvature, "profile_curvature", "1/mm", "1/m",
      "curvature of the profile" + of + ", positive where convex");
  add(C::ToolFit, "tool_fit", "1", "1",
      "tool radius over the radius of a hollow" + of + "; above 1 the tool does not fit");
}

/// What a machine M with main(), second(), second_motion(), contact_force() and contact_stress()
/// has, the two flanks by the names given.
template <template <class> class M>
std::vector<MechanismResponse> pair_responses(const std::string& main, const std::string& second) {
  std::vector<MechanismResponse> all;
  add_pair_geometry<M>(all, OfPair::Main, main);
  add_pair_geometry<M>(all, OfPair::Second, second);
  const auto bearing = [&](Bearing which, ResponseAbout about) {
    all.push_back(listed_curve<M>(std::move(about), turn_of_the_cam(), which,
                                  [](const auto& cam, Bearing wanted, const auto& motion) {
                                    const auto f = cam.over_angle(motion);
                                    return wanted == Bearing::Force ? cam.contact_force(f)
                                                                    : cam.contact_stress(f);
                                  }));
  };
  const std::string first = main.substr(0, main.find(' '));   // "main", "driving"
  const std::string both = main.substr(main.rfind(' ') + 1);  // "cam", "flank"
  bearing(Bearing::Force, {"contact_force", "N", "N",
                           "force between the loaded " + both +
                               " and its roller, positive where that is the " + first + " one"});
  bearing(Bearing::Stress,
          {"contact_stress", "MPa", "Pa", "greatest Hertz pressure on the loaded " + both});
  for (const char* undercut : {"undercut", "second_undercut"}) {
    set_defined_while(all, {"contact_stress"}, {.response = undercut, .upper = 1});
  }
  return all;
}

/// Of a machine M with crown(): of the roller on the flank that bears.
template <template <class> class M>
std::vector<MechanismResponse> pair_crown_responses() {
  return crown_responses<M>(
      {"undercut", "second_undercut"},
      [](const auto& cam, CrownCurve which, const auto& f) { return cam.crown(which, f); });
}

template <template <class> class M>
std::vector<MechanismResponse> second_profile(const char* meaning) {
  return {drawn_response<M>(DrawnCurve::SecondX, "second_profile_x", meaning),
          drawn_response<M>(DrawnCurve::SecondY, "second_profile_y", meaning)};
}

/// A named peak of the second flank.
inline NamedPeak of_second(NamedPeak peak, const char* second) {
  const bool is_peak = peak.name.starts_with("peak");
  return {is_peak ? peak.name.replace(0, std::string("peak").size(), "peak_second")
                  : "second_" + peak.name,
          "second_" + peak.curve, peak.part, peak.meaning + ", for the " + second};
}

}  // namespace camlaw::problems
