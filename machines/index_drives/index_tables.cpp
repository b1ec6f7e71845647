// SPDX-License-Identifier: MIT
#include "machines/index_drives/index_tables.h"

#include <fmt/format.h>

#include <cmath>

#include "machines/index_drives/turret_responses.h"

namespace camlaw::problems {

using optim::Part;

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
  constexpr double kRounding = 1e-9;  // of a pitch: what is meant to be an integer
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
