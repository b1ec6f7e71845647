// SPDX-License-Identifier: MIT
#include "machines/cams/conjugate_cam.h"

#include "machines/cams/buildable_checks.h"
#include "machines/cams/cam_tables.h"
#include "machines/cams/cams.h"
#include "machines/cams/extent_responses.h"
#include "machines/cams/follower_responses.h"
#include "machines/cams/roller_responses.h"
#include "machines/model/append.h"

namespace camlaw::problems {

template <>
struct MachineTraits<ConjugateCam> {
  static const std::vector<MechanismParameter>& parameters();
  template <class T>
  static constexpr std::array fields{&ConjugateCam<T>::stroke,
                                     &ConjugateCam<T>::base_radius,
                                     &ConjugateCam<T>::roller_radius,
                                     &ConjugateCam<T>::offset,
                                     &ConjugateCam<T>::roller_distance,
                                     &ConjugateCam<T>::angular_speed,
                                     &ConjugateCam<T>::mass,
                                     &ConjugateCam<T>::spring_rate,
                                     &ConjugateCam<T>::spring_preload,
                                     &ConjugateCam<T>::load,
                                     &ConjugateCam<T>::face_width,
                                     &ConjugateCam<T>::youngs_modulus,
                                     &ConjugateCam<T>::poisson_ratio,
                                     &ConjugateCam<T>::cutter_radius,
                                     &ConjugateCam<T>::bore_radius};
};

const std::vector<MechanismParameter>& MachineTraits<ConjugateCam>::parameters() {
  static const Parameters all =
      joined({stroke_parameter(),
              base_parameter(),
              roller_parameter(),
              offset_parameter(),
              {{"roller_distance", "D", "mm", "m",
                "distance of the two rollers, along the carriage's path", 140, 1e-3, 1e5}},
              speed_parameter(),
              sliding_load(0, 0),
              contact_parameters(),
              cutter_parameter(),
              bore_parameter()});
  return all;
}

namespace {

using C = RollerCurve;

/// Geometry of the main cam or, with the complementary motion, of the second one.
enum class Of { Main, Second };

MechanismResponse geometry(Of cam_of, C which, ResponseAbout about) {
  return listed_curve<ConjugateCam>(
      std::move(about), turn_of_the_cam(), std::pair(cam_of, which),
      [](const auto& cam, std::pair<Of, C> wanted, const auto& motion) {
        const auto f = cam.over_angle(motion);
        return wanted.first == Of::Main
                   ? roller_curve(cam.main(), wanted.second, f)
                   : roller_curve(cam.second(), wanted.second, cam.second_motion(f));
      });
}

void add_geometry(std::vector<MechanismResponse>& all, Of of) {
  const std::string prefix = of == Of::Main ? "" : "second_";
  const std::string cam = of == Of::Main ? " of the main cam" : " of the second cam";
  const auto add = [&](C which, const char* name, const char* unit, const char* stored,
                       const std::string& meaning) {
    all.push_back(geometry(of, which, {prefix + name, unit, stored, meaning}));
  };
  add(C::PressureAngle, "pressure_angle", "deg", "rad",
      "pressure angle" + cam + ", signed as the slope of its own motion");
  add(C::Undercut, "undercut", "1", "1",
      "share of the pitch curve's radius that the roller takes" + cam + "; at 1 it is undercut");
  add(C::PitchCurvature, "pitch_curvature", "1/mm", "1/m",
      "curvature of the pitch curve" + cam + ", positive where convex");
  add(C::ProfileCurvature, "profile_curvature", "1/mm", "1/m",
      "curvature of the profile" + cam + ", positive where convex");
  add(C::ToolFit, "tool_fit", "1", "1",
      "share of a hollow's radius that the tool takes" + cam + "; above 1 it does not fit");
}

enum class Bearing { Force, Stress };

MechanismResponse bearing(Bearing which, ResponseAbout about) {
  return listed_curve<ConjugateCam>(std::move(about), turn_of_the_cam(), which,
                                    [](const auto& cam, Bearing wanted, const auto& motion) {
                                      const auto f = cam.over_angle(motion);
                                      return wanted == Bearing::Force ? cam.contact_force(f)
                                                                      : cam.contact_stress(f);
                                    });
}

MechanismResponse second_profile(DrawnCurve which, const char* name) {
  return drawn_response<ConjugateCam>(
      which, name, "profile of the second cam, in the coordinates of the main one");
}

std::vector<MechanismResponse> conjugate_responses() {
  std::vector<MechanismResponse> all = follower_responses<ConjugateCam>(kSliding);
  add_geometry(all, Of::Main);
  add_geometry(all, Of::Second);
  all.push_back(bearing(Bearing::Force,
                        {"contact_force", "N", "N",
                         "force between the cam that bears and its roller, above 0 where it is "
                         "the main one"}));
  all.push_back(bearing(Bearing::Stress, {"contact_stress", "MPa", "Pa",
                                          "greatest Hertz pressure on the cam that bears"}));
  for (const char* undercut : {"undercut", "second_undercut"}) {
    set_defined_while(all, {"contact_stress"}, {.response = undercut, .upper = 1});
  }
  append(all, drawn_responses<ConjugateCam>(false));
  all.push_back(second_profile(DrawnCurve::SecondX, "second_profile_x"));
  all.push_back(second_profile(DrawnCurve::SecondY, "second_profile_y"));
  append(all, extent_responses<ConjugateCam>());
  all.push_back(number_response<ConjugateCam>(
      {"second_base_radius", "mm", "m",
       "radius of the second cam's profile at displacement 1, its least for programs up to there"},
      [](const auto& cam) { return cam.second_base_radius(); }));
  return all;
}

NamedPeak of_second(NamedPeak peak) {
  const bool is_peak = peak.name.starts_with("peak");
  return {is_peak ? peak.name.replace(0, std::string("peak").size(), "peak_second")
                  : "second_" + peak.name,
          "second_" + peak.curve, peak.part, peak.meaning + " of the second cam"};
}

}  // namespace

Mechanism conjugate_cam_mechanism() {
  return checked(
      {.name = "disc-cam-conjugate",
       .title = "pair of conjugate disc cams that move a carriage with two rollers",
       .source = "docs/theory.md, Cams",
       .parameters = MachineTraits<ConjugateCam>::parameters(),
       .responses = conjugate_responses(),
       .peaks = {peak_pressure_angle(), of_second(peak_pressure_angle()), peak_undercut(),
                 of_second(peak_undercut()), peak_force(), peak_torque(), peak_stress(),
                 outer_radius(), of_second(outer_radius()), least_wall(), of_second(least_wall())},
       .moved_by = MovedBy::Program,
       .form = Form::DiscConjugate,
       .possible = {{{"stroke", "roller_distance"}, "DS2"},
                    {{"base_radius"}, "DS2"},
                    {{"roller_radius"}, "DS2"}}},
      {conjugate_checks()});
}

}  // namespace camlaw::problems
