// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "kinematics/laws/catalogue.h"
#include "problems/statement/statement.h"

namespace camlaw::problems {

/// What no law that moves from rest to rest can better, where an objective is the peak of a curve
/// of a free law that rests at its ends: what a free law has there it has whatever its
/// coefficients.
std::optional<optim::KnownLimit> known_limit(const ProblemStatement& statement,
                                             const ObjectiveStatement& objective,
                                             const Member& member);

}  // namespace camlaw::problems
