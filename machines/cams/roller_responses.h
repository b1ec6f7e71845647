// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/bearing_side.h"
#include "machines/cams/cam_motion.h"
#include "machines/model/listed_responses.h"

/// What all roller followers have in common, on a cam of one flank or in a groove.
namespace camlaw::problems {

enum class RollerCurve {
  PressureAngle,
  Undercut,
  PitchCurvature,
  ProfileCurvature,
  ToolFit,
  ContactForce,
  ContactStress,
  ContactHalfWidth,
  OuterUndercut,
  GrooveStress
};

/// Those of the pitch curve alone, for a machine with pitch_curve(), pressure_angle() and roller().
template <class Cam, class X>
X roller_geometry(const Cam& cam, RollerCurve which, const FollowerMotion<X>& f) {
  if (which == RollerCurve::PressureAngle) return cam.pressure_angle(f);
  const auto roller = cam.roller();
  const X k = cam.pitch_curve(f).curvature();
  switch (which) {
    case RollerCurve::Undercut:
      return roller.undercut(k);
    case RollerCurve::ProfileCurvature:
      return roller.profile_curvature(k);
    case RollerCurve::ToolFit:
      return roller.tool_fit(k);
    case RollerCurve::OuterUndercut:
      return outer_undercut(roller, k);
    default:
      break;
  }
  return k;
}

template <class Cam, class X>
X roller_curve(const Cam& cam, RollerCurve which, const FollowerMotion<X>& f) {
  if (which == RollerCurve::ContactForce) return cam.contact_force(f);
  const auto curvature = [&] { return cam.pitch_curve(f).curvature(); };
  switch (which) {
    case RollerCurve::ContactStress:
      return cam.roller().stress(cam.contact_force(f), curvature());
    case RollerCurve::ContactHalfWidth:
      return cam.roller().half_width(cam.contact_force(f), curvature());
    case RollerCurve::GrooveStress:
      return groove_stress(cam.roller(), cam.contact_force(f), curvature());
    default:
      break;
  }
  return roller_geometry(cam, which, f);
}

/// All of them for a machine M with pitch_curve(), pressure_angle(), contact_force() and roller().
template <template <class> class M>
std::vector<MechanismResponse> roller_responses() {
  std::vector<MechanismResponse> all;
  const auto add = [&](RollerCurve which, ResponseAbout about) {
    all.push_back(listed_curve<M>(std::move(about), turn_of_the_cam(), which,
                                  [](const auto& cam, RollerCurve curve, const auto& motion) {
                                    return roller_curve(cam, curve, cam.over_angle(motion));
                                  }));
  };
  using C = RollerCurve;
  add(C::PressureAngle, {"pressure_angle", "deg", "rad",
                         "angle between the normal of the profile and the path of the roller's "
                         "centre, with the sign of the slope"});
  add(C::Undercut,
      {"undercut", "1", "1",
       "roller radius over the pitch curve's radius of curvature; at 1 the profile is undercut"});
  add(C::PitchCurvature,
      {"pitch_curvature", "1/mm", "1/m", "curvature of the pitch curve, positive where convex"});
  add(C::ProfileCurvature,
      {"profile_curvature", "1/mm", "1/m", "curvature of the profile, positive where convex"});
  add(C::ToolFit, {"tool_fit", "1", "1",
                   "tool radius over the radius of a hollow; above 1 the tool does not fit"});
  add(C::ContactForce, {"contact_force", "N", "N", "force between roller and cam"});
  add(C::ContactStress,
      {"contact_stress", "MPa", "Pa", "greatest Hertz pressure between roller and cam"});
  add(C::ContactHalfWidth, {"contact_half_width", "mm", "m", "half the width of the contact"});
  add(C::OuterUndercut, {"outer_undercut", "1", "1",
                         "roller radius over the radius of curvature of the pitch curve, for a "
                         "groove's outer flank; at 1 that flank is undercut"});
  add(C::GrooveStress,
      {"groove_stress", "MPa", "Pa",
       "greatest Hertz pressure in a groove, on the flank that carries the force"});
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
