// SPDX-License-Identifier: MIT
#include "kinematics/law.h"
#include "machines/model/append.h"
#include "machines/model/given.h"
#include "machines/model/mean_number.h"
#include "machines/model/possibility.h"
#include "machines/model/responses.h"
#include "machines/model/usual_problem.h"
#include "machines/model/why_impossible.h"
#include "numerics/formula/expression.h"

/// Axes that a servo motor moves through a gear, by a program instead of a cam (docs/theory.md,
/// "Servo axes"). SI units.
namespace camlaw::problems {
namespace {

/// What the motor's shaft gives.
struct ServoMotor {
  Expression inertia;            ///< J_M, kg m^2, with a brake
  Expression continuous_torque;  ///< M_0, N m, root mean square that its heat allows
  Expression maximum_torque;     ///< M_max, N m, up to the corner speed
  Expression corner_speed;       ///< omega_c, rad/s
  Expression maximum_speed;      ///< omega_max, rad/s
  Expression end_torque;         ///< M_e, N m, at the maximum speed

  static ServoMotor given_by(Given& given) {
    return {given({"motor_inertia", "J_M", "kg cm2", "kg m2",
                   "moment of inertia of the motor, with a brake", 1.6, 1e-6, 1e8}),
            given({"continuous_torque", "M_0", "N m", "N m",
                   "torque that the motor can deliver continuously without overheating", 2.4, 1e-6,
                   1e7}),
            given({"maximum_torque", "M_max", "N m", "N m",
                   "greatest torque up to the corner speed", 7.2, 1e-6, 1e7}),
            given({"corner_speed", "n_c", "rpm", "rad/s",
                   "speed above which the greatest torque falls", 3600, 0, 1e6}),
            given({"maximum_speed", "n_max", "rpm", "rad/s", "greatest speed of the motor", 6000,
                   1e-3, 1e6}),
            given({"end_torque", "M_e", "N m", "N m", "greatest torque at the maximum speed", 3, 0,
                   1e7})};
  }
  auto conditions() const {
    return std::to_array<Condition>(
        {{corner_speed, "corner_speed must be 0 or above", true},
         {maximum_speed - corner_speed, "corner_speed must be below maximum_speed"}});
  }
  /// (SV7) Greatest torque at a speed of either sense, N m: M_max up to the corner speed, from
  /// there on the line down to M_e at the maximum speed.
  Expression available_torque(const Expression& speed) const {
    const Expression slope = (maximum_torque - end_torque) / (maximum_speed - corner_speed);
    const Expression line = maximum_torque - slope * (absolute(speed) - corner_speed);
    return lesser_of(maximum_torque, line);
  }
};

/// Where the load is, and how it moves: m or rad, and seconds.
struct AxisMotion {
  Expression s, v, a, j;
};

/// Motor, gear and load of an axis; what is said of the load is in kg, N and m, or in kg m^2, N m
/// and rad.
struct ServoDrive {
  ServoMotor motor;
  Expression turns;         ///< k, angle of the motor per travel of the load: rad/m, or 1
  Expression gear_inertia;  ///< J_G, kg m^2, at the motor's shaft
  Expression efficiency;    ///< eta, of gear and all that the load drives or is driven by
  Expression load_inertia;  ///< m, or J_L
  Expression load;          ///< F_L, constant, against motion to greater displacements
  Expression friction;      ///< F_C, against the motion, whatever its speed
  Expression viscosity;     ///< d, friction by velocity

  /// (SV2) What the gear gives the load: F = m a + d v + F_C sgn v + F_L.
  Expression output(const AxisMotion& y) const {
    return load_inertia * y.a + viscosity * y.v + along(y.v, friction) + load;
  }
  /// Motor and gear, at the motor's shaft.
  Expression own_inertia() const { return motor.inertia + gear_inertia; }
  /// (SV3) The load's inertia at the motor's shaft, kg m^2: m / k^2.
  Expression reflected_inertia() const { return load_inertia / (turns * turns); }
  /// (SV4) Torque on the motor's shaft, N m: (J_M + J_G) k a + M + M_R, where M = F / k and M_R is
  /// what the gear's losses add to M eta^-1 where the motor drives the load and leave of it, M eta,
  /// where the load drives the motor. At rest neither drives.
  Expression motor_torque(const AxisMotion& y) const {
    const Expression lossless = output(y) / turns;
    const Expression driving = (1 / efficiency - 1) * lossless;
    const Expression driven = (efficiency - 1) * lossless;
    const Expression losses = by_side(y.v, greater_of(driving, driven), lesser_of(driving, driven));
    return own_inertia() * turns * y.a + lossless + unless_zero(y.v, losses);
  }
  /// (SV5) What of it accelerates, without losses: (J_M + J_G + m / k^2) k a.
  Expression acceleration_torque(const AxisMotion& y) const {
    return (own_inertia() + reflected_inertia()) * turns * y.a;
  }
  /// (SV6) Power of the motor's shaft, W; below 0 the load drives the motor.
  Expression motor_power(const AxisMotion& y) const { return motor_torque(y) * (turns * y.v); }
  Expression available_torque(const AxisMotion& y) const {
    return motor.available_torque(turns * y.v);
  }
  /// (SV8) What is left of the available torque, N m. Below 0 the motor does not follow.
  Expression torque_reserve(const AxisMotion& y) const {
    return available_torque(y) - absolute(motor_torque(y));
  }
  /// (SV9) Torque over what is available; not a number where nothing is.
  Expression torque_utilisation(const AxisMotion& y) const {
    const Expression available = available_torque(y);
    return where_positive(available, absolute(motor_torque(y)) / available);
  }
  /// (SV11) Inertia of gear and load at the motor's shaft over the motor's own.
  Expression inertia_ratio() const { return (gear_inertia + reflected_inertia()) / motor.inertia; }
  /// (SV12) The k that needs the least torque for an acceleration of the load, without losses:
  /// there the reflected inertia is that of motor and gear.
  Expression matched_turns() const { return sqrt(load_inertia / own_inertia()); }
};

/// Parameters of any axis.
namespace axes {

inline constexpr MachineParameter kStroke{
    "stroke", "S", "deg", "rad", "travel of the load at displacement 1", 90, 1e-6, 1e6},
    kSpeed{"speed", "n", "rpm", "rad/s", "cycles of the axis per minute", 120, 1e-3, 1e6},
    kGearRatio{"gear_ratio", "i",  "1", "1", "turns of the motor per turn of the load",
               10,           1e-3, 1e5},
    kGearInertia{"gear_inertia",
                 "J_G",
                 "kg cm2",
                 "kg m2",
                 "moment of inertia of gear and coupling, referred to the motor's shaft",
                 0.3,
                 0,
                 1e8},
    kEfficiency{"gear_efficiency",
                "eta",
                "1",
                "1",
                "efficiency of gear and guide, in either direction of power flow",
                0.95,
                0.01,
                1};

}  // namespace axes

/// An axis that turns its load. Fields in SI units.
struct ServoAxis {
  Given given = {};
  Expression stroke = given(axes::kStroke);         ///< S, rad, of the load
  Expression cycle_speed = given(axes::kSpeed);     ///< omega, rad/s, 2 pi per cycle
  Expression gear_ratio = given(axes::kGearRatio);  ///< i, turns of the motor per turn of the load
  Expression gear_inertia = given(axes::kGearInertia);  ///< J_G, kg m^2, at the motor's shaft
  Expression efficiency = given(axes::kEfficiency);     ///< eta
  Expression load_inertia =
      given({"load_inertia", "J_L", "kg m2", "kg m2",
             "moment of inertia of everything that turns with the load", 0.02, 0, 1e6});
  Expression load = given(
      {"load_torque", "M_L", "N m", "N m",
       "constant torque of the load that opposes motion to greater displacements", 0, -1e9, 1e9});
  Expression friction =
      given({"friction_torque", "M_C", "N m", "N m",
             "friction of the load, which opposes its motion at any speed", 0, 0, 1e9});
  Expression viscosity =
      given({"viscous_friction", "d", "N m s", "N m s",
             "viscous friction of the load, per unit of its velocity", 0, 0, 1e9});
  ServoMotor motor = ServoMotor::given_by(given);

  auto conditions() const { return motor.conditions(); }
  ServoDrive drive() const {
    return {motor, gear_ratio, gear_inertia, efficiency, load_inertia, load, friction, viscosity};
  }
  /// (SV12) Gear ratio of the matched inertia.
  Expression matched_ratio() const { return drive().matched_turns(); }
};

/// An axis that moves its load along a line, by a screw, a pinion or a belt. Fields in SI units.
struct LinearServoAxis {
  Given given = {};
  Expression stroke =
      given({"stroke", "S", "mm", "m", "travel of the load at displacement 1", 200, 1e-6, 1e6});
  Expression feed =
      given({"feed", "p", "mm", "m",
             "travel of the load per turn of the screw, the pinion or the belt's pulley", 100, 1e-3,
             1e5});
  Expression cycle_speed = given(axes::kSpeed.by_default(60));  ///< omega, rad/s, 2 pi per cycle
  Expression gear_ratio = given(axes::kGearRatio.by_default(3).meaning_that(
      "turns of the motor per turn of the screw or pinion"));
  Expression gear_inertia = given(axes::kGearInertia);  ///< J_G, kg m^2, at the motor's shaft
  Expression efficiency = given(axes::kEfficiency);     ///< eta
  Expression mass =
      given({"mass", "m", "kg", "kg", "mass of everything that moves with the load", 10, 0, 1e6});
  Expression load = given(
      {"load_force", "F_L", "N", "N",
       "constant force of the load that opposes motion to greater displacements", 0, -1e9, 1e9});
  Expression friction =
      given({"friction_force", "F_C", "N", "N",
             "friction of the load, which opposes its motion at any speed", 0, 0, 1e9});
  Expression viscosity =
      given({"viscous_friction", "d", "N s/m", "N s/m",
             "viscous friction of the load, per unit of its velocity", 0, 0, 1e9});
  ServoMotor motor = ServoMotor::given_by(given);

  auto conditions() const { return motor.conditions(); }
  /// k = 2 pi i / p.
  ServoDrive drive() const {
    const Expression turns = 2 * pi() * gear_ratio / feed;
    return {motor, turns, gear_inertia, efficiency, mass, load, friction, viscosity};
  }
  /// (SV12) Gear ratio of the matched inertia.
  Expression matched_ratio() const { return drive().matched_turns() * feed / (2 * pi()); }
};

/// (SV1) The load's motion in time: s = S s(x), v = S s' / t_c, a = S s'' / t_c^2, ..., with the
/// time of a cycle t_c = 2 pi / omega.
template <class Axis>
AxisMotion axis_motion(const Axis& axis, const Motion<Expression>& motion) {
  const Expression rate = axis.cycle_speed / (2 * pi());
  const Expression first = axis.stroke * rate, second = first * rate, third = second * rate;
  return {axis.stroke * motion.s, first * motion.v, second * motion.a, third * motion.j};
}

using optim::Part;

/// Units and names that differ between loads that turn and loads that slide.
struct AxisWords {
  const char *place, *place_stored, *output, *output_unit, *output_meaning;
};
constexpr AxisWords kTurning{"deg", "rad", "output_torque", "N m",
                             "torque that the gear delivers to the load"};
constexpr AxisWords kLinear{"mm", "m", "output_force", "N",
                            "force that screw or pinion exerts on the load"};

template <class M>
std::vector<MechanismResponse> servo_curves(const AxisWords& w) {
  const std::string unit = w.place_stored;
  const auto curve = [](ResponseAbout about, auto formula) {
    return curve_response<M>(std::move(about), turn_of_the_cam(),
                             [formula](const auto& axis, const auto& motion) {
                               return formula(axis.drive(), axis_motion(axis, motion));
                             });
  };
  std::vector<MechanismResponse> all{
      curve({"displacement", w.place, w.place_stored, "travel of the load"},
            [](const auto&, const auto& y) { return y.s; }),
      curve({"velocity", unit + "/s", unit + "/s", "velocity of the load"},
            [](const auto&, const auto& y) { return y.v; }),
      curve({"acceleration", unit + "/s2", unit + "/s2", "acceleration of the load"},
            [](const auto&, const auto& y) { return y.a; }),
      curve({"jerk", unit + "/s3", unit + "/s3", "jerk of the load"},
            [](const auto&, const auto& y) { return y.j; }),
      curve({w.output, w.output_unit, w.output_unit, w.output_meaning},
            [](const auto& drive, const auto& y) { return drive.output(y); }),
      curve({"motor_angle", "deg", "rad", "angle of the motor, 0 at displacement 0"},
            [](const auto& drive, const auto& y) { return drive.turns * y.s; }),
      curve({"motor_speed", "rpm", "rad/s", "speed of the motor"},
            [](const auto& drive, const auto& y) { return drive.turns * y.v; }),
      curve({"motor_acceleration", "rad/s2", "rad/s2", "acceleration of the motor"},
            [](const auto& drive, const auto& y) { return drive.turns * y.a; }),
      curve({"motor_jerk", "rad/s3", "rad/s3", "jerk of the motor"},
            [](const auto& drive, const auto& y) { return drive.turns * y.j; }),
      curve({"motor_torque", "N m", "N m", "torque on the motor's shaft"},
            [](const auto& drive, const auto& y) { return drive.motor_torque(y); }),
      curve({"acceleration_torque", "N m", "N m",
             "part of the motor torque that accelerates motor, gear and load, without losses"},
            [](const auto& drive, const auto& y) { return drive.acceleration_torque(y); }),
      curve({"motor_power", "W", "W",
             "power of the motor's shaft; below 0 the load drives the motor"},
            [](const auto& drive, const auto& y) { return drive.motor_power(y); }),
      curve({"available_torque", "N m", "N m",
             "greatest torque that the motor can deliver at its present speed"},
            [](const auto& drive, const auto& y) { return drive.available_torque(y); }),
      curve({"torque_reserve", "N m", "N m", "available torque minus the motor's torque"},
            [](const auto& drive, const auto& y) { return drive.torque_reserve(y); }),
      curve({"torque_utilisation", "1", "1",
             "the motor's torque, in either direction, over the available torque"},
            [](const auto& drive, const auto& y) { return drive.torque_utilisation(y); }),
      curve({"speed_utilisation", "1", "1",
             "the motor's speed, in either direction, over its maximum speed"},
            [](const auto& drive, const auto& y) {
              return absolute(drive.turns * y.v) / drive.motor.maximum_speed;
            })};
  set_defined_while(all, {"available_torque", "torque_reserve", "torque_utilisation"},
                    {.response = "speed_utilisation", .upper = 1});
  return all;
}

/// A number from the mean of integrand(drive, motion) over the cycle: formula(axis, mean).
template <class M, class Integrand, class F>
MechanismResponse servo_mean(ResponseAbout about, Integrand integrand, F formula) {
  return mean_number<M>(
      std::move(about),
      [integrand](const auto& axis, const auto& motion) {
        return integrand(axis.drive(), axis_motion(axis, motion));
      },
      formula);
}

template <class M>
std::vector<MechanismResponse> servo_numbers() {
  const auto square = [](const auto& drive, const auto& y) {
    const auto torque = drive.motor_torque(y);
    return torque * torque;
  };
  const auto power = [](const auto& drive, const auto& y) { return drive.motor_power(y); };
  const auto taken_back = [](const auto& drive, const auto& y) {
    const auto given = drive.motor_power(y);
    return greater_of(0, -given);
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
      servo_mean<M>(
          {"regenerated_energy", "J", "J",
           "energy that the load returns to the motor's shaft in a cycle"},
          taken_back,
          [](const auto& axis, const auto& mean) { return 2 * pi() / axis.cycle_speed * mean; }),
      number_response<M>(
          {"inertia_ratio", "1", "1",
           "inertia of gear and load, referred to the motor's shaft, over the motor's own"},
          [](const auto& axis) { return axis.drive().inertia_ratio(); }),
      number_response<M>(
          {"matched_ratio", "1", "1",
           "gear ratio that accelerates the load with the least torque, without losses"},
          [](const auto& axis) { return axis.matched_ratio(); })};
}

template <class M>
Mechanism servo_mechanism(const char* name, const char* title, const AxisWords& words,
                          UsualProblem usual) {
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
      .why_impossible = why_impossible_as<M>,
      .usual = usual_problem(std::move(usual))};
}

}  // namespace

Mechanism servo_axis_mechanism() {
  return servo_mechanism<ServoAxis>(
      "servo-axis", "servo motor that turns a load through a gear", kTurning,
      {.objective = "torque_rms",
       .variables = {{"gear_ratio", 1, 30, 8}},
       .limits = {{"torque_utilisation", kNone, 0.9}, {"inertia_ratio", kNone, 10}},
       .others = {"peak_torque", "peak_motor_speed", "peak_power", "speed_utilisation",
                  "rms_utilisation", "matched_ratio"},
       .segments = rise_and_return()});
}

Mechanism linear_servo_axis_mechanism() {
  return servo_mechanism<LinearServoAxis>(
      "linear-servo-axis", "servo motor that moves a load by screw, pinion or belt", kLinear,
      {.objective = "torque_rms",
       .variables = {{"gear_ratio", 1, 10, 3}},
       .limits = {{"torque_utilisation", kNone, 0.9}, {"rms_utilisation", kNone, 0.9}},
       .others = {"peak_torque", "peak_motor_speed", "peak_power", "speed_utilisation",
                  "inertia_ratio", "matched_ratio"},
       .segments = rise_and_return()});
}

}  // namespace camlaw::problems
