// SPDX-License-Identifier: MIT
#include "machines/cams/knife_edge_cam.h"

#include "machines/cams/buildable_checks.h"
#include "machines/cams/cam_tables.h"
#include "machines/cams/extent_responses.h"
#include "machines/cams/follower_responses.h"
#include "machines/cams/guide_response.h"
#include "machines/cams/sliding_responses.h"
#include "machines/model/append.h"
#include "machines/model/usual_problem.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {

using optim::Part;

Mechanism knife_edge_cam_mechanism() {
  std::vector<MechanismResponse> responses = follower_responses<KnifeEdgeCam>(kSliding);
  append(responses, {cam_curve<KnifeEdgeCam>(
                         {"pressure_angle", "deg", "rad",
                          "angle between the normal of the profile and the follower's "
                          "path, with the sign of the slope"},
                         [](const auto& cam, const auto& f) { return cam.pressure_angle(f); }),
                     cam_curve<KnifeEdgeCam>(
                         {"profile_curvature", "1/mm", "1/m",
                          "curvature of the profile, positive where convex, negative where hollow"},
                         [](const auto& cam, const auto& f) { return cam.profile_curvature(f); }),
                     cam_curve<KnifeEdgeCam>(
                         {"tool_fit", "1", "1",
                          "tool radius over the radius of a hollow; above 1 the tool does not fit"},
                         [](const auto& cam, const auto& f) { return cam.tool_fit(f); }),
                     cam_curve<KnifeEdgeCam>(
                         {"contact_force", "N", "N", "force between edge and cam"},
                         [](const auto& cam, const auto& f) { return cam.contact_force(f); })});
  append(responses, sliding_responses<KnifeEdgeCam>({"contact_force"}));
  responses.push_back(guide_response<KnifeEdgeCam>());
  responses.push_back(overhang_response<KnifeEdgeCam>());
  append(responses, drawn_responses<KnifeEdgeCam>(true));
  append(responses, blank_responses<KnifeEdgeCam>());
  append(responses, extent_responses<KnifeEdgeCam>());
  return checked({.name = "disc-cam-knife-edge",
                  .title = "disc cam with a translating knife-edged follower",
                  .source = "docs/theory.md, Cams",
                  .parameters = parameters_of<KnifeEdgeCam>(),
                  .responses = std::move(responses),
                  .peaks = {peak_pressure_angle(),
                            {"sharpest_curvature", "profile_curvature", Part::Highest,
                             "greatest curvature of the profile"},
                            {"least_curvature", "profile_curvature", Part::Lowest,
                             "least curvature of the profile; above 0 the whole profile is convex"},
                            least_force(),
                            peak_force(),
                            peak_torque(),
                            outer_radius(),
                            least_wall(),
                            peak_end_deviation(),
                            least_elastic(kSliding)},
                  .moved_by = MovedBy::Program,
                  .validity = {outside_guide()},
                  .form = Form::DiscKnifeEdge,
                  .why_impossible = why_impossible_as<KnifeEdgeCam>,
                  .usual = usual_problem(
                      {.objective = "base_radius",
                       .variables = {{"base_radius", 5, 120, 60}},
                       .limits = {{"pressure_angle", -40, 35}, {"profile_curvature", 0, kNone}},
                       .others = {"peak_pressure_angle", "peak_force", "peak_torque",
                                  "contact_loss_speed", "outer_radius", "cam_mass"},
                       .segments = rise_and_return()})},
                 {hollow_checks(), force_closure_checks(kSliding), wall_checks(), guide_checks()});
}

}  // namespace camlaw::problems
