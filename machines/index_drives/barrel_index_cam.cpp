// SPDX-License-Identifier: MIT
#include "machines/index_drives/barrel_index_cam.h"

#include "machines/cams/buildable_checks.h"
#include "machines/index_drives/index_drives.h"
#include "machines/index_drives/index_tables.h"
#include "machines/index_drives/rib_responses.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {

template <>
struct MachineTraits<BarrelIndexCam> {
  static const std::vector<MechanismParameter>& parameters();
  template <class T>
  static constexpr std::array<T BarrelIndexCam<T>::*, 18> fields{
      &BarrelIndexCam<T>::stations,        &BarrelIndexCam<T>::rollers,
      &BarrelIndexCam<T>::axis_distance,   &BarrelIndexCam<T>::turret_radius,
      &BarrelIndexCam<T>::cam_radius,      &BarrelIndexCam<T>::roller_radius,
      &BarrelIndexCam<T>::angular_speed,   &BarrelIndexCam<T>::inertia,
      &BarrelIndexCam<T>::friction,        &BarrelIndexCam<T>::load,
      &BarrelIndexCam<T>::face_width,      &BarrelIndexCam<T>::youngs_modulus,
      &BarrelIndexCam<T>::poisson_ratio,   &BarrelIndexCam<T>::bore_radius,
      &BarrelIndexCam<T>::train_stiffness, &BarrelIndexCam<T>::train_damping,
      &BarrelIndexCam<T>::end_share,       &BarrelIndexCam<T>::crown_radius};
};

const std::vector<MechanismParameter>& MachineTraits<BarrelIndexCam>::parameters() {
  static const Parameters all =
      joined({stations_parameter(4),
              turret_rollers(8),
              index_sizes(80, 80),
              {{"cam_radius", "R_c", "mm", "m", "radius of the cam at the middle of a roller", 60,
                1e-3, 1e5}},
              roller_radius_parameter(12),
              index_load(),
              roller_contact(),
              bore_parameter(),
              table_train(),
              turret_crown()});
  return all;
}

Mechanism barrel_index_cam_mechanism() {
  return checked(
      {.name = "indexing-barrel",
       .title = "barrel index drive: a barrel cam that turns a turret with axial rollers",
       .source = "docs/theory.md, Index drives",
       .parameters = MachineTraits<BarrelIndexCam>::parameters(),
       .responses = rib_responses<BarrelIndexCam>(),
       .peaks = rib_peaks(),
       .moved_by = MovedBy::Program,
       .advances = {{.by = {"stations", "rollers"}, .why_open = why_ribs_differ}},
       .form = Form::BarrelIndex,
       .why_impossible = why_impossible_as<BarrelIndexCam>},
      {rib_checks(), ring_checks()});
}

}  // namespace camlaw::problems
