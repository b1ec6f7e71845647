// SPDX-License-Identifier: MIT
#pragma once

#include "numerics/formula/formula.h"
#include "numerics/scalar/by_side.h"
#include "numerics/scalar/dual.h"
#include "numerics/scalar/extremes.h"
#include "numerics/scalar/power.h"
#include "numerics/scalar/where_positive.h"

/// What each operation does in a scalar.
namespace camlaw {

constexpr bool is_arithmetic(Operation operation) {
  return operation == Operation::Add || operation == Operation::Subtract ||
         operation == Operation::Multiply || operation == Operation::Divide;
}

/// Arithmetic of a number that moves, X, with one that does not.
template <class X, class A, class B>
X arithmetic(Operation operation, const A& a, const B& b) {
  switch (operation) {
    case Operation::Add:
      return a + b;
    case Operation::Subtract:
      return a - b;
    case Operation::Multiply:
      return a * b;
    default:
      if constexpr (std::is_same_v<B, X>) {
        return X(a) / b;
      } else {
        return a / b;
      }
  }
}

template <class T>
T divided(const T& a, const T& b) {
  return a / b;
}
/// Of a divisor that is 0 nothing is known.
inline Interval divided(const Interval& a, const Interval& b) { return quotient(a, b); }

/// Applies an operation; operands that it does not need are ignored.
template <class T>
T operate(Operation operation, const T& a, const T& b, const T& c) {
  using std::asin;
  using std::atan;
  using std::cos;
  using std::exp;
  using std::log;
  using std::sin;
  using std::sqrt;
  using std::tan;
  switch (operation) {
    case Operation::Add:
      return a + b;
    case Operation::Subtract:
      return a - b;
    case Operation::Multiply:
      return a * b;
    case Operation::Divide:
      return divided(a, b);
    case Operation::Negate:
      return -a;
    case Operation::Sqrt:
      return unmoved(a, T(sqrt(a + number<T>(0))));  // the root of -0 would be -0
    case Operation::Sin:
      return sin(a);
    case Operation::Cos:
      return cos(a);
    case Operation::Tan:
      return tan(a);
    case Operation::Asin:
      return unmoved(a, T(asin(a)));
    case Operation::Atan:
      return atan(a);
    case Operation::Log:
      return unmoved(a, T(log(a)));
    case Operation::Exp:
      return exp(a);
    case Operation::Power:
      return power(a, value_of(b));
    case Operation::Absolute:
      return absolute(a);
    case Operation::Greater:
      return greater_of(a, b);
    case Operation::Lesser:
      return lesser_of(a, b);
    case Operation::BySide:
      return by_side(a, b, c);
    case Operation::Along:
      return along(a, b);
    case Operation::WherePositive:
      return where_positive(a, b);
    case Operation::UnlessZero:
      return unless_zero(a, b);
    case Operation::Pi:
      return pi<T>();
    case Operation::Input:
    case Operation::Constant:
    case Operation::Unknown:
    case Operation::Root:
      break;
  }
  return a;
}

}  // namespace camlaw
