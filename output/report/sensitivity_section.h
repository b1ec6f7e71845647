// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "optim/problem/problem.h"
#include "output/report/page.h"
#include "problems/statement/statement.h"

namespace camlaw::cli {

/// What becomes of a design when each variable is off by its usual tolerance
/// (tolerance_output.h): the change
/// by each, and the spread of all together.
ReportSection sensitivity_section(const optim::Problem& problem, optim::Design x);

/// How objective and limits depend on every parameter, at the design and near it; none where they
/// depend on no continuous one.
std::optional<ReportSection> derivatives_section(const problems::ProblemStatement& design);

}  // namespace camlaw::cli
