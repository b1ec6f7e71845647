// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "machines/model/machine.h"

namespace camlaw::problems {

/// Mechanism::why_impossible of a machine M that has conditions().
template <class M>
std::string why_impossible_as(std::span<const double> values) {
  const char* const broken = detail::broken_condition<M>(values);
  return broken == nullptr ? "" : broken;
}

}  // namespace camlaw::problems
