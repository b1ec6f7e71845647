// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "machines/model/mechanism.h"
#include "numerics/scalar/series.h"
#include "optim/problem/curve.h"

/// Curves of mechanisms that no law moves: formulas in the angle of a shaft that turns evenly.
namespace camlaw::problems {

/// A curve's formula with the machine of one design worked in, in every scalar that a trace needs.
/// The turn has sections in which the formula is smooth; angles in rad, 0 to 2 pi.
class TurnFormula {
 public:
  template <class T, std::size_t N>
  using Angle = Series<T, N>;

  virtual ~TurnFormula() = default;
  /// Where sections meet, increasing, each between 0 and 2 pi.
  virtual std::vector<Interval> breaks() const = 0;
  virtual Series<double, 3> at(std::size_t section, const Angle<double, 3>& angle) const = 0;
  virtual Series<Interval, 1> at(std::size_t section, const Angle<Interval, 1>& angle) const = 0;
  virtual Series<Interval, 2> at(std::size_t section, const Angle<Interval, 2>& angle) const = 0;
  virtual Series<Interval, 3> at(std::size_t section, const Angle<Interval, 3>& angle) const = 0;
};

/// What a curve over the turn is made of.
struct TurnParts {
  /// Of the machine's arguments and the angle: the kernel of a section.
  std::vector<std::shared_ptr<const optim::Kernel>> sections;
  /// Of the machine's arguments: the kernels of the two sections at each of their breaks, wherever
  /// it moves; empty where that does not matter.
  struct Joint {
    std::shared_ptr<const optim::Kernel> left, right;
  };
  std::vector<Joint> joints;
  /// Where sections meet, rad, for given arguments of the machine.
  std::function<std::vector<double>(std::span<const double>)> breaks;
  /// The formula for given arguments of the machine.
  std::function<std::unique_ptr<const TurnFormula>(std::span<const double>)> formula;
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
  std::unique_ptr<optim::Trace> trace(optim::Design x) const override;
  optim::Shape shape() const override { return shape_; }

 private:
  std::vector<double> arguments(optim::Design x) const;

  std::shared_ptr<const TurnParts> parts_;
  std::vector<std::size_t> variables_;  ///< behind the machine's arguments
  optim::Shape shape_;
};

}  // namespace camlaw::problems
