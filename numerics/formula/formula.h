// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "numerics/scalar/series.h"

/// Formulas as data: what is computed, as a list of steps, evaluated in any scalar.
namespace camlaw {

class Expression;
class FormulaRoots;

/// What a step does with the results of earlier ones.
enum class Operation : std::uint8_t {
  Input,
  Constant,
  Pi,
  Add,
  Subtract,
  Multiply,
  Divide,
  Negate,
  Sqrt,
  Sin,
  Cos,
  Tan,
  Asin,
  Atan,
  Log,
  Exp,
  Power,  ///< a to the power of b, a plain constant
  Absolute,
  Greater,
  Lesser,
  BySide,         ///< by_side(a, b, c)
  Along,          ///< along(a, b)
  WherePositive,  ///< where_positive(a, b)
  UnlessZero,     ///< unless_zero(a, b)
  Unknown,        ///< a place between a and b that the root with the number c tries
  Root,           ///< the root of b in the unknown a; of several the one where c is highest
};

struct Step {
  Operation operation;
  /// Earlier steps. Of an input a is its number, of an unknown c.
  std::uint32_t a = 0, b = 0, c = 0;
  double value = 0, lower = 0, upper = 0;  ///< of a constant, and what it is proved to lie between
  friend bool operator==(const Step&, const Step&) = default;
};

/// A function of some inputs. A copy shares the steps.
class Formula {
 public:
  /// Calls `write` with an expression for each input; what it returns is the formula. Equal steps
  /// are written once.
  static Formula record(std::size_t inputs,
                        const std::function<Expression(std::span<const Expression>)>& write);

  std::size_t inputs() const;
  const std::vector<Step>& steps() const;
  /// The inputs that the value depends on, increasing.
  const std::vector<std::size_t>& uses() const;
  bool depends_on(std::size_t input) const;
  const FormulaRoots& roots() const;

  /// The value at u, which has a number for each input that the value depends on; in double, Dual,
  /// Dual2, Interval, or Series of Interval with 1 or 2 terms.
  template <class T>
  T operator()(std::span<const T> u) const;

 private:
  struct Data;
  explicit Formula(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
  std::shared_ptr<const Data> data_;
};

/// A formula with its first inputs fixed as plain numbers, as a machine stays while its motion
/// runs. The others are series over T, which is double with N 3, or Interval with N up to 3 or 7;
/// or numbers of the same kind, in Dual and Dual2 too.
template <class T>
class FormulaAlong {
 public:
  FormulaAlong(const Formula& formula, std::span<const T> first);

  /// With the others plain too.
  T operator()(std::span<const T> others) const;
  template <std::size_t N>
  Series<T, N> operator()(std::span<const Series<T, N>> others) const;

 private:
  /// A step that one of the others reaches.
  struct Moving {
    Operation operation;
    std::array<std::uint32_t, 3> from;  ///< earlier steps; of an input its number
    std::array<bool, 3> moves;          ///< of the earlier steps that it uses
    bool all_move;                      ///< whether each of those does
    std::uint32_t result;
  };

  Formula formula_;
  std::vector<bool> moves_;
  std::vector<T> still_;  ///< results of the other steps
  std::vector<Moving> moving_;
};

}  // namespace camlaw
