// SPDX-License-Identifier: MIT

#include "machines/geneva/drive_tables.h"
#include "machines/geneva/surplus.h"
#include "machines/model/append.h"
#include "machines/model/usual_problem.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {
namespace {

using optim::Part;

template <class M>
std::vector<MechanismResponse> drive_responses() {
  const auto number = [](ResponseAbout about, auto formula) {
    return number_response<M>(std::move(about), formula);
  };
  std::vector<MechanismResponse> all{
      number({"engagement", "deg", "rad", "angle of the driver while the wheel moves"},
             [](const auto& drive) { return drive.engagement(); }),
      number({"mean_torque", "N m", "N m", "mean torque on the driver over its turn"},
             [](const auto& drive) { return drive.mean_torque(); }),
      number({"surplus_range", "J", "J", "energy that a flywheel or a balancing cam has to store"},
             [](const auto& drive) { return surplus_of(drive).range; }),
      number({"greatest_drive_torque", "N m", "N m", "greatest torque on the driver"},
             [](const auto& drive) { return surplus_of(drive).peak_torque; }),
      number(
          {"ideal_balance", "1", "1", "greatest torque over mean torque: K of an ideal balance"},
          [](const auto& drive) { return surplus_of(drive).peak_torque / drive.mean_torque(); })};
  append(all, drive_curves<M>());
  return all;
}

std::vector<MechanismResponse> rooms() {
  const auto room = [](const char* name, const char* meaning, auto formula) {
    return number_response<PlanarGenevaDrive>({name, "mm", "m", meaning}, formula);
  };
  return {
      room("crank_radius", "radius of the pin's circle",
           [](const auto& drive) { return drive.crank_radius(); }),
      room("wheel_radius", "radius of the wheel where the pin enters",
           [](const auto& drive) { return drive.wheel_radius(); }),
      room("driver_shaft_room",
           "greatest diameter of a driver's shaft that clears the wheel; a thicker one blocks it",
           [](const auto& drive) { return drive.driver_shaft_room(); }),
      room("wheel_shaft_room",
           "greatest diameter of the wheel's shaft that the slots leave room for",
           [](const auto& drive) { return drive.wheel_shaft_room(); }),
      room("web", "least thickness of the wheel between two slots; below 0 neighbouring slots meet",
           [](const auto& drive) { return drive.web(); })};
}

std::vector<NamedPeak> peaks() {
  return {
      {"peak_velocity", "wheel_velocity", Part::Magnitude, "greatest angular velocity"},
      {"peak_acceleration", "wheel_acceleration", Part::Magnitude, "greatest angular acceleration"},
      {"peak_torque", "drive_torque", Part::Magnitude, "greatest torque on the driver"}};
}

}  // namespace

Mechanism planar_geneva_mechanism() {
  std::vector<MechanismResponse> responses = rooms();
  append(responses, drive_responses<PlanarGenevaDrive>());
  return {
      .name = "geneva",
      .title = "planar Geneva that drives a conveyor",
      .source = "docs/theory.md, Geneva mechanisms",
      .parameters = parameters_of<PlanarGenevaDrive>(),
      .responses = std::move(responses),
      .peaks = peaks(),
      .moved_by = MovedBy::Nothing,
      .form = Form::Geneva,
      .why_impossible = why_impossible_as<PlanarGenevaDrive>,
      .usual = usual_problem({.objective = "speed",
                              .sense = optim::Sense::Maximize,
                              .variables = {{"slots", 4, 8, 6}, {"speed", 10, 200, 50}},
                              .limits = {{"peak_acceleration", kNone, 60},
                                         {"driver_shaft_room", 45, kNone},
                                         {"wheel_shaft_room", 60, kNone}},
                              .others = {"peak_velocity", "peak_torque", "greatest_drive_torque",
                                         "crank_radius", "wheel_radius"}})};
}

Mechanism spherical_geneva_mechanism() {
  return {.name = "geneva-spherical",
          .title = "spherical Geneva with perpendicular axes that drives a conveyor",
          .source = "docs/theory.md, Geneva mechanisms",
          .parameters = parameters_of<SphericalGenevaDrive>(),
          .responses = drive_responses<SphericalGenevaDrive>(),
          .peaks = peaks(),
          .moved_by = MovedBy::Nothing,
          .form = Form::SphericalGeneva,
          .why_impossible = why_impossible_as<SphericalGenevaDrive>,
          .usual = usual_problem({.objective = "speed",
                                  .sense = optim::Sense::Maximize,
                                  .variables = {{"slots", 4, 8, 6}, {"speed", 10, 200, 40}},
                                  .limits = {{"peak_torque", kNone, 150}},
                                  .others = {"peak_velocity", "peak_acceleration",
                                             "greatest_drive_torque", "mean_torque", "engagement"},
                                  .constants = {{"inertia", 4}}})};
}

}  // namespace camlaw::problems
