// SPDX-License-Identifier: MIT
#include "machines/usual_problem.h"

#include <algorithm>
#include <stdexcept>

namespace camlaw::problems {
namespace {

using Segments = std::vector<UsualProblem::Segment>;
constexpr std::nullopt_t kNone = std::nullopt;

/// Up, a dwell, back, a dwell.
Segments rise_and_return() {
  return {{"rise", 110, "modified-sine"},
          {"high", 50, nullptr},
          {"return", 120, "cycloidal"},
          {"low", 80, nullptr}};
}

/// A dwell on both sides of the motion to the next station.
Segments index_once(double dwell, double index) {
  return {{"dwell", dwell, nullptr},
          {"index", index, "modified-sine"},
          {"rest", 360 - dwell - index, nullptr}};
}

std::vector<UsualProblem> disc_cams() {
  return {{.mechanism = "disc-cam-roller",
           .objective = "base_radius",
           .variables = {{"base_radius", 10, 120, 60}},
           .limits = {{"pressure_angle", -40, 30},
                      {"undercut", kNone, 0.8},
                      {"follower_force", 0, kNone}},
           .segments = rise_and_return()},
          {.mechanism = "disc-cam-flat",
           .objective = "base_radius",
           .variables = {{"base_radius", 10, 200, 80}},
           .limits = {{"profile_radius", 5, kNone}, {"follower_force", 0, kNone}},
           .segments = rise_and_return()},
          {.mechanism = "disc-cam-knife-edge",
           .objective = "base_radius",
           .variables = {{"base_radius", 5, 120, 60}},
           .limits = {{"pressure_angle", -40, 35}, {"profile_curvature", 0, kNone}},
           .segments = rise_and_return()},
          {.mechanism = "disc-cam-conjugate",
           .objective = "roller_distance",
           .variables = {{"base_radius", 20, 120, 50}, {"roller_distance", 60, 300, 180}},
           .limits = {{"pressure_angle", -35, 35},
                      {"second_pressure_angle", -35, 35},
                      {"second_base_radius", 25, kNone}},
           .segments = rise_and_return()},
          {.mechanism = "disc-cam-oscillating-roller",
           .objective = "peak_pressure_angle",
           .variables = {{"arm_length", 60, 120, 80}, {"pivot_distance", 80, 140, 100}},
           .limits = {{"undercut", kNone, 0.7}, {"follower_torque", 0, kNone}},
           .segments = rise_and_return()},
          {.mechanism = "disc-cam-leading-roller",
           .objective = "base_radius",
           .variables = {{"base_radius", 20, 80, 60}},
           .limits = {{"pressure_angle", -40, 40}, {"undercut", kNone, 0.7}},
           .constants = {{"swing", 18}, {"arm_length", 90}, {"pivot_distance", 110}},
           .segments = rise_and_return()},
          {.mechanism = "disc-cam-oscillating-flat",
           .objective = "base_radius",
           .variables = {{"base_radius", 10, 70, 50}},
           .limits = {{"profile_radius", 8, kNone}, {"contact_lever", 30, 180}},
           .constants = {{"swing", 15}, {"face_offset", 4}, {"pivot_distance", 110}},
           .segments = rise_and_return()}};
}

std::vector<UsualProblem> other_cams() {
  return {{.mechanism = "end-cam",
           .objective = "radius",
           .variables = {{"radius", 5, 200, 60}},
           .limits = {{"pressure_angle", -35, 35}},
           .segments = rise_and_return()},
          {.mechanism = "end-cam-oscillating",
           .objective = "radius",
           .variables = {{"radius", 10, 200, 80}},
           .limits = {{"pressure_angle", -40, 35}},
           .segments = rise_and_return()},
          {.mechanism = "linear-cam",
           .objective = "travel",
           .variables = {{"travel", 50, 1000, 400}},
           .limits = {{"pressure_angle", -35, 35}, {"undercut", kNone, 0.5}},
           .segments = rise_and_return()}};
}

std::vector<UsualProblem> index_drives() {
  return {{.mechanism = "parallel-index-cam",
           .objective = "axis_distance",
           .variables = {{"axis_distance", 60, 400, 170}, {"turret_radius", 40, 300, 120}},
           .limits = {{"pressure_angle", -40, 40},
                      {"second_pressure_angle", -40, 40},
                      {"crossing_ratio", kNone, 1.05},
                      {"contact_stress", kNone, 900}},
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
           .segments = index_once(80, 200)},
          {.mechanism = "indexing-barrel",
           .objective = "cam_radius",
           .variables = {{"cam_radius", 30, 300, 120}, {"turret_radius", 40, 150, 80}},
           .limits = {{"tip_pressure_angle", -40, 40},
                      {"roller_gap", 14, kNone},
                      {"tip_contact_stress", kNone, 900}},
           .constants = {{"stations", 8},
                         {"axis_distance", 57},
                         {"roller_radius", 13},
                         {"speed", 120},
                         {"inertia", 2},
                         {"friction_torque", 4},
                         {"face_width", 18},
                         {"bore_radius", 18}},
           .segments = index_once(120, 120)},
          {.mechanism = "globoidal-cam",
           .objective = "axis_distance",
           .variables = {{"axis_distance", 100, 500, 220}, {"turret_radius", 50, 250, 100}},
           .limits = {{"tip_pressure_angle", kNone, 40},
                      {"roller_gap", 14, kNone},
                      {"tip_contact_stress", kNone, 1000}},
           .constants = {{"stations", 8},
                         {"roller_radius", 13},
                         {"speed", 120},
                         {"inertia", 0.6},
                         {"friction_torque", 4},
                         {"face_width", 18},
                         {"bore_radius", 18}},
           .segments = index_once(120, 120)},
          {.mechanism = "geneva",
           .objective = "speed",
           .sense = optim::Sense::Maximize,
           .variables = {{"slots", 4, 8, 6}, {"speed", 10, 200, 50}},
           .limits = {{"peak_acceleration", kNone, 60},
                      {"driver_shaft_room", 45, kNone},
                      {"wheel_shaft_room", 60, kNone}}},
          {.mechanism = "geneva-spherical",
           .objective = "speed",
           .sense = optim::Sense::Maximize,
           .variables = {{"slots", 4, 8, 6}, {"speed", 10, 200, 40}},
           .limits = {{"peak_torque", kNone, 150}},
           .constants = {{"inertia", 4}}}};
}

std::vector<UsualProblem> drives_and_trains() {
  return {{.mechanism = "servo-axis",
           .objective = "torque_rms",
           .variables = {{"gear_ratio", 1, 30, 8}},
           .limits = {{"torque_utilisation", kNone, 0.9}, {"inertia_ratio", kNone, 10}},
           .segments = rise_and_return()},
          {.mechanism = "linear-servo-axis",
           .objective = "torque_rms",
           .variables = {{"gear_ratio", 1, 10, 3}},
           .limits = {{"torque_utilisation", kNone, 0.9}, {"rms_utilisation", kNone, 0.9}},
           .segments = rise_and_return()},
          {.mechanism = "follower-train",
           .objective = "peak_mass_acceleration",
           .variables = {{"rise_angle", 60, 150, 90}},
           .limits = {{"residual_displacement", -0.05, 0.05}},
           .law = "modified-sine"},
          {.mechanism = "law",
           .objective = "C_a",
           .limits = {{"C_v", kNone, 1.6}, {"C_j", kNone, 60}},
           .law = "free"}};
}

std::vector<UsualProblem> springs() {
  return {{.mechanism = "helical-spring",
           .objective = "active_mass",
           .variables = {{"wire_diameter", 1, 8, 4},
                         {"mean_diameter", 10, 100, 30},
                         {"active_coils", 2, 30, 8},
                         {"preload_deflection", 0, 60, 10},
                         {"working_deflection", 0, 80, 25}},
           .limits = {{"stroke", 12, kNone},
                      {"preload_force", 250, kNone},
                      {"working_stress", kNone, 700},
                      {"index", kNone, 7},
                      {"surge_frequency", 400, kNone}}},
          {.mechanism = "disc-springs",
           .objective = "springs",
           .variables = {{"series", 12, 20, 16},
                         {"preload_deflection", 0, 40, 5},
                         {"working_deflection", 0, 50, 10}},
           .limits = {{"stroke", 8, kNone},
                      {"preload_force", 5500, kNone},
                      {"preload_flattening", 0.15, kNone},
                      {"flattening", kNone, 0.75},
                      {"stress_III", kNone, 1100}},
           .constants = {{"parallel", 2}}}};
}

std::vector<UsualProblem> published_machines() {
  const std::vector<UsualProblem::Variable> springs_of_cam = {{"preload_ratio", 0.6, 2, 1},
                                                              {"cone_height", 0.65, 1, 0.75}};
  return {{.mechanism = "spine-cutter",
           .objective = "cam_radius",
           .variables = {{"cam_radius", 20, 80, 40}},
           .limits = {{"cam_pressure_angle", -30, 30}, {"peak_inertia_force", kNone, 20}},
           .law = "modified-sine"},
          {.mechanism = "die-press",
           .objective = "peak running_approach",
           .variables = {{"roller_radius", 20, 100, 50}, {"spring_preload", 0, 2000, 1000}},
           .limits = {{"lowest running_force", 100, kNone}, {"highest running_stress", kNone, 180}},
           .law = "cosine"},
          {.mechanism = "sheet-delivery",
           .objective = "lowest efficiency",
           .sense = optim::Sense::Maximize,
           .variables = {{"guide_ratio", 0.1, 2, 0.4}, {"rod_angle_max", 10, 75, 60}},
           .limits = {{"slow_down", 0.2, kNone}},
           .law = "cycloidal"},
          {.mechanism = "signature-feeder",
           .objective = "peak drum_acceleration",
           .variables = {{"crank_radius", 60, 150, 92},
                         {"centre_distance", 400, 900, 702},
                         {"offset", 45, 200, 52}},
           .limits = {{"drum_swing", 240, kNone}, {"greatest_guide_length", kNone, 800}}},
          {.mechanism = "balancing-cam",
           .objective = "spring_tension",
           .variables = springs_of_cam,
           .limits = {{"flattening", kNone, 0.75}, {"balancing_coefficient", 9.1, kNone}},
           .constants = {{"springs", 48}}},
          {.mechanism = "balancing-cam-spherical",
           .objective = "spring_tension",
           .variables = springs_of_cam,
           .limits = {{"flattening", kNone, 0.75}, {"balancing_coefficient", 3.7, kNone}},
           .constants = {{"springs", 48}}}};
}

const std::vector<UsualProblem>& all_problems() {
  static const std::vector<UsualProblem> all = [] {
    std::vector<UsualProblem> result;
    for (const auto group :
         {disc_cams, other_cams, index_drives, drives_and_trains, springs, published_machines}) {
      for (UsualProblem& problem : group()) result.push_back(std::move(problem));
    }
    return result;
  }();
  return all;
}

struct UsualInput {
  std::string_view name;
  double value;
};
constexpr UsualInput kInputs[] = {
    {"wheel_radius", 50}, {"wall", 5},         {"keyway_depth", 3.3}, {"free_length", 100},
    {"solid_length", 30}, {"solid_angle", 60}, {"arm_width", 16},     {"allowable_pressure", 1200}};

}  // namespace

const UsualProblem& usual_problem(const Mechanism& mechanism) {
  const auto found =
      std::find_if(all_problems().begin(), all_problems().end(),
                   [&](const UsualProblem& p) { return p.mechanism == mechanism.name; });
  if (found == all_problems().end()) {
    throw std::logic_error("no usual problem is stated for " + mechanism.name);
  }
  return *found;
}

double usual_input(std::string_view name) {
  const auto* const found = std::find_if(std::begin(kInputs), std::end(kInputs),
                                         [&](const UsualInput& i) { return i.name == name; });
  if (found == std::end(kInputs)) {
    throw std::logic_error("no usual value is stated for " + std::string(name));
  }
  return found->value;
}

}  // namespace camlaw::problems
