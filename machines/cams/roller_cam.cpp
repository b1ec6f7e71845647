// SPDX-License-Identifier: MIT
#include "machines/cams/roller_cam.h"

#include "machines/cams/buildable_checks.h"
#include "machines/cams/cam_tables.h"
#include "machines/cams/duty_responses.h"
#include "machines/cams/extent_responses.h"
#include "machines/cams/follower_responses.h"
#include "machines/cams/guide_response.h"
#include "machines/cams/roller_responses.h"
#include "machines/model/append.h"
#include "machines/model/usual_problem.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {

Mechanism roller_cam_mechanism() {
  std::vector<MechanismResponse> responses = follower_responses<RollerCam>(kSliding);
  append(responses, roller_responses<RollerCam>());
  append(responses, duty_responses<RollerCam>());
  responses.push_back(guide_response<RollerCam>());
  responses.push_back(overhang_response<RollerCam>());
  append(responses, drawn_responses<RollerCam>(true));
  append(responses, blank_responses<RollerCam>());
  append(responses, extent_responses<RollerCam>());
  return checked(
      {.name = "disc-cam-roller",
       .title = "disc cam with a translating roller follower",
       .source = "docs/theory.md, Cams",
       .parameters = parameters_of<RollerCam>(),
       .responses = std::move(responses),
       .peaks = {peak_pressure_angle(), peak_undercut(), least_force(), peak_force(), peak_torque(),
                 peak_stress(), peak_outer_undercut(), peak_groove_stress(), outer_radius(),
                 least_wall(), peak_end_deviation(), least_elastic(kSliding)},
       .moved_by = MovedBy::Program,
       .validity = {outside_guide()},
       .form = Form::DiscRoller,
       .why_impossible = why_impossible_as<RollerCam>,
       .usual = usual_problem({.objective = "base_radius",
                               .variables = {{"base_radius", 10, 120, 60}},
                               .limits = {{"pressure_angle", -40, 30},
                                          {"undercut", kNone, 0.8},
                                          {"follower_force", 0, kNone}},
                               .others = {"peak_stress", "peak_torque", "contact_loss_speed",
                                          "life", "outer_radius", "cam_mass"},
                               .segments = rise_and_return()})},
      {roller_checks(), force_closure_checks(kSliding), wall_checks(), roller_stress_checks(),
       guide_checks()});
}

}  // namespace camlaw::problems
