// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <utility>

#include "kinematics/law.h"
#include "machines/model/possibility.h"
#include "numerics/formula/formula.h"
#include "numerics/formula/plain_values.h"

/// Machines in plain numbers: what their formulas come to for the values of one design.
namespace camlaw::testing {

/// A test has one before it makes its machines, and asks plain() for their numbers.
class PlainNumbers {
 public:
  PlainNumbers() : before_(std::exchange(current(), &values_)) {}
  ~PlainNumbers() { current() = before_; }
  PlainNumbers(const PlainNumbers&) = delete;
  PlainNumbers& operator=(const PlainNumbers&) = delete;

  static PlainValues*& current() {
    thread_local PlainValues* values = nullptr;
    return values;
  }

 private:
  PlainValues values_;
  PlainValues* before_;
};

inline double plain(const Expression& x) { return (*PlainNumbers::current())(x); }
inline std::pair<double, double> plain(const std::pair<Expression, Expression>& p) {
  return {plain(p.first), plain(p.second)};
}

/// A motion as a machine's formulas take it.
inline Motion<Expression> written(const Motion<double>& m) { return {m.s, m.v, m.a, m.j}; }

/// Whether all conditions of a machine hold.
template <class Machine>
bool is_possible(const Machine& machine) {
  for (const Condition& condition : machine.conditions()) {
    if (!margin_holds(plain(condition.margin), condition.may_be_zero)) return false;
  }
  return true;
}

/// The value of a formula of one number, and two derivatives, by the record's own series.
inline std::array<double, 3> plain_derivatives(
    const std::function<Expression(const Expression&)>& formula, double at) {
  const Formula record =
      Formula::record(1, [&](std::span<const Expression> x) { return formula(x[0]); });
  const FormulaAlong<double> along(record, std::span<const double>());
  const Series<double, 3> x = Series<double, 3>::variable(at, 1);
  const Series<double, 3> series = along(std::span<const Series<double, 3>>(&x, 1));
  return {series.c[0], series.c[1], 2 * series.c[2]};
}

}  // namespace camlaw::testing
