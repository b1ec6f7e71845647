// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

#include "machines/model/curve_formula.h"
#include "machines/model/cycle.h"
#include "machines/model/jumps.h"
#include "machines/model/law_binding.h"
#include "machines/model/mechanism.h"
#include "optim/cycle/moving_jumps.h"
#include "optim/problem/curve.h"

namespace camlaw::problems {

class AffineCurve;
class PlaceMotion;

/// What a curve of a mechanism is made of.
struct CurveParts {
  Cycle cycle;
  std::array<bool, 4> uses = {true, true, true, true};  ///< which of s, v, a, j
  bool uses_place = false;                              ///< whether x itself matters
  /// The formula in the machine's arguments, s, v, a, j, and x where that matters.
  std::shared_ptr<const optim::Kernel> point;
  /// The formula for given arguments of the machine.
  std::function<std::unique_ptr<const CurveFormula>(std::span<const double>)> formula;
  /// What to look for jumps with, made from the record when it is first asked for.
  std::function<FormulaJumps()> find_jumps;
};

/// A curve of a mechanism over the variables of a binding.
class MechanismCurve final : public optim::Curve, public optim::MovingJumps {
 public:
  MechanismCurve(CurveParts parts, const Binding& binding, optim::Shape shape);

  optim::Function at(optim::Place place) const override;
  std::vector<double> slope_gradient(optim::Place place, optim::Design x) const override;
  bool breaks_move() const override;
  double memory() const override { return law_->memory(); }
  optim::Place tied(optim::Place place, optim::Design x) const override;
  std::vector<double> jump_motion(optim::Place place, optim::Design x) const override;
  std::optional<optim::Function> joint_angle(int joint) const override;
  std::vector<optim::Rest> rests(double bound, optim::Design x) const override;
  std::unique_ptr<optim::Trace> trace(optim::Design x) const override;
  std::optional<double> largest_change(const std::vector<double>& scales, int places,
                                       double shortest) const override;
  double largest(optim::Design x) const override;
  bool is_light() const override { return affine() != nullptr; }
  optim::Shape shape() const override { return shape_; }

 private:
  bool joint_moves(int joint) const;
  PlaceMotion motion_at(optim::Place place) const;
  const AffineCurve* affine() const;
  const FormulaJumps& jumps() const;
  bool jumps_move() const;
  std::optional<std::vector<double>> jump_places(optim::Design x) const;

  std::shared_ptr<const CurveParts> parts_;
  std::vector<std::size_t> variables_;  ///< behind the machine's arguments
  std::shared_ptr<const LawBinding> law_;
  optim::Shape shape_;
  /// Worked out when it is first asked for.
  mutable std::once_flag affine_asked_, jumps_asked_, places_asked_;
  mutable std::shared_ptr<const AffineCurve> affine_;
  mutable FormulaJumps jumps_;
  mutable std::vector<double> still_places_;  ///< of jumps that do not move
};

}  // namespace camlaw::problems
