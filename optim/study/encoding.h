// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "optim/pareto/task.h"

namespace camlaw::optim {

/// An outcome as bytes, every number to the last bit, for a pipe between processes of one build.
std::string encoded(const Outcome& outcome);
/// None where the bytes are not those of one outcome.
std::optional<Outcome> decoded(std::string_view bytes);

}  // namespace camlaw::optim
