// SPDX-License-Identifier: MIT

#include "machines/follower_train/elastic_follower.h"
#include "machines/follower_train/speed_curve.h"
#include "machines/follower_train/train_curve.h"
#include "machines/model/law_formula.h"
#include "machines/model/usual_problem.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {
namespace {

using optim::Part;
using S = optim::Shape;

enum class Number { Frequency, RiseTime, PeriodRatio };

MechanismResponse number_of(Number which, ResponseAbout about) {
  return number_response<ElasticFollower>(std::move(about), [which](const auto& follower) {
    if (which == Number::Frequency) return follower.natural_frequency();
    if (which == Number::RiseTime) return follower.rise_time();
    return follower.period_ratio();
  });
}

enum class Residual { Displacement, Velocity, Amplitude, Acceleration };

/// What is left when the rise is over.
MechanismResponse residual(Residual which, ResponseAbout about) {
  // The train's two numbers, and what turns parts of the stroke into the residual.
  const auto parts = [which](const ElasticFollower& f) {
    Expression scale = f.stroke;
    if (which == Residual::Velocity) scale = f.stroke / f.rise_time();
    if (which == Residual::Acceleration) scale = f.stiffness / f.mass * f.stroke;
    return std::array<Expression, 3>{f.period_ratio(), f.damping_ratio, scale};
  };
  return law_number<ElasticFollower>(
      std::move(about), parts,
      law_kernel([which]<class T>(std::span<const T> part, const Law<T>& law) -> Possible<T> {
        const FollowerTrain<T> train{part[0], part[1]};
        const auto state = train.after(law);
        if (!state) return state.reason();
        if (which == Residual::Displacement) return T(part[2] * state->z);
        return T(part[2] * (which == Residual::Velocity ? state->rate : train.amplitude(*state)));
      }));
}

/// Of what the train makes of the cam's acceleration.
std::vector<ShapeStatement> linear_train() {
  return {{{"law"}, S::Linear, "DS10"}, {{"stroke"}, S::Linear, "DS10"}};
}

std::vector<MechanismResponse> train_numbers() {
  const std::vector<ShapeStatement> linear = linear_train();
  const std::vector<ShapeStatement> convex{{{"law"}, S::Convex, "DS10"},
                                           {{"stroke"}, S::Linear, "DS10"}};
  return {
      number_of(Number::Frequency, {"natural_frequency", "Hz", "Hz", "without damping"}),
      number_of(Number::RiseTime, {"rise_time", "s", "s", "duration of the rise"}),
      number_of(Number::PeriodRatio,
                {"period_ratio", "1", "1", "duration of the rise over the natural period"}),
      residual(Residual::Displacement,
               {"residual_displacement", "mm", "m",
                "displacement of the mass from its final position at the end of the rise", linear}),
      residual(Residual::Velocity, {"residual_velocity", "m/s", "m/s",
                                    "velocity of the mass at the end of the rise", linear}),
      residual(Residual::Amplitude,
               {"residual_amplitude", "mm", "m", "amplitude of the residual vibration", convex}),
      residual(Residual::Acceleration,
               {"residual_acceleration", "m/s2", "m/s2",
                "greatest acceleration of the residual vibration, undamped", convex})};
}

/// A curve that the law decides as a whole.
MechanismResponse curve(TrainQuantity which, ResponseAbout about) {
  const auto parts = [which](const ElasticFollower& f) {
    const Expression none = 0;
    Expression scale = f.stroke;
    if (which == TrainQuantity::Amplification) scale = 1;
    if (which == TrainQuantity::MassAcceleration) scale = scale / (f.rise_time() * f.rise_time());
    return std::array<Expression, kTrainParts>{
        f.period_ratio(), f.damping_ratio, scale, none, none, none, none};
  };
  return train_curve<ElasticFollower>(which, TrainRun::Rise, std::move(about), parts);
}

/// What is left over the range of speeds.
MechanismResponse over_speeds() {
  return speed_curve<ElasticFollower>(
      {"residual_over_speed",
       "mm",
       "m",
       "amplitude of the residual vibration, over the speeds of the range",
       {{{"law"}, S::Convex, "DS10"}, {{"stroke"}, S::Linear, "DS10"}}},
      [](const ElasticFollower& f) {
        return std::array<Expression, kSpeedParts>{f.natural_frequency(), f.damping_ratio,
                                                   f.rise_angle,          f.stroke,
                                                   f.slowest_speed,       f.fastest_speed};
      });
}

}  // namespace

Mechanism follower_train_mechanism() {
  const std::vector<ShapeStatement> linear = linear_train();
  std::vector<MechanismResponse> responses = train_numbers();
  using Q = TrainQuantity;
  responses.push_back(
      curve(Q::Deviation,
            {"deviation", "mm", "m", "deviation of the mass from the cam's displacement", linear}));
  responses.push_back(curve(Q::MassDisplacement,
                            {"mass_displacement", "mm", "m", "displacement of the mass", linear}));
  responses.push_back(curve(Q::MassAcceleration, {"mass_acceleration", "m/s2", "m/s2",
                                                  "acceleration of the mass", linear}));
  responses.push_back(
      curve(Q::Amplification, {"amplified_acceleration", "1", "1",
                               "acceleration of the mass over the cam's greatest acceleration"}));
  responses.push_back(over_speeds());
  return {
      .name = "follower-train",
      .title = "elastic follower train with one mass, over a rise from rest",
      .source = "docs/theory.md, Elastic follower train",
      .parameters = parameters_of<ElasticFollower>(),
      .responses = std::move(responses),
      .peaks = {{"peak_deviation", "deviation", Part::Magnitude,
                 "greatest deviation during the rise"},
                {"peak_mass_acceleration", "mass_acceleration", Part::Magnitude,
                 "greatest acceleration of the mass during the rise"},
                {"amplification", "amplified_acceleration", Part::Magnitude,
                 "greatest acceleration of the mass over that of the cam"},
                {"worst_residual", "residual_over_speed", Part::Highest,
                 "greatest residual amplitude at any speed of the range"}},
      .why_impossible = why_impossible_as<ElasticFollower>,
      .usual = usual_problem({.objective = "peak_mass_acceleration",
                              .variables = {{"rise_angle", 60, 150, 90}},
                              .limits = {{"residual_displacement", -0.05, 0.05}},
                              .others = {"worst_residual", "residual_amplitude", "peak_deviation",
                                         "amplification", "natural_frequency"},
                              .law = "modified-sine"})};
}

}  // namespace camlaw::problems
