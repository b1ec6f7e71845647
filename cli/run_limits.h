// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "cli/command.h"

/// What a command that searches may take: time and memory.
namespace camlaw::cli {

/// As they are written on the command line.
struct RunLimits {
  std::optional<std::string> time_limit, memory;
};

/// No answer in time: exit status kNotSolved.
struct NotSolved : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// --time-limit, --memory.
/// `answer`: what there is when the time is over.
Option time_limit_option(RunLimits& limits, const std::string& answer = "the best design");
Option memory_option(RunLimits& limits);

/// Seconds of --time-limit; none where it is not given. Throws std::invalid_argument.
std::optional<double> time_limit_of(const RunLimits& limits);
/// Bytes of --memory, else what the machine has free. Throws std::invalid_argument.
double memory_of(const RunLimits& limits);

/// Bytes of "4 GB", "500 MB", "2 GiB"; `what` names it in errors. Throws std::invalid_argument.
double parse_memory(const std::string& text, const std::string& what);

}  // namespace camlaw::cli
