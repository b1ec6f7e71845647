// SPDX-License-Identifier: MIT
#include "machines/cams/oscillating_end_cam.h"

#include "machines/cams/buildable_checks.h"
#include "machines/cams/cam_tables.h"
#include "machines/cams/drawn_responses.h"
#include "machines/cams/duty_responses.h"
#include "machines/cams/follower_responses.h"
#include "machines/cams/roller_responses.h"
#include "machines/model/append.h"
#include "machines/model/usual_problem.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {

Mechanism oscillating_end_cam_mechanism() {
  std::vector<MechanismResponse> responses = follower_responses<OscillatingEndCam>(kOscillating);
  append(responses, roller_responses<OscillatingEndCam>());
  append(responses, duty_responses<OscillatingEndCam>());
  append(responses, drawn_responses<OscillatingEndCam>(true));
  return checked({.name = "end-cam-oscillating",
                  .title = "end or barrel cam with an oscillating roller arm",
                  .source = "docs/theory.md, Cams",
                  .parameters = parameters_of<OscillatingEndCam>(),
                  .responses = std::move(responses),
                  .peaks = {peak_pressure_angle(), peak_undercut(), peak_torque(), peak_stress(),
                            least_torque(), peak_outer_undercut(), peak_groove_stress(),
                            peak_end_deviation(), least_elastic(kOscillating)},
                  .moved_by = MovedBy::Program,
                  .form = Form::EndArm,
                  .why_impossible = why_impossible_as<OscillatingEndCam>,
                  .usual = usual_problem({.objective = "radius",
                                          .variables = {{"radius", 10, 200, 80}},
                                          .limits = {{"pressure_angle", -40, 35}},
                                          .others = {"undercut", "follower_torque", "peak_stress",
                                                     "peak_torque", "contact_loss_speed", "life"},
                                          .segments = rise_and_return()})},
                 {roller_checks(), force_closure_checks(kOscillating), roller_stress_checks()});
}

}  // namespace camlaw::problems
