// SPDX-License-Identifier: MIT
#pragma once

#include <exception>

#include "optim/problem/deadline.h"
#include "optim/problem/problem.h"

namespace camlaw::optim {

/// Whether Interrupted is what was thrown.
bool is_interruption(const std::exception_ptr& error);

/// The same problem, whose responses throw Interrupted once the deadline has passed. Whatever is
/// worked out of a problem, from scales to proofs, comes from its responses: so all of it ends in
/// time, without each loop asking. The stop flag of the deadline must outlive the copy.
Problem interruptible(Problem problem, const Deadline& deadline);
/// The same of one response.
Response interruptible(Response response, const Deadline& deadline);

}  // namespace camlaw::optim
