// SPDX-License-Identifier: MIT
#include "kinematics/cams/end_cam.h"

#include "problems/cams/cams.h"
#include "problems/cams/follower_responses.h"

namespace camlaw::problems {

template <>
struct MachineTraits<EndCam> {
  static const std::vector<MechanismParameter>& parameters();
  template <class T>
  static constexpr std::array fields{&EndCam<T>::stroke,         &EndCam<T>::radius,
                                     &EndCam<T>::roller_radius,  &EndCam<T>::angular_speed,
                                     &EndCam<T>::mass,           &EndCam<T>::spring_rate,
                                     &EndCam<T>::spring_preload, &EndCam<T>::load};
};

const std::vector<MechanismParameter>& MachineTraits<EndCam>::parameters() {
  static const std::vector<MechanismParameter> all{
      {"stroke", "h", "mm", "m", "stroke of the follower, at displacement 1", 20, 1e-06, 100000.0},
      {"radius", "R", "mm", "m", "mean radius of the roller's track", 50, 0.001, 100000.0},
      {"roller_radius", "r_r", "mm", "m", "radius of the roller", 10, 0.001, 100000.0},
      {"speed", "n", "rpm", "rad/s", "speed of the cam", 300, 0.001, 1000000.0},
      {"mass", "m", "kg", "kg", "mass that moves with the follower", 1, 0, 1000000.0},
      {"spring_rate", "c", "N/mm", "N/m", "rate of the spring that closes the pair", 0, 0,
       1000000.0},
      {"spring_preload", "F_0", "N", "N", "force of the spring at the lowest place", 0,
       -1000000000.0, 1000000000.0},
      {"load", "F_L", "N", "N", "constant load against the rise", 0, -1000000000.0, 1000000000.0}};
  return all;
}

namespace {

using optim::Part;
using S = optim::Shape;

enum class Curve { PressureAngle, PitchCurvature, Undercut, ContactForce };

MechanismResponse curve(Curve which, ResponseAbout about) {
  return listed_curve<EndCam>(std::move(about), turn_of_the_cam(), which,
                              [](const auto& cam, Curve wanted, const auto& motion) {
                                const auto f = cam.over_angle(motion);
                                switch (wanted) {
                                  case Curve::PressureAngle:
                                    return cam.pressure_angle(f);
                                  case Curve::PitchCurvature:
                                    return cam.pitch_curvature(f);
                                  case Curve::Undercut:
                                    return cam.undercut(f);
                                  case Curve::ContactForce:
                                    break;
                                }
                                return cam.contact_force(f);
                              });
}

}  // namespace

Mechanism end_cam_mechanism() {
  std::vector<MechanismResponse> responses = follower_responses<EndCam>(kSliding);
  responses.push_back(curve(Curve::PressureAngle, {"pressure_angle",
                                                   "deg",
                                                   "rad",
                                                   "pressure angle, signed as the slope",
                                                   {{{"law", "radius"}, S::Quasilinear},
                                                    {{"stroke", "radius"}, S::Quasilinear}}}));
  responses.push_back(curve(Curve::PitchCurvature,
                            {"pitch_curvature", "1/mm", "1/m",
                             "curvature of the developed pitch curve, positive where hollow"}));
  responses.push_back(curve(Curve::Undercut, {"undercut", "1", "1",
                                              "share of the pitch curve's radius that the roller "
                                              "takes, signed; at 1 or -1 a track is undercut"}));
  responses.push_back(
      curve(Curve::ContactForce, {"contact_force", "N", "N", "force between roller and cam"}));
  return {.name = "end-cam",
          .title = "end or barrel cam with a roller that moves along its axis",
          .source = "docs/theory.md, Cams",
          .parameters = MachineTraits<EndCam>::parameters(),
          .responses = std::move(responses),
          .peaks = {{"peak_pressure_angle", "pressure_angle", Part::Magnitude,
                     "greatest pressure angle"},
                    {"least_force", "follower_force", Part::Lowest,
                     "least force along the follower's way; above 0 the spring keeps contact"},
                    {"peak_force", "follower_force", Part::Magnitude,
                     "greatest force along the follower's way"},
                    {"peak_torque", "drive_torque", Part::Magnitude, "greatest drive torque"}},
          .moved_by = MovedBy::Program};
}

}  // namespace camlaw::problems
