// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "optim/search/hopeless.h"

/// Limits that no design meets, since their response has no value anywhere.
namespace camlaw::optim {

/// When a limit is asked about: before a search, where only what a search could not mend counts, or
/// after one that came upon no design with numbers.
enum class Asked : char { Before, After };

/// Looks for a limit whose response has no value at the start, nor at any of many places that fill
/// the box of the variables evenly and by orders of magnitude. Before a search only such a one
/// without which the problem has numbers there, within all limits beyond which responses may have
/// no value. It is no proof: a domain narrower than the places are apart is not seen. None where
/// there is none.
std::optional<Hopeless> limit_without_value(const Problem& problem, std::uint64_t seed,
                                            Asked asked);

/// Why no design can be found whose objective has a value: it has none at the start, nor at any of
/// the same places. Empty where it has one at any of them.
std::string objective_without_value(const Problem& problem, std::uint64_t seed);

}  // namespace camlaw::optim
