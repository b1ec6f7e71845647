// SPDX-License-Identifier: MIT
#include "machines/cams/linear_cam.h"

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
namespace {

/// A plate has no shaft: its force stands for the torque.
std::vector<MechanismResponse> plate_responses() {
  std::vector<MechanismResponse> responses = follower_responses<LinearCam>(kSliding);
  std::erase_if(responses, [](const auto& response) {
    return response.name.find("torque") != std::string::npos;
  });
  responses.push_back(
      cam_curve<LinearCam>({"plate_force", "N", "N", "force that moves the plate"},
                           [](const auto& cam, const auto& f) { return cam.plate_force(f); }));
  return responses;
}

}  // namespace

Mechanism linear_cam_mechanism() {
  std::vector<MechanismResponse> responses = plate_responses();
  append(responses, roller_responses<LinearCam>());
  append(responses, duty_responses<LinearCam>());
  responses.push_back(guide_response<LinearCam>());
  responses.push_back(overhang_response<LinearCam>());
  append(responses, drawn_responses<LinearCam>(true));
  return checked(
      {.name = "linear-cam",
       .title = "cam plate that slides under a translating roller follower",
       .source = "docs/theory.md, Cams",
       .parameters = parameters_of<LinearCam>(),
       .responses = std::move(responses),
       .peaks = {peak_pressure_angle(),
                 peak_undercut(),
                 least_force(),
                 peak_force(),
                 {"peak_plate_force", "plate_force", optim::Part::Magnitude,
                  "greatest force that moves the plate"},
                 peak_stress(),
                 peak_outer_undercut(),
                 peak_groove_stress(),
                 peak_end_deviation(),
                 least_elastic(kSliding)},
       .moved_by = MovedBy::Program,
       .validity = {outside_guide()},
       .form = Form::Plate,
       .why_impossible = why_impossible_as<LinearCam>,
       .usual = usual_problem({.objective = "travel",
                               .variables = {{"travel", 50, 1000, 400}},
                               .limits = {{"pressure_angle", -35, 35}, {"undercut", kNone, 0.5}},
                               .others = {"follower_force", "peak_plate_force", "peak_stress",
                                          "contact_loss_speed", "life"},
                               .segments = rise_and_return()})},
      {roller_checks(), force_closure_checks(kSliding), roller_stress_checks(), guide_checks()});
}

}  // namespace camlaw::problems
