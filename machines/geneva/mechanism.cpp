// SPDX-License-Identifier: MIT
#include "machines/geneva/mechanism.h"

#include "machines/geneva/drive_tables.h"
#include "machines/geneva/surplus.h"
#include "machines/model/append.h"

namespace camlaw::problems {

template <>
struct MachineTraits<PlanarGenevaDrive> {
  static const std::vector<MechanismParameter>& parameters() {
    static const std::vector<MechanismParameter> all = [] {
      auto result = drive_parameters();
      result.push_back(
          {"centre_distance", "a", "mm", "m", "distance of driver and wheel", 200, 1e-3, 1e5});
      result.push_back({"pin_radius", "r_p", "mm", "m", "radius of the driver's pin", 10, 0, 1e5});
      return result;
    }();
    return all;
  }
  template <class T>
  static constexpr std::array<T PlanarGenevaDrive<T>::*, 6> fields{
      &PlanarGenevaDrive<T>::slots,           &PlanarGenevaDrive<T>::angular_speed,
      &PlanarGenevaDrive<T>::inertia,         &PlanarGenevaDrive<T>::friction,
      &PlanarGenevaDrive<T>::centre_distance, &PlanarGenevaDrive<T>::pin_radius};
};

template <>
struct MachineTraits<SphericalGenevaDrive> {
  static const std::vector<MechanismParameter>& parameters() {
    static const std::vector<MechanismParameter> all = drive_parameters();
    return all;
  }
  template <class T>
  static constexpr std::array fields{
      &SphericalGenevaDrive<T>::slots, &SphericalGenevaDrive<T>::angular_speed,
      &SphericalGenevaDrive<T>::inertia, &SphericalGenevaDrive<T>::friction};
};

namespace {

using optim::Part;

enum class Quantity { Engagement, MeanTorque, SurplusRange, GreatestTorque, IdealBalance };

template <class Drive>
auto quantity(const Drive& drive, Quantity which) {
  if (which == Quantity::Engagement) return drive.engagement();
  if (which == Quantity::MeanTorque) return drive.mean_torque();
  const auto surplus = surplus_of(drive);
  if (which == Quantity::SurplusRange) return surplus.range;
  if (which == Quantity::GreatestTorque) return surplus.peak_torque;
  return surplus.peak_torque / drive.mean_torque();
}

template <template <class> class M>
std::vector<MechanismResponse> drive_responses() {
  const std::vector<ShapeStatement> loads{{{"inertia", "friction"}, optim::Shape::Linear}};
  std::vector<MechanismResponse> all;
  const auto add = [&](Quantity which, ResponseAbout about) {
    all.push_back(number_response<M>(
        std::move(about), [which](const auto& drive) { return quantity(drive.drive(), which); }));
  };
  using Q = Quantity;
  add(Q::Engagement, {"engagement", "deg", "rad", "angle of the driver while the wheel moves"});
  add(Q::MeanTorque,
      {"mean_torque", "N m", "N m", "mean torque on the driver over its turn", loads});
  add(Q::SurplusRange,
      {"surplus_range", "J", "J", "what a flywheel or a balancing cam has to store"});
  add(Q::GreatestTorque, {"greatest_drive_torque", "N m", "N m", "greatest torque on the driver"});
  add(Q::IdealBalance,
      {"ideal_balance", "1", "1", "greatest over mean torque: K of an ideal balance"});
  append(all, drive_curves<M>());
  return all;
}

enum class Room { CrankRadius, WheelRadius, DriverShaft, WheelShaft, Web };

std::vector<MechanismResponse> rooms() {
  std::vector<MechanismResponse> all;
  const auto add = [&](Room which, const char* name, const char* meaning) {
    all.push_back(
        number_response<PlanarGenevaDrive>({name, "mm", "m", meaning}, [which](const auto& drive) {
          switch (which) {
            case Room::CrankRadius:
              return drive.crank_radius();
            case Room::WheelRadius:
              return drive.wheel_radius();
            case Room::DriverShaft:
              return drive.driver_shaft_room();
            case Room::Web:
              return drive.web();
            case Room::WheelShaft:
              break;
          }
          return drive.wheel_shaft_room();
        }));
  };
  add(Room::CrankRadius, "crank_radius", "radius of the pin's circle");
  add(Room::WheelRadius, "wheel_radius", "radius of the wheel where the pin enters");
  add(Room::DriverShaft, "driver_shaft_room",
      "greatest diameter of a driver's shaft that passes the wheel; a thicker one locks it");
  add(Room::WheelShaft, "wheel_shaft_room",
      "greatest diameter of the wheel's shaft inside the slots");
  add(Room::Web, "web",
      "least thickness of the wheel between two slots; below 0 neighbouring slots meet");
  return all;
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
  return {.name = "geneva",
          .title = "planar Geneva that drives a conveyor",
          .source = "docs/theory.md, Geneva mechanisms",
          .parameters = MachineTraits<PlanarGenevaDrive>::parameters(),
          .responses = std::move(responses),
          .peaks = peaks(),
          .moved_by = MovedBy::Nothing,
          .form = Form::Geneva};
}

Mechanism spherical_geneva_mechanism() {
  return {.name = "geneva-spherical",
          .title = "spherical Geneva, its axes at right angles, that drives a conveyor",
          .source = "docs/theory.md, Geneva mechanisms",
          .parameters = MachineTraits<SphericalGenevaDrive>::parameters(),
          .responses = drive_responses<SphericalGenevaDrive>(),
          .peaks = peaks(),
          .moved_by = MovedBy::Nothing,
          .form = Form::SphericalGeneva};
}

}  // namespace camlaw::problems
