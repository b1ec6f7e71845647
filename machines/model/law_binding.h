// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "kinematics/laws/catalogue.h"
#include "numerics/scalar/dual.h"
#include "numerics/scalar/scalar.h"

namespace camlaw::problems {

/// A parameter of a law family that varies: which, which element of a list, and the design variable
/// behind it.
struct LawVariable {
  std::size_t parameter;
  std::size_t element = 0;
  std::size_t variable = 0;
};

/// s, v, a, j of a law at one x with their derivatives by the varying parameters.
struct MotionDerivatives {
  std::array<double, 4> value;
  std::vector<std::array<double, 4>> gradient;  ///< by each varying parameter
  std::vector<std::array<double, 4>> hessian;   ///< packed; empty where the law is linear
};

/// s, v, a, j of a law that is linear in what varies, at one x and at its own values, with the
/// derivatives by those varying parameters that move it there.
struct SparseMotion {
  struct Slope {
    std::size_t input;  ///< of the varying parameters, increasing
    std::array<double, 4> by;
  };
  std::array<double, 4> value;
  std::vector<Slope> slopes;
};

/// An end of a piece of a law.
struct PieceEnd {
  std::size_t piece;
  bool is_end;  ///< whether the piece ends there; else it begins there
};

struct BoundLaws;
struct LinearLaw;

/// A law whose parameters are design variables. Where the law is linear in all that vary, its
/// derivatives are worked out once; else by dual numbers at each design, the laws of the last few
/// designs kept. Const functions may be called in several threads at once.
class LawBinding {
 public:
  /// Throws std::invalid_argument where a parameter has no such element or no derivatives, and
  /// where the member is not a law.
  LawBinding(Member member, std::vector<LawVariable> variables);

  const Member& member() const { return member_; }
  const std::vector<LawVariable>& variables() const { return variables_; }
  /// Of several laws side by side the binding of each, in variables of the same design; none of one
  /// law. Whatever asks for a motion asks one of these.
  const std::vector<std::shared_ptr<const LawBinding>>& parts() const { return parts_; }
  /// Bytes that second derivatives take: a law for each pair of blocks of kDualWidth parameters, of
  /// each design that is kept. 0 where the law is linear.
  double memory() const;
  /// Whether the law is linear in everything that varies.
  bool is_linear() const { return linear_; }
  /// The varying parameters of a design, in the order of variables().
  std::vector<double> values_at(std::span<const double> design) const;
  /// The member at a design. Its law has the same pieces as the laws that carry derivatives: by
  /// them a joint is counted.
  Member member_at(std::span<const double> design) const {
    Member result = member_;
    result.arguments = arguments_of<double>(values_at(design));
    keep_pieces(result.arguments);
    return result;
  }
  template <class S>
  Possible<Law<S>> possible_law_at(std::span<const double> design) const {
    return member_at(design).template possible_law<S>();
  }
  /// The same; throws std::invalid_argument where the design makes no law.
  template <class S>
  Law<S> law_at(std::span<const double> design) const {
    return possible_law_at<S>(design).value();
  }
  /// The family's arguments for values of the varying parameters that carry derivatives of their
  /// own.
  template <class S>
  Arguments<S> arguments_of(std::span<const S> values) const {
    Arguments<S> arguments = member_.arguments.as<S>();
    for (std::size_t i = 0; i < variables_.size(); ++i) {
      arguments.values()[variables_[i].parameter][variables_[i].element] = values[i];
    }
    return arguments;
  }
  /// The law for such values.
  template <class S>
  Possible<Law<S>> possible_law_of(std::span<const S> values) const {
    Arguments<S> arguments = arguments_of(values);
    keep_pieces(arguments);
    return member_.family->possible(arguments);
  }
  /// The law with derivatives by the varying parameters, one for each kDualWidth of them; none
  /// where the values make no law.
  std::vector<Law<Dual>> first_laws(std::span<const double> values) const;
  /// Motion at x with derivatives, order 0, 1 or 2, at values of the varying parameters; at a break
  /// the limit from the given side. NaN where the values make no law.
  MotionDerivatives motion(double x, Side side, std::span<const double> values, int order) const;
  /// The same where a piece of the law meets the next one, from the given side, with the
  /// derivatives by what moves this joint. order 0, 1 or 2.
  MotionDerivatives joint_motion(std::size_t piece, Side side, std::span<const double> values,
                                 int order) const;
  /// The derivative of s of an order below kEndOrders at an end of a piece, in [0] of value,
  /// gradient and hessian; `derivatives` is 0, 1 or 2.
  MotionDerivatives end_derivative(PieceEnd end, std::size_t order, std::span<const double> values,
                                   int derivatives) const;
  /// Laws rest with the first few derivatives at 0; where all below this order vanish, the order of
  /// a rest counts as unknown.
  static constexpr std::size_t kEndOrders = 8;
  /// The x of an end of a piece, wherever that moves, in [0] of value, gradient and hessian.
  MotionDerivatives end_place(PieceEnd end, std::span<const double> values, int derivatives) const;
  /// Of a law that is linear in what varies.
  SparseMotion linear_motion_at(double x, Side side) const;
  /// The same over every x; null where the law is not linear in what varies, or nothing does.
  const LinearLaw* linear_law() const;
  /// v, a, j and the derivative of j: the motion's own derivatives by x, with theirs by the varying
  /// parameters, first order.
  MotionDerivatives motion_rate(double x, Side side, std::span<const double> values) const;

 private:
  /// Moves a varying parameter by a unit of the last place where two pieces of the law would join
  /// at its value.
  template <class S>
  void keep_pieces(Arguments<S>& arguments) const {
    for (const LawVariable& v : variables_) {
      const auto& joins = member_.family->parameters[v.parameter].joins_at;
      S& value = arguments.values()[v.parameter][v.element];
      if (!joins || !camlaw::is_number(value, *joins)) continue;
      value = camlaw::number<S>(std::nextafter(*joins, 1.0));
    }
  }

  template <class Look>
  MotionDerivatives seen(const Look& look, std::span<const double> values, int order) const;
  Member member_;
  std::vector<LawVariable> variables_;
  bool linear_;
  std::vector<double> values_;  ///< the member's own
  double second_bytes_ = 0;     ///< of the laws with second derivatives of one design
  std::shared_ptr<BoundLaws> laws_;
  std::vector<std::shared_ptr<const LawBinding>> parts_;
};

/// Of several laws side by side the one that moves a cam of that number; else the law itself.
std::shared_ptr<const LawBinding> law_of_cam(const std::shared_ptr<const LawBinding>& law,
                                             std::optional<std::size_t> cam);

}  // namespace camlaw::problems
