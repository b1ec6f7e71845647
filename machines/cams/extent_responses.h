// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/drawn_responses.h"

/// How far a disc cam reaches, and what that leaves to its bore and to the pivot of its follower
/// (docs/theory.md, "What a cam leaves room for").
namespace camlaw::problems {

enum class Extent { CentreDistance, BoreGap, PivotGap, SecondCentreDistance, SecondBoreGap };

/// Distance of the profile from the cam's centre; cams whose rollers change say it themselves.
template <class Cam, class X>
X profile_distance(const Cam& cam, const FollowerMotion<X>& f) {
  if constexpr (requires { cam.profile_distance(f); }) {
    return cam.profile_distance(f);
  } else {
    return profile_of(cam, f).distance();
  }
}

template <class Cam, class X>
X second_profile_distance(const Cam& cam, const FollowerMotion<X>& f) {
  if constexpr (requires { cam.second_profile_distance(f); }) {
    return cam.second_profile_distance(f);
  } else {
    return cam.second_profile(f).distance();
  }
}

template <class Cam, class X>
X extent(const Cam& cam, Extent which, const FollowerMotion<X>& f) {
  if constexpr (requires { cam.second_profile(f); }) {
    if (which == Extent::SecondCentreDistance) return second_profile_distance(cam, f);
    if (which == Extent::SecondBoreGap) return second_profile_distance(cam, f) - cam.bore_radius;
  }
  const X distance = profile_distance(cam, f);
  if (which == Extent::BoreGap) return distance - cam.bore_radius;
  if constexpr (requires { cam.pivot_distance; }) {  // (M42)
    if (which == Extent::PivotGap) return -distance + cam.pivot_distance;
  }
  return distance;
}

template <template <class> class M>
MechanismResponse extent_response(Extent which, const char* name, const std::string& meaning) {
  return listed_curve<M>({name, "mm", "m", meaning}, turn_of_the_cam(), which,
                         [](const auto& cam, Extent wanted, const auto& motion) {
                           return extent(cam, wanted, cam.over_angle(motion));
                         });
}

/// Of a machine M with a bore_radius, and where it has that a pivot_distance and a second cam, or
/// what is called so.
template <template <class> class M>
std::vector<MechanismResponse> extent_responses(
    const std::string& second_profile = "second cam's profile") {
  using E = Extent;
  std::vector<MechanismResponse> all{
      extent_response<M>(E::CentreDistance, "centre_distance",
                         "distance of the profile from the cam's centre"),
      extent_response<M>(E::BoreGap, "bore_gap", "distance of the profile from the bore's edge")};
  if constexpr (requires(const M<double>& cam) { cam.pivot_distance; }) {
    all.push_back(extent_response<M>(
        E::PivotGap, "pivot_gap",
        "clearance between the profile of the turning cam and the axis of the arm's pivot"));
  }
  if constexpr (requires(const M<double>& cam, const FollowerMotion<double>& f) {
                  cam.second_profile(f);
                }) {
    all.push_back(extent_response<M>(E::SecondCentreDistance, "second_centre_distance",
                                     "distance of the " + second_profile + " from its centre"));
    all.push_back(
        extent_response<M>(E::SecondBoreGap, "second_bore_gap",
                           "distance of the " + second_profile + " from the bore's edge"));
  }
  return all;
}

}  // namespace camlaw::problems
