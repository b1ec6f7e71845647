// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "output/answers/claim_output.h"
#include "output/document/document.h"
#include "problems/statement/bind.h"

namespace camlaw::cli {

/// Every response of a design, how it stands to the limits, and whether it can be built.
Document evaluation_document(const problems::ProblemStatement& statement,
                             const std::vector<problems::EvaluatedResponse>& responses,
                             const std::vector<optim::LimitReport>& limits,
                             const ClaimReview& review);

}  // namespace camlaw::cli
