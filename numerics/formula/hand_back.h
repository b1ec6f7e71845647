// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "numerics/formula/formula.h"
#include "numerics/scalar/dual.h"
#include "numerics/scalar/power.h"

/// How a step hands the slopes that it is owed back to its operands (docs/theory.md, (RF1)).
namespace camlaw {

/// A step that an input reaches.
struct BackStep {
  Operation operation;
  std::uint32_t result;
  std::uint32_t a, b, c;  ///< as of Step
  /// Of a sine the cosine of the same angle, and the other way round, where the formula has it;
  /// else the step itself.
  std::uint32_t partner;
};

/// The i-th of some steps.
BackStep back_step(const std::vector<Step>& steps, std::uint32_t i);

/// Whether an operation hands all of what it is owed to one of its operands.
bool is_choice(Operation operation);

/// The operand that a choice hands to, and with which sign; 0 where to none.
struct HandedTo {
  std::uint32_t step;
  double sign;
};

/// Of the operands' plain numbers.
inline HandedTo chosen(const BackStep& step, double a, double b) {
  switch (step.operation) {
    case Operation::Greater:
      return {std::isnan(b) || a < b ? step.b : step.a, 1};
    case Operation::Lesser:
      return {std::isnan(b) || a > b ? step.b : step.a, 1};
    case Operation::BySide:
      return {a < 0 ? step.c : step.b, 1};
    case Operation::Along:
      if (a == 0) return {step.b, 0};
      return {step.b, (a < 0) == (b < 0) ? 1.0 : -1.0};
    case Operation::UnlessZero:
      return {step.b, a == 0 ? 0.0 : 1.0};
    default:  // where_positive
      return {step.b, 1};
  }
}

/// The slope p x^(p - 1) of a power; none where it vanishes for every x.
template <class T>
T power_slope(const T& x, double p) {
  return p == 0 ? number<T>(0) : number<T>(p) * power(x, p - 1);
}

/// Adds what a step's operands owe to its result to what is owed to them, and marks them.
template <class T>
void hand_back(const BackStep& step, const T* results, T* owed, bool* handed);

// ---------------------------------------------------------------------------------------------

template <class T>
void hand_back(const BackStep& step, const T* results, T* owed, bool* handed) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  const T& due = owed[step.result];
  const T &a = results[step.a], &b = results[step.b], &own = results[step.result];
  if (is_choice(step.operation)) {
    const HandedTo to = chosen(step, value_of(a), value_of(b));
    if (to.sign == 0) return;
    owed[to.step] = to.sign < 0 ? owed[to.step] - due : owed[to.step] + due;
    handed[to.step] = true;
    return;
  }
  T &to_a = owed[step.a], &to_b = owed[step.b];
  const T one = number<T>(1);
  const auto mark = [&](bool both) {
    handed[step.a] = true;
    if (both) handed[step.b] = true;
  };
  switch (step.operation) {
    case Operation::Add:
      to_a = to_a + due;
      to_b = to_b + due;
      return mark(true);
    case Operation::Subtract:
      to_a = to_a + due;
      to_b = to_b - due;
      return mark(true);
    case Operation::Multiply:
      to_a = to_a + due * b;
      to_b = to_b + due * a;
      return mark(true);
    case Operation::Divide: {
      const T part = due / b;
      to_a = to_a + part;
      to_b = to_b - part * own;
      return mark(true);
    }
    case Operation::Negate:
      to_a = to_a - due;
      return mark(false);
    case Operation::Sqrt:
      to_a = to_a + due / (own + own);
      return mark(false);
    case Operation::Sin:
      to_a = to_a + due * (step.partner == step.result ? T(cos(a)) : results[step.partner]);
      return mark(false);
    case Operation::Cos:
      to_a = to_a - due * (step.partner == step.result ? T(sin(a)) : results[step.partner]);
      return mark(false);
    case Operation::Tan:
      to_a = to_a + due * (one + own * own);
      return mark(false);
    case Operation::Asin:
      to_a = to_a + due / sqrt((one - a) * (one + a));
      return mark(false);
    case Operation::Atan:
      to_a = to_a + due / (one + a * a);
      return mark(false);
    case Operation::Log:
      to_a = to_a + due / a;
      return mark(false);
    case Operation::Exp:
      to_a = to_a + due * own;
      return mark(false);
    case Operation::Power:
      to_a = to_a + due * power_slope(a, value_of(b));
      return mark(false);
    case Operation::Absolute:
      to_a = value_of(a) < 0 ? to_a - due : to_a + due;
      return mark(false);
    default:  // what has no operands, and roots, which are not handed back
      return;
  }
}

}  // namespace camlaw
