// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/answers/claim_output.h"
#include "problems/results/judged_design.h"
#include "problems/results/recorded_design.h"
#include "problems/statement/bind.h"
#include "problems/statement/buildable.h"
#include "problems/statement/evaluate.h"

/// A design judged again for an answer: nothing that was recorded of it is believed.
namespace camlaw::cli {

/// All that is found out about a design before it is told.
struct DesignReview {
  std::vector<problems::EvaluatedResponse> evaluated;
  std::optional<problems::HeldProblem> held;
  std::optional<optim::Assessment> assessment;  ///< of a problem with one objective
  std::vector<optim::LimitReport> limits;
  problems::Buildability built;

  /// `progress` is told how far the responses are.
  explicit DesignReview(const problems::ReadDesign& read,
                        const problems::EvaluationProgress& progress = {});

  /// Of the problem with its choices held: so far prices hold.
  bool is_optimal() const;
  bool is_certified() const { return is_optimal() && held->whole; }
  std::size_t met() const;
};

/// A word that is coloured by its kind: "good", "bad", "unsure" or "plain".
struct VerdictBadge {
  std::string kind, text;
};

/// What was found here, or the words of the search where they agree with it.
VerdictBadge verdict_badge(const problems::ReadDesign& read, const ClaimReview& claim,
                           const DesignReview& review);

}  // namespace camlaw::cli
