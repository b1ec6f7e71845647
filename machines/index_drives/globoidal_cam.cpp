// SPDX-License-Identifier: MIT
#include "machines/index_drives/globoidal_cam.h"

#include "machines/cams/buildable_checks.h"
#include "machines/index_drives/index_drives.h"
#include "machines/index_drives/index_tables.h"
#include "machines/index_drives/rib_responses.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {

Mechanism globoidal_cam_mechanism() {
  return checked(
      {.name = "globoidal-cam",
       .title = "roller gear index drive: a globoidal cam that turns a turret with radial rollers",
       .source = "docs/theory.md, Index drives",
       .parameters = parameters_of<GloboidalCam>(),
       .responses = rib_responses<GloboidalCam>(),
       .peaks = rib_peaks(),
       .moved_by = MovedBy::Program,
       .advances = {{.by = {"stations", "rollers"}, .why_open = why_ribs_differ}},
       .form = Form::RollerGear,
       .why_impossible = why_impossible_as<GloboidalCam>},
      {rib_checks(), ring_checks()});
}

}  // namespace camlaw::problems
