// SPDX-License-Identifier: MIT
#pragma once

#include "problems/statement/statement.h"

namespace camlaw::problems {

/// Limits the variables to values that make a law: what a family's parameters must leave together
/// (Room), such as 1 - a - b - c >= 0 for the phases of scca, becomes a constraint where the bounds
/// of the variables do not see to it. So a design at the edge of what is possible stands at a limit
/// with a price. Constraints of an earlier call go first: what is fixed may have changed.
void limit_to_laws(ProblemStatement& problem);

/// A limit of validity as a constraint on a mechanism's response.
ConstraintStatement valid_limit(const Mechanism& mechanism, const ValidityLimit& limit);

/// Between what a parameter of a law varies.
struct LawRange {
  std::size_t parameter, element;
  double lower, upper;
};

/// The most that a law, some of its parameters in their ranges, may leave of such a constraint's
/// room; none for other constraints and other laws.
std::optional<double> most_room(const ConstraintStatement& constraint, const Member& law,
                                std::span<const LawRange> varying);

}  // namespace camlaw::problems
