// SPDX-License-Identifier: MIT
#include "machines/model/shape_rules.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "numerics/formula/operations.h"
#include "numerics/formula/steps.h"

namespace camlaw::problems {
namespace {

using optim::Shape;

/// What a function is in the design's variables. Quasiconvex: every set {f <= c} is convex. Where
/// one variable alone varies: whether the function rises or falls with it, not strictly. Any of
/// these says too that the set where the function has a value is convex.
struct Curvature {
  bool convex = false, concave = false, quasiconvex = false, quasiconcave = false;
  bool rises = false, falls = false;

  bool is_linear() const { return convex && concave; }
  bool is_monotone() const { return rises || falls; }
  bool is_quasilinear() const { return (quasiconvex && quasiconcave) || is_monotone(); }
  /// Whether every set {f <= c} ({f >= c}) is convex.
  bool convex_below() const { return quasiconvex || is_monotone(); }
  bool convex_above() const { return quasiconcave || is_monotone(); }
};
constexpr Curvature kLinearShape{true, true, true, true};

/// What is known of a step's result. A constant has every curvature.
struct Ruled : Curvature {
  bool is_constant = false;
  Interval range;
  bool is_sum_of_squares = false;  ///< of linear functions; constants of 0 or above count

  bool is_not_negative() const { return range.lower() >= 0; }
  bool is_not_positive() const { return range.upper() <= 0; }
  bool is_positive() const { return range.lower() > 0; }
  bool is_negative() const { return range.upper() < 0; }
};

Curvature mirrored(const Curvature& a) {
  return {a.concave, a.convex, a.quasiconcave, a.quasiconvex, a.falls, a.rises};
}
Ruled negative(const Ruled& a) { return {mirrored(a), a.is_constant, -a.range}; }

Curvature sum(const Ruled& a, const Ruled& b) {
  if (a.is_constant) return b;
  if (b.is_constant) return a;
  const bool below = a.convex && b.convex, above = a.concave && b.concave;
  return {below, above, below, above, a.rises && b.rises, a.falls && b.falls};
}

/// Of a constant factor of either sign, or its reciprocal: at a place it has one of them.
Curvature scaled_by_unknown(const Curvature& a) {
  return {a.is_linear(), a.is_linear(), a.is_quasilinear(), a.is_quasilinear()};
}

/// Of a constant factor and another.
Curvature scaled(const Ruled& factor, const Ruled& a) {
  if (factor.is_not_negative()) return a;
  if (factor.is_not_positive()) return mirrored(a);
  return scaled_by_unknown(a);
}

Curvature product(const Ruled& a, const Ruled& b) {
  if (a.is_constant) return scaled(a, b);
  if (b.is_constant) return scaled(b, a);
  if (!a.is_not_negative() || !b.is_not_negative()) return {};
  return {false, false, false, a.concave && b.concave, a.rises && b.rises, a.falls && b.falls};
}

/// Whether a step gives a sum of squares of linear functions, whose root is a norm.
bool gives_sum_of_squares(Operation operation, bool same, const Ruled& a, const Ruled& b) {
  const auto counts = [](const Ruled& x) {
    return x.is_constant ? x.is_not_negative() : x.is_sum_of_squares;
  };
  switch (operation) {
    case Operation::Add:
      return counts(a) && counts(b);
    case Operation::Multiply:
      return same ? a.is_linear() : (a.is_constant || b.is_constant) && counts(a) && counts(b);
    case Operation::Divide:
      return b.is_constant && b.is_positive() && counts(a);
    case Operation::Power:
      return a.is_linear() && value_of(b.range) == 2;
    default:
      return false;
  }
}

/// The root. A norm of linear functions is convex.
Curvature root_of(const Ruled& a, const Curvature& increasing) {
  Curvature result = increasing;
  result.convex |= a.is_sum_of_squares;
  result.quasiconvex |= a.is_sum_of_squares;
  return result;
}

/// An increasing function of a. It keeps quasiconvex and quasiconcave; `is_convex` and `is_concave`
/// say what it is itself.
Curvature increasing(const Curvature& a, bool is_convex, bool is_concave) {
  return {is_convex && a.convex,
          is_concave && a.concave,
          a.quasiconvex,
          a.quasiconcave,
          a.rises,
          a.falls};
}

/// A function that has a value where a is 0 or above. That set is convex where a is quasiconcave.
Curvature from_zero_on(const Ruled& a, const Curvature& result) {
  return a.is_not_negative() || a.convex_above() ? result : Curvature{};
}

/// The arcsine, which has a value where a is within -1 and 1.
Curvature arcsine(const Ruled& a) {
  const bool inside = a.range.lower() >= -1 && a.range.upper() <= 1;
  return inside || a.is_quasilinear() ? increasing(a, false, false) : Curvature{};
}

/// The tangent increases between plus and minus a right angle; from 0 on it is convex.
Curvature tangent(const Ruled& a) {
  const double right = (pi<Interval>() / Interval(2.0)).lower();
  if (a.range.lower() <= -right || a.range.upper() >= right) return {};
  return increasing(a, a.is_not_negative(), a.is_not_positive());
}

/// a where it is positive.
Ruled where_positive(const Ruled& a) {
  const double least = std::numeric_limits<double>::min(), most = std::max(least, a.range.upper());
  const Interval range(std::max(least, a.range.lower()), most);
  const Curvature own = a;
  return {a.is_positive() || a.convex_above() ? own : Curvature{}, a.is_constant, range};
}

/// 1 / b of one sign: it decreases; of a positive b it is convex, of a negative one concave.
Ruled reciprocal(const Ruled& b) {
  Ruled result{Curvature{}, b.is_constant, quotient(Interval(1.0), b.range)};
  const Curvature opposite = mirrored(b);
  if (b.is_positive()) static_cast<Curvature&>(result) = increasing(opposite, true, false);
  if (b.is_negative()) static_cast<Curvature&>(result) = increasing(opposite, false, true);
  if (b.is_constant) static_cast<Curvature&>(result) = kLinearShape;
  return result;
}

Curvature ratio(const Ruled& a, const Ruled& b) {
  if (b.is_negative()) return ratio(negative(a), negative(b));
  if (!b.is_positive()) return b.is_constant ? scaled_by_unknown(a) : Curvature{};
  if (a.is_constant || b.is_constant) {
    const Ruled divisor = reciprocal(b);
    return a.is_constant ? scaled(a, divisor) : scaled(divisor, a);
  }
  const bool below =
      a.convex && (a.is_not_negative() ? b.concave : a.is_not_positive() && b.convex);
  const bool above =
      a.concave && (a.is_not_negative() ? b.convex : a.is_not_positive() && b.concave);
  const bool both_linear = a.is_linear() && b.is_linear();
  return {false, false, both_linear || below, both_linear || above};
}

Curvature size_of(const Ruled& a) {
  if (a.is_not_negative()) return a;
  if (a.is_not_positive()) return mirrored(a);
  return {a.is_linear(), false, a.is_quasilinear(), false};
}

Curvature powered(const Ruled& a, double p) {
  const bool is_integer = is_integer_exponent(p);
  if (p < 0) return a.is_positive() ? increasing(mirrored(a), true, false) : Curvature{};
  if (a.is_not_negative()) return increasing(a, p >= 1, p <= 1);
  if (!is_integer) return from_zero_on(a, increasing(a, p >= 1 && a.is_linear(), p <= 1));
  if (std::fmod(p, 2) == 0) return increasing(size_of(a), true, false);
  return increasing(a, false, a.is_not_positive());
}

Curvature greatest(const Curvature& a, const Curvature& b) {
  return {
      a.convex && b.convex, false, a.convex_below() && b.convex_below(), false, a.rises && b.rises,
      a.falls && b.falls};
}
Curvature least(const Curvature& a, const Curvature& b) {
  return mirrored(greatest(mirrored(a), mirrored(b)));
}

/// Of one or the other.
Curvature common(const Curvature& a, const Curvature& b) {
  return {a.convex && b.convex,
          a.concave && b.concave,
          a.convex_below() && b.convex_below(),
          a.convex_above() && b.convex_above(),
          a.rises && b.rises,
          a.falls && b.falls};
}

Shape shape_of(const Curvature& a) {
  if (a.is_linear()) return Shape::Linear;
  if (a.quasiconvex && a.quasiconcave) return Shape::Quasilinear;
  if (a.convex) return Shape::Convex;
  if (a.concave) return Shape::Concave;
  if (a.is_monotone()) return Shape::Quasilinear;
  if (a.quasiconvex) return Shape::Quasiconvex;
  return a.quasiconcave ? Shape::Quasiconcave : Shape::General;
}

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
    if (boost::numeric::empty(range)) range = Interval::whole();
    const std::size_t used = operands(step.operation);
    const bool is_constant =
        a.is_constant && (used < 2 || b.is_constant) && (used < 3 || c.is_constant);
    return {is_constant ? kLinearShape : curvature(step, a, b, c), is_constant, range,
            !is_constant && gives_sum_of_squares(step.operation, step.a == step.b, a, b)};
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
        return step.a == step.b ? powered(a, 2) : product(a, b);
      case Operation::Divide:
        return ratio(a, b);
      case Operation::Sqrt:
        return root_of(a, from_zero_on(a, increasing(a, false, true)));
      case Operation::Log:  // at 0 it is infinite, and the set above need not be convex
        return a.is_positive() || a.convex_above() ? increasing(a, false, true) : Curvature{};
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
