// SPDX-License-Identifier: MIT
#include "machines/signature_feeder.h"

#include "machines/model/append.h"
#include "machines/model/turn_responses.h"
#include "machines/model/usual_problem.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {
namespace {

using optim::Part;

/// A curve from formula(drive, angle), of the drive as printed.
template <class F>
MechanismResponse curve(ResponseAbout about, F formula) {
  return turn_response<SignatureFeeder>(std::move(about), [formula](const auto& drive) {
    return [formula, drive](std::size_t, const auto& phi) { return formula(drive, phi); };
  });
}

/// The same of the drive with e = r_p.
template <class F>
MechanismResponse meshing(ResponseAbout about, F formula) {
  return curve(std::move(about), [formula](const auto& drive, const auto& phi) {
    return formula(drive.meshing(), phi);
  });
}

template <class F>
MechanismResponse feeder_number(ResponseAbout about, F formula) {
  return number_response<SignatureFeeder>(std::move(about), formula);
}

std::vector<MechanismResponse> feeder_numbers() {
  return {feeder_number({"drum_swing", "deg", "rad", "swing of the cylinder between its reversals"},
                        [](const auto& drive) { return drive.drum_swing(); }),
          feeder_number({"guide_swing", "deg", "rad", "swing of the guide"},
                        [](const auto& drive) { return drive.guide_swing(); }),
          feeder_number(
              {"least_guide_length", "mm", "m", "least distance of the crank pin along the guide"},
              [](const auto& drive) { return drive.least_guide_length(); }),
          feeder_number({"greatest_guide_length", "mm", "m",
                         "greatest distance of the crank pin along the guide"},
                        [](const auto& drive) { return drive.greatest_guide_length(); })};
}

std::vector<MechanismResponse> feeder_curves() {
  const auto travel = [](const auto& drive, const auto& phi) {
    return drive.rack_travel(phi).value;
  };
  const auto drum = [](const auto& drive, const auto& phi) { return drive.drum_angle(phi).value; };
  const auto velocity = [](const auto& drive, const auto& phi) { return drive.drum_velocity(phi); };
  const auto acceleration = [](const auto& drive, const auto& phi) {
    return drive.drum_acceleration(phi);
  };
  return {
      curve({"guide_length", "mm", "m", "distance of the crank pin along the guide"},
            [](const auto& drive, const auto& phi) { return drive.guide_length(phi).value; }),
      curve({"guide_angle", "deg", "rad", "angle of the guide from its extreme position"},
            [](const auto& drive, const auto& phi) { return drive.guide_angle(phi).value; }),
      curve({"rack_travel", "mm", "m", "travel of the rack over the pinion"}, travel),
      curve({"drum_angle", "deg", "rad", "angle of the cylinder"}, drum),
      curve({"drum_ratio", "1", "1", "angular velocity of the cylinder over that of the crank"},
            [](const auto& drive, const auto& phi) { return drive.drum_angle(phi).first; }),
      curve({"drum_ratio_slope", "1", "1",
             "second derivative of the cylinder's angle with respect to the crank's angle"},
            [](const auto& drive, const auto& phi) { return drive.drum_angle(phi).second; }),
      curve({"drum_velocity", "rad/s", "rad/s", "angular velocity of the cylinder"}, velocity),
      curve({"drum_acceleration", "rad/s2", "rad/s2", "angular acceleration of the cylinder"},
            acceleration),
      meshing({"meshing_rack_travel", "mm", "m",
               "travel of the rack over the pinion, if the rack's offset were the pinion's radius"},
              travel),
      meshing({"meshing_drum_angle", "deg", "rad",
               "angle of the cylinder, if the rack's offset were the pinion's radius"},
              drum),
      meshing({"meshing_drum_velocity", "rad/s", "rad/s",
               "angular velocity of the cylinder, if the rack's offset were the pinion's radius"},
              velocity),
      meshing(
          {"meshing_drum_acceleration", "rad/s2", "rad/s2",
           "angular acceleration of the cylinder, if the rack's offset were the pinion's radius"},
          acceleration)};
}

}  // namespace

Mechanism signature_feeder_mechanism() {
  std::vector<MechanismResponse> responses = feeder_numbers();
  append(responses, feeder_curves());
  return {.name = "signature-feeder",
          .title = "crank, rocking guide and rack of a reversing signature feeder",
          .source =
              "O. V. Romanchenko, Z. M. Prystavskyi, Synthesis of the coulisse-rack mechanism "
              "and determination of the kinematic characteristics of the delivery cylinders "
              "of the reversing signature feeder, NTUU KPI",
          .parameters = parameters_of<SignatureFeeder>(),
          .responses = std::move(responses),
          .peaks = {{"peak_velocity", "drum_velocity", Part::Magnitude,
                     "greatest angular velocity of the cylinder"},
                    {"peak_acceleration", "drum_acceleration", Part::Magnitude,
                     "greatest angular acceleration of the cylinder"}},
          .moved_by = MovedBy::Nothing,
          .form = Form::SignatureFeeder,
          .why_impossible = why_impossible_as<SignatureFeeder>,
          .usual = usual_problem(
              {.objective = "peak drum_acceleration",
               .variables = {{"crank_radius", 60, 150, 92},
                             {"centre_distance", 400, 900, 702},
                             {"offset", 45, 200, 52}},
               .limits = {{"drum_swing", 240, kNone}, {"greatest_guide_length", kNone, 800}},
               .others = {"peak_velocity", "peak_acceleration", "drum_velocity", "rack_travel",
                          "guide_swing"}})};
}

}  // namespace camlaw::problems
