// SPDX-License-Identifier: MIT
#include "machines/index_drives/barrel_index_cam.h"

#include "machines/cams/buildable_checks.h"
#include "machines/index_drives/index_tables.h"
#include "machines/index_drives/rib_duty.h"
#include "machines/model/usual_problem.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {

Mechanism barrel_index_cam_mechanism() {
  return checked(
      {.name = "indexing-barrel",
       .title = "barrel index drive: a barrel cam that turns a turret with axial rollers",
       .source = "docs/theory.md, Index drives",
       .parameters = parameters_of<BarrelIndexCam>(),
       .responses = rib_drive_responses<BarrelIndexCam>(),
       .peaks = rib_peaks(),
       .moved_by = MovedBy::Program,
       .advances = {{.by = {"stations", "rollers"}, .why_open = why_ribs_differ}},
       .form = Form::BarrelIndex,
       .why_impossible = why_impossible_as<BarrelIndexCam>,
       .usual = usual_problem(
           {.objective = "cam_radius",
            .variables = {{"cam_radius", 30, 300, 120}, {"turret_radius", 40, 150, 80}},
            .limits = {{"tip_pressure_angle", -40, 40},
                       {"roller_gap", 14, kNone},
                       {"tip_contact_stress", kNone, 900}},
            .others = {"peak_stress", "peak_torque", "torque_rms", "undercut", "outer_radius",
                       "wall"},
            .constants = {{"stations", 8},
                          {"axis_distance", 57},
                          {"roller_radius", 13},
                          {"speed", 120},
                          {"inertia", 2},
                          {"friction_torque", 4},
                          {"face_width", 18},
                          {"bore_radius", 18}},
            .segments = index_once(120, 120)})},
      {rib_checks(), ring_checks()});
}

}  // namespace camlaw::problems
