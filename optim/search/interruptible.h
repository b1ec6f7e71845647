// SPDX-License-Identifier: MIT
#pragma once

#include <exception>

#include "optim/problem/problem.h"
#include "optim/search/deadline.h"

namespace camlaw::optim {

/// A response was asked for after the deadline.
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "the search was cut short"; }
};

/// Whether that is what was thrown.
bool is_interruption(const std::exception_ptr& error);

/// The same problem, whose responses throw Interrupted once the deadline has passed. Whatever is
/// worked out of a problem, from sizes to proofs, comes from its responses: so all of it ends in
/// time, without each loop asking. The deadline must outlive the copy.
Problem interruptible(Problem problem, const Deadline& deadline);

}  // namespace camlaw::optim
