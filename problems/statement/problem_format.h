// SPDX-License-Identifier: MIT
#pragma once

#include "numerics/text/file_format.h"

namespace camlaw::problems {

/// What a problem file states in `format`; every file that the program writes has it.
inline constexpr FileFormat kProblemFormat{"camlaw problem", 1};

}  // namespace camlaw::problems
