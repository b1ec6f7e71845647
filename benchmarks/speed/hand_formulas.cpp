// SPDX-License-Identifier: MIT
#include "benchmarks/speed/hand_formulas.h"

#include <cmath>
#include <numbers>

namespace camlaw::benchmarks {
namespace {

constexpr double kPi = std::numbers::pi, kDegree = kPi / 180;
constexpr double kRpm = kPi / 30;  // rad/s

double square(double x) { return x * x; }

/// A roller on a disc cam with an offset, a guide with friction, and Hertz's stress.
double roller_stress(std::span<const double> u) {
  const double stroke = u[0] * 1e-3, base = u[1] * 1e-3, roller = u[2] * 1e-3, offset = u[3] * 1e-3;
  const double speed = u[4] * kRpm, mass = u[5], rate = u[6] * 1e3, preload = u[7], load = u[8];
  const double friction = u[9], overhang = u[10] * 1e-3, guide = u[11] * 1e-3;
  const double width = u[12] * 1e-3, modulus = u[13] * 1e9, poisson = u[14];
  const double lift = stroke * u[15], slope = stroke * u[16] / (2 * kPi);
  const double bend = stroke * u[17] / square(2 * kPi);
  const double axial = mass * speed * speed * bend + rate * lift + preload + load;
  const double along = slope - offset;
  const double height = lift + std::sqrt(square(base + roller) - offset * offset);
  const double size = std::abs(along / height);
  const double sign = slope == 0 ? 0 : slope < 0 ? -1 : 1;
  const double rubbing = friction * (2 * (overhang - lift) / guide + 1) * sign * size;
  const double force = axial / (1 - (axial < 0 ? -rubbing : rubbing)) *
                       std::sqrt(square(along / height) + 1) / width;
  const double radius = std::sqrt(height * height + along * along);
  const double curvature =
      (along * (2 * slope - offset) - height * (bend - height)) / (radius * radius * radius);
  return 1e-6 * std::sqrt(modulus / (1 - poisson * poisson) / (2 * kPi) * force /
                          (roller * (1 - roller * curvature)));
}

double arm_pressure_angle(std::span<const double> u) {
  const double swing = u[0] * kDegree, arm = u[1], pivots = u[2], radius = u[3] + u[4];
  const double start =
      std::acos((arm * arm + pivots * pivots - radius * radius) / (2 * arm * pivots));
  const double angle = swing * u[5] + start, rate = swing * u[6] / (2 * kPi);
  return std::atan((arm * (rate + 1) - pivots * std::cos(angle)) / (pivots * std::sin(angle))) /
         kDegree;
}

double wheel_torque(std::span<const double> u) {
  const double half = kPi / 2 - kPi / u[0], speed = u[1] * kRpm, inertia = u[2], friction = u[3];
  if (u[4] - 2 * half >= 0) return 0;
  const double crank = std::sin(kPi / u[0]), angle = u[4] - half;
  const double bent = 1 + crank * crank - 2 * crank * std::cos(angle);
  return friction -
         inertia * speed * speed * crank * (1 - crank * crank) * std::sin(angle) / (bent * bent);
}

double press_approach(std::span<const double> u) {
  const double mass = u[0], stroke = u[1] * 1e-3, rate = u[2] * 1e3, preload = u[3];
  const double width = u[4] * 1e-3, poisson = u[5], modulus = u[6] * 1e9;
  const double radii = (u[7] + u[8]) * 1e-3, turn = u[9] * kRpm / kPi;
  const double load =
      (mass * stroke * turn * turn * u[11] + rate * stroke * u[10] + preload) / width;
  return 1e6 * 2 * (1 - poisson * poisson) / (kPi * modulus) * load *
         (std::log(4 * radii * modulus / (load * 1.52 * 1.52)) + 0.815);
}

double spring_stress(std::span<const double> u) {
  const double wire = u[0] * 1e-3, mean = u[1] * 1e-3, coils = u[2], modulus = u[3] * 1e9;
  const double deflection = u[4] * 1e-3, index = mean / wire;
  const double rate = modulus * wire * wire * wire * wire / (8 * mean * mean * mean * coils);
  return 1e-6 * (index + 0.5) / (index - 0.75) * 8 * mean / (kPi * wire * wire * wire) * rate *
         deflection;
}

double train_periods(std::span<const double> u) {
  return u[0] * kDegree / (u[1] * kRpm) * std::sqrt(u[2] * 1e3 / u[3]) / (2 * kPi);
}

}  // namespace

const std::vector<HandFormula>& hand_formulas() {
  static const std::vector<HandFormula> kAll{
      {"disc-cam-roller",
       "contact_stress",
       {"stroke", "base_radius", "roller_radius", "offset", "speed", "mass", "spring_rate",
        "spring_preload", "load", "guide_friction", "overhang", "guide_length", "face_width",
        "youngs_modulus", "poisson_ratio", "s", "v", "a"},
       roller_stress},
      {"disc-cam-oscillating-roller",
       "pressure_angle",
       {"swing", "arm_length", "pivot_distance", "base_radius", "roller_radius", "s", "v"},
       arm_pressure_angle},
      {"geneva", "wheel_torque", {"slots", "speed", "inertia", "friction", "angle"}, wheel_torque},
      {"die-press",
       "running_approach",
       {"mass", "stroke", "spring_rate", "spring_preload", "face_width", "poisson_ratio",
        "youngs_modulus", "roller_radius", "segment_radius", "speed", "s", "a"},
       press_approach},
      {"helical-spring",
       "working_stress",
       {"wire_diameter", "mean_diameter", "active_coils", "shear_modulus", "working_deflection"},
       spring_stress},
      {"follower-train",
       "period_ratio",
       {"rise_angle", "speed", "stiffness", "mass"},
       train_periods}};
  return kAll;
}

}  // namespace camlaw::benchmarks
