// SPDX-License-Identifier: MIT
#include "machines/spine_cutter.h"

#include "machines/model/append.h"
#include "machines/model/responses.h"
#include "machines/model/usual_problem.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {
namespace {

using optim::Part, optim::Shape;

std::vector<MechanismResponse> cutter_numbers() {
  return {
      number_response<SpineCutter>({"chord_of_contact",
                                    "mm",
                                    "m",
                                    "chord of the cutter's contact",
                                    {{{"depth", "cutter_diameter"}, Shape::Concave, "DS7"}}},
                                   [](const auto& m) { return m.chord_of_contact(); }),
      number_response<SpineCutter>({"contact_angle",
                                    "deg",
                                    "rad",
                                    "angle of the cutter's contact",
                                    {{{"depth", "cutter_diameter"}, Shape::Quasilinear, "DS7"}}},
                                   [](const auto& m) { return m.contact_angle(); }),
      number_response<SpineCutter>({"blades_in_contact",
                                    "1",
                                    "1",
                                    "blades in contact at a time",
                                    {{{"depth", "cutter_diameter"}, Shape::Quasilinear, "DS7"},
                                     {{"blades", "depth"}, Shape::Quasiconcave, "DS7"}}},
                                   [](const auto& m) { return m.blades_in_contact(); }),
      number_response<SpineCutter>(
          {"path_per_revolution", "mm", "m", "travel of the block in one revolution"},
          [](const auto& m) { return m.path_per_revolution(); }),
      number_response<SpineCutter>(
          {"angular_velocity",
           "rad/s",
           "rad/s",
           "angular velocity of the cutter",
           {{{"block_speed", "depth", "cutter_diameter"}, Shape::Quasilinear, "DS7"}}},
          [](const auto& m) { return m.angular_velocity(); })};
}

/// A curve over one revolution of the cam.
template <class F>
MechanismResponse curve(ResponseAbout about, F formula) {
  static const Cycle revolution{"deg", {{0, 180}, {180, 360, true}}};
  return curve_response<SpineCutter>(std::move(about), revolution, formula);
}

std::vector<MechanismResponse> cutter_curves() {
  const std::vector<std::string> speeds{"block_speed", "depth", "cutter_diameter"};
  return {
      curve({"cam_pressure_angle",
             "deg",
             "rad",
             "pressure angle on the cam",
             {{{"law", "cam_radius"}, Shape::Quasilinear, "DS8"}}},
            [](const auto& m, const auto& motion) { return atan(m.pressure_scale() * motion.v); }),
      curve({"required_cam_radius", "mm", "m",
             "cam radius that the permissible pressure angle requires, with the sign of s'"},
            [](const auto& m, const auto& motion) { return m.radius_scale() * motion.v; }),
      curve({"inertia_force",
             "N",
             "N",
             "inertia force of the moved mass",
             {{speeds, Shape::Quasilinear, "DS7"}}},
            [](const auto& m, const auto& motion) { return m.force_scale() * motion.a; }),
      curve({"drive_torque",
             "N m",
             "N m",
             "torque of the inertia force on the cam's axis",
             {{speeds, Shape::Quasilinear, "DS7"}}},
            [](const auto& m, const auto& motion) {
              return m.torque_scale() * (motion.v * motion.a);
            }),
      curve({"displacement", "mm", "m", "axial displacement of the cutter"},
            [](const auto& m, const auto& motion) { return m.stroke * motion.s; })};
}

}  // namespace

Mechanism spine_cutter_mechanism() {
  std::vector<MechanismResponse> responses = cutter_numbers();
  append(responses, cutter_curves());
  return {.name = "spine-cutter",
          .title = "spine-notching cutter stroked by a face cam",
          .source = "Tekhnolohiia i tekhnika drukarstva, 2020, No. 4(70)",
          .parameters = parameters_of<SpineCutter>(),
          .responses = std::move(responses),
          .peaks = {{"minimum_cam_radius", "required_cam_radius", Part::Magnitude,
                     "least cam radius at the permissible pressure angle"},
                    {"peak_inertia_force", "inertia_force", Part::Magnitude, "peak inertia force"},
                    {"peak_drive_torque", "drive_torque", Part::Magnitude, "peak drive torque"}},
          .why_impossible = why_impossible_as<SpineCutter>,
          .usual = usual_problem(
              {.objective = "cam_radius",
               .variables = {{"cam_radius", 20, 80, 40}},
               .limits = {{"cam_pressure_angle", -30, 30}, {"peak_inertia_force", kNone, 20}},
               .others = {"minimum_cam_radius", "peak_drive_torque", "inertia_force",
                          "drive_torque", "blades_in_contact"},
               .law = "modified-sine"})};
}

}  // namespace camlaw::problems
