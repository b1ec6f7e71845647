// SPDX-License-Identifier: MIT
#include "machines/signature_feeder/mechanism.h"

#include "machines/model/append.h"
#include "machines/model/turn_responses.h"
#include "machines/signature_feeder/signature_feeder.h"

namespace camlaw::problems {

template <>
struct MachineTraits<SignatureFeeder> {
  static const std::vector<MechanismParameter>& parameters();
  template <class T>
  static constexpr std::array fields{
      &SignatureFeeder<T>::crank_radius, &SignatureFeeder<T>::centre_distance,
      &SignatureFeeder<T>::offset, &SignatureFeeder<T>::pinion_radius,
      &SignatureFeeder<T>::crank_speed};
};

const std::vector<MechanismParameter>& MachineTraits<SignatureFeeder>::parameters() {
  static const std::vector<MechanismParameter> all{
      {"crank_radius", "r1", "mm", "m", "radius of the crank", 92, 1e-3, 1e5},
      {"centre_distance", "L", "mm", "m", "distance of the centres of crank and guide", 702, 1e-3,
       1e5},
      {"offset", "e", "mm", "m", "distance of the guide's centre from the rack's pitch line", 52, 0,
       1e5},
      {"pinion_radius", "r_p", "mm", "m", "pitch radius of the cylinder's pinion", 45, 1e-3, 1e5},
      {"speed", "n", "rpm", "rad/s", "speed of the crank", 60, 1e-3, 1e6}};
  return all;
}

namespace {

using optim::Part;
using S = optim::Shape;

enum class Quantity {
  GuideLength,
  GuideAngle,
  Travel,
  Drum,
  Ratio,
  RatioSlope,
  Velocity,
  Acceleration
};

template <class Machine, class X>
X at_angle(const Machine& drive, Quantity wanted, const X& phi) {
  switch (wanted) {
    case Quantity::GuideLength:
      return drive.guide_length(phi).value;
    case Quantity::GuideAngle:
      return drive.guide_angle(phi).value;
    case Quantity::Travel:
      return drive.rack_travel(phi).value;
    case Quantity::Drum:
      return drive.drum_angle(phi).value;
    case Quantity::Ratio:
      return drive.drum_angle(phi).first;
    case Quantity::RatioSlope:
      return drive.drum_angle(phi).second;
    case Quantity::Velocity:
      return drive.drum_velocity(phi);
    case Quantity::Acceleration:
      break;
  }
  return drive.drum_acceleration(phi);
}

/// Of the drive as printed, or of the same with e = r_p.
enum class Rack { Printed, Meshing };

MechanismResponse rack_curve(Rack rack, Quantity which, ResponseAbout about) {
  return turn_response<SignatureFeeder>(std::move(about), [rack, which](const auto& drive) {
    return [which, used = rack == Rack::Meshing ? drive.meshing() : drive](
               std::size_t, const auto& phi) { return at_angle(used, which, phi); };
  });
}

MechanismResponse curve(Quantity which, ResponseAbout about) {
  return rack_curve(Rack::Printed, which, std::move(about));
}

MechanismResponse meshing(Quantity which, ResponseAbout about) {
  return rack_curve(Rack::Meshing, which, std::move(about));
}

enum class Size { DrumSwing, GuideSwing, LeastLength, GreatestLength };

MechanismResponse number(Size which, ResponseAbout about) {
  return number_response<SignatureFeeder>(std::move(about), [which](const auto& drive) {
    switch (which) {
      case Size::DrumSwing:
        return drive.drum_swing();
      case Size::GuideSwing:
        return drive.guide_swing();
      case Size::LeastLength:
        return drive.least_guide_length();
      case Size::GreatestLength:
        break;
    }
    return drive.greatest_guide_length();
  });
}

std::vector<MechanismResponse> numbers() {
  return {number(Size::DrumSwing, {"drum_swing",
                                   "deg",
                                   "rad",
                                   "swing of the cylinder between its reversals",
                                   {{{"crank_radius"}, S::Linear},
                                    {{"crank_radius", "pinion_radius"}, S::Quasilinear}}}),
          number(Size::GuideSwing, {"guide_swing", "deg", "rad", "swing of the guide"}),
          number(Size::LeastLength, {"least_guide_length", "mm", "m",
                                     "least distance of the crank pin along the guide"}),
          number(Size::GreatestLength, {"greatest_guide_length", "mm", "m",
                                        "greatest distance of the crank pin along the guide"})};
}

std::vector<MechanismResponse> curves() {
  using Q = Quantity;
  const std::vector<ShapeStatement> linear{{{"speed"}, S::Linear}};
  const std::vector<ShapeStatement> monotone{{{"speed"}, S::Quasilinear}};
  return {
      curve(Q::GuideLength,
            {"guide_length", "mm", "m", "distance of the crank pin along the guide"}),
      curve(Q::GuideAngle,
            {"guide_angle", "deg", "rad", "angle of the guide from its extreme position"}),
      curve(Q::Travel, {"rack_travel", "mm", "m", "travel of the rack over the pinion"}),
      curve(Q::Drum, {"drum_angle", "deg", "rad", "angle of the cylinder"}),
      curve(Q::Ratio,
            {"drum_ratio", "1", "1", "angular velocity of the cylinder over the crank's"}),
      curve(Q::RatioSlope, {"drum_ratio_slope", "1", "1",
                            "second derivative of the cylinder's angle by the crank's"}),
      curve(Q::Velocity,
            {"drum_velocity", "rad/s", "rad/s", "angular velocity of the cylinder", linear}),
      curve(Q::Acceleration, {"drum_acceleration", "rad/s2", "rad/s2",
                              "angular acceleration of the cylinder", monotone}),
      meshing(Q::Travel, {"meshing_rack_travel", "mm", "m",
                          "travel of a rack that meshes with a pinion on the guide's centre"}),
      meshing(Q::Drum,
              {"meshing_drum_angle", "deg", "rad", "angle of the cylinder with that rack"}),
      meshing(Q::Velocity, {"meshing_drum_velocity", "rad/s", "rad/s",
                            "angular velocity of the cylinder with that rack", linear}),
      meshing(Q::Acceleration, {"meshing_drum_acceleration", "rad/s2", "rad/s2",
                                "angular acceleration of the cylinder with that rack", monotone})};
}

}  // namespace

Mechanism signature_feeder_mechanism() {
  std::vector<MechanismResponse> responses = numbers();
  append(responses, curves());
  return {.name = "signature-feeder",
          .title = "crank, rocking guide and rack of a reversing signature feeder",
          .source =
              "O. V. Romanchenko, Z. M. Prystavskyi, Synthesis of the coulisse-rack mechanism "
              "and determination of the kinematic characteristics of the delivery cylinders "
              "of the reversing signature feeder, NTUU KPI",
          .parameters = MachineTraits<SignatureFeeder>::parameters(),
          .responses = std::move(responses),
          .peaks = {{"peak_velocity", "drum_velocity", Part::Magnitude,
                     "greatest angular velocity of the cylinder"},
                    {"peak_acceleration", "drum_acceleration", Part::Magnitude,
                     "greatest angular acceleration of the cylinder"}},
          .moved_by = MovedBy::Nothing,
          .form = Form::SignatureFeeder};
}

}  // namespace camlaw::problems
