// SPDX-License-Identifier: MIT
#include "kinematics/cams/roller_cam.h"

#include "problems/cams/cams.h"
#include "problems/cams/follower_responses.h"
#include "problems/cams/roller_responses.h"

namespace camlaw::problems {

template <>
struct MachineTraits<RollerCam> {
  static const std::vector<MechanismParameter>& parameters();
  template <class T>
  static constexpr std::array fields{
      &RollerCam<T>::stroke,       &RollerCam<T>::base_radius,    &RollerCam<T>::roller_radius,
      &RollerCam<T>::offset,       &RollerCam<T>::angular_speed,  &RollerCam<T>::mass,
      &RollerCam<T>::spring_rate,  &RollerCam<T>::spring_preload, &RollerCam<T>::load,
      &RollerCam<T>::face_width,   &RollerCam<T>::youngs_modulus, &RollerCam<T>::poisson_ratio,
      &RollerCam<T>::cutter_radius};
};

const std::vector<MechanismParameter>& MachineTraits<RollerCam>::parameters() {
  static const std::vector<MechanismParameter> all{
      {"stroke", "h", "mm", "m", "stroke of the follower, at displacement 1", 20, 1e-06, 100000.0},
      {"base_radius", "r_b", "mm", "m", "least radius of the profile", 40, 0.001, 100000.0},
      {"roller_radius", "r_r", "mm", "m", "radius of the roller", 10, 0.001, 100000.0},
      {"offset", "e", "mm", "m", "distance of the follower's way from the cam's centre", 0,
       -100000.0, 100000.0},
      {"speed", "n", "rpm", "rad/s", "speed of the cam", 300, 0.001, 1000000.0},
      {"mass", "m", "kg", "kg", "mass that moves with the follower", 1, 0, 1000000.0},
      {"spring_rate", "c", "N/mm", "N/m", "rate of the spring that closes the pair", 5, 0,
       1000000.0},
      {"spring_preload", "F_0", "N", "N", "force of the spring at the lowest place", 50,
       -1000000000.0, 1000000000.0},
      {"load", "F_L", "N", "N", "constant load against the rise", 0, -1000000000.0, 1000000000.0},
      {"face_width", "b", "mm", "m", "width of the contact along the cam's axis", 15, 0.001,
       10000.0},
      {"youngs_modulus", "E", "GPa", "Pa", "Young's modulus of cam and roller", 210, 0.001,
       10000.0},
      {"poisson_ratio", "nu", "1", "1", "Poisson's ratio of cam and roller", 0.3, 0, 0.5},
      {"cutter_radius", "r_c", "mm", "m", "radius of the tool that cuts the profile", 10, 0.001,
       10000.0}};
  return all;
}

Mechanism roller_cam_mechanism() {
  using optim::Part;
  using S = optim::Shape;
  std::vector<MechanismResponse> responses = follower_responses<RollerCam>(kSliding);
  for (MechanismResponse& response :
       roller_responses<RollerCam>({{{"law"}, S::Quasilinear},
                                    {{"stroke"}, S::Quasilinear},
                                    {{"base_radius"}, S::Quasilinear},
                                    {{"roller_radius"}, S::Quasilinear}})) {
    responses.push_back(std::move(response));
  }
  return {.name = "disc-cam-roller",
          .title = "disc cam with a translating roller follower",
          .source = "docs/theory.md, Cams",
          .parameters = MachineTraits<RollerCam>::parameters(),
          .responses = std::move(responses),
          .peaks = {{"peak_pressure_angle", "pressure_angle", Part::Magnitude,
                     "greatest pressure angle"},
                    {"peak_undercut", "undercut", Part::Highest,
                     "greatest share of the pitch curve's radius that the roller takes"},
                    {"least_force", "follower_force", Part::Lowest,
                     "least force along the follower's way; above 0 the spring keeps contact"},
                    {"peak_force", "follower_force", Part::Magnitude,
                     "greatest force along the follower's way"},
                    {"peak_torque", "drive_torque", Part::Magnitude, "greatest drive torque"},
                    {"peak_stress", "contact_stress", Part::Highest, "greatest contact stress"}},
          .moved_by = MovedBy::Program};
}

}  // namespace camlaw::problems
