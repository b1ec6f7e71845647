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

/// formula(flank), or, where rollers serve one after the other, formula(that which does).
template <class Flank, class F>
Expression on_flank(const Flank& flank, const FollowerMotion& f, F formula) {
  if constexpr (requires { flank.of_roller(f, formula); }) {
    return flank.of_roller(f, formula);
  } else {
    return formula(flank);
  }
}

/// Geometry of the main flank or, with its own motion, of the second one: formula(roller, motion).
template <class M, class F>
MechanismResponse pair_geometry(OfPair of, ResponseAbout about, F formula) {
  return cam_curve<M>(std::move(about), [of, formula](const auto& cam, const auto& f) {
    const auto geometry = [&](const auto& flank, const auto& own) {
      return on_flank(flank, own, [&](const auto& roller) { return formula(roller, own); });
    };
    return of == OfPair::Main ? geometry(cam.main(), f)
                              : geometry(cam.second(), cam.second_motion(f));
  });
}

template <class M>
void add_pair_geometry(std::vector<MechanismResponse>& all, OfPair which, const std::string& name) {
  const std::string prefix = which == OfPair::Main ? "" : "second_", of = " of the " + name;
  const auto add = [&](const char* short_name, const char* unit, const char* stored,
                       const std::string& meaning, auto formula) {
    all.push_back(pair_geometry<M>(which, {prefix + short_name, unit, stored, meaning}, formula));
  };
  add("pressure_angle", "deg", "rad",
      "pressure angle" + of + ", with the sign of the slope of its own motion",
      [](const auto& flank, const auto& f) { return flank.pressure_angle(f); });
  add("undercut", "1", "1",
      "roller radius over the pitch curve's radius of curvature" + of + "; at 1 it is undercut",
      [](const auto& flank, const auto& f) {
        return flank.roller().undercut(pitch_curvature(flank, f));
      });
  add("pitch_curvature", "1/mm", "1/m",
      "curvature of the pitch curve" + of + ", positive where convex",
      [](const auto& flank, const auto& f) { return pitch_curvature(flank, f); });
  add("profile_curvature", "1/mm", "1/m",
      "curvature of the profile" + of + ", positive where convex",
      [](const auto& flank, const auto& f) {
        return flank.roller().profile_curvature(pitch_curvature(flank, f));
      });
  add("tool_fit", "1", "1",
      "tool radius over the radius of a hollow" + of + "; above 1 the tool does not fit",
      [](const auto& flank, const auto& f) {
        return flank.roller().tool_fit(pitch_curvature(flank, f));
      });
}

/// What a machine M with main(), second(), second_motion(), contact_force() and contact_stress()
/// has, the two flanks by the names given.
template <class M>
std::vector<MechanismResponse> pair_responses(const std::string& main, const std::string& second) {
  std::vector<MechanismResponse> all;
  add_pair_geometry<M>(all, OfPair::Main, main);
  add_pair_geometry<M>(all, OfPair::Second, second);
  const std::string first = main.substr(0, main.find(' '));   // "main", "driving"
  const std::string both = main.substr(main.rfind(' ') + 1);  // "cam", "flank"
  all.push_back(cam_curve<M>({"contact_force", "N", "N",
                              "force between the loaded " + both +
                                  " and its roller, positive where that is the " + first + " one"},
                             [](const auto& cam, const auto& f) { return cam.contact_force(f); }));
  all.push_back(
      cam_curve<M>({"contact_stress", "MPa", "Pa", "greatest Hertz pressure on the loaded " + both},
                   [](const auto& cam, const auto& f) { return cam.contact_stress(f); }));
  for (const char* undercut : {"undercut", "second_undercut"}) {
    set_defined_while(all, {"contact_stress"}, {.response = undercut, .upper = 1});
  }
  return all;
}

/// Of a machine M with of_pressed(): of the roller on the flank that bears.
template <class M>
std::vector<MechanismResponse> pair_crown_responses() {
  return crown_responses<M>({"undercut", "second_undercut"},
                            [](const auto& cam, const auto& f, const auto& formula) {
                              return cam.of_pressed(f, formula);
                            });
}

template <class M>
std::vector<MechanismResponse> second_profile(const char* meaning) {
  return drawn_curve<M>("second_profile", meaning,
                        [](const auto& cam, const auto& f) { return cam.second_profile(f); });
}

/// A named peak of the second flank.
inline NamedPeak of_second(NamedPeak peak, const char* second) {
  const bool is_peak = peak.name.starts_with("peak");
  return {is_peak ? peak.name.replace(0, std::string("peak").size(), "peak_second")
                  : "second_" + peak.name,
          "second_" + peak.curve, peak.part, peak.meaning + ", for the " + second};
}

}  // namespace camlaw::problems
