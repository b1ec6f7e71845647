// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "optim/problem/function.h"

/// Options that one back end has and the others do not: Ipopt's "mu_strategy", the "population" of
/// NLopt's crs2. They are passed on by the names that the back end has for them.
namespace camlaw::optim {

using NativeValue = std::variant<std::int64_t, double, std::string>;
/// Of one solver, by the option's name.
using NativeOptions = std::map<std::string, NativeValue>;

/// An option of a back end and what it accepts.
struct NativeRule {
  enum class Kind { Integer, Number, Text };

  std::string name;
  Kind kind = Kind::Number;
  double lower = -kInfinity, upper = kInfinity;   ///< of Integer and Number
  bool above_lower = false, below_upper = false;  ///< whether the bound itself is excluded
  std::vector<std::string> texts = {};            ///< that Text accepts; empty where it is any
  std::string reserved = {};  ///< why nobody but camlaw may set it; empty where anybody may
};

/// Of an option that camlaw keeps to itself, and why.
inline NativeRule reserved_option(const char* name, const char* why) {
  return {.name = name, .reserved = why};
}

/// Throws std::invalid_argument where `solver`, whose options are `rules`, has no such option, does
/// not accept the value, or keeps the option to itself. The message names the solver, the option
/// and what is accepted.
void check_native_option(const std::string& solver, const std::vector<NativeRule>& rules,
                         const std::string& name, const NativeValue& value);

/// An integer or a number as a number. A text is a programmer's error: check first.
double number_of(const NativeValue& value);
/// "adaptive", "12", "0.5": as it stands in words.
std::string to_text(const NativeValue& value);

}  // namespace camlaw::optim
