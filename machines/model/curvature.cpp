// SPDX-License-Identifier: MIT
#include "machines/model/curvature.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace camlaw::problems {

using optim::Shape;

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

namespace {
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
}  // namespace

Curvature product(const Ruled& a, const Ruled& b) {
  if (a.is_constant) return scaled(a, b);
  if (b.is_constant) return scaled(b, a);
  if (!a.is_not_negative() || !b.is_not_negative()) return {};
  const bool rises = a.rises && b.rises, falls = a.falls && b.falls;
  const bool is_convex = a.convex && b.convex && (rises || falls);
  return {is_convex, false, is_convex, a.concave && b.concave, rises, falls};
}

bool gives_sum_of_squares(Operation operation, bool same, const Ruled& a, const Ruled& b) {
  const auto counts = [](const Ruled& x) {
    return x.is_constant ? x.is_not_negative() : x.is_sum_of_squares;
  };
  const bool may_be_squared = a.is_linear() || (a.convex && a.is_not_negative());
  switch (operation) {
    case Operation::Add:
      return counts(a) && counts(b);
    case Operation::Multiply:
      return same ? may_be_squared : (a.is_constant || b.is_constant) && counts(a) && counts(b);
    case Operation::Divide:
      return b.is_constant && b.is_positive() && counts(a);
    case Operation::Power:
      return may_be_squared && value_of(b.range) == 2;
    default:
      return false;
  }
}

bool gives_log_convex(Operation operation, const Ruled& a, const Ruled& b) {
  const auto counts = [](const Ruled& x) {
    return x.is_constant ? x.is_positive() : x.is_log_convex;
  };
  switch (operation) {
    case Operation::Exp:
      return a.convex;
    case Operation::Add:
    case Operation::Multiply:
      return counts(a) && counts(b);
    case Operation::Divide:
      return counts(a) && b.concave && b.is_positive();
    case Operation::Sqrt:
      return counts(a);
    case Operation::Power:
      return value_of(b.range) > 0 ? counts(a) : a.concave && a.is_positive();
    default:
      return false;
  }
}

Curvature increasing(const Curvature& a, bool is_convex, bool is_concave) {
  return {is_convex && a.convex,
          is_concave && a.concave,
          a.quasiconvex,
          a.quasiconcave,
          a.rises,
          a.falls};
}

namespace {
/// A function that has a value where a is 0 or above. That set is convex where a is quasiconcave.
Curvature from_zero_on(const Ruled& a, const Curvature& result) {
  return a.is_not_negative() || a.convex_above() ? result : Curvature{};
}
}  // namespace

Curvature root_of(const Ruled& a) {
  Curvature result = from_zero_on(a, increasing(a, false, true));
  result.convex |= a.is_sum_of_squares;
  result.quasiconvex |= a.is_sum_of_squares;
  return result;
}

Curvature logarithm(const Ruled& a) {
  // At 0 it is infinite, and the set above need not be convex.
  if (!a.is_positive() && !a.convex_above()) return {};
  Curvature result = increasing(a, false, true);
  result.convex |= a.is_log_convex;
  result.quasiconvex |= a.is_log_convex;
  return result;
}

Curvature arcsine(const Ruled& a) {
  const bool inside = a.range.lower() >= -1 && a.range.upper() <= 1;
  return inside || a.is_quasilinear() ? increasing(a, false, false) : Curvature{};
}

Curvature tangent(const Ruled& a) {
  const double right = (pi<Interval>() / Interval(2.0)).lower();
  if (a.range.lower() <= -right || a.range.upper() >= right) return {};
  return increasing(a, a.is_not_negative(), a.is_not_positive());
}

Ruled where_positive(const Ruled& a) {
  const double least = std::numeric_limits<double>::min(), most = std::max(least, a.range.upper());
  const Interval range(std::max(least, a.range.lower()), most);
  const Curvature own = a;
  return {a.is_positive() || a.convex_above() ? own : Curvature{}, a.is_constant, range};
}

namespace {
/// 1 / b of one sign: it decreases; of a positive b it is convex, of a negative one concave.
Ruled reciprocal(const Ruled& b) {
  Ruled result{Curvature{}, b.is_constant, quotient(Interval(1.0), b.range)};
  const Curvature opposite = mirrored(b);
  if (b.is_positive()) static_cast<Curvature&>(result) = increasing(opposite, true, false);
  if (b.is_negative()) static_cast<Curvature&>(result) = increasing(opposite, false, true);
  if (b.is_constant) static_cast<Curvature&>(result) = kLinearShape;
  return result;
}
}  // namespace

Curvature ratio(const Ruled& a, const Ruled& b) {
  if (b.is_negative()) return ratio(negative(a), negative(b));
  if (!b.is_positive()) {
    // What stays at a place has one sign there; over 0 itself there is no value.
    const bool has_value = b.is_constant && !b.is_zero();
    return has_value ? scaled_by_unknown(a) : Curvature{};
  }
  if (a.is_constant || b.is_constant) {
    const Ruled divisor = reciprocal(b);
    return a.is_constant ? scaled(a, divisor) : scaled(divisor, a);
  }
  const bool below =
      a.convex && (a.is_not_negative() ? b.concave : a.is_not_positive() && b.convex);
  const bool above =
      a.concave && (a.is_not_negative() ? b.convex : a.is_not_positive() && b.concave);
  const bool both_linear = a.is_linear() && b.is_linear();
  // A square of a convex function of 0 or above by a concave one, as of the perspective of x^2.
  const bool is_convex = a.is_sum_of_squares && b.concave;
  return {is_convex, false, is_convex || both_linear || below, both_linear || above};
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

Curvature common(const Curvature& a, const Curvature& b) {
  return {a.convex && b.convex,
          a.concave && b.concave,
          a.convex_below() && b.convex_below(),
          a.convex_above() && b.convex_above(),
          a.rises && b.rises,
          a.falls && b.falls};
}

optim::Shape shape_of(const Curvature& a) {
  if (a.is_linear()) return Shape::Linear;
  if (a.quasiconvex && a.quasiconcave) return Shape::Quasilinear;
  if (a.convex) return Shape::Convex;
  if (a.concave) return Shape::Concave;
  if (a.is_monotone()) return Shape::Quasilinear;
  if (a.quasiconvex) return Shape::Quasiconvex;
  return a.quasiconcave ? Shape::Quasiconcave : Shape::General;
}

}  // namespace camlaw::problems
