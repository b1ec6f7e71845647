// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "numerics/formula/formula.h"
#include "numerics/formula/steps.h"

namespace camlaw {

/// Adds a formula's steps to those of others and returns which one is its value.
std::uint32_t join(const Formula& formula, Recorder& all);

}  // namespace camlaw
