// SPDX-License-Identifier: MIT
#include "machines/servo_axis/mechanism.h"

#include "machines/model/append.h"
#include "machines/model/listed_responses.h"
#include "machines/model/mean_number.h"
#include "machines/model/why_impossible.h"
#include "machines/servo_axis/servo_axis.h"
#include "numerics/scalar/by_side.h"

namespace camlaw::problems {

namespace {

using optim::Part;

enum class ServoCurve {
  Displacement,
  Velocity,
  Acceleration,
  Jerk,
  Output,
  MotorAngle,
  MotorSpeed,
  MotorAcceleration,
  MotorJerk,
  MotorTorque,
  AccelerationTorque,
  MotorPower,
  AvailableTorque,
  TorqueReserve,
  TorqueUtilisation,
  SpeedUtilisation
};

template <class T, class X>
X servo_curve(const ServoDrive<T>& drive, ServoCurve which, const AxisMotion<X>& y) {
  using C = ServoCurve;
  switch (which) {
    case C::Displacement:
      return y.s;
    case C::Velocity:
      return y.v;
    case C::Acceleration:
      return y.a;
    case C::Jerk:
      return y.j;
    case C::Output:
      return drive.output(y);
    case C::MotorAngle:
      return drive.turns * y.s;
    case C::MotorSpeed:
      return drive.turns * y.v;
    case C::MotorAcceleration:
      return drive.turns * y.a;
    case C::MotorJerk:
      return drive.turns * y.j;
    case C::MotorTorque:
      return drive.motor_torque(y);
    case C::AccelerationTorque:
      return drive.acceleration_torque(y);
    case C::MotorPower:
      return drive.motor_power(y);
    case C::AvailableTorque:
      return drive.available_torque(y);
    case C::TorqueReserve:
      return drive.torque_reserve(y);
    case C::TorqueUtilisation:
      return drive.torque_utilisation(y);
    case C::SpeedUtilisation:
      break;
  }
  return absolute(X(drive.turns * y.v)) / drive.motor.maximum_speed;
}

/// Units and names that differ between loads that turn and loads that slide.
struct AxisWords {
  const char *place, *place_stored, *velocity, *acceleration, *jerk;
  const char *output, *output_unit, *output_meaning;
};
constexpr AxisWords kTurning{
    "deg",    "rad",           "rad/s", "rad/s2",
    "rad/s3", "output_torque", "N m",   "torque that the gear delivers to the load"};
constexpr AxisWords kLinear{"mm",   "m",
                            "m/s",  "m/s2",
                            "m/s3", "output_force",
                            "N",    "force that screw or pinion exerts on the load"};

template <template <class> class M>
std::vector<MechanismResponse> servo_curves(const AxisWords& w) {
  using C = ServoCurve;
  std::vector<MechanismResponse> all;
  const auto add = [&](C which, const char* name, const char* listed, const char* stored,
                       const char* meaning) {
    all.push_back(listed_curve<M>({name, listed, stored, meaning}, turn_of_the_cam(), which,
                                  [](const auto& axis, C curve, const auto& motion) {
                                    return servo_curve(axis.drive(), curve,
                                                       axis_motion(axis, motion));
                                  }));
  };
  add(C::Displacement, "displacement", w.place, w.place_stored, "travel of the load");
  add(C::Velocity, "velocity", w.velocity, w.velocity, "velocity of the load");
  add(C::Acceleration, "acceleration", w.acceleration, w.acceleration, "acceleration of the load");
  add(C::Jerk, "jerk", w.jerk, w.jerk, "jerk of the load");
  add(C::Output, w.output, w.output_unit, w.output_unit, w.output_meaning);
  add(C::MotorAngle, "motor_angle", "deg", "rad", "angle of the motor, 0 at displacement 0");
  add(C::MotorSpeed, "motor_speed", "rpm", "rad/s", "speed of the motor");
  add(C::MotorAcceleration, "motor_acceleration", "rad/s2", "rad/s2", "acceleration of the motor");
  add(C::MotorJerk, "motor_jerk", "rad/s3", "rad/s3", "jerk of the motor");
  add(C::MotorTorque, "motor_torque", "N m", "N m", "torque on the motor's shaft");
  add(C::AccelerationTorque, "acceleration_torque", "N m", "N m",
      "part of the motor torque that accelerates motor, gear and load, without losses");
  add(C::MotorPower, "motor_power", "W", "W",
      "power of the motor's shaft; below 0 the load drives the motor");
  add(C::AvailableTorque, "available_torque", "N m", "N m",
      "greatest torque that the motor can deliver at its present speed");
  add(C::TorqueReserve, "torque_reserve", "N m", "N m",
      "available torque minus the motor's torque");
  add(C::TorqueUtilisation, "torque_utilisation", "1", "1",
      "the motor's torque, in either direction, over the available torque");
  add(C::SpeedUtilisation, "speed_utilisation", "1", "1",
      "the motor's speed, in either direction, over its maximum speed");
  set_defined_while(all, {"available_torque", "torque_reserve", "torque_utilisation"},
                    {.response = "speed_utilisation", .upper = 1});
  return all;
}

/// A number from the mean of integrand(drive, motion) over the cycle: formula(axis, mean).
template <template <class> class M, class Integrand, class F>
MechanismResponse servo_mean(ResponseAbout about, Integrand integrand, F formula) {
  return mean_number<M>(
      std::move(about),
      [integrand](const auto& axis, const auto& motion) {
        return integrand(axis.drive(), axis_motion(axis, motion));
      },
      formula);
}

template <template <class> class M>
std::vector<MechanismResponse> servo_numbers() {
  const auto square = [](const auto& drive, const auto& y) {
    const auto torque = drive.motor_torque(y);
    return torque * torque;
  };
  const auto power = [](const auto& drive, const auto& y) { return drive.motor_power(y); };
  const auto taken_back = [](const auto& drive, const auto& y) {
    const auto given = drive.motor_power(y);
    using X = std::decay_t<decltype(given)>;
    return greater_of(number<X>(0), X(-given));
  };
  return {
      servo_mean<M>({"torque_rms", "N m", "N m", "root mean square of the motor torque"}, square,
                    [](const auto&, const auto& mean) { return root_of_squares(mean); }),
      servo_mean<M>({"rms_utilisation", "1", "1", "torque_rms over the continuous torque"}, square,
                    [](const auto& axis, const auto& mean) {
                      return root_of_squares(mean) / axis.motor.continuous_torque;
                    }),
      servo_mean<M>({"mean_power", "W", "W", "mean power of the motor's shaft"}, power,
                    [](const auto&, const auto& mean) { return mean; }),
      servo_mean<M>({"regenerated_energy", "J", "J",
                     "energy that the load returns to the motor's shaft in a cycle"},
                    taken_back,
                    [](const auto& axis, const auto& mean) {
                      using T = std::decay_t<decltype(mean)>;
                      return number<T>(2) * pi<T>() / axis.cycle_speed * mean;
                    }),
      number_response<M>(
          {"inertia_ratio", "1", "1",
           "inertia of gear and load, referred to the motor's shaft, over the motor's own"},
          [](const auto& axis) { return axis.drive().inertia_ratio(); }),
      number_response<M>(
          {"matched_ratio", "1", "1",
           "gear ratio that accelerates the load with the least torque, without losses"},
          [](const auto& axis) { return axis.matched_ratio(); })};
}

template <template <class> class M>
Mechanism servo_mechanism(const char* name, const char* title, const AxisWords& words) {
  std::vector<MechanismResponse> responses = servo_curves<M>(words);
  append(responses, servo_numbers<M>());
  return {
      .name = name,
      .title = title,
      .source = "docs/theory.md, Servo axes",
      .parameters = parameters_of<M>(),
      .responses = std::move(responses),
      .peaks = {{"peak_torque", "motor_torque", Part::Magnitude, "greatest torque of the motor"},
                {"peak_motor_speed", "motor_speed", Part::Magnitude, "greatest speed of the motor"},
                {"peak_power", "motor_power", Part::Highest,
                 "greatest power that the motor delivers"},
                {"peak_regenerated_power", "motor_power", Part::Lowest,
                 "greatest power that the load returns, as a negative number"},
                {"least_torque_reserve", "torque_reserve", Part::Lowest,
                 "least torque in reserve; below 0 the motor cannot follow"},
                {"peak_torque_utilisation", "torque_utilisation", Part::Highest,
                 "greatest torque over the available torque; above 1 the motor cannot follow"}},
      .moved_by = MovedBy::Program,
      .keeps_times = true,
      .why_impossible = why_impossible_as<M>};
}

}  // namespace

Mechanism servo_axis_mechanism() {
  return servo_mechanism<ServoAxis>("servo-axis", "servo motor that turns a load through a gear",
                                    kTurning);
}

Mechanism linear_servo_axis_mechanism() {
  return servo_mechanism<LinearServoAxis>(
      "linear-servo-axis", "servo motor that moves a load by screw, pinion or belt", kLinear);
}

}  // namespace camlaw::problems
