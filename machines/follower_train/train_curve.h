// SPDX-License-Identifier: MIT
#pragma once

#include "machines/follower_train/elastic_follower.h"
#include "machines/model/law_number.h"

/// Curves of an elastic follower train over its rise: what has happened since the beginning decides
/// them, so that the law is needed as a whole.
namespace camlaw::problems {

/// Amplification: acceleration of the mass over the cam's greatest, y'' / C.
enum class TrainQuantity { Deviation, MassDisplacement, MassAcceleration, Amplification };

/// Value and two derivatives by x of a quantity, in parts of the stroke, from the law's s, v, a, j
/// and the state: z'' and z''' by the equation of motion (U0).
template <class T>
std::array<T, 3> train_quantity(TrainQuantity which, const FollowerTrain<T>& train,
                                const std::array<T, 4>& law, const TrainState<T>& state) {
  const T W = number<T>(2) * pi<T>() * train.period_ratio;
  const T damping = number<T>(2) * train.damping_ratio * W, square = W * W;
  const T second = -law[2] - damping * state.rate - square * state.z;
  const T third = -law[3] - damping * second - square * state.rate;
  if (which == TrainQuantity::Deviation) return {state.z, state.rate, second};
  if (which == TrainQuantity::MassDisplacement) {
    return {law[0] + state.z, law[1] + state.rate, law[2] + second};
  }
  return {-(damping * state.rate + square * state.z), -(damping * second + square * state.rate),
          -(damping * third + square * second)};
}

/// What of the machine matters to a curve: tau, zeta, and the factor from parts of the stroke, by
/// x, to SI units, as far as the law does not decide it.
std::vector<Write> train_parts(TrainQuantity which);

/// A curve of the train over x, 0 to 1.
class TrainCurve final : public optim::Curve {
 public:
  /// `parts` are those of train_parts, `factor` leads from SI to the listed unit.
  TrainCurve(TrainQuantity which, std::vector<Recorded> parts, const UnitFactor& factor,
             const Binding& binding, optim::Shape shape);

  optim::Function at(optim::Place place) const override { return derivative_at(place, 0); }
  std::vector<double> slope_gradient(optim::Place place, optim::Design x) const override;
  bool breaks_move() const override { return !binding_.law->is_linear(); }
  double memory() const override { return binding_.law->memory(); }
  /// Joints are those of the law's pieces, counted from 0.
  optim::Place tied(optim::Place place, optim::Design x) const override;
  std::unique_ptr<optim::Trace> trace(optim::Design x) const override;
  optim::Shape shape() const override { return shape_; }

 private:
  /// The curve's derivative by x of order 0 or 1, as a function of the design.
  optim::Function derivative_at(optim::Place place, std::size_t order) const;

  TrainQuantity which_;
  std::vector<Recorded> parts_;  ///< train_parts
  UnitFactor factor_;
  Binding binding_;
  optim::Shape shape_;
};

}  // namespace camlaw::problems
