// SPDX-License-Identifier: MIT
#include "machines/cams/conjugate_cam.h"

#include "machines/cams/buildable_checks.h"
#include "machines/cams/cam_tables.h"
#include "machines/cams/extent_responses.h"
#include "machines/cams/follower_responses.h"
#include "machines/cams/guide_response.h"
#include "machines/cams/pair_duty_responses.h"
#include "machines/cams/pair_responses.h"
#include "machines/model/append.h"
#include "machines/model/usual_problem.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {
namespace {

constexpr const char *kMain = "main cam", *kSecond = "second cam";

std::vector<MechanismResponse> conjugate_responses() {
  std::vector<MechanismResponse> all = follower_responses<ConjugateCam>(kSliding);
  append(all, pair_responses<ConjugateCam>(kMain, kSecond));
  append(all, pair_crown_responses<ConjugateCam>());
  append(all, pair_duty_responses<ConjugateCam>(kMain, kSecond));
  append(all, film_responses<ConjugateCam>({"undercut", "second_undercut"}, "loaded cam",
                                           [](const auto& cam, const auto& f, const auto& formula) {
                                             return formula(cam.film(f));
                                           }));
  all.push_back(guide_response<ConjugateCam>());
  all.push_back(overhang_response<ConjugateCam>());
  append(all, drawn_responses<ConjugateCam>(false));
  append(all, second_profile<ConjugateCam>(
                  "profile of the second cam, in the coordinates of the main one"));
  append(all, extent_responses<ConjugateCam>());
  all.push_back(
      number_response<ConjugateCam>({"second_base_radius", "mm", "m",
                                     "radius of the second cam's profile at displacement 1, its "
                                     "least radius if no displacement is above 1"},
                                    [](const auto& cam) { return cam.second_base_radius(); }));
  return all;
}

}  // namespace

Mechanism conjugate_cam_mechanism() {
  return checked(
      {.name = "disc-cam-conjugate",
       .title = "pair of conjugate disc cams that move a carriage with two rollers",
       .source = "docs/theory.md, Cams",
       .parameters = parameters_of<ConjugateCam>(),
       .responses = conjugate_responses(),
       .peaks = {peak_pressure_angle(), of_second(peak_pressure_angle(), kSecond), peak_undercut(),
                 of_second(peak_undercut(), kSecond), peak_force(), peak_torque(), peak_stress(),
                 outer_radius(), of_second(outer_radius(), kSecond), least_wall(),
                 of_second(least_wall(), kSecond), peak_end_deviation(), least_elastic(kSliding)},
       .moved_by = MovedBy::Program,
       .validity = {outside_guide()},
       .form = Form::DiscConjugate,
       .why_impossible = why_impossible_as<ConjugateCam>,
       .usual = usual_problem(
           {.objective = "roller_distance",
            .variables = {{"base_radius", 20, 120, 50}, {"roller_distance", 60, 300, 180}},
            .limits = {{"pressure_angle", -35, 35},
                       {"second_pressure_angle", -35, 35},
                       {"second_base_radius", 25, kNone}},
            .others = {"peak_stress", "peak_torque", "undercut", "life", "outer_radius",
                       "second_outer_radius"},
            .segments = rise_and_return()})},
      {conjugate_checks(), guide_checks()});
}

}  // namespace camlaw::problems
