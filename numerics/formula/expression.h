// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstdint>
#include <functional>

#include "numerics/formula/formula.h"
#include "numerics/scalar/scalar.h"

/// The scalar that formulas are recorded with. A formula of expressions, called once, writes down
/// what it computes (docs/theory.md, "Recorded formulas").
namespace camlaw {

/// A number of the formula that is being recorded on this thread, and of no other formula. It has
/// no value: a formula that decides by one does not compile, and says by_side, along, absolute or
/// where_positive instead.
///
/// Whole numbers stand in a formula as they are, 2 * x. A fraction does not, as the double that is
/// nearest to it may be another number: ratio(815, 1000) has bounds that hold the fraction, and
/// Expression(0.5) is the double itself.
class Expression {
 public:
  /// The number 0.
  Expression() : Expression(0.0) {}
  Expression(double constant);  // NOLINT: formulas mix plain numbers with their scalar
  /// A constant that is proved to lie between two numbers.
  Expression(double constant, double lower, double upper);

  /// Its step.
  std::uint32_t step() const { return step_; }
  bool is_finite_constant() const;
  /// Whether it is this plain number, whatever the inputs are.
  bool is(double c) const;
  /// Of a constant 1 where it is 0 or above and -1 where it is below; 0 of what is neither.
  int constant_side() const;

  /// The result of a step that is written into the formula being recorded.
  static Expression of(const Step& step);

 private:
  std::uint32_t step_;
};

Expression operator+(const Expression& a, const Expression& b);
Expression operator-(const Expression& a, const Expression& b);
Expression operator*(const Expression& a, const Expression& b);
Expression operator/(const Expression& a, const Expression& b);
Expression operator-(const Expression& a);
template <std::floating_point F>
Expression operator+(F, const Expression&) = delete;
template <std::floating_point F>
Expression operator+(const Expression&, F) = delete;
template <std::floating_point F>
Expression operator-(F, const Expression&) = delete;
template <std::floating_point F>
Expression operator-(const Expression&, F) = delete;
template <std::floating_point F>
Expression operator*(F, const Expression&) = delete;
template <std::floating_point F>
Expression operator*(const Expression&, F) = delete;
template <std::floating_point F>
Expression operator/(F, const Expression&) = delete;
template <std::floating_point F>
Expression operator/(const Expression&, F) = delete;
/// The number pi, and the fraction p / q of two plain numbers: one constant, with bounds that hold
/// the fraction where it is no double.
Expression pi();
Expression ratio(double p, double q);
Expression sqrt(const Expression& a);
Expression sin(const Expression& a);
Expression cos(const Expression& a);
Expression tan(const Expression& a);
Expression asin(const Expression& a);
Expression atan(const Expression& a);
Expression log(const Expression& a);
Expression exp(const Expression& a);
/// numerics/scalar/power.h
Expression power(const Expression& a, double p);
Expression absolute(const Expression& a);
/// numerics/scalar/extremes.h
Expression greater_of(const Expression& a, const Expression& b);
Expression lesser_of(const Expression& a, const Expression& b);
/// numerics/scalar/by_side.h
Expression by_side(const Expression& force, const Expression& pushing, const Expression& pulling);
Expression along(const Expression& direction, const Expression& x);
Expression where_positive(const Expression& condition, const Expression& x);
Expression unless_zero(const Expression& force, const Expression& x);
Expression root_of_squares(const Expression& sum);
/// numerics/scalar/root.h. A level that is a constant has the first of several roots.
Expression root_of(const Expression& low, const Expression& high,
                   const std::function<Expression(const Expression&)>& f,
                   const std::function<Expression(const Expression&)>& level);

template <>
struct ScalarTraits<Expression> {
  static Expression number(double x) { return {x}; }
  static Expression pi() { return camlaw::pi(); }
  static bool is_number(const Expression& x, double c) { return x.is(c); }
};

}  // namespace camlaw
