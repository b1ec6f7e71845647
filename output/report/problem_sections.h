// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "optim/verdict/verdict.h"
#include "output/report/page.h"
#include "problems/statement/bind.h"
#include "problems/statement/buildable.h"

/// Sections that say what was asked and how a design answers it.
namespace camlaw::cli {

/// The problem in sentences.
ReportSection problem_section(const problems::ProblemStatement& statement);

/// The values of what varies and of every constant, with units and bounds.
ReportSection values_section(const problems::ProblemStatement& design);

/// Each limit with value, bound, margin and the place where it is worst, and a bar of its margin.
/// A limit from both sides has a row for each, the nearer first. `priced` adds what easing each by
/// one unit buys; `blamed` names those that a search found cannot be met.
ReportSection limits_section(const problems::ProblemStatement& design,
                             const std::vector<optim::LimitReport>& limits, bool priced,
                             const std::vector<std::string>& blamed);

/// Each check of whether the machine can be built.
ReportSection buildable_section(const problems::Buildability& found);

/// What the errors of the profile that a problem states do to its follower, and what the shop must
/// hold; or why that cannot be said. None where it states none.
std::optional<ReportSection> profile_section(const problems::ProblemStatement& design);

/// What the mechanism's numbers and peaks are.
ReportSection numbers_section(const std::vector<problems::EvaluatedResponse>& evaluated);

/// A law's peaks measured with what no law passes; none for a mechanism without one law.
std::optional<ReportSection> rulers_section(const problems::ProblemStatement& design);

/// A mechanism to scale with the controls that move it; the still picture when printed. Where there
/// is not a drawing the controls alone, which move the mark in the curves.
ReportSection motion_section(const problems::ProblemStatement& design, const std::string& svg);

}  // namespace camlaw::cli
