// SPDX-License-Identifier: MIT
#include "output/answers/design_review.h"

#include <algorithm>

#include "output/answers/buildable_output.h"
#include "problems/tolerance/reached.h"

namespace camlaw::cli {

DesignReview::DesignReview(const problems::ReadDesign& read,
                           const problems::EvaluationProgress& progress)
    : evaluated(problems::evaluate(read.statement, progress)),
      held(problems::held_problem(read)),
      built(problems::buildability(read.statement)) {
  const problems::ProblemStatement& design = read.statement;
  if (held && design.objectives.size() == 1) assessment = problems::judged(*held);
  // A reliability is met where parts that the search did not have say so, as for verify.
  if (assessment) {
    if (const auto hold = problems::held_to_parts(design)) hold(*assessment);
  }
  limits =
      assessment ? problems::as_stated(design, assessment->limits) : problems::standing(design);
}

bool DesignReview::is_optimal() const {
  return assessment && assessment->verdict == optim::Verdict::Certified;
}

std::size_t DesignReview::met() const {
  return static_cast<std::size_t>(std::count_if(limits.begin(), limits.end(),
                                                [](const optim::LimitReport& l) { return l.met; }));
}

VerdictBadge verdict_badge(const problems::ReadDesign& read, const ClaimReview& claim,
                           const DesignReview& review) {
  using optim::Verdict;
  if (!claim.differences.empty()) return {"bad", "the result is wrong"};
  const std::optional<std::string> said = claim.is_believed() ? read.verdict : std::nullopt;
  const auto good = [&](const std::string& verdict) -> VerdictBadge {
    const Headline line = headline(verdict, review.built);
    return {line.spoilt ? "unsure" : "good", line.text};
  };
  if (review.is_certified()) return good(std::string(to_string(Verdict::Certified)));
  const bool meets = review.met() == review.limits.size();
  if (!meets) {
    const bool agrees = said == to_string(Verdict::Infeasible);
    return {"bad", agrees ? *said : "violates a limit"};
  }
  // Among its choices the search compared designs; among what varies evenly this page looks itself.
  const bool optimal = said == to_string(Verdict::Certified) && review.is_optimal();
  if (optimal) return good(*said);
  const bool agrees = said == to_string(Verdict::Feasible) ||
                      (said == to_string(Verdict::Certified) && !review.held);
  const Headline line = headline(agrees ? *said : "meets its limits", review.built);
  return {line.spoilt ? "unsure" : "plain", line.text};
}

}  // namespace camlaw::cli
