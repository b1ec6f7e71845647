// SPDX-License-Identifier: MIT
#include "machines/cams/end_cam.h"

#include "machines/cams/buildable_checks.h"
#include "machines/cams/cam_tables.h"
#include "machines/cams/drawn_responses.h"
#include "machines/cams/duty_responses.h"
#include "machines/cams/follower_responses.h"
#include "machines/cams/guide_response.h"
#include "machines/cams/roller_responses.h"
#include "machines/model/append.h"
#include "machines/model/usual_problem.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {

Mechanism end_cam_mechanism() {
  std::vector<MechanismResponse> responses = follower_responses<EndCam>(kSliding);
  append(responses, roller_responses<EndCam>());
  append(responses, duty_responses<EndCam>());
  responses.push_back(guide_response<EndCam>());
  responses.push_back(overhang_response<EndCam>());
  append(responses, drawn_responses<EndCam>(true));
  return checked(
      {.name = "end-cam",
       .title = "end or barrel cam with a roller that moves along its axis",
       .source = "docs/theory.md, Cams",
       .parameters = parameters_of<EndCam>(),
       .responses = std::move(responses),
       .peaks = {peak_pressure_angle(), peak_undercut(), least_force(), peak_force(), peak_torque(),
                 peak_stress(), peak_outer_undercut(), peak_groove_stress(), peak_end_deviation(),
                 least_elastic(kSliding)},
       .moved_by = MovedBy::Program,
       .validity = {outside_guide()},
       .form = Form::EndRoller,
       .why_impossible = why_impossible_as<EndCam>,
       .usual = usual_problem({.objective = "radius",
                               .variables = {{"radius", 5, 200, 60}},
                               .limits = {{"pressure_angle", -35, 35}},
                               .others = {"undercut", "follower_force", "peak_stress",
                                          "peak_torque", "contact_loss_speed", "life"},
                               .segments = rise_and_return()})},
      {roller_checks(), force_closure_checks(kSliding), roller_stress_checks(), guide_checks()});
}

}  // namespace camlaw::problems
