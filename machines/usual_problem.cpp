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
           .others = {"peak_stress", "peak_torque", "contact_loss_speed", "life", "outer_radius",
                      "cam_mass"},
           .segments = rise_and_return()},
          {.mechanism = "disc-cam-flat",
           .objective = "base_radius",
           .variables = {{"base_radius", 10, 200, 80}},
           .limits = {{"profile_radius", 5, kNone}, {"follower_force", 0, kNone}},
           .others = {"peak_stress", "peak_torque", "contact_loss_speed", "face_half_width",
                      "outer_radius", "cam_mass"},
           .segments = rise_and_return()},
          {.mechanism = "disc-cam-knife-edge",
           .objective = "base_radius",
           .variables = {{"base_radius", 5, 120, 60}},
           .limits = {{"pressure_angle", -40, 35}, {"profile_curvature", 0, kNone}},
           .others = {"peak_pressure_angle", "peak_force", "peak_torque", "contact_loss_speed",
                      "outer_radius", "cam_mass"},
           .segments = rise_and_return()},
          {.mechanism = "disc-cam-conjugate",
           .objective = "roller_distance",
           .variables = {{"base_radius", 20, 120, 50}, {"roller_distance", 60, 300, 180}},
           .limits = {{"pressure_angle", -35, 35},
                      {"second_pressure_angle", -35, 35},
                      {"second_base_radius", 25, kNone}},
           .others = {"peak_stress", "peak_torque", "undercut", "life", "outer_radius",
                      "second_outer_radius"},
           .segments = rise_and_return()},
          {.mechanism = "disc-cam-oscillating-roller",
           .objective = "peak_pressure_angle",
           .variables = {{"arm_length", 60, 120, 80}, {"pivot_distance", 80, 140, 100}},
           .limits = {{"undercut", kNone, 0.7}, {"follower_torque", 0, kNone}},
           .others = {"peak_stress", "peak_torque", "contact_loss_speed", "life", "outer_radius",
                      "cam_mass"},
           .segments = rise_and_return()},
          {.mechanism = "disc-cam-leading-roller",
           .objective = "base_radius",
           .variables = {{"base_radius", 20, 80, 60}},
           .limits = {{"pressure_angle", -40, 40}, {"undercut", kNone, 0.7}},
           .others = {"follower_torque", "peak_stress", "peak_torque", "contact_loss_speed", "life",
                      "outer_radius"},
           .constants = {{"swing", 18}, {"arm_length", 90}, {"pivot_distance", 110}},
           .segments = rise_and_return()},
          {.mechanism = "disc-cam-oscillating-flat",
           .objective = "base_radius",
           .variables = {{"base_radius", 10, 70, 50}},
           .limits = {{"profile_radius", 8, kNone}, {"contact_lever", 30, 180}},
           .others = {"follower_torque", "peak_stress", "peak_torque", "contact_loss_speed",
                      "outer_radius", "cam_mass"},
           .constants = {{"swing", 15}, {"face_offset", 4}, {"pivot_distance", 110}},
           .segments = rise_and_return()}};
}

std::vector<UsualProblem> other_cams() {
  return {{.mechanism = "end-cam",
           .objective = "radius",
           .variables = {{"radius", 5, 200, 60}},
           .limits = {{"pressure_angle", -35, 35}},
           .others = {"undercut", "follower_force", "peak_stress", "peak_torque",
                      "contact_loss_speed", "life"},
           .segments = rise_and_return()},
          {.mechanism = "end-cam-oscillating",
           .objective = "radius",
           .variables = {{"radius", 10, 200, 80}},
           .limits = {{"pressure_angle", -40, 35}},
           .others = {"undercut", "follower_torque", "peak_stress", "peak_torque",
                      "contact_loss_speed", "life"},
           .segments = rise_and_return()},
          {.mechanism = "linear-cam",
           .objective = "travel",
           .variables = {{"travel", 50, 1000, 400}},
           .limits = {{"pressure_angle", -35, 35}, {"undercut", kNone, 0.5}},
           .others = {"follower_force", "peak_plate_force", "peak_stress", "contact_loss_speed",
                      "life"},
           .segments = rise_and_return()}};
}

std::vector<UsualProblem> index_drives() {
  return {
      {.mechanism = "parallel-index-cam",
       .objective = "axis_distance",
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
       .segments = index_once(80, 200)},
      {.mechanism = "indexing-barrel",
       .objective = "cam_radius",
       .variables = {{"cam_radius", 30, 300, 120}, {"turret_radius", 40, 150, 80}},
       .limits = {{"tip_pressure_angle", -40, 40},
                  {"roller_gap", 14, kNone},
                  {"tip_contact_stress", kNone, 900}},
       .others = {"peak_stress", "peak_torque", "torque_rms", "undercut", "outer_radius", "wall"},
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
       .others = {"peak_stress", "peak_torque", "torque_rms", "undercut", "outer_radius", "wall"},
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
                  {"wheel_shaft_room", 60, kNone}},
       .others = {"peak_velocity", "peak_torque", "greatest_drive_torque", "crank_radius",
                  "wheel_radius"}},
      {.mechanism = "geneva-spherical",
       .objective = "speed",
       .sense = optim::Sense::Maximize,
       .variables = {{"slots", 4, 8, 6}, {"speed", 10, 200, 40}},
       .limits = {{"peak_torque", kNone, 150}},
       .others = {"peak_velocity", "peak_acceleration", "greatest_drive_torque", "mean_torque",
                  "engagement"},
       .constants = {{"inertia", 4}}}};
}

std::vector<UsualProblem> drives_and_trains() {
  return {{.mechanism = "servo-axis",
           .objective = "torque_rms",
           .variables = {{"gear_ratio", 1, 30, 8}},
           .limits = {{"torque_utilisation", kNone, 0.9}, {"inertia_ratio", kNone, 10}},
           .others = {"peak_torque", "peak_motor_speed", "peak_power", "speed_utilisation",
                      "rms_utilisation", "matched_ratio"},
           .segments = rise_and_return()},
          {.mechanism = "linear-servo-axis",
           .objective = "torque_rms",
           .variables = {{"gear_ratio", 1, 10, 3}},
           .limits = {{"torque_utilisation", kNone, 0.9}, {"rms_utilisation", kNone, 0.9}},
           .others = {"peak_torque", "peak_motor_speed", "peak_power", "speed_utilisation",
                      "inertia_ratio", "matched_ratio"},
           .segments = rise_and_return()},
          {.mechanism = "follower-train",
           .objective = "peak_mass_acceleration",
           .variables = {{"rise_angle", 60, 150, 90}},
           .limits = {{"residual_displacement", -0.05, 0.05}},
           .others = {"worst_residual", "residual_amplitude", "peak_deviation", "amplification",
                      "natural_frequency"},
           .law = "modified-sine"},
          {.mechanism = "law",
           .objective = "C_a",
           .limits = {{"C_v", kNone, 1.6}, {"C_j", kNone, 60}},
           .others = {"C_Mdyn", "acceleration", "mean_square_acceleration", "mean_square_jerk",
                      "residual_amplitude"},
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
                      {"surge_frequency", 400, kNone}},
           .others = {"rate", "outer_diameter", "free_length", "solid_stress", "buckling", "mass"}},
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
           .others = {"working_force", "stress_II", "stress_range_III", "free_length",
                      "working_length", "mass"},
           .constants = {{"parallel", 2}}}};
}

std::vector<UsualProblem> published_machines() {
  const std::vector<UsualProblem::Variable> springs_of_cam = {{"preload_ratio", 0.6, 2, 1},
                                                              {"cone_height", 0.65, 1, 0.75}};
  return {
      {.mechanism = "spine-cutter",
       .objective = "cam_radius",
       .variables = {{"cam_radius", 20, 80, 40}},
       .limits = {{"cam_pressure_angle", -30, 30}, {"peak_inertia_force", kNone, 20}},
       .others = {"minimum_cam_radius", "peak_drive_torque", "inertia_force", "drive_torque",
                  "blades_in_contact"},
       .law = "modified-sine"},
      {.mechanism = "die-press",
       .objective = "peak running_approach",
       .variables = {{"roller_radius", 20, 100, 50}, {"spring_preload", 0, 2000, 1000}},
       .limits = {{"lowest running_force", 100, kNone}, {"highest running_stress", kNone, 180}},
       .others = {"peak_force", "peak_stress", "peak_approach", "running_stress", "running_force"},
       .law = "cosine"},
      {.mechanism = "sheet-delivery",
       .objective = "lowest efficiency",
       .sense = optim::Sense::Maximize,
       .variables = {{"guide_ratio", 0.1, 2, 0.4}, {"rod_angle_max", 10, 75, 60}},
       .limits = {{"slow_down", 0.2, kNone}},
       .others = {"least_efficiency", "least_reverse_efficiency", "greatest_efficiency",
                  "efficiency", "relative_speed"},
       .law = "cycloidal"},
      {.mechanism = "signature-feeder",
       .objective = "peak drum_acceleration",
       .variables = {{"crank_radius", 60, 150, 92},
                     {"centre_distance", 400, 900, 702},
                     {"offset", 45, 200, 52}},
       .limits = {{"drum_swing", 240, kNone}, {"greatest_guide_length", kNone, 800}},
       .others = {"peak_velocity", "peak_acceleration", "drum_velocity", "rack_travel",
                  "guide_swing"}},
      {.mechanism = "balancing-cam",
       .objective = "spring_tension",
       .variables = springs_of_cam,
       .limits = {{"flattening", kNone, 0.75}, {"balancing_coefficient", 9.1, kNone}},
       .others = {"peak_residual_torque", "peak_stress", "peak_pressure_angle",
                  "least_roller_force", "spring_stress", "undercut"},
       .constants = {{"springs", 48}}},
      {.mechanism = "balancing-cam-spherical",
       .objective = "spring_tension",
       .variables = springs_of_cam,
       .limits = {{"flattening", kNone, 0.75}, {"balancing_coefficient", 3.7, kNone}},
       .others = {"peak_residual_torque", "peak_stress", "peak_pressure_angle",
                  "least_roller_force", "spring_stress", "undercut"},
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
