// SPDX-License-Identifier: MIT
#include "machines/index_drives/parallel_index_cam.h"

#include "machines/cams/buildable_checks.h"
#include "machines/cams/cam_tables.h"
#include "machines/cams/extent_responses.h"
#include "machines/cams/pair_responses.h"
#include "machines/index_drives/index_tables.h"
#include "machines/index_drives/turret_duty.h"
#include "machines/index_drives/turret_responses.h"
#include "machines/model/append.h"
#include "machines/model/usual_problem.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {
namespace {

constexpr const char *kDriving = "driving flank", *kHolding = "holding flank";

/// Of the profile at a distance from the cam's centre.
constexpr auto kGap = [](const auto& cam, const auto& distance) {
  return -distance + (cam.axis_distance - cam.shaft_radius);
};

std::vector<MechanismResponse> shaft_gaps() {
  const auto clearance = [](const char* flank) {
    return std::string("clearance between the ") + flank +
           " of the turning cam and the turret's shaft";
  };
  return {cam_curve<ParallelIndexCam>(
              {"shaft_gap", "mm", "m", clearance(kDriving)},
              [](const auto& cam, const auto& f) { return kGap(cam, profile_distance(cam, f)); }),
          cam_curve<ParallelIndexCam>({"second_shaft_gap", "mm", "m", clearance(kHolding)},
                                      [](const auto& cam, const auto& f) {
                                        return kGap(cam, second_profile_distance(cam, f));
                                      })};
}

std::vector<MechanismResponse> roller_angles() {
  return {cam_curve<ParallelIndexCam>(
              {"roller_angle", "deg", "rad",
               "angle between the line of centres and the roller on the driving flank"},
              [](const auto& cam, const auto& f) { return cam.main().serving(f).angle; }),
          cam_curve<ParallelIndexCam>(
              {"second_roller_angle", "deg", "rad",
               "angle between the line of centres and the roller on the holding flank"},
              [](const auto& cam, const auto& f) { return cam.second().serving(f).angle; })};
}

/// (IX23) Seen from its place on the holding flank a roller will drive P - 1 places later.
std::vector<Expression> by_place(const ParallelIndexCam& cam, std::span<const Expression> means) {
  constexpr int kMostPlates = 4;  // that `plates` accepts
  const auto driven = means.first(kServed), held = means.subspan(kServed);
  std::vector<Expression> all(driven.begin(), driven.end());
  all.resize(kServed + kMostPlates - 1, 0);
  for (int plates = 2; plates <= kMostPlates; ++plates) {
    const Expression half = Expression(0.5), apart = cam.plates - plates;
    const Expression are_so_many = half - absolute(apart);
    for (std::size_t place = 0; place < held.size(); ++place) {
      Expression& sum = all[place + static_cast<std::size_t>(plates - 1)];
      sum = sum + by_side(are_so_many, held[place], 0);
    }
  }
  return all;
}

Write damage(int side, int place) {
  return detail::written_integrand<ParallelIndexCam>(
      [side, place](const auto& cam, const auto& motion) {
        return cam.damage(side, place, cam.over_angle(motion));
      });
}

std::vector<MechanismResponse> duty_of_rollers() {
  const auto turns = [](const auto& cam, const auto& f) { return cam.bearing_turns(f); };
  std::vector<MechanismResponse> all = turret_roller_speeds<ParallelIndexCam>(turns);
  all.push_back(turret_static_fraction<ParallelIndexCam>(
      [](const auto& cam, const auto& f) { return cam.contact_force(f); }));
  append(all,
         film_responses<ParallelIndexCam>({"undercut", "second_undercut"}, "loaded flank",
                                          [](const auto& cam, const auto& f, const auto& formula) {
                                            return cam.of_film(f, formula);
                                          }));
  std::vector<Write> damages;
  for (const int side : {1, -1}) {
    for (int place = 0; place < kServed; ++place) damages.push_back(damage(side, place));
  }
  append(all, turret_life<ParallelIndexCam>(
                  std::move(damages), turns,
                  [](const auto& cam, const auto& means) { return by_place(cam, means); }));
  return all;
}

/// Drawn, but not exported as a profile: they are parts of several cams.
std::vector<MechanismResponse> flanks() {
  std::vector<MechanismResponse> all = drawn_curve<ParallelIndexCam>(
      "flank", "driving flanks of all cams, in their own coordinates",
      [](const auto& cam, const auto& f) { return profile_of(cam, f); });
  append(all, drawn_curve<ParallelIndexCam>(
                  "second_flank", "holding flanks of all cams, in the same coordinates",
                  [](const auto& cam, const auto& f) { return cam.second_profile(f); }));
  append(all, drawn_curve<ParallelIndexCam>(
                  "roller_path", "path of the driving rollers' centres over the cams",
                  [](const auto& cam, const auto& f) { return trace_point(cam, f); }));
  return all;
}

std::vector<MechanismResponse> parallel_responses() {
  std::vector<MechanismResponse> all = turret_responses<ParallelIndexCam>();
  append(all, roller_angles());
  append(all, pair_responses<ParallelIndexCam>(kDriving, kHolding));
  append(all, pair_crown_responses<ParallelIndexCam>());
  append(all, duty_of_rollers());
  append(all, flanks());
  append(all, extent_responses<ParallelIndexCam>(kHolding));
  all.push_back(cam_curve<ParallelIndexCam>(
      {"crossing_ratio", "1", "1",
       "speed of a roller on the line of centres over that of the cam's surface; well above 1 it "
       "cuts into the next flank"},
      [](const auto& cam, const auto& f) { return cam.crossing_ratio(f); }));
  append(all, shaft_gaps());
  all.push_back(number_response<ParallelIndexCam>(
      {"roller_gap", "mm", "m", "gap between neighbouring rollers of a ring"},
      [](const auto& cam) { return cam.roller_gap(); }));
  return all;
}

/// Why the cams do not close after this many stations, in words; empty where they do.
std::string why_open(std::span<const double> parameters, double advance) {
  const double stations = parameters[0], rollers = parameters[1], plates = parameters[2];
  return why_rollers_differ(stations, rollers, advance, rollers * plates / stations * advance);
}

}  // namespace

Mechanism parallel_index_cam_mechanism() {
  return checked(
      {.name = "parallel-index-cam",
       .title = "parallel index drive: conjugate disc cams that turn a turret with rollers",
       .source = "docs/theory.md, Index drives",
       .parameters = parameters_of<ParallelIndexCam>(),
       .responses = parallel_responses(),
       .peaks = {peak_pressure_angle(), of_second(peak_pressure_angle(), kHolding), peak_undercut(),
                 of_second(peak_undercut(), kHolding), peak_turret_torque(), peak_torque(),
                 peak_stress(), outer_radius(), of_second(outer_radius(), kHolding), least_wall(),
                 of_second(least_wall(), kHolding), shaft_clearance(),
                 of_second(shaft_clearance(), kHolding), peak_end_deviation(),
                 least_elastic(table_words())},
       .moved_by = MovedBy::Program,
       .advances = {{.by = {"stations", "rollers", "plates"}, .why_open = why_open}},
       .form = Form::ParallelIndex,
       .why_impossible = why_impossible_as<ParallelIndexCam>,
       .usual = usual_problem(
           {.objective = "axis_distance",
            .variables = {{"axis_distance", 60, 400, 170}, {"turret_radius", 40, 300, 120}},
            .limits = {{"pressure_angle", -40, 40},
                       {"second_pressure_angle", -40, 40},
                       {"crossing_ratio", kNone, 1.05},
                       {"contact_stress", kNone, 900}},
            .others = {"peak_stress", "peak_torque", "torque_rms", "undercut", "second_undercut",
                       "outer_radius"},
            .constants = {{"stations", 8},
                          {"rollers", 8},
                          {"plates", 3},
                          {"speed", 120},
                          {"inertia", 4},
                          {"friction_torque", 4},
                          {"face_width", 14},
                          {"bore_radius", 30},
                          {"shaft_radius", 20},
                          {"cutter_radius", 8}},
            .segments = index_once(80, 200)})},
      {conjugate_checks(), shaft_checks(), ring_checks()});
}

}  // namespace camlaw::problems
