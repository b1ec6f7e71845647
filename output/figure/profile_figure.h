// SPDX-License-Identifier: MIT
#pragma once

#include "output/figure/chart.h"
#include "problems/statement/statement.h"

namespace camlaw::cli {

/// A cam as it is drawn and cut: profile, pitch curve and path of the tool, both axes to one scale.
/// Throws std::invalid_argument for a mechanism without a profile.
Figure profile_figure(const problems::ProblemStatement& statement);

}  // namespace camlaw::cli
