// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/possibility.h"
#include "machines/model/responses.h"

namespace camlaw::problems {

/// The condition that a machine M<double> of these values, in their listed units, does not meet;
/// empty where it meets all. Its is_possible() is a Possibility.
template <template <class> class M>
std::string why_impossible_as(std::span<const double> values) {
  const Possibility possibility = detail::machine_of<M>(values).is_possible();
  return possibility ? "" : possibility.why();
}

}  // namespace camlaw::problems
