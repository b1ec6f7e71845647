// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/possibility.h"
#include "machines/model/responses.h"

namespace camlaw::problems {

/// Mechanism::why_impossible of a machine M whose is_possible() is a Possibility.
template <template <class> class M>
std::string why_impossible_as(std::span<const double> values) {
  const Possibility possibility = detail::machine_of<M>(values).is_possible();
  return possibility ? "" : possibility.why();
}

}  // namespace camlaw::problems
