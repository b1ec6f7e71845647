// SPDX-License-Identifier: MIT
#pragma once

#include "optim/problem/problem.h"
#include "output/report/page.h"

namespace camlaw::cli {

/// What becomes of a design when each variable is off by up to a hundredth of its value: the change
/// by each, and the spread of all together.
ReportSection sensitivity_section(const optim::Problem& problem, optim::Design x);

}  // namespace camlaw::cli
