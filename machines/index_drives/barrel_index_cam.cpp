// SPDX-License-Identifier: MIT
#include "machines/index_drives/barrel_index_cam.h"

#include "machines/cams/buildable_checks.h"
#include "machines/index_drives/index_drives.h"
#include "machines/index_drives/index_tables.h"
#include "machines/index_drives/rib_responses.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {

Mechanism barrel_index_cam_mechanism() {
  return checked(
      {.name = "indexing-barrel",
       .title = "barrel index drive: a barrel cam that turns a turret with axial rollers",
       .source = "docs/theory.md, Index drives",
       .parameters = parameters_of<BarrelIndexCam>(),
       .responses = rib_responses<BarrelIndexCam>(),
       .peaks = rib_peaks(),
       .moved_by = MovedBy::Program,
       .advances = {{.by = {"stations", "rollers"}, .why_open = why_ribs_differ}},
       .form = Form::BarrelIndex,
       .why_impossible = why_impossible_as<BarrelIndexCam>},
      {rib_checks(), ring_checks()});
}

}  // namespace camlaw::problems
