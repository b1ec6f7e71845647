// SPDX-License-Identifier: MIT
#include "kinematics/cams/end_cam.h"

#include "problems/cams/cam_tables.h"
#include "problems/cams/cams.h"
#include "problems/cams/follower_responses.h"
#include "problems/cams/roller_responses.h"

namespace camlaw::problems {

template <>
struct MachineTraits<EndCam> {
  static const std::vector<MechanismParameter>& parameters();
  template <class T>
  static constexpr std::array<T EndCam<T>::*, 11> fields{
      &EndCam<T>::stroke,         &EndCam<T>::radius,       &EndCam<T>::roller_radius,
      &EndCam<T>::angular_speed,  &EndCam<T>::mass,         &EndCam<T>::spring_rate,
      &EndCam<T>::spring_preload, &EndCam<T>::load,         &EndCam<T>::face_width,
      &EndCam<T>::youngs_modulus, &EndCam<T>::poisson_ratio};
};

const std::vector<MechanismParameter>& MachineTraits<EndCam>::parameters() {
  static const Parameters all =
      joined({stroke_parameter(),
              {{"radius", "R", "mm", "m", "mean radius of the roller's track", 50, 1e-3, 1e5}},
              roller_parameter(),
              speed_parameter(),
              sliding_load(0, 0),
              contact_parameters()});
  return all;
}

namespace {

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
  responses.push_back(roller_response<EndCam>(RollerCurve::OuterUndercut, outer_undercut_about()));
  responses.push_back(roller_response<EndCam>(RollerCurve::GrooveStress, groove_stress_about()));
  return {.name = "end-cam",
          .title = "end or barrel cam with a roller that moves along its axis",
          .source = "docs/theory.md, Cams",
          .parameters = MachineTraits<EndCam>::parameters(),
          .responses = std::move(responses),
          .peaks = {peak_pressure_angle(), least_force(), peak_force(), peak_torque(),
                    peak_outer_undercut(), peak_groove_stress()},
          .moved_by = MovedBy::Program};
}

}  // namespace camlaw::problems
