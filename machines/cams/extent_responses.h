// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/drawn_responses.h"

/// How far a disc cam reaches, and what that leaves to its bore and to the pivot of its follower
/// (docs/theory.md, "Springs, walls and clearances").
namespace camlaw::problems {

/// Distance of the profile from the cam's centre; cams whose rollers change say it themselves.
template <class Cam>
Expression profile_distance(const Cam& cam, const FollowerMotion& f) {
  if constexpr (requires { cam.profile_distance(f); }) {
    return cam.profile_distance(f);
  } else {
    return profile_of(cam, f).distance();
  }
}

template <class Cam>
Expression second_profile_distance(const Cam& cam, const FollowerMotion& f) {
  if constexpr (requires { cam.second_profile_distance(f); }) {
    return cam.second_profile_distance(f);
  } else {
    return cam.second_profile(f).distance();
  }
}

/// Of a machine M with a bore_radius, and where it has that a pivot_distance and a second cam, or
/// what is called so.
template <class M>
std::vector<MechanismResponse> extent_responses(
    const std::string& second_profile = "second cam's profile") {
  std::vector<MechanismResponse> all{
      cam_curve<M>({"centre_distance", "mm", "m", "distance of the profile from the cam's centre"},
                   [](const auto& cam, const auto& f) { return profile_distance(cam, f); }),
      cam_curve<M>({"bore_gap", "mm", "m", "distance of the profile from the bore's edge"},
                   [](const auto& cam, const auto& f) {
                     return profile_distance(cam, f) - cam.bore_radius;
                   })};
  if constexpr (requires(const M& cam) { cam.pivot_distance; }) {  // (M42)
    all.push_back(cam_curve<M>(
        {"pivot_gap", "mm", "m",
         "clearance between the profile of the turning cam and the axis of the arm's pivot"},
        [](const auto& cam, const auto& f) {
          return -profile_distance(cam, f) + cam.pivot_distance;
        }));
  }
  if constexpr (requires(const M& cam, const FollowerMotion& f) { cam.second_profile(f); }) {
    all.push_back(cam_curve<M>(
        {"second_centre_distance", "mm", "m",
         "distance of the " + second_profile + " from its centre"},
        [](const auto& cam, const auto& f) { return second_profile_distance(cam, f); }));
    all.push_back(cam_curve<M>({"second_bore_gap", "mm", "m",
                                "distance of the " + second_profile + " from the bore's edge"},
                               [](const auto& cam, const auto& f) {
                                 return second_profile_distance(cam, f) - cam.bore_radius;
                               }));
  }
  return all;
}

}  // namespace camlaw::problems
