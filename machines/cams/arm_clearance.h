// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/drawn_responses.h"

namespace camlaw::problems {

/// What the cam leaves to the middle line of a roller's arm, from two places of the cycle: where
/// the arm stands, and where the point of the profile is touched (docs/theory.md, "What a cam
/// leaves room for").
struct ArmAndProfile {
  /// Curves in mm, as the frame sees them: the point that the roller touches, the roller's centre.
  MechanismResponse contact_x, contact_y, centre_x, centre_y;
  std::size_t pivot_distance;  ///< a parameter, in mm
  double turn;                 ///< 1, or -1 of a cam that turns the other way
};

/// Completes a number.
MechanismResponse arm_clearance(MechanismResponse response, ArmAndProfile of);

/// Of a machine M with pitch_curve() and a pivot_distance.
template <class M>
MechanismResponse arm_clearance_response() {
  const auto seen = [](const char* name, auto formula) {
    return cam_curve<M>({name, "mm", "m", ""}, formula);
  };
  constexpr bool turns_back = requires(const M& cam, const CamPoint& p) { cam.placed(p, 0.0); };
  const auto& all = parameters_of<M>();
  const auto pivot = std::find_if(all.begin(), all.end(),
                                  [](const auto& p) { return p.name == "pivot_distance"; });
  ArmAndProfile of{
      seen("contact_x", [](const auto& cam, const auto& f) { return profile_of(cam, f).x; }),
      seen("contact_y", [](const auto& cam, const auto& f) { return profile_of(cam, f).y; }),
      seen("centre_x", [](const auto& cam, const auto& f) { return cam.pitch_curve(f).x; }),
      seen("centre_y", [](const auto& cam, const auto& f) { return cam.pitch_curve(f).y; }),
      static_cast<std::size_t>(pivot - all.begin()),
      turns_back ? -1.0 : 1.0};
  return arm_clearance(
      detail::described<M>({"arm_clearance", "mm", "mm",
                            "least distance of the profile from the arm's centre line, between "
                            "roller and pivot; below 0 if the arm cuts into the cam"}),
      std::move(of));
}

}  // namespace camlaw::problems
