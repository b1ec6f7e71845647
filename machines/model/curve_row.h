// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "machines/model/cycle.h"
#include "machines/model/law_binding.h"
#include "optim/problem/function.h"

namespace camlaw::problems {

/// The follower's motion from the law's, and its rate along x from that of the law's.
MotionDerivatives follower_motion(const Stretch& stretch, MotionDerivatives law);
MotionDerivatives follower_rate(const Stretch& stretch, MotionDerivatives law);

/// The follower's motion at one place of the cycle, as a function of the law's variables.
class PlaceMotion {
 public:
  /// `uses` tells which of s, v, a, j matter.
  PlaceMotion(std::shared_ptr<const LawBinding> law, const Cycle& cycle, const Stretch& stretch,
              const LawPlace& place, const std::array<bool, 4>& uses);
  /// Where a piece of the law meets the next one, wherever that is.
  PlaceMotion(std::shared_ptr<const LawBinding> law, const Cycle& cycle, std::size_t stretch,
              std::size_t piece, LawPlace side, const std::array<bool, 4>& uses);

  /// The law's variables that the motion here depends on: of a linear law only those whose
  /// derivatives are not all zero, such as the few coefficients of a spline.
  const std::vector<std::size_t>& variables() const { return variables_; }
  /// At values of these variables. Derivatives of what does not matter are 0.
  MotionDerivatives at(std::span<const double> values, int order) const;
  /// The place in the whole cycle, from 0 to 1, in [0] of value, gradient and hessian: it moves
  /// where the place is a joint.
  MotionDerivatives place_at(std::span<const double> values, int order) const;

  /// What the motion is over a box of these variables: numbers that s, v, a, j lie between, and
  /// their slopes, which a linear law has only.
  struct Range {
    std::array<Interval, 4> motion;
    std::vector<std::array<double, 4>> slopes;
    Interval x;  ///< the place in the whole cycle
  };
  /// None where the law is not linear in them, or its joint moves.
  std::optional<Range> range(std::span<const optim::Bounds> box) const;

 private:
  MotionDerivatives linear_at(std::span<const double> values) const;
  MotionDerivatives law_at(std::span<const double> values, int order) const;
  /// s and s' as one comes to the place from its side, where that is a rest (resting_velocity,
  /// resting_displacement).
  void come_from_within(MotionDerivatives& motion, std::span<const double> values) const;
  /// The follower's motion beside the place, on its side; none at an end of the law.
  std::optional<MotionDerivatives> beside(double distance, std::span<const double> values) const;

  std::shared_ptr<const LawBinding> law_;
  Stretch stretch_;
  Cycle::Part part_;
  LawPlace place_;
  std::array<bool, 4> uses_;
  std::optional<std::size_t> joint_ = {};  ///< the piece that ends there
  std::vector<std::size_t> variables_;
  std::vector<double> origin_;   ///< of a linear law: values at which ...
  MotionDerivatives expansion_;  ///< ... the motion here, and its derivatives everywhere, are these
};

/// A curve at one place. Arguments: the machine's that vary, then the law's variables that matter
/// here. `point` is the curve's formula in the machine's arguments, s, v, a, j, and x where
/// `uses_place`; derivatives by the law follow by the chain rule (docs/theory.md, "Curves over the
/// cycle").
class CurveRow final : public optim::Kernel {
 public:
  CurveRow(std::shared_ptr<const optim::Kernel> point, std::size_t machine_arguments,
           PlaceMotion motion, bool uses_place);

  double value(std::span<const double> u) const override;
  double gradient(std::span<const double> u, std::span<double> g) const override;
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override;
  optim::BoxRange range(std::span<const optim::Bounds> box) const override;

 private:
  /// s, v, a, j, and x where it counts, with their derivatives by the law's variables: a row for
  /// each of them.
  using Numbers = std::array<double, 5>;
  struct Point {
    Numbers value;
    std::vector<Numbers> gradient;  ///< by each variable of the law
    std::vector<Numbers> hessian;   ///< packed; empty where the law is linear
  };
  Point point(std::span<const double> values, int order) const;
  std::vector<double> point_at(std::span<const double> u, const Point& point) const;
  void chain_gradient(std::span<const double> inner, const Point& point, std::span<double> g) const;
  void chain_hessian(std::span<const double> inner, std::span<const double> inner_second,
                     const Point& point, std::span<double> h) const;

  std::shared_ptr<const optim::Kernel> point_;
  std::size_t machine_;
  PlaceMotion motion_;
  std::size_t numbers_;  ///< of a point: 4, or 5 with x
  std::size_t inner_;    ///< arguments of the point
  bool uses_place_;
};

}  // namespace camlaw::problems
