// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/drawn_responses.h"

/// How far a disc cam reaches, and what that leaves to its bore and to the pivot of its follower
/// (docs/theory.md, "What a cam leaves room for").
namespace camlaw::problems {

enum class Extent { CentreDistance, BoreGap, PivotGap, SecondCentreDistance, SecondBoreGap };

template <class Cam, class X>
X extent(const Cam& cam, Extent which, const FollowerMotion<X>& f) {
  if constexpr (requires { cam.second_profile(f); }) {
    if (which == Extent::SecondCentreDistance) return cam.second_profile(f).distance();
    if (which == Extent::SecondBoreGap) return cam.second_profile(f).distance() - cam.bore_radius;
  }
  const X distance = profile_of(cam, f).distance();
  if (which == Extent::BoreGap) return distance - cam.bore_radius;
  if constexpr (requires { cam.pivot_distance; }) {  // (M42)
    if (which == Extent::PivotGap) return -distance + cam.pivot_distance;
  }
  return distance;
}

template <template <class> class M>
MechanismResponse extent_response(Extent which, const char* name, const char* meaning) {
  return listed_curve<M>({name, "mm", "m", meaning}, turn_of_the_cam(), which,
                         [](const auto& cam, Extent wanted, const auto& motion) {
                           return extent(cam, wanted, cam.over_angle(motion));
                         });
}

/// Of a machine M with a bore_radius, and where it has that a pivot_distance and a second cam.
template <template <class> class M>
std::vector<MechanismResponse> extent_responses() {
  using E = Extent;
  std::vector<MechanismResponse> all{
      extent_response<M>(E::CentreDistance, "centre_distance",
                         "distance of the profile from the cam's centre"),
      extent_response<M>(E::BoreGap, "bore_gap", "distance of the profile from the bore's edge")};
  if constexpr (requires(const M<double>& cam) { cam.pivot_distance; }) {
    all.push_back(extent_response<M>(
        E::PivotGap, "pivot_gap",
        "distance that the profile, as the cam turns, keeps from the axis of the arm's pivot"));
  }
  if constexpr (requires(const M<double>& cam, const FollowerMotion<double>& f) {
                  cam.second_profile(f);
                }) {
    all.push_back(extent_response<M>(E::SecondCentreDistance, "second_centre_distance",
                                     "distance of the second cam's profile from its centre"));
    all.push_back(extent_response<M>(E::SecondBoreGap, "second_bore_gap",
                                     "distance of the second cam's profile from the bore's edge"));
  }
  return all;
}

}  // namespace camlaw::problems
