// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "numerics/scalar/absolute.h"
#include "numerics/scalar/scalar.h"

namespace camlaw {

/// What must hold for there to be a machine: that a quantity is above 0, or 0 or above where it may
/// be zero. The words tell it in the names by which the machine's parameters are listed.
template <class T>
struct Condition {
  T margin;
  const char* words;  ///< "corner_speed must be below maximum_speed"
  bool may_be_zero = false;

  bool holds() const {
    const double plain = value_of(margin);
    return plain > 0 || (may_be_zero && plain == 0);
  }
};

template <class T, std::size_t N>
using Conditions = std::array<Condition<T>, N>;

/// One list of conditions and another behind it.
template <class T, std::size_t N, std::size_t K>
Conditions<T, N + K> joined(const Conditions<T, N>& first, const Conditions<T, K>& second) {
  Conditions<T, N + K> all;
  std::copy(first.begin(), first.end(), all.begin());
  std::copy(second.begin(), second.end(), all.begin() + N);
  return all;
}

/// The first condition of a machine that fails, in words; nothing where there is such a machine.
template <class Machine>
const char* broken_condition(const Machine& machine) {
  if constexpr (requires { machine.conditions(); }) {
    for (const auto& condition : machine.conditions()) {
      if (!condition.holds()) return condition.words;
    }
  }
  return nullptr;
}

/// Whether there is such a machine.
template <class Machine>
bool is_possible(const Machine& machine) {
  return broken_condition(machine) == nullptr;
}

}  // namespace camlaw
