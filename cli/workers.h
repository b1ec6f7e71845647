// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "cli/command.h"
#include "optim/problem/problem.h"

/// What a command whose work processes may share takes.
namespace camlaw::cli {

/// --workers.
Option workers_option(std::optional<std::string>& workers);

/// As many as were asked for, else the usual number. Throws std::invalid_argument for a count
/// that makes no sense.
int workers_of(const std::optional<std::string>& workers);

/// As many of them as have room for the searches of a problem in so many bytes. Throws
/// optim::MemoryRefusal where not one has.
int workers_with_room(int workers, const optim::Problem& problem, double allowed);

}  // namespace camlaw::cli
