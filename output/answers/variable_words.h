// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "optim/search/optimise.h"

namespace camlaw::cli {

/// A variable's value in ten digits, and 0 for what is nothing beside the bounds. In all digits
/// where these would tell a bound, or 0, that another objective belongs to.
std::string variable_in_words(const optim::Optimum& optimum, std::size_t variable);

}  // namespace camlaw::cli
