// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/mechanism.h"

/// The mechanisms that problem files name.
namespace camlaw::problems {

/// Every mechanism, in the order of the listing.
const std::vector<Mechanism>& mechanisms();
/// Throws std::invalid_argument with the known names.
const Mechanism& find_mechanism(std::string_view name);

}  // namespace camlaw::problems
