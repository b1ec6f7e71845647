// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/possibility.h"
#include "machines/model/responses.h"

namespace camlaw::problems {

/// Mechanism::why_impossible of a machine M that has conditions().
template <template <class> class M>
std::string why_impossible_as(std::span<const double> values) {
  const char* const broken = broken_condition(detail::machine_of<M>(values));
  return broken == nullptr ? "" : broken;
}

}  // namespace camlaw::problems
