// SPDX-License-Identifier: MIT
#include "machines/index_drives/globoidal_cam.h"

#include "machines/cams/buildable_checks.h"
#include "machines/index_drives/index_tables.h"
#include "machines/index_drives/rib_duty.h"
#include "machines/model/usual_problem.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {

Mechanism globoidal_cam_mechanism() {
  return checked(
      {.name = "globoidal-cam",
       .title = "roller gear index drive: a globoidal cam that turns a turret with radial rollers",
       .source = "docs/theory.md, Index drives",
       .parameters = parameters_of<GloboidalCam>(),
       .responses = rib_drive_responses<GloboidalCam>(),
       .peaks = rib_peaks(),
       .moved_by = MovedBy::Program,
       .advances = {{.by = {"stations", "rollers"}, .why_open = why_ribs_differ}},
       .form = Form::RollerGear,
       .why_impossible = why_impossible_as<GloboidalCam>,
       .usual = usual_problem(
           {.objective = "axis_distance",
            .variables = {{"axis_distance", 100, 500, 220}, {"turret_radius", 50, 250, 100}},
            .limits = {{"tip_pressure_angle", kNone, 40},
                       {"roller_gap", 14, kNone},
                       {"tip_contact_stress", kNone, 1000}},
            .others = {"peak_stress", "peak_torque", "torque_rms", "undercut", "outer_radius",
                       "wall"},
            .constants = {{"stations", 8},
                          {"roller_radius", 13},
                          {"speed", 120},
                          {"inertia", 0.6},
                          {"friction_torque", 4},
                          {"face_width", 18},
                          {"bore_radius", 18}},
            .segments = index_once(120, 120)})},
      {rib_checks(), ring_checks()});
}

}  // namespace camlaw::problems
