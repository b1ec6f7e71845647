// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <utility>

#include "optim/cycle/moving_jumps.h"
#include "optim/problem/problem.h"

namespace camlaw::optim {

/// A curve that is another one, but for its trace.
class ForwardingCurve : public Curve, public MovingJumps {
 public:
  explicit ForwardingCurve(std::shared_ptr<const Curve> curve) : curve_(std::move(curve)) {}

  Function at(Place place) const override { return curve_->at(place); }
  std::vector<double> slope_gradient(Place place, Design x) const override {
    return curve_->slope_gradient(place, x);
  }
  bool breaks_move() const override { return curve_->breaks_move(); }
  Place tied(Place place, Design x) const override { return curve_->tied(place, x); }
  std::vector<double> jump_motion(Place place, Design x) const override {
    return optim::jump_motion(*curve_, place, x);
  }
  std::vector<Rest> rests(double bound, Design x) const override { return curve_->rests(bound, x); }
  Shape shape() const override { return curve_->shape(); }
  double memory() const override { return curve_->memory(); }

 protected:
  const Curve& curve() const { return *curve_; }

 private:
  std::shared_ptr<const Curve> curve_;
};

/// A response that is a curve, with that curve made into a C(curve, more...).
template <class C, class... More>
Response with_curve(const Response& response, More&&... more) {
  auto curve = std::get<std::shared_ptr<const Curve>>(response.measure);
  return {response.name, response.unit,
          std::make_shared<C>(std::move(curve), std::forward<More>(more)...)};
}

/// Each curve of a problem once made into make(curve): limits on one curve go on sharing it.
template <class Make>
void replace_curves(Problem& problem, const Make& make) {
  std::map<const Curve*, std::shared_ptr<const Curve>> made;
  const auto replace = [&](Response& response) {
    if (!response.is_curve()) return;
    auto& curve = std::get<std::shared_ptr<const Curve>>(response.measure);
    auto& its = made[curve.get()];
    if (!its) its = make(curve);
    curve = its;
  };
  for (Objective& objective : problem.objectives) replace(objective.response);
  for (Constraint& c : problem.constraints) replace(c.response);
}

}  // namespace camlaw::optim
