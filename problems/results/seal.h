// SPDX-License-Identifier: MIT
#pragma once

#include "numerics/text/file_format.h"
#include "problems/law_files/json_text.h"
#include "problems/results/recorded_design.h"

/// What a result says of itself as a file: its format, and the checksum that tells whether it is as
/// it was written.
namespace camlaw::problems {

inline constexpr FileFormat kResultFormat{"camlaw result", 1};

/// Gives an object `checksum`, over all else that it holds: 16 digits of optim::Checksum. The order
/// of keys, the layout and how a number is written do not matter.
void seal(Json& object);

Seal seal_of(const Json& object);

}  // namespace camlaw::problems
