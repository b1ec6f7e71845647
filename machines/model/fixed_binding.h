// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "machines/model/given_law.h"
#include "machines/model/mechanism.h"

namespace camlaw::problems {

/// The binding of a machine with these constants and this law, in which nothing varies. Throws
/// std::invalid_argument where the member is not a law.
inline Binding fixed_binding(std::vector<double> constants, Member law) {
  Binding binding;
  binding.constants = std::move(constants);
  binding.law = given_law(std::move(law), {}, binding);
  return binding;
}

}  // namespace camlaw::problems
