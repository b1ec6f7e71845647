// SPDX-License-Identifier: MIT
#include "machines/sheet_delivery.h"

#include "machines/model/append.h"
#include "machines/model/listed_responses.h"
#include "machines/model/usual_problem.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {
namespace {

using optim::Part;

enum class DeliveryQuantity {
  RodAngle,
  GuideAngle,
  RelativeSpeed,
  SpeedRatio,
  SlowSpeedRatio,
  EfficiencyA,
  EfficiencyB,
  Efficiency,
  ReverseEfficiency,
  PrintedEfficiencyA,
  PrintedEfficiencyB,
  PrintedEfficiency,
  PrintedReverseEfficiency
};

template <class Machine, class X>
X efficiency(const Machine& drive, DeliveryQuantity wanted, const RodPlace<X>& at,
             Friction friction) {
  switch (wanted) {
    case DeliveryQuantity::EfficiencyA:
    case DeliveryQuantity::PrintedEfficiencyA:
      return drive.efficiency_A(at, friction);
    case DeliveryQuantity::EfficiencyB:
    case DeliveryQuantity::PrintedEfficiencyB:
      return drive.efficiency_B(at, friction);
    case DeliveryQuantity::Efficiency:
    case DeliveryQuantity::PrintedEfficiency:
      return drive.efficiency(at, friction);
    default:
      return drive.reverse_efficiency(at, friction);
  }
}

template <class Machine, class X>
X along_guide(const Machine& drive, DeliveryQuantity wanted, const Motion<X>& motion) {
  switch (wanted) {
    case DeliveryQuantity::RodAngle:
      return drive.rod_angle(motion);
    case DeliveryQuantity::GuideAngle:
      return drive.guide_angle(motion);
    default:
      break;
  }
  const auto at = drive.place(motion);
  switch (wanted) {
    case DeliveryQuantity::RelativeSpeed:
      return drive.relative_speed(at);
    case DeliveryQuantity::SpeedRatio:
      return drive.speed_ratio(at);
    case DeliveryQuantity::SlowSpeedRatio:
      return drive.slow_speed_ratio(at);
    case DeliveryQuantity::PrintedEfficiencyA:
    case DeliveryQuantity::PrintedEfficiencyB:
    case DeliveryQuantity::PrintedEfficiency:
    case DeliveryQuantity::PrintedReverseEfficiency:
      return efficiency(drive, wanted, at, Friction::AsPrinted);
    default:
      return efficiency(drive, wanted, at, Friction::Dissipates);
  }
}

MechanismResponse curve(DeliveryQuantity which, ResponseAbout about) {
  static const Cycle stretch{"1", {{0, 1}}};
  return listed_curve<SheetDelivery>(
      std::move(about), stretch, which,
      [](const auto& drive, DeliveryQuantity wanted, const auto& motion) {
        return along_guide(drive, wanted, motion);
      });
}

std::vector<MechanismResponse> delivery_numbers() {
  return {
      number_response<SheetDelivery>(
          {"slow_down", "1", "1",
           "fraction of its travel by which the carriage falls behind the chain in a stretch"},
          [](const auto& drive) { return drive.slow_down(); }),
      number_response<SheetDelivery>(
          {"efficiency_O", "1", "1", "efficiency of the sprocket's bearing"},
          [](const auto& drive) { return drive.efficiency_O(); }),
      number_response<SheetDelivery>(
          {"boundary_efficiency", "1", "1", "efficiency where speeding up and slowing down meet"},
          [](const auto& drive) { return drive.boundary_efficiency(); })};
}

std::vector<MechanismResponse> delivery_curves() {
  using Q = DeliveryQuantity;
  return {
      curve(Q::RodAngle, {"rod_angle", "deg", "rad", "angle of the rod, alpha"}),
      curve(Q::GuideAngle, {"guide_angle", "deg", "rad", "angle of the curved guide, beta"}),
      curve(Q::RelativeSpeed, {"relative_speed", "1", "1",
                               "speed of the carriage about the link over that of the chain"}),
      curve(Q::SpeedRatio,
            {"speed_ratio", "1", "1", "speed of the carriage over that of the chain, speeding up"}),
      curve(Q::SlowSpeedRatio,
            {"slow_speed_ratio", "1", "1",
             "speed of the carriage over that of the chain, slowing down on the mirrored stretch"}),
      curve(Q::EfficiencyA, {"efficiency_A", "1", "1", "efficiency of the link's joint and guide"}),
      curve(Q::EfficiencyB,
            {"efficiency_B", "1", "1", "efficiency of the carriage's joint and guide"}),
      curve(Q::Efficiency,
            {"efficiency", "1", "1",
             "efficiency from the motor to the carriage; at 0 or below the drive is self-locking"}),
      curve(Q::ReverseEfficiency,
            {"reverse_efficiency", "1", "1", "efficiency from the carriage to the motor"}),
      curve(Q::PrintedEfficiencyA,
            {"printed_efficiency_A", "1", "1", "efficiency_A with the signs as printed"}),
      curve(Q::PrintedEfficiencyB,
            {"printed_efficiency_B", "1", "1", "efficiency_B with the signs as printed"}),
      curve(Q::PrintedEfficiency,
            {"printed_efficiency", "1", "1", "efficiency with the signs as printed"}),
      curve(Q::PrintedReverseEfficiency, {"printed_reverse_efficiency", "1", "1",
                                          "reverse_efficiency with the signs as printed"})};
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
