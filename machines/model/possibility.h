// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "numerics/formula/expression.h"

namespace camlaw {

/// What must hold for there to be a machine: that a quantity is above 0, or 0 or above where it may
/// be zero. The words tell it in the names by which the machine's parameters are listed.
struct Condition {
  Expression margin;
  const char* words;  ///< "corner_speed must be below maximum_speed"
  bool may_be_zero = false;
};

/// Whether a condition with this margin holds.
inline bool margin_holds(double margin, bool may_be_zero) {
  return margin > 0 || (may_be_zero && margin == 0);
}

template <std::size_t N>
using Conditions = std::array<Condition, N>;

/// One list of conditions and another behind it.
template <std::size_t N, std::size_t K>
Conditions<N + K> joined(const Conditions<N>& first, const Conditions<K>& second) {
  Conditions<N + K> all;
  std::copy(first.begin(), first.end(), all.begin());
  std::copy(second.begin(), second.end(), all.begin() + N);
  return all;
}

}  // namespace camlaw
