// SPDX-License-Identifier: MIT
#include "numerics/formula/expression.h"

#include <cmath>
#include <stdexcept>

namespace camlaw {
namespace {

Expression written(Operation operation, const Expression& a) {
  return Expression::of({.operation = operation, .a = a.step()});
}

Expression written(Operation operation, const Expression& a, const Expression& b) {
  return Expression::of({.operation = operation, .a = a.step(), .b = b.step()});
}

}  // namespace

// What is exact in every scalar is worked out at once: so a constant that removes a term, such as a
// friction of 0, removes the term's steps as well.
Expression operator+(const Expression& a, const Expression& b) {
  if (a.is(0)) return b;
  if (b.is(0)) return a;
  return written(Operation::Add, a, b);
}
Expression operator-(const Expression& a, const Expression& b) {
  return b.is(0) ? a : written(Operation::Subtract, a, b);
}
Expression operator*(const Expression& a, const Expression& b) {
  if (a.is(1)) return b;
  if (b.is(1)) return a;
  if ((a.is(0) && b.is_finite_constant()) || (b.is(0) && a.is_finite_constant())) return 0.0;
  return written(Operation::Multiply, a, b);
}
Expression operator/(const Expression& a, const Expression& b) {
  return b.is(1) ? a : written(Operation::Divide, a, b);
}
Expression operator-(const Expression& a) { return written(Operation::Negate, a); }
Expression sqrt(const Expression& a) { return written(Operation::Sqrt, a); }
Expression sin(const Expression& a) { return written(Operation::Sin, a); }
Expression cos(const Expression& a) { return written(Operation::Cos, a); }
Expression tan(const Expression& a) { return written(Operation::Tan, a); }
Expression asin(const Expression& a) { return written(Operation::Asin, a); }
Expression atan(const Expression& a) { return written(Operation::Atan, a); }
Expression log(const Expression& a) { return written(Operation::Log, a); }
Expression exp(const Expression& a) { return written(Operation::Exp, a); }
Expression power(const Expression& a, double p) {
  if (p == 0) return 1.0;
  return p == 1 ? a : written(Operation::Power, a, Expression(p));
}
Expression absolute(const Expression& a) { return written(Operation::Absolute, a); }
Expression greater_of(const Expression& a, const Expression& b) {
  return written(Operation::Greater, a, b);
}
Expression lesser_of(const Expression& a, const Expression& b) {
  return written(Operation::Lesser, a, b);
}
Expression by_side(const Expression& force, const Expression& pushing, const Expression& pulling) {
  if (const int side = force.constant_side()) return side < 0 ? pulling : pushing;
  return Expression::of({.operation = Operation::BySide,
                         .a = force.step(),
                         .b = pushing.step(),
                         .c = pulling.step()});
}
Expression along(const Expression& direction, const Expression& x) {
  return written(Operation::Along, direction, x);
}
Expression where_positive(const Expression& condition, const Expression& x) {
  return written(Operation::WherePositive, condition, x);
}
Expression unless_zero(const Expression& force, const Expression& x) {
  return written(Operation::UnlessZero, force, x);
}
Expression root_of_squares(const Expression& sum) { return unless_zero(sum, sqrt(sum)); }

Expression root_of(const Expression& low, const Expression& high,
                   const std::function<Expression(const Expression&)>& f,
                   const std::function<Expression(const Expression&)>& level) {
  thread_local std::uint32_t depth = 0;  // roots within roots have unknowns of their own
  struct Deeper {
    Deeper() { ++depth; }
    ~Deeper() { --depth; }
  };
  constexpr std::uint32_t kDeepest = 2;
  if (depth == kDeepest) throw std::invalid_argument("roots are nested more than 2 deep");
  const Expression unknown = Expression::of(
      {.operation = Operation::Unknown, .a = low.step(), .b = high.step(), .c = depth});
  const Deeper deeper;
  const Expression zero = f(unknown), its = level(unknown);
  return Expression::of(
      {.operation = Operation::Root, .a = unknown.step(), .b = zero.step(), .c = its.step()});
}

Expression pi() { return Expression::of({.operation = Operation::Pi}); }
Expression ratio(double p, double q) {
  const double share = p / q;
  if (std::fma(share, q, -p) == 0) return share;  // a double, such as 1/2
  const Interval bounds = quotient(Interval(p), Interval(q));
  return {share, bounds.lower(), bounds.upper()};
}

}  // namespace camlaw
