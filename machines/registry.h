// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/mechanism.h"

/// The mechanisms that problem files name.
namespace camlaw::problems {

/// Every mechanism, in the order of the listing.
const std::vector<Mechanism>& mechanisms();
/// By its name, or one that it had in earlier programs; null where there is none.
const Mechanism* known_mechanism(std::string_view name);
/// The same. Throws std::invalid_argument with the known names.
const Mechanism& find_mechanism(std::string_view name);
/// Such a mechanism as one that somebody may own: it stays, whoever has it.
std::shared_ptr<const Mechanism> listed(const Mechanism& mechanism);
/// The name that a mechanism had in earlier programs; empty where it had no other.
std::string_view earlier_name(const Mechanism& mechanism);

}  // namespace camlaw::problems
