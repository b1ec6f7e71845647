// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "problems/statement/statement.h"

/// What a check of whether a machine can be built asks of a problem.
namespace camlaw::problems {

/// A parameter of the machine by its name; how many there are where it has none.
std::size_t parameter_named(const ProblemStatement& problem, std::string_view name);

/// Whether a name is of that response, over ranges or not.
bool is_of(const ResponseName& name, const MechanismResponse& response);

/// What a check needs and the problem does not state; empty where nothing is missing.
std::string missing(const BuildableCheck& check, const ProblemStatement& problem);

/// Why a check cannot be made over all values that a parameter takes; empty where it can be.
std::string mixed(const BuildableCheck& check, const ProblemStatement& problem);

/// The limit that a check is. Nothing that it needs is missing.
ConstraintStatement limit_of(const BuildableCheck& check, const ProblemStatement& problem);

/// The part that states what a check needs; null where none does.
const PartStatement* part_behind(const BuildableCheck& check, const ProblemStatement& problem);

/// The bound of that limit, and what it is for a machine with other constants.
double bound_of(const BuildableCheck& check, const ProblemStatement& problem);
double bound_with(const BuildableCheck& check, const ProblemStatement& problem,
                  const std::vector<double>& constants);
/// Whether it is another at one end of a parameter's range than at the other.
bool bound_moves(const BuildableCheck& check, const ProblemStatement& problem,
                 const ParameterRange& range);

}  // namespace camlaw::problems
