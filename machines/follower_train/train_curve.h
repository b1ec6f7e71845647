// SPDX-License-Identifier: MIT
#pragma once

#include "machines/follower_train/follower_train.h"
#include "machines/model/box_traces.h"
#include "machines/model/law_number.h"
#include "machines/model/responses.h"

/// Curves of an elastic follower train over its rise, or over the turn of a cam: what has happened
/// before decides them, so that the law is needed as a whole.
namespace camlaw::problems {

/// Amplification: acceleration of the mass over the cam's greatest, y'' / C. CamForce: what the cam
/// must give, a sum of what stands, of the law's s and s'', and of the mass's y''.
enum class TrainQuantity { Deviation, MassDisplacement, MassAcceleration, Amplification, CamForce };

/// The factors of such a sum: a constant, of s, of s'' and of y''.
template <class T>
using TrainLoad = std::array<T, 4>;

/// Value and two derivatives by x of a quantity, in parts of the stroke, from the law's s and four
/// derivatives and the state: z'' and what follows by the equation of motion (U0).
template <class T>
std::array<T, 3> train_quantity(TrainQuantity which, const FollowerTrain<T>& train,
                                const std::array<T, 5>& law, const TrainState<T>& state,
                                const TrainLoad<T>& load) {
  const T W = number<T>(2) * pi<T>() * train.period_ratio;
  const T damping = number<T>(2) * train.damping_ratio * W, square = W * W;
  const T second = -law[2] - damping * state.rate - square * state.z;
  const T third = -law[3] - damping * second - square * state.rate;
  if (which == TrainQuantity::Deviation) return {state.z, state.rate, second};
  if (which == TrainQuantity::MassDisplacement) {
    return {law[0] + state.z, law[1] + state.rate, law[2] + second};
  }
  const std::array<T, 3> mass{-(damping * state.rate + square * state.z),
                              -(damping * second + square * state.rate),
                              -(damping * third + square * second)};
  if (which != TrainQuantity::CamForce) return mass;
  const auto& [stands, by_s, by_a, by_mass] = load;
  return {stands + by_s * law[0] + by_a * law[2] + by_mass * mass[0],
          by_s * law[1] + by_a * law[3] + by_mass * mass[1],
          by_s * law[2] + by_a * law[4] + by_mass * mass[2]};
}

/// What of a machine matters to a curve: tau, zeta, the factor from parts of the stroke, by x, to
/// SI units, as far as the law does not decide it, and of CamForce the load.
inline constexpr std::size_t kTrainParts = 7;

/// Over what a curve runs: a rise from rest, x from 0 to 1, or the turn of a cam in its steady
/// state, in degrees.
enum class TrainRun { Rise, Turn };

/// The quantity at a place and two derivatives by x, with the derivatives by what moves it where
/// the place is tied to a joint. `parts` are kTrainParts.
template <class T>
Possible<std::array<T, 3>> train_quantity_at(TrainQuantity which, TrainRun run,
                                             std::span<const T> parts, const Law<T>& law,
                                             optim::Place place);

/// A law, and the same in intervals.
struct TrainLaws {
  Law<double> plain;
  Law<Interval> enclosing;
};

/// The quantity over the run for one train, times `factor`.
std::unique_ptr<optim::Trace> train_trace(TrainQuantity which, TrainRun run,
                                          std::span<const double> parts,
                                          std::span<const Interval> enclosing, double factor,
                                          std::shared_ptr<const TrainLaws> laws);

struct TrainOfTurn;

/// A curve of the train.
class TrainCurve final : public optim::Curve, public BoundedOverBoxes {
 public:
  /// `parts` are kTrainParts, `factor` leads from SI to the listed unit.
  TrainCurve(TrainQuantity which, TrainRun run, std::vector<Recorded> parts,
             const UnitFactor& factor, const Binding& binding, optim::Shape shape);

  optim::Function at(optim::Place place) const override { return derivative_at(place, 0); }
  std::vector<double> slope_gradient(optim::Place place, optim::Design x) const override;
  bool breaks_move() const override { return !binding_.law->is_linear(); }
  double memory() const override { return binding_.law->memory(); }
  /// Joints are those of the law's pieces, counted from 0.
  optim::Place tied(optim::Place place, optim::Design x) const override;
  std::optional<optim::Function> joint_angle(int joint) const override;
  std::unique_ptr<optim::Trace> trace(optim::Design x) const override;
  optim::Shape shape() const override { return shape_; }
  /// Of a turn; of a rise nothing is known.
  std::unique_ptr<OverBoxes> over_boxes(const Widened& wide, optim::Design x,
                                        TraceAt at) const override;

 private:
  /// Null where the design makes no law.
  std::shared_ptr<const TrainLaws> laws_at(optim::Design x) const;
  /// The curve's derivative by the place, of order 0 or 1, as a function of the design.
  optim::Function derivative_at(optim::Place place, std::size_t order) const;

  TrainQuantity which_;
  TrainRun run_;
  std::vector<Recorded> parts_;
  UnitFactor factor_;
  Binding binding_;
  optim::Shape shape_;
  std::shared_ptr<const TrainOfTurn> of_turn_;  ///< null over a rise, and where the law varies
};

/// (U6) The greatest amplitude of the free vibration in a dwell of the turn, from the first three
/// of kTrainParts.
LawKernel swing_at_rest();

/// The response of a machine M that such a curve is, from
/// parts(machine) -> std::array<T, kTrainParts>.
template <class M, class Parts>
MechanismResponse train_curve(TrainQuantity which, TrainRun run, ResponseAbout about, Parts parts) {
  const UnitFactor factor(about.stored, about.unit);
  MechanismResponse response = detail::described<M>(std::move(about));
  const std::vector<Write> writes = machine_parts<M>(parts);
  response.uses = used_by_any(writes, parameters_of<M>().size());
  if (run == TrainRun::Turn) response.cycle = std::make_shared<Cycle>(turn_of_the_cam());
  response.along = response.cycle ? response.cycle->unit : std::string(1, '1');
  response.sees_law = true;
  response.curve = [=, is_possible = response.is_possible](const Binding& binding,
                                                           optim::Shape shape) {
    return std::make_shared<TrainCurve>(which, run, recorded_parts(binding, writes, is_possible),
                                        factor, binding, shape);
  };
  return response;
}

}  // namespace camlaw::problems
