// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "machines/model/law_binding.h"
#include "machines/model/mechanism.h"

namespace camlaw::problems {

/// The binding of a machine with these constants and this law, in which nothing varies. Throws
/// std::invalid_argument where the member is not a law.
inline Binding fixed_binding(std::vector<double> constants, Member law) {
  Binding binding;
  binding.constants = std::move(constants);
  binding.law = std::make_shared<LawBinding>(std::move(law), std::vector<LawVariable>{});
  return binding;
}

}  // namespace camlaw::problems
