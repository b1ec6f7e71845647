// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "optim/crew/crew.h"
#include "problems/statement/statement.h"

/// Yields sent to processes that are started afresh (problems/fronts/study_worker.h).
namespace camlaw::problems {

/// A design as its problem's text and settings give it: what can be sent, and recorded. All that is
/// worked out of its parts is of this one. Throws std::invalid_argument where they give another
/// one, by more than rounding.
ProblemStatement restated_design(const ProblemStatement& design);

/// How a process is started that counts parts of a design. `tolerances` as asked_variations() takes
/// them. Throws std::invalid_argument for a design that its problem's text and settings do not
/// give.
optim::WorkerProgram tolerance_program(const ProblemStatement& design,
                                       const std::vector<std::string>& tolerances);

/// What a worker program does for a design that it was sent; none where it was sent something else.
/// Throws std::invalid_argument where it comes from another version of camlaw or its libraries.
std::optional<optim::Service> service_of_tolerance(const std::string& sent);

}  // namespace camlaw::problems
