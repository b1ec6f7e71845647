// SPDX-License-Identifier: MIT
#include "kinematics/cams/swinging_roller_cam.h"

#include "problems/cams/cam_tables.h"
#include "problems/cams/cams.h"
#include "problems/cams/follower_responses.h"
#include "problems/cams/roller_responses.h"

namespace camlaw::problems {

template <>
struct MachineTraits<SwingingRollerCam> {
  static const std::vector<MechanismParameter>& parameters();
  template <class T>
  static constexpr std::array fields{
      &SwingingRollerCam<T>::swing,          &SwingingRollerCam<T>::base_radius,
      &SwingingRollerCam<T>::roller_radius,  &SwingingRollerCam<T>::arm_length,
      &SwingingRollerCam<T>::pivot_distance, &SwingingRollerCam<T>::angular_speed,
      &SwingingRollerCam<T>::inertia,        &SwingingRollerCam<T>::spring_rate,
      &SwingingRollerCam<T>::spring_preload, &SwingingRollerCam<T>::load,
      &SwingingRollerCam<T>::face_width,     &SwingingRollerCam<T>::youngs_modulus,
      &SwingingRollerCam<T>::poisson_ratio,  &SwingingRollerCam<T>::cutter_radius};
};

const std::vector<MechanismParameter>& MachineTraits<SwingingRollerCam>::parameters() {
  static const Parameters all = joined(
      {{{"swing", "Psi", "deg", "rad", "swing of the arm, at displacement 1", 20, 1e-6, 179}},
       base_parameter(),
       roller_parameter(),
       {{"arm_length", "l", "mm", "m", "length of the arm", 80, 1e-3, 1e5},
        {"pivot_distance", "d", "mm", "m", "distance of the arm's pivot from the cam's centre", 100,
         1e-3, 1e5}},
       speed_parameter(),
       {{"inertia", "J", "kg m2", "kg m2", "moment of inertia of all that swings", 0.002, 0, 1e6},
        {"spring_rate", "c", "N m/deg", "N m/rad", "rate of the spring about the pivot", 0.2, 0,
         1e9},
        {"spring_preload", "M_0", "N m", "N m", "torque of the spring at the lowest place", 3, -1e9,
         1e9},
        {"load", "M_L", "N m", "N m", "constant torque against the rise", 0, -1e9, 1e9}},
       contact_parameters(),
       cutter_parameter()});
  return all;
}

Mechanism swinging_roller_cam_mechanism() {
  using optim::Part;
  std::vector<MechanismResponse> responses = follower_responses<SwingingRollerCam>(kSwinging);
  for (MechanismResponse& response : roller_responses<SwingingRollerCam>({})) {
    responses.push_back(std::move(response));
  }
  return {.name = "disc-cam-swinging-roller",
          .title = "disc cam with an oscillating roller follower",
          .source = "docs/theory.md, Cams",
          .parameters = MachineTraits<SwingingRollerCam>::parameters(),
          .responses = std::move(responses),
          .peaks = {peak_pressure_angle(),
                    peak_undercut(),
                    peak_torque(),
                    peak_stress(),
                    {"least_torque", "follower_torque", Part::Lowest,
                     "least torque on the arm; above 0 the spring keeps contact"}},
          .moved_by = MovedBy::Program};
}

}  // namespace camlaw::problems
