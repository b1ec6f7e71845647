// SPDX-License-Identifier: MIT
#include "machines/cams/cam_tables.h"

namespace camlaw::problems {

using optim::Part;

Parameters stroke_parameter() {
  return {{"stroke", "h", "mm", "m", "stroke of the follower, at displacement 1", 20, 1e-6, 1e5}};
}

Parameters swing_parameter() {
  return {{"swing", "Psi", "deg", "rad", "swing of the arm, at displacement 1", 20, 1e-6, 179}};
}

Parameters base_parameter() {
  return {{"base_radius", "r_b", "mm", "m", "least radius of the profile", 40, 1e-3, 1e5}};
}

Parameters roller_parameter() {
  return {{"roller_radius", "r_r", "mm", "m", "radius of the roller", 10, 1e-3, 1e5}};
}

Parameters offset_parameter() {
  return {{"offset", "e", "mm", "m",
           "offset of the follower's path from the cam's centre; above 0 it lowers the pressure "
           "angle of the rise",
           0, -1e5, 1e5}};
}

Parameters speed_parameter() {
  return {{"speed", "n", "rpm", "rad/s", "speed of the cam", 300, 1e-3, 1e6}};
}

Parameters sliding_load(double rate, double preload) {
  return {{"mass", "m", "kg", "kg", "mass that moves with the follower", 1, 0, 1e6},
          {"spring_rate", "c", "N/mm", "N/m",
           "rate of the spring that holds the follower on the cam", rate, 0, 1e6},
          {"spring_preload", "F_0", "N", "N", "force of the spring at the lowest position", preload,
           -1e9, 1e9},
          {"load", "F_L", "N", "N", "constant load on the follower that opposes the rise", 0, -1e9,
           1e9}};
}

Parameters oscillating_load(double rate, double preload) {
  return {{"inertia", "J", "kg m2", "kg m2", "moment of inertia of everything that swings", 0.002,
           0, 1e6},
          {"spring_rate", "c", "N m/deg", "N m/rad", "rate of the spring about the pivot", rate, 0,
           1e9},
          {"spring_preload", "M_0", "N m", "N m", "torque of the spring at the lowest position",
           preload, -1e9, 1e9},
          {"load", "M_L", "N m", "N m", "constant torque on the arm that opposes the rise", 0, -1e9,
           1e9}};
}

Parameters contact_parameters() {
  return {
      {"face_width", "b", "mm", "m", "width of the contact along the cam's axis", 15, 1e-3, 1e4},
      {"youngs_modulus", "E", "GPa", "Pa", "Young's modulus of cam and roller", 210, 1e-3, 1e4},
      {"poisson_ratio", "nu", "1", "1", "Poisson's ratio of cam and roller", 0.3, 0, 0.5}};
}

Parameters bore_parameter() {
  return {{"bore_radius", "r_0", "mm", "m", "radius of the cam's bore", 10, 0, 1e5}};
}

Parameters blank_parameters() {
  return joined({{{"density", "rho", "kg/m3", "kg/m3", "density of the cam", 7850, 1, 1e5}},
                 bore_parameter()});
}

Parameters friction_parameters() {
  return {{"guide_friction", "mu", "1", "1", "coefficient of friction of the follower's guide", 0,
           0, 1},
          {"guide_length", "l_g", "mm", "m", "length of the follower's guide", 60, 1e-3, 1e5}};
}

Parameters guide_parameters() {
  return joined(
      {friction_parameters(),
       {{"overhang", "a", "mm", "m",
         "distance of roller or edge from the guide at the lowest position", 40, 0, 1e5}}});
}

Parameters wear_parameter() {
  return {{"wear_coefficient", "k_w", "mm3/N/m", "m2/N",
           "wear coefficient after Archard: volume that the profile loses per force and length of "
           "sliding",
           1e-7, 0, 1}};
}

namespace {

Parameters train(const char* unit, const char* stored, const char* what) {
  return {
      {"train_stiffness", "c_t", unit, stored,
       "stiffness between the cam and the follower's end; 0 stands for a rigid follower, without "
       "the responses of its end",
       0, 0, 1e9},
      {"train_damping", "zeta", "1", "1",
       "damping ratio of the train: its damping over critical damping", 0.05, 0, 0.99},
      {"end_share", "kappa", "1", "1", what, 1, 1e-6, 1}};
}

}  // namespace

Parameters sliding_train() {
  return train("N/mm", "N/m", "fraction of the mass at the end of the train");
}

Parameters oscillating_train() {
  return train("N m/deg", "N m/rad", "fraction of the inertia at the end of the train");
}

Parameters cutter_parameter() {
  return {{"cutter_radius", "r_c", "mm", "m", "radius of the tool that cuts the profile", 10, 1e-3,
           1e4}};
}

Parameters bearing_parameters() {
  return {{"dynamic_rating", "C", "kN", "N", "basic dynamic load rating of the roller's bearing",
           10, 1e-3, 1e5},
          {"static_rating", "C_0", "kN", "N", "basic static load rating of the roller's bearing",
           10, 1e-3, 1e5},
          {"speed_limit", "n_G", "rpm", "rad/s", "permissible speed of the roller on its pin", 6000,
           1e-3, 1e6}};
}

Parameters crown_parameter() {
  return {{"crown_radius", "R_c", "mm", "m", "radius of the roller's crown along its axis", 500, 1,
           1e6}};
}

Parameters lubricant_parameters() {
  return {{"viscosity", "eta", "mPa s", "Pa s", "viscosity of the lubricant at the contact's inlet",
           50, 1e-3, 1e6},
          {"pressure_viscosity", "alpha", "1/GPa", "1/Pa",
           "pressure-viscosity coefficient of the lubricant", 20, 1e-3, 1e3},
          {"roughness", "R_q", "um", "m",
           "root mean square roughness of both surfaces, sqrt(R_q1^2 + R_q2^2)", 0.4, 1e-4, 1e3}};
}

Parameters duty_parameters() {
  return joined({crown_parameter(), bearing_parameters(), lubricant_parameters()});
}

Parameters joined(const std::vector<Parameters>& lists) {
  Parameters all;
  for (const Parameters& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

NamedPeak peak_pressure_angle() {
  return {"peak_pressure_angle", "pressure_angle", Part::Magnitude, "greatest pressure angle"};
}

NamedPeak peak_undercut() {
  return {"peak_undercut", "undercut", Part::Highest,
          "greatest roller radius over the pitch curve's radius of curvature"};
}

NamedPeak peak_torque() {
  return {"peak_torque", "drive_torque", Part::Magnitude, "greatest drive torque"};
}

NamedPeak peak_stress() {
  return {"peak_stress", "contact_stress", Part::Highest, "greatest contact stress"};
}

NamedPeak peak_outer_undercut() {
  return {"peak_outer_undercut", "outer_undercut", Part::Highest,
          "greatest roller radius over the pitch curve's radius of curvature, for the outer flank"};
}

NamedPeak peak_groove_stress() {
  return {"peak_groove_stress", "groove_stress", Part::Highest, "greatest stress in a groove"};
}

NamedPeak least_force() {
  return {"least_force", "follower_force", Part::Lowest,
          "least force along the follower's path; above 0 the spring keeps contact"};
}

NamedPeak least_torque() {
  return {"least_torque", "follower_torque", Part::Lowest,
          "least torque on the arm; above 0 the spring keeps contact"};
}

NamedPeak peak_force() {
  return {"peak_force", "follower_force", Part::Magnitude,
          "greatest force along the follower's path"};
}

NamedPeak outer_radius() {
  return {"outer_radius", "centre_distance", Part::Highest,
          "radius of the circle that the turning cam sweeps"};
}

NamedPeak least_wall() {
  return {"wall", "bore_gap", Part::Lowest, "least wall between profile and bore"};
}

NamedPeak pivot_clearance() {
  return {"pivot_clearance", "pivot_gap", Part::Lowest,
          "gap between the circle that the turning cam sweeps and the axis of the arm's pivot"};
}

}  // namespace camlaw::problems
