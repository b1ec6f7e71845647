// SPDX-License-Identifier: MIT
#pragma once

#include "machines/follower_train/follower_train.h"
#include "machines/model/law_number.h"

/// What a rise leaves of vibration, over a range of speeds.
namespace camlaw::problems {

/// What of a machine matters: f_n, zeta, the rise's angle, the stroke, and the ends of the range,
/// in rad/s.
inline constexpr std::size_t kSpeedParts = 6;

/// (U1) over the cam's speed, in rpm: the amplitude that a rise from rest leaves.
class SpeedCurve final : public optim::Curve {
 public:
  SpeedCurve(std::vector<Recorded> parts, const UnitFactor& factor, const Binding& binding,
             optim::Shape shape);

  optim::Function at(optim::Place place) const override;
  /// Its joints are the two ends of the range, which may be variables.
  bool breaks_move() const override { return ends_move_; }
  optim::Place tied(optim::Place place, optim::Design x) const override;
  std::unique_ptr<optim::Trace> trace(optim::Design x) const override;
  optim::Shape shape() const override { return shape_; }
  double memory() const override { return binding_.law->memory(); }

 private:
  std::vector<Recorded> parts_;
  UnitFactor factor_;
  Binding binding_;
  optim::Shape shape_;
  bool ends_move_;
};

/// The response of a machine M that such a curve is, from
/// parts(machine) -> std::array<T, kSpeedParts>.
template <class M, class Parts>
MechanismResponse speed_curve(ResponseAbout about, Parts parts) {
  const UnitFactor factor(about.stored, about.unit);
  MechanismResponse response = detail::described<M>(std::move(about));
  const std::vector<Write> writes = machine_parts<M>(parts);
  response.uses = used_by_any(writes, parameters_of<M>().size());
  response.along = "rpm";
  response.sees_law = true;
  response.curve = [=, is_possible = response.is_possible](const Binding& binding,
                                                           optim::Shape shape) {
    return std::make_shared<SpeedCurve>(recorded_parts(binding, writes, is_possible), factor,
                                        binding, shape);
  };
  return response;
}

}  // namespace camlaw::problems
