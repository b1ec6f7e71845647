// SPDX-License-Identifier: MIT
#include "machines/cams/flat_cam.h"

#include "machines/cams/buildable_checks.h"
#include "machines/cams/cam_tables.h"
#include "machines/cams/extent_responses.h"
#include "machines/cams/face_responses.h"
#include "machines/cams/follower_responses.h"
#include "machines/cams/guide_response.h"
#include "machines/cams/sliding_responses.h"
#include "machines/model/append.h"
#include "machines/model/usual_problem.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {

using optim::Part;

Mechanism flat_cam_mechanism() {
  std::vector<MechanismResponse> responses = follower_responses<FlatCam>(kSliding);
  responses.push_back(
      cam_curve<FlatCam>({"contact_offset", "mm", "m",
                          "position of the contact on the face, from the follower's axis"},
                         [](const auto& cam, const auto& f) { return cam.contact_offset(f); }));
  responses.push_back(
      cam_curve<FlatCam>({"contact_force", "N", "N", "force between face and cam"},
                         [](const auto& cam, const auto& f) { return cam.contact_force(f); }));
  responses.push_back(profile_radius_response<FlatCam>());
  append(responses, face_contact_responses<FlatCam>());
  append(responses, sliding_responses<FlatCam>({"follower_force", "profile_radius"}));
  responses.push_back(guide_response<FlatCam>());
  append(responses, drawn_responses<FlatCam>(false));
  append(responses, blank_responses<FlatCam>());
  append(responses, extent_responses<FlatCam>());
  return checked({.name = "disc-cam-flat",
                  .title = "disc cam with a translating flat-faced follower",
                  .source = "docs/theory.md, Cams",
                  .parameters = parameters_of<FlatCam>(),
                  .responses = std::move(responses),
                  .peaks = {{"least_profile_radius", "profile_radius", Part::Lowest,
                             "least radius of curvature of the profile"},
                            {"face_half_width", "contact_offset", Part::Magnitude,
                             "how far the face must extend from the follower's axis"},
                            least_force(),
                            peak_force(),
                            peak_torque(),
                            peak_stress(),
                            outer_radius(),
                            least_wall(),
                            peak_end_deviation(),
                            least_elastic(kSliding)},
                  .moved_by = MovedBy::Program,
                  .form = Form::DiscFlat,
                  .why_impossible = why_impossible_as<FlatCam>,
                  .usual = usual_problem(
                      {.objective = "base_radius",
                       .variables = {{"base_radius", 10, 200, 80}},
                       .limits = {{"profile_radius", 5, kNone}, {"follower_force", 0, kNone}},
                       .others = {"peak_stress", "peak_torque", "contact_loss_speed",
                                  "face_half_width", "outer_radius", "cam_mass"},
                       .segments = rise_and_return()})},
                 {face_checks(), force_closure_checks(kSliding), wall_checks(), stress_checks(),
                  guide_checks()});
}

}  // namespace camlaw::problems
