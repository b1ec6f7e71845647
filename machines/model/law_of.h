// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <stdexcept>

#include "kinematics/laws/catalogue.h"

namespace camlaw::problems {

/// The law of a member; none where its arguments make no law.
template <class S>
std::optional<Law<S>> law_of(const Member& member) {
  try {
    return member.law<S>();
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace camlaw::problems
