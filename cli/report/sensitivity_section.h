// SPDX-License-Identifier: MIT
#pragma once

#include "cli/report/page.h"
#include "optim/verdict/tolerance.h"

namespace camlaw::cli {

/// What becomes of a design when each variable is off by up to its tolerance: the change by each,
/// and the spread of all together.
ReportSection sensitivity_section(const std::vector<optim::Variable>& variables,
                                  const std::vector<double>& tolerances,
                                  const optim::ToleranceReport& report);

}  // namespace camlaw::cli
