// SPDX-License-Identifier: MIT
#include "machines/index_drives/index_tables.h"

#include <fmt/format.h>

#include <cmath>

#include "machines/index_drives/turret_responses.h"

namespace camlaw::problems {

using optim::Part;

Parameters stations_parameter(double stations) {
  return {{"stations", "S", "1", "1", "stops of the turret per revolution", stations, 3, 60, true}};
}

Parameters index_sizes(double axis_distance, double turret_radius) {
  return {{"axis_distance", "a", "mm", "m", "centre distance of cam and turret", axis_distance,
           1e-3, 1e5},
          {"turret_radius", "R_t", "mm", "m",
           "radius of the circle on which the rollers' centres lie", turret_radius, 1e-3, 1e5}};
}

Parameters turret_rollers(double rollers) {
  return {{"rollers", "N", "1", "1", "rollers of the turret", rollers, 3, 60, true}};
}

Parameters roller_radius_parameter(double radius) {
  return {{"roller_radius", "r_r", "mm", "m", "radius of a roller", radius, 1e-3, 1e5}};
}

Parameters roller_contact() {
  Parameters all = contact_parameters();
  all.front().meaning = "length of the contact along a roller";
  return all;
}

Parameters index_load() {
  return {{"speed", "n", "rpm", "rad/s", "speed of the cam", 100, 1e-3, 1e6},
          {"inertia", "J", "kg m2", "kg m2",
           "moment of inertia of everything that turns with the turret", 0.1, 0, 1e6},
          {"friction_torque", "M_C", "N m", "N m",
           "friction torque on the turret, which opposes its motion at any speed", 0, 0, 1e9},
          {"load_torque", "M_L", "N m", "N m",
           "constant torque on the turret that opposes its motion", 0, -1e9, 1e9}};
}

Parameters turret_crown() {
  Parameters all = crown_parameter();
  all.front().symbol = "R_k";  // R_c is a barrel's radius
  return all;
}

Parameters table_train() {
  Parameters all = oscillating_train();
  all.front().meaning =
      "stiffness of the train between turret and table; 0 stands for a rigid train, without the "
      "responses of its end";
  return all;
}

NamedPeak peak_turret_torque() {
  return {"peak_turret_torque", "turret_torque", Part::Magnitude,
          "greatest torque that turret, table and load require"};
}

NamedPeak shaft_clearance() {
  return {"shaft_clearance", "shaft_gap", Part::Lowest,
          "gap between the circle that the turning cam sweeps and the turret's shaft"};
}

std::vector<NamedPeak> rib_peaks() {
  const auto at_end = [](NamedPeak peak, const std::string& end, const char* where) {
    peak.curve = end + "_" + peak.curve;
    peak.name.replace(0, std::string("peak").size(), "peak_" + end);
    peak.meaning += where;
    return peak;
  };
  const char* const tip = " at the rollers' ends towards the cam's axis";
  return {peak_pressure_angle(), at_end(peak_pressure_angle(), "tip", tip),
          peak_turret_torque(),  peak_torque(),
          peak_stress(),         at_end(peak_stress(), "tip", tip),
          peak_end_deviation(),  least_elastic(table_words())};
}

std::string why_rollers_differ(double stations, double rollers, double advance, double handovers) {
  const double pitches = rollers * advance / stations;
  if (!(advance > 0))
    return fmt::format("an index drive advances by 1 station or more in a cycle; {:g} is given",
                       advance);
  constexpr double kRounding = 1e-9;
  if (std::abs(pitches - std::round(pitches)) > kRounding) {
    return fmt::format(
        "an advance by {:g} of {:g} stations is {:.4g} pitches of the {:g} rollers of a cam; it "
        "must be a whole number of pitches, or the cam does not repeat itself",
        advance, stations, pitches, rollers);
  }
  if (handovers > kMostHandovers + kRounding) {
    return fmt::format("{:g} rollers are handed over in a cycle; at most {} are accepted",
                       handovers, kMostHandovers);
  }
  return "";
}

std::string why_ribs_differ(std::span<const double> parameters, double advance) {
  const double stations = parameters[0], rollers = parameters[1];
  return why_rollers_differ(stations, rollers, advance, rollers / stations * advance);
}

}  // namespace camlaw::problems
