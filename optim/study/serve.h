// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "optim/problem/problem.h"

/// The part of a process that works on a study.
namespace camlaw::optim {

/// Carries out what arrives at the socket (Order) and answers each with its outcome, until the
/// other end is gone. An interrupt or a request to end, which may be sent to all processes at once,
/// is the study's to handle, and ignored here: else a search that was cut short would be taken for
/// one that failed.
void serve(int socket, const ProblemSpace& space);

/// What a program that is started for this says first. The number counts the versions of what is
/// said after it (messages.h, encoding.h).
inline constexpr std::string_view kGreeting = "camlaw worker 1";

/// The whole of a program that is started for this: greets, takes the problem from the socket,
/// answers with an empty message, or with what `space_of` throws, and serves. Ends at once where
/// the other end goes away in the middle of a search. Returns the exit status.
int serve_as_program(int socket, const std::function<ProblemSpace(const std::string&)>& space_of);

}  // namespace camlaw::optim
