// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace camlaw::problems {

/// Whether a parameter is a size by which a designer tells one cam from another: stroke, swing,
/// base or roller radius, on a shaft with its cam before it.
bool is_main_size(std::string_view parameter);

}  // namespace camlaw::problems
