// SPDX-License-Identifier: MIT
#include "machines/cams/arm_clearance.h"
#include "machines/cams/buildable_checks.h"
#include "machines/cams/cam_tables.h"
#include "machines/cams/duty_responses.h"
#include "machines/cams/extent_responses.h"
#include "machines/cams/follower_responses.h"
#include "machines/cams/leading_roller_cam.h"
#include "machines/cams/roller_responses.h"
#include "machines/model/append.h"
#include "machines/model/usual_problem.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {
namespace {

template <class M>
Mechanism oscillating_mechanism(const char* name, const char* title, Form form,
                                UsualProblem usual) {
  std::vector<MechanismResponse> responses = follower_responses<M>(kOscillating);
  append(responses, roller_responses<M>());
  append(responses, duty_responses<M>());
  append(responses, drawn_responses<M>(true));
  append(responses, blank_responses<M>());
  append(responses, extent_responses<M>());
  responses.push_back(arm_clearance_response<M>());
  return checked({.name = name,
                  .title = title,
                  .source = "docs/theory.md, Cams",
                  .parameters = parameters_of<M>(),
                  .responses = std::move(responses),
                  .peaks = {peak_pressure_angle(), peak_undercut(), peak_torque(), peak_stress(),
                            least_torque(), peak_outer_undercut(), peak_groove_stress(),
                            outer_radius(), least_wall(), pivot_clearance(), peak_end_deviation(),
                            least_elastic(kOscillating)},
                  .moved_by = MovedBy::Program,
                  .form = form,
                  .why_impossible = why_impossible_as<M>,
                  .usual = usual_problem(std::move(usual))},
                 {roller_checks(), force_closure_checks(kOscillating), wall_checks(),
                  pivot_checks(), arm_checks(), roller_stress_checks()});
}

}  // namespace

Mechanism oscillating_roller_cam_mechanism() {
  return oscillating_mechanism<OscillatingRollerCam>(
      "disc-cam-oscillating-roller", "disc cam with an oscillating roller follower, trailing",
      Form::DiscTrailingRoller,
      {.objective = "peak_pressure_angle",
       .variables = {{"arm_length", 60, 120, 80}, {"pivot_distance", 80, 140, 100}},
       .limits = {{"undercut", kNone, 0.7}, {"follower_torque", 0, kNone}},
       .others = {"peak_stress", "peak_torque", "contact_loss_speed", "life", "outer_radius",
                  "cam_mass"},
       .segments = rise_and_return()});
}

Mechanism leading_roller_cam_mechanism() {
  return oscillating_mechanism<LeadingRollerCam>(
      "disc-cam-leading-roller", "disc cam with an oscillating roller follower, leading",
      Form::DiscLeadingRoller,
      {.objective = "base_radius",
       .variables = {{"base_radius", 20, 80, 60}},
       .limits = {{"pressure_angle", -40, 40}, {"undercut", kNone, 0.7}},
       .others = {"follower_torque", "peak_stress", "peak_torque", "contact_loss_speed", "life",
                  "outer_radius"},
       .constants = {{"swing", 18}, {"arm_length", 90}, {"pivot_distance", 110}},
       .segments = rise_and_return()});
}

}  // namespace camlaw::problems
