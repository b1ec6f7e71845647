// SPDX-License-Identifier: MIT
#include "machines/geneva/drive_tables.h"

namespace camlaw::problems {

std::vector<MechanismParameter> drive_parameters() {
  return {{"slots", "n", "1", "1", "slots of the wheel", 6, 3, 60, true},
          {"speed", "n_d", "rpm", "rad/s", "speed of the driver", 60, 1e-3, 1e6},
          {"inertia", "J", "kg m2", "kg m2", "of all that moves, at the wheel", 0.8, 0, 1e6},
          {"friction", "M_f", "N m", "N m", "torque of friction at the wheel while it moves", 40,
           1e-6, 1e9}};
}

std::vector<DriveRow> drive_rows() {
  using S = optim::Shape;
  const std::vector<ShapeStatement> speed{{{"speed"}, S::Linear}};
  const std::vector<ShapeStatement> square{{{"speed"}, S::Quasilinear}};
  const std::vector<ShapeStatement> loads{{{"inertia", "friction"}, S::Linear},
                                          {{"speed"}, S::Quasilinear}};
  using C = DriveCurve;
  return {
      {C::Angle, {"wheel_angle", "deg", "rad", "angle of the wheel from the middle of its step"}},
      {C::Velocity, {"wheel_velocity", "rad/s", "rad/s", "angular velocity of the wheel", speed}},
      {C::Acceleration,
       {"wheel_acceleration", "rad/s2", "rad/s2", "angular acceleration of the wheel", square}},
      {C::WheelTorque,
       {"wheel_torque", "N m", "N m", "inertia and friction at the wheel while it moves", loads}},
      {C::DriveTorque, {"drive_torque", "N m", "N m", "torque on the driver", loads}},
      {C::SurplusTorque,
       {"surplus_torque", "N m", "N m", "torque on the driver less its mean", loads}},
      {C::SurplusWork,
       {"surplus_work", "J", "J", "integral of the surplus torque from the engagement on", loads}}};
}

}  // namespace camlaw::problems
