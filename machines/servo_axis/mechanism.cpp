// SPDX-License-Identifier: MIT
#include "machines/servo_axis/mechanism.h"

#include "machines/model/append.h"
#include "machines/model/listed_responses.h"
#include "machines/model/mean_number.h"
#include "machines/model/why_impossible.h"
#include "machines/servo_axis/servo_axis.h"
#include "numerics/scalar/by_side.h"

namespace camlaw::problems {

template <>
struct MachineTraits<ServoAxis> {
  static const std::vector<MechanismParameter>& parameters();
  template <class T>
  static constexpr std::array<T ServoAxis<T>::*, 15> fields{
      &ServoAxis<T>::stroke,        &ServoAxis<T>::cycle_speed,       &ServoAxis<T>::gear_ratio,
      &ServoAxis<T>::gear_inertia,  &ServoAxis<T>::efficiency,        &ServoAxis<T>::load_inertia,
      &ServoAxis<T>::load,          &ServoAxis<T>::friction,          &ServoAxis<T>::viscosity,
      &ServoAxis<T>::motor_inertia, &ServoAxis<T>::continuous_torque, &ServoAxis<T>::maximum_torque,
      &ServoAxis<T>::corner_speed,  &ServoAxis<T>::maximum_speed,     &ServoAxis<T>::end_torque};
};

template <>
struct MachineTraits<LinearServoAxis> {
  static const std::vector<MechanismParameter>& parameters();
  template <class T>
  static constexpr std::array<T LinearServoAxis<T>::*, 16> fields{
      &LinearServoAxis<T>::stroke,         &LinearServoAxis<T>::feed,
      &LinearServoAxis<T>::cycle_speed,    &LinearServoAxis<T>::gear_ratio,
      &LinearServoAxis<T>::gear_inertia,   &LinearServoAxis<T>::efficiency,
      &LinearServoAxis<T>::mass,           &LinearServoAxis<T>::load,
      &LinearServoAxis<T>::friction,       &LinearServoAxis<T>::viscosity,
      &LinearServoAxis<T>::motor_inertia,  &LinearServoAxis<T>::continuous_torque,
      &LinearServoAxis<T>::maximum_torque, &LinearServoAxis<T>::corner_speed,
      &LinearServoAxis<T>::maximum_speed,  &LinearServoAxis<T>::end_torque};
};

namespace {

using optim::Part;
using AxisParameters = std::vector<MechanismParameter>;

/// The gear, whose ratio is per turn of `turn`.
void add_gear(AxisParameters& all, double ratio, const std::string& turn) {
  all.insert(
      all.end(),
      {{"gear_ratio", "i", "1", "1", "turns of the motor per turn of the " + turn, ratio, 1e-3,
        1e5},
       {"gear_inertia", "J_G", "kg cm2", "kg m2",
        "moment of inertia of gear and coupling, referred to the motor's shaft", 0.3, 0, 1e8},
       {"gear_efficiency", "eta", "1", "1",
        "efficiency of gear and guide, in either direction of power flow", 0.95, 0.01, 1}});
}

void add_motor(AxisParameters& all) {
  all.insert(
      all.end(),
      {{"motor_inertia", "J_M", "kg cm2", "kg m2", "moment of inertia of the motor, with a brake",
        1.6, 1e-6, 1e8},
       {"continuous_torque", "M_0", "N m", "N m",
        "torque that the motor can deliver continuously without overheating", 2.4, 1e-6, 1e7},
       {"maximum_torque", "M_max", "N m", "N m", "greatest torque up to the corner speed", 7.2,
        1e-6, 1e7},
       {"corner_speed", "n_c", "rpm", "rad/s", "speed above which the greatest torque falls", 3600,
        0, 1e6},
       {"maximum_speed", "n_max", "rpm", "rad/s", "greatest speed of the motor", 6000, 1e-3, 1e6},
       {"end_torque", "M_e", "N m", "N m", "greatest torque at the maximum speed", 3, 0, 1e7}});
}

MechanismParameter cycles_per_minute(double n) {
  return {"speed", "n", "rpm", "rad/s", "cycles of the axis per minute", n, 1e-3, 1e6};
}

}  // namespace

const std::vector<MechanismParameter>& MachineTraits<ServoAxis>::parameters() {
  static const AxisParameters all = [] {
    AxisParameters list{
        {"stroke", "S", "deg", "rad", "travel of the load at displacement 1", 90, 1e-6, 1e6},
        cycles_per_minute(120)};
    add_gear(list, 10, "load");
    list.insert(
        list.end(),
        {{"load_inertia", "J_L", "kg m2", "kg m2",
          "moment of inertia of everything that turns with the load", 0.02, 0, 1e6},
         {"load_torque", "M_L", "N m", "N m",
          "constant torque of the load that opposes motion to greater displacements", 0, -1e9, 1e9},
         {"friction_torque", "M_C", "N m", "N m",
          "friction of the load, which opposes its motion at any speed", 0, 0, 1e9},
         {"viscous_friction", "d", "N m s", "N m s",
          "viscous friction of the load, per unit of its velocity", 0, 0, 1e9}});
    add_motor(list);
    return list;
  }();
  return all;
}

const std::vector<MechanismParameter>& MachineTraits<LinearServoAxis>::parameters() {
  static const AxisParameters all = [] {
    AxisParameters list{
        {"stroke", "S", "mm", "m", "travel of the load at displacement 1", 200, 1e-6, 1e6},
        {"feed", "p", "mm", "m",
         "travel of the load per turn of the screw, the pinion or the belt's pulley", 100, 1e-3,
         1e5},
        cycles_per_minute(60)};
    add_gear(list, 3, "screw or pinion");
    list.insert(
        list.end(),
        {{"mass", "m", "kg", "kg", "mass of everything that moves with the load", 10, 0, 1e6},
         {"load_force", "F_L", "N", "N",
          "constant force of the load that opposes motion to greater displacements", 0, -1e9, 1e9},
         {"friction_force", "F_C", "N", "N",
          "friction of the load, which opposes its motion at any speed", 0, 0, 1e9},
         {"viscous_friction", "d", "N s/m", "N s/m",
          "viscous friction of the load, per unit of its velocity", 0, 0, 1e9}});
    add_motor(list);
    return list;
  }();
  return all;
}

namespace {

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
                      return root_of_squares(mean) / axis.continuous_torque;
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
      .parameters = MachineTraits<M>::parameters(),
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
