// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "problems/statement/statement.h"

/// Load cases of a problem: what is limited and sought in each of them.
namespace camlaw::problems {

/// A response in a case, named so: "peak fast.contact_stress" of "peak contact_stress"; the same
/// where it does not differ.
ResponseName in_case(const Mechanism& mechanism, const ResponseName& name, const LoadCase& load);

/// "worst torque_rms".
std::string over_name(OverCases over, const std::string& name);

/// A limit in each of these cases; once where its response does not differ, and where it has a
/// reliability: a part must hold it in all of them.
std::vector<ConstraintStatement> in_cases(const ProblemStatement& problem,
                                          const ConstraintStatement& limit,
                                          const std::vector<std::string>& cases);

/// An objective over all cases; as it is where its response does not differ, or is in one case
/// already.
ObjectiveStatement over_cases(const ProblemStatement& problem, ObjectiveStatement objective,
                              OverCases over);

/// A case by its name; null where there is none.
const LoadCase* find_case(const ProblemStatement& problem, std::string_view name);

/// Makes what is limited and sought anew, where cases or ranges have changed.
void renew(ProblemStatement& problem);

}  // namespace camlaw::problems
