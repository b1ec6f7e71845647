// SPDX-License-Identifier: MIT
#include "machines/cams/oscillating_flat_cam.h"

#include "machines/cams/buildable_checks.h"
#include "machines/cams/cam_tables.h"
#include "machines/cams/extent_responses.h"
#include "machines/cams/face_responses.h"
#include "machines/cams/follower_responses.h"
#include "machines/cams/sliding_responses.h"
#include "machines/model/append.h"
#include "machines/model/usual_problem.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {

using optim::Part;

Mechanism oscillating_flat_cam_mechanism() {
  std::vector<MechanismResponse> responses = follower_responses<OscillatingFlatCam>(kOscillating);
  responses.push_back(cam_curve<OscillatingFlatCam>(
      {"contact_lever", "mm", "m",
       "position of the contact along the face, from the foot of the perpendicular from the pivot"},
      [](const auto& cam, const auto& f) { return cam.contact_lever(f); }));
  responses.push_back(profile_radius_response<OscillatingFlatCam>());
  responses.push_back(cam_curve<OscillatingFlatCam>(
      {"contact_force", "N", "N", "force between face and cam"},
      [](const auto& cam, const auto& f) { return cam.contact_force(f); }));
  append(responses, face_contact_responses<OscillatingFlatCam>());
  append(responses, sliding_responses<OscillatingFlatCam>({"contact_force", "profile_radius"}));
  append(responses, drawn_responses<OscillatingFlatCam>(false));
  append(responses, blank_responses<OscillatingFlatCam>());
  append(responses, extent_responses<OscillatingFlatCam>());
  return checked({.name = "disc-cam-oscillating-flat",
                  .title = "disc cam with an oscillating flat-faced follower",
                  .source = "docs/theory.md, Cams",
                  .parameters = parameters_of<OscillatingFlatCam>(),
                  .responses = std::move(responses),
                  .peaks = {{"least_profile_radius", "profile_radius", Part::Lowest,
                             "least radius of curvature of the profile"},
                            {"longest_lever", "contact_lever", Part::Highest,
                             "how far from the pivot the face must extend"},
                            {"shortest_lever", "contact_lever", Part::Lowest,
                             "how near to the pivot the face must begin"},
                            peak_torque(),
                            peak_stress(),
                            least_torque(),
                            outer_radius(),
                            least_wall(),
                            pivot_clearance(),
                            peak_end_deviation(),
                            least_elastic(kOscillating)},
                  .moved_by = MovedBy::Program,
                  .form = Form::DiscFlatArm,
                  .why_impossible = why_impossible_as<OscillatingFlatCam>,
                  .usual = usual_problem(
                      {.objective = "base_radius",
                       .variables = {{"base_radius", 10, 70, 50}},
                       .limits = {{"profile_radius", 8, kNone}, {"contact_lever", 30, 180}},
                       .others = {"follower_torque", "peak_stress", "peak_torque",
                                  "contact_loss_speed", "outer_radius", "cam_mass"},
                       .constants = {{"swing", 15}, {"face_offset", 4}, {"pivot_distance", 110}},
                       .segments = rise_and_return()})},
                 {face_checks(), force_closure_checks(kOscillating), wall_checks(), pivot_checks(),
                  stress_checks()});
}

}  // namespace camlaw::problems
