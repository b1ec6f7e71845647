// SPDX-License-Identifier: MIT
#pragma once

#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

#include "numerics/formula/unit_factor.h"

namespace camlaw {

/// A parameter of a machine, as people read and set it.
struct MachineParameter {
  const char *name, *symbol;  ///< "stroke", "S_f"
  const char* unit;           ///< the one it is listed in
  const char* stored;         ///< the one of the formulas, SI
  const char* meaning;
  double default_value, low, high;  ///< in the listed unit; low and high are accepted too
  bool integer = false;

  constexpr MachineParameter by_default(double value) const {
    MachineParameter other = *this;
    other.default_value = value;
    return other;
  }
  constexpr MachineParameter meaning_that(const char* words) const {
    MachineParameter other = *this;
    other.meaning = words;
    return other;
  }
  constexpr MachineParameter with_symbol(const char* letter) const {
    MachineParameter other = *this;
    other.symbol = letter;
    return other;
  }
};

/// What a machine is made of: the value of each parameter, which a machine asks for where it
/// declares the field that holds it,
///   Given given = {};
///   Expression stroke = given({"stroke", "h", "mm", "m", "of the follower", 20, 1e-6, 1e5});
/// so that a parameter is stated once. The first field is `given` itself; the order of the others
/// is that in which people read them. A machine is made by M{given}.
class Given {
 public:
  /// The default of each parameter.
  Given() = default;
  /// Values in listed units, in the order of the fields, and the factors to those of the formulas.
  /// Both must outlive the machine's construction, but not the machine.
  Given(std::span<const Expression> values, std::span<const UnitFactor> factors)
      : values_(values), factors_(factors) {}
  /// 0 in every field, of a machine whose formulas need only the fields that are set by hand.
  static Given unset() {
    Given none;
    none.unset_ = true;
    return none;
  }
  /// The defaults, and what each parameter is, which goes to the end of `seen`.
  explicit Given(std::vector<MachineParameter>& seen) : seen_(&seen) {}

  /// The value of the next parameter, in the unit of the formulas.
  Expression operator()(const MachineParameter& parameter) {
    if (unset_) return 0;
    if (seen_ != nullptr) seen_->push_back(parameter);
    const std::size_t i = next_++;
    assert(values_.empty() || i < values_.size());
    if (i < values_.size()) return factors_[i].as<Expression>() * values_[i];
    return UnitFactor(parameter.unit, parameter.stored).as<Expression>() *
           Expression(parameter.default_value);
  }

 private:
  std::span<const Expression> values_;
  std::span<const UnitFactor> factors_;
  std::vector<MachineParameter>* seen_ = nullptr;
  std::size_t next_ = 0;
  bool unset_ = false;
};

}  // namespace camlaw
