// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "machines/model/mechanism.h"

namespace camlaw::problems {

/// The condition that a machine of these values, in their listed units, does not meet, in the names
/// of its parameters; empty where it meets all, and of a machine that names none.
std::string why_impossible(const Mechanism& mechanism, std::span<const double> values);

}  // namespace camlaw::problems
