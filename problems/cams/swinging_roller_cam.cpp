// SPDX-License-Identifier: MIT
#include "kinematics/cams/swinging_roller_cam.h"

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
  static const std::vector<MechanismParameter> all{
      {"swing", "Psi", "deg", "rad", "swing of the arm, at displacement 1", 20, 1e-06, 179},
      {"base_radius", "r_b", "mm", "m", "least radius of the profile", 40, 0.001, 100000.0},
      {"roller_radius", "r_r", "mm", "m", "radius of the roller", 10, 0.001, 100000.0},
      {"arm_length", "l", "mm", "m", "length of the arm", 80, 0.001, 100000.0},
      {"pivot_distance", "d", "mm", "m", "distance of the arm's pivot from the cam's centre", 100,
       0.001, 100000.0},
      {"speed", "n", "rpm", "rad/s", "speed of the cam", 300, 0.001, 1000000.0},
      {"inertia", "J", "kg m2", "kg m2", "moment of inertia of all that swings", 0.002, 0,
       1000000.0},
      {"spring_rate", "c", "N m/deg", "N m/rad", "rate of the spring about the pivot", 0.2, 0,
       1000000000.0},
      {"spring_preload", "M_0", "N m", "N m", "torque of the spring at the lowest place", 3,
       -1000000000.0, 1000000000.0},
      {"load", "M_L", "N m", "N m", "constant torque against the rise", 0, -1000000000.0,
       1000000000.0},
      {"face_width", "b", "mm", "m", "width of the contact along the cam's axis", 15, 0.001,
       10000.0},
      {"youngs_modulus", "E", "GPa", "Pa", "Young's modulus of cam and roller", 210, 0.001,
       10000.0},
      {"poisson_ratio", "nu", "1", "1", "Poisson's ratio of cam and roller", 0.3, 0, 0.5},
      {"cutter_radius", "r_c", "mm", "m", "radius of the tool that cuts the profile", 10, 0.001,
       10000.0}};
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
          .peaks = {{"peak_pressure_angle", "pressure_angle", Part::Magnitude,
                     "greatest pressure angle"},
                    {"peak_undercut", "undercut", Part::Highest,
                     "greatest share of the pitch curve's radius that the roller takes"},
                    {"peak_torque", "drive_torque", Part::Magnitude, "greatest drive torque"},
                    {"peak_stress", "contact_stress", Part::Highest, "greatest contact stress"},
                    {"least_torque", "follower_torque", Part::Lowest,
                     "least torque on the arm; above 0 the spring keeps contact"}},
          .moved_by = MovedBy::Program};
}

}  // namespace camlaw::problems
