// SPDX-License-Identifier: MIT
#include "machines/index_drives/globoidal_cam.h"

#include "machines/cams/buildable_checks.h"
#include "machines/index_drives/index_drives.h"
#include "machines/index_drives/index_tables.h"
#include "machines/index_drives/rib_responses.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {

template <>
struct MachineTraits<GloboidalCam> {
  static const std::vector<MechanismParameter>& parameters();
  template <class T>
  static constexpr std::array<T GloboidalCam<T>::*, 17> fields{
      &GloboidalCam<T>::stations,       &GloboidalCam<T>::rollers,
      &GloboidalCam<T>::axis_distance,  &GloboidalCam<T>::turret_radius,
      &GloboidalCam<T>::roller_radius,  &GloboidalCam<T>::angular_speed,
      &GloboidalCam<T>::inertia,        &GloboidalCam<T>::friction,
      &GloboidalCam<T>::load,           &GloboidalCam<T>::face_width,
      &GloboidalCam<T>::youngs_modulus, &GloboidalCam<T>::poisson_ratio,
      &GloboidalCam<T>::bore_radius,    &GloboidalCam<T>::train_stiffness,
      &GloboidalCam<T>::train_damping,  &GloboidalCam<T>::end_share,
      &GloboidalCam<T>::crown_radius};
};

const std::vector<MechanismParameter>& MachineTraits<GloboidalCam>::parameters() {
  static const Parameters all = joined(
      {stations_parameter(4), turret_rollers(8), index_sizes(120, 70), roller_radius_parameter(11),
       index_load(), roller_contact(), bore_parameter(), table_train(), turret_crown()});
  return all;
}

Mechanism globoidal_cam_mechanism() {
  return checked(
      {.name = "globoidal-cam",
       .title = "roller gear index drive: a globoidal cam that turns a turret with radial rollers",
       .source = "docs/theory.md, Index drives",
       .parameters = MachineTraits<GloboidalCam>::parameters(),
       .responses = rib_responses<GloboidalCam>(),
       .peaks = rib_peaks(),
       .moved_by = MovedBy::Program,
       .advances = {{.by = {"stations", "rollers"}, .why_open = why_ribs_differ}},
       .form = Form::RollerGear,
       .why_impossible = why_impossible_as<GloboidalCam>},
      {rib_checks(), ring_checks()});
}

}  // namespace camlaw::problems
