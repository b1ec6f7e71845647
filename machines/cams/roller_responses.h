// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/bearing_side.h"
#include "machines/cams/cam_curve.h"
#include "machines/cams/cam_motion.h"

/// What all roller followers have in common, on a cam of one flank or in a groove.
namespace camlaw::problems {

/// Curvature of the pitch curve.
template <class Cam>
Expression pitch_curvature(const Cam& cam, const FollowerMotion& f) {
  return cam.pitch_curve(f).curvature();
}

/// All of them for a machine M with pitch_curve(), pressure_angle(), contact_force() and roller().
template <class M>
std::vector<MechanismResponse> roller_responses() {
  std::vector<MechanismResponse> all{
      cam_curve<M>({"pressure_angle", "deg", "rad",
                    "angle between the normal of the profile and the path of the roller's centre, "
                    "with the sign of the slope"},
                   [](const auto& cam, const auto& f) { return cam.pressure_angle(f); }),
      cam_curve<M>({"undercut", "1", "1",
                    "roller radius over the pitch curve's radius of curvature; at 1 the profile is "
                    "undercut"},
                   [](const auto& cam, const auto& f) {
                     return cam.roller().undercut(pitch_curvature(cam, f));
                   }),
      cam_curve<M>(
          {"pitch_curvature", "1/mm", "1/m", "curvature of the pitch curve, positive where convex"},
          [](const auto& cam, const auto& f) { return pitch_curvature(cam, f); }),
      cam_curve<M>(
          {"profile_curvature", "1/mm", "1/m", "curvature of the profile, positive where convex"},
          [](const auto& cam, const auto& f) {
            return cam.roller().profile_curvature(pitch_curvature(cam, f));
          }),
      cam_curve<M>({"tool_fit", "1", "1",
                    "tool radius over the radius of a hollow; above 1 the tool does not fit"},
                   [](const auto& cam, const auto& f) {
                     return cam.roller().tool_fit(pitch_curvature(cam, f));
                   }),
      cam_curve<M>({"contact_force", "N", "N", "force between roller and cam"},
                   [](const auto& cam, const auto& f) { return cam.contact_force(f); }),
      cam_curve<M>(
          {"contact_stress", "MPa", "Pa", "greatest Hertz pressure between roller and cam"},
          [](const auto& cam, const auto& f) {
            return cam.roller().stress(cam.contact_force(f), pitch_curvature(cam, f));
          }),
      cam_curve<M>({"contact_half_width", "mm", "m", "half the width of the contact"},
                   [](const auto& cam, const auto& f) {
                     return cam.roller().half_width(cam.contact_force(f), pitch_curvature(cam, f));
                   }),
      cam_curve<M>({"outer_undercut", "1", "1",
                    "roller radius over the radius of curvature of the pitch curve, for a groove's "
                    "outer flank; at 1 that flank is undercut"},
                   [](const auto& cam, const auto& f) {
                     return outer_undercut(cam.roller(), pitch_curvature(cam, f));
                   }),
      cam_curve<M>({"groove_stress", "MPa", "Pa",
                    "greatest Hertz pressure in a groove, on the flank that carries the force"},
                   [](const auto& cam, const auto& f) {
                     return groove_stress(cam.roller(), cam.contact_force(f),
                                          pitch_curvature(cam, f));
                   })};
  all.push_back(number_response<M>(
      {"groove_fit", "1", "1",
       "radius of the tool over that of the roller; above 1 the tool does not fit into the groove"},
      [](const auto& cam) { return cam.roller().groove_fit(); }));
  set_defined_while(all, {"contact_stress", "contact_half_width", "groove_stress"},
                    {.response = "undercut", .upper = 1});
  set_defined_while(all, {"contact_stress", "contact_half_width"},
                    {.response = "contact_force", .lower = 0});
  set_defined_while(all, {"groove_stress"}, {.response = "outer_undercut", .upper = 1});
  return all;
}

}  // namespace camlaw::problems
