// SPDX-License-Identifier: MIT
#include "machines/sheet_delivery.h"

#include "machines/model/append.h"
#include "machines/model/responses.h"
#include "machines/model/usual_problem.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {
namespace {

using optim::Part;

/// A curve over one stretch of the guide.
template <class F>
MechanismResponse curve(ResponseAbout about, F formula) {
  static const Cycle stretch{"1", {{0, 1}}};
  return curve_response<SheetDelivery>(std::move(about), stretch, formula);
}

/// Efficiencies, by names that begin and words that end with these.
std::vector<MechanismResponse> efficiencies(const std::string& prefix, Friction friction,
                                            const std::array<std::string, 4>& meanings) {
  const auto of = [&](const char* name, const std::string& meaning, auto formula) {
    return curve({prefix + name, "1", "1", meaning},
                 [friction, formula](const auto& drive, const auto& motion) {
                   return formula(drive, drive.place(motion), friction);
                 });
  };
  return {
      of("efficiency_A", meanings[0],
         [](const auto& drive, const auto& at, Friction by) { return drive.efficiency_A(at, by); }),
      of("efficiency_B", meanings[1],
         [](const auto& drive, const auto& at, Friction by) { return drive.efficiency_B(at, by); }),
      of("efficiency", meanings[2],
         [](const auto& drive, const auto& at, Friction by) { return drive.efficiency(at, by); }),
      of("reverse_efficiency", meanings[3], [](const auto& drive, const auto& at, Friction by) {
        return drive.reverse_efficiency(at, by);
      })};
}

std::vector<MechanismResponse> delivery_numbers() {
  return {number_response<SheetDelivery>(
              {"slow_down", "1", "1",
               "fraction of its travel by which the carriage falls behind the chain in a stretch"},
              [](const auto& drive) { return drive.slow_down(); }),
          number_response<SheetDelivery>(
              {"efficiency_O", "1", "1", "efficiency of the sprocket's bearing"},
              [](const auto& drive) { return drive.efficiency_O(); }),
          number_response<SheetDelivery>(
              {"boundary_efficiency", "1", "1",
               "efficiency at the end of acceleration, where deceleration begins"},
              [](const auto& drive) { return drive.boundary_efficiency(); })};
}

std::vector<MechanismResponse> delivery_curves() {
  std::vector<MechanismResponse> all{
      curve({"rod_angle", "deg", "rad", "angle of the rod, alpha"},
            [](const auto& drive, const auto& motion) { return drive.rod_angle(motion); }),
      curve({"guide_angle", "deg", "rad", "angle of the curved guide, beta"},
            [](const auto& drive, const auto& motion) { return drive.guide_angle(motion); }),
      curve({"relative_speed", "1", "1",
             "speed of the carriage about the link over that of the chain"},
            [](const auto& drive, const auto& motion) {
              return drive.relative_speed(drive.place(motion));
            }),
      curve({"speed_ratio", "1", "1", "speed of the carriage over that of the chain, speeding up"},
            [](const auto& drive, const auto& motion) {
              return drive.speed_ratio(drive.place(motion));
            }),
      curve({"slow_speed_ratio", "1", "1",
             "speed of the carriage over that of the chain, slowing down on the mirrored stretch"},
            [](const auto& drive, const auto& motion) {
              return drive.slow_speed_ratio(drive.place(motion));
            })};
  append(all, efficiencies("", Friction::Dissipates,
                           {"efficiency of the link's joint and guide",
                            "efficiency of the carriage's joint and guide",
                            "efficiency from the motor to the carriage; at 0 or below the drive is "
                            "self-locking",
                            "efficiency from the carriage to the motor"}));
  append(all, efficiencies(
                  "printed_", Friction::AsPrinted,
                  {"efficiency_A with the signs as printed",
                   "efficiency_B with the signs as printed", "efficiency with the signs as printed",
                   "reverse_efficiency with the signs as printed"}));
  return all;
}

}  // namespace

Mechanism sheet_delivery_mechanism() {
  std::vector<MechanismResponse> responses = delivery_numbers();
  append(responses, delivery_curves());
  return {.name = "sheet-delivery",
          .title = "sheet-delivery carriage that a chain in curved guides moves by a rod",
          .source =
              "Analytical study of the efficiency of sheet-delivery conveyors with "
              "curvilinear chain guides, Polihrafiia i vydavnycha sprava, received "
              "29.12.1982",
          .parameters = parameters_of<SheetDelivery>(),
          .responses = std::move(responses),
          .peaks = {{"least_efficiency", "efficiency", Part::Lowest,
                     "least efficiency from the motor to the carriage"},
                    {"least_reverse_efficiency", "reverse_efficiency", Part::Lowest,
                     "least efficiency from the carriage to the motor"},
                    {"greatest_efficiency", "efficiency", Part::Highest,
                     "greatest efficiency from the motor to the carriage"}},
          .why_impossible = why_impossible_as<SheetDelivery>,
          .usual = usual_problem(
              {.objective = "lowest efficiency",
               .sense = optim::Sense::Maximize,
               .variables = {{"guide_ratio", 0.1, 2, 0.4}, {"rod_angle_max", 10, 75, 60}},
               .limits = {{"slow_down", 0.2, kNone}},
               .others = {"least_efficiency", "least_reverse_efficiency", "greatest_efficiency",
                          "efficiency", "relative_speed"},
               .law = "cycloidal"})};
}

}  // namespace camlaw::problems
