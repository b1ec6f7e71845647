// SPDX-License-Identifier: MIT
#include "machines/model/shape_rules.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "machines/model/curvature.h"
#include "numerics/formula/operations.h"
#include "numerics/formula/steps.h"

namespace camlaw::problems {
namespace {

using optim::Shape;

class Rules {
 public:
  /// `one` says that one input alone varies, and linearly: it rises.
  Rules(const Formula& formula, std::span<const RuledInput> inputs, bool one)
      : steps_(formula.steps()), inputs_(inputs), one_(one) {}

  Shape operator()() {
    for (const Step& step : steps_) ruled_.push_back(ruled_of(step));
    return shape_of(ruled_.back());
  }

  /// Whether the ranges show that the formula has a value everywhere.
  bool is_defined() const {
    return std::all_of(steps_.begin(), steps_.end(),
                       [&](const Step& step) { return is_defined(step); });
  }

 private:
  bool is_defined(const Step& step) const {
    if (operands(step.operation) == 0) return true;
    const Ruled& a = ruled_[step.a];
    switch (step.operation) {
      case Operation::Divide:
        return ruled_[step.b].is_positive() || ruled_[step.b].is_negative();
      case Operation::Sqrt:
        return a.is_not_negative();
      case Operation::Log:
      case Operation::WherePositive:
        return a.is_positive();
      case Operation::Asin:
        return a.range.lower() >= -1 && a.range.upper() <= 1;
      case Operation::Power:
        return a.is_positive() || (is_integer_exponent(value_of(ruled_[step.b].range)) &&
                                   value_of(ruled_[step.b].range) >= 0);
      case Operation::Root:
        return false;
      case Operation::Tan:  // over a pole it is not bounded
        return std::isfinite(magnitude(tan(a.range)));
      default:
        return true;
    }
  }

  Ruled ruled_of(const Step& step) const {
    if (step.operation == Operation::Input) {
      const RuledInput& input = inputs_[step.a];
      Curvature own = input.varies == Varies::Otherwise ? Curvature{} : kLinearShape;
      own.rises = one_ && input.varies == Varies::Linearly;
      return {own, input.varies == Varies::Not, input.range};
    }
    if (step.operation == Operation::Constant) {
      return {kLinearShape, true, Interval(step.lower, step.upper)};
    }
    if (step.operation == Operation::Pi) return {kLinearShape, true, pi<Interval>()};
    const Ruled &a = ruled_[step.a], &b = ruled_[step.b], &c = ruled_[step.c];
    if (step.operation == Operation::WherePositive && step.a == step.b) return where_positive(a);
    Interval range = step.operation == Operation::Unknown
                         ? boost::numeric::hull(a.range, b.range)
                         : operate<Interval>(step.operation, a.range, b.range, c.range);
    const bool has_value = !boost::numeric::empty(range) && !is_infinite(step.operation, a, b);
    if (!has_value) range = Interval::whole();
    const std::size_t used = operands(step.operation);
    const bool is_constant =
        a.is_constant && (used < 2 || b.is_constant) && (used < 3 || c.is_constant);
    if (is_constant && !has_value) return {Curvature{}, false, range};
    Curvature own = is_constant ? kLinearShape : curvature(step, a, b, c);
    const bool is_log_convex = !is_constant && gives_log_convex(step.operation, a, b);
    own.convex |= is_log_convex;
    own.quasiconvex |= is_log_convex;
    return {own, is_constant, range,
            !is_constant && gives_sum_of_squares(step.operation, step.a == step.b, a, b),
            is_log_convex};
  }

  /// Whether an operation has a pole where its operands are.
  static bool is_infinite(Operation operation, const Ruled& a, const Ruled& b) {
    return (operation == Operation::Divide && b.is_zero()) ||
           (operation == Operation::Log && a.is_zero()) ||
           (operation == Operation::Power && a.is_zero() && b.is_negative());
  }

  /// Of two factors. x log(x / y) of linear x and y > 0 is convex, x log(y / x) concave.
  Curvature of_factors(const Step& step, const Ruled& a, const Ruled& b) const {
    Curvature result = product(a, b);
    for (const auto& [x, other] : {std::pair(step.a, step.b), std::pair(step.b, step.a)}) {
      if (steps_[other].operation != Operation::Log || !ruled_[x].is_linear()) continue;
      const std::size_t inside = steps_[other].a;
      const Step& divided = steps_[inside];
      const auto is_ratio = [&](std::size_t above, std::size_t below, std::size_t y) {
        return divided.operation == Operation::Divide && divided.a == above && divided.b == below &&
               ruled_[y].is_linear() && ruled_[y].is_positive();
      };
      const bool is_convex = inside == x || is_ratio(x, divided.b, divided.b);
      const bool is_concave = is_ratio(divided.a, x, divided.a);
      result.convex |= is_convex, result.quasiconvex |= is_convex;
      result.concave |= is_concave, result.quasiconcave |= is_concave;
    }
    return result;
  }

  Curvature curvature(const Step& step, const Ruled& a, const Ruled& b, const Ruled& c) const {
    switch (step.operation) {
      case Operation::Add:
        return sum(a, b);
      case Operation::Subtract:
        return sum(a, negative(b));
      case Operation::Negate:
        return mirrored(a);
      case Operation::Multiply:
        return step.a == step.b ? powered(a, 2) : of_factors(step, a, b);
      case Operation::Divide:
        return ratio(a, b);
      case Operation::Sqrt:
        return root_of(a);
      case Operation::Log:
        return logarithm(a);
      case Operation::Exp:
        return increasing(a, true, false);
      case Operation::Atan:
        return increasing(a, false, false);
      case Operation::Tan:
        return tangent(a);
      case Operation::Asin:
        return arcsine(a);
      case Operation::Power:
        return powered(a, value_of(b.range));
      case Operation::Absolute:
        return size_of(a);
      case Operation::Greater:
        return greatest(a, b);
      case Operation::Lesser:
        return least(a, b);
      case Operation::BySide:
        return a.is_constant ? common(b, c) : Curvature{};
      default:
        return {};
    }
  }

  const std::vector<Step>& steps_;
  std::span<const RuledInput> inputs_;
  bool one_;
  std::vector<Ruled> ruled_;
};

/// The shape of a function of one input, which has a value everywhere, by what encloses its slope
/// and its second derivative all over its range. It is continuous where its value is enclosed.
Shape enclosed_shape(const Formula& formula, std::span<const RuledInput> inputs,
                     std::size_t varying) {
  std::vector<Series<Interval, 3>> at;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    at.push_back(
        Series<Interval, 3>::variable(inputs[i].range, Interval(i == varying ? 1.0 : 0.0)));
  }
  const auto [value, slope, bend] = formula(std::span<const Series<Interval, 3>>(at)).c;
  if (!std::isfinite(value.lower()) || !std::isfinite(value.upper())) return Shape::General;
  const bool is_convex = bend.lower() >= 0, is_concave = bend.upper() <= 0;
  if (is_convex && is_concave) return Shape::Linear;
  if (slope.lower() >= 0 || slope.upper() <= 0) return Shape::Quasilinear;
  return is_convex ? Shape::Convex : is_concave ? Shape::Concave : Shape::General;
}

/// The inputs that vary of a formula; none where one of them does not vary linearly.
std::vector<std::size_t> linear_inputs(const Formula& formula, std::span<const RuledInput> inputs) {
  std::vector<std::size_t> varying;
  for (const std::size_t i : formula.uses()) {
    if (inputs[i].varies == Varies::Otherwise) return {};
    if (inputs[i].varies == Varies::Linearly) varying.push_back(i);
  }
  return varying;
}

}  // namespace

RuledShape shape_by_rules(const Formula& formula, std::span<const RuledInput> inputs) {
  const std::vector<std::size_t> varying = linear_inputs(formula, inputs);
  Rules rules(formula, inputs, varying.size() == 1);
  const Shape ruled = rules();
  const bool is_weak =
      ruled == Shape::General || ruled == Shape::Quasiconvex || ruled == Shape::Quasiconcave;
  if (!is_weak || varying.size() != 1 || !rules.is_defined()) return {ruled};
  const Shape enclosed = enclosed_shape(formula, inputs, varying.front());
  return enclosed == Shape::General ? RuledShape{ruled} : RuledShape{enclosed, true};
}

}  // namespace camlaw::problems
