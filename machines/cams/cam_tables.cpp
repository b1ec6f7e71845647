// SPDX-License-Identifier: MIT
#include "machines/cams/cam_tables.h"

namespace camlaw::problems {

using optim::Part;

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
