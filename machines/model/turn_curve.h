// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "machines/model/recorded_response.h"
#include "optim/problem/curve.h"

/// Curves of mechanisms that no law moves: formulas in the angle of a shaft that turns evenly,
/// which has sections in which they are smooth.
namespace camlaw::problems {

/// Completes a curve over the turn; of its domain, where it has one, the other inputs are those of
/// ShaftTurn::sided. With `has_ranges` its rows know their ranges over boxes of designs: from them
/// a bound of the optimum follows, which takes seconds where the formula is long.
MechanismResponse recorded_turn(MechanismResponse response, ShaftTurn turn,
                                const std::vector<MechanismParameter>& parameters,
                                bool has_ranges = false);

/// A curve's formula in one section, of the angle, rad, or at a place: it lies behind the breaks
/// before it.
Write in_section(const ShaftTurn& turn, std::size_t section, const Write& at = {});

/// What a curve over the turn is made of, for what varies of a binding.
struct TurnParts {
  /// The formula of a section, of the machine's arguments and the angle, rad.
  std::vector<Recorded> sections;
  std::vector<std::shared_ptr<const optim::Kernel>> kernels;  ///< of the sections
  /// Where a section has a value, if that is known.
  std::vector<Recorded> domains;
  /// Of the machine's arguments: the kernels of the two sections at each of their breaks that
  /// moves, wherever it is, and where some break moves, the angle of each, deg. Empty where a break
  /// does not matter.
  struct Joint {
    std::shared_ptr<const optim::Kernel> left, right, angle;
  };
  std::vector<Joint> joints;
  /// Of the machine's arguments: where sections meet, rad.
  std::vector<Recorded> breaks;
  bool has_ranges;

  std::vector<double> breaks_at(std::span<const double> arguments) const;
};

/// The section of a place, in deg, between breaks in rad; where two meet, the earlier one from the
/// left.
std::size_t section_of(const std::vector<double>& breaks, optim::Place place);

/// A curve over the turn, its places in degrees, over the variables of a binding.
class TurnCurve final : public optim::Curve {
 public:
  TurnCurve(TurnParts parts, const Binding& binding, optim::Shape shape);

  optim::Function at(optim::Place place) const override;
  std::vector<double> slope_gradient(optim::Place place, optim::Design x) const override;
  bool breaks_move() const override;
  optim::Place tied(optim::Place place, optim::Design x) const override;
  std::optional<optim::Function> joint_angle(int joint) const override;
  std::unique_ptr<optim::Trace> trace(optim::Design x) const override;
  optim::Shape shape() const override { return shape_; }

 private:
  std::shared_ptr<const TurnParts> parts_;
  std::vector<std::size_t> variables_;  ///< behind the machine's arguments
  optim::Shape shape_;
};

}  // namespace camlaw::problems
