// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "cli/command.h"

/// What a command whose work processes may share takes.
namespace camlaw::cli {

/// --workers.
Option workers_option(std::optional<std::string>& workers);

/// As many as were asked for, else the usual number. Throws std::invalid_argument for a count
/// that makes no sense.
int workers_of(const std::optional<std::string>& workers);

}  // namespace camlaw::cli
