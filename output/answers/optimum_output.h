// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "optim/search/easing.h"
#include "optim/search/optimise.h"
#include "output/answers/design_value.h"
#include "output/document/document.h"
#include "output/figure/chart.h"
#include "problems/law_files/json_text.h"
#include "problems/refinement/refined_knots.h"
#include "problems/statement/bind.h"
#include "problems/statement/buildable.h"
#include "problems/tolerance/reached.h"

/// The answer to a problem file, for people, for programs and as a picture.
namespace camlaw::cli {

/// An answer with what it answers.
struct Answer {
  const problems::BoundProblem& bound;
  const optim::ProblemSpace& space;
  const optim::Optimum& optimum;
  std::string asked;  ///< the solver asked for, or "auto"
  std::uint64_t seed;
  std::vector<std::string> warnings = {};  ///< what stands beside the verdict, warnings_of(*this)
  problems::Buildability built = {};       ///< of the design, buildability_of(*this)
  std::optional<problems::RefinedKnots> knots = {};  ///< where they were found: knots = "auto"
  problems::ReachedReliability reached = {};         ///< of reliabilities and of a robust objective
  optim::FoundEasings easings = {};  ///< of an infeasible answer, what would cure it

  /// Option or variable by name, with units: the design.
  std::vector<DesignValue> values() const;
  /// The law of the design with all its parameters; none where the model gave no design.
  std::optional<Member> law() const;
  /// The limits, turned as they were stated.
  std::vector<optim::LimitReport> limits() const;
};

/// Of an answer with a design that meets its limits; else no checks.
problems::Buildability buildability_of(const Answer& answer);

struct FreeLimit;  // free_limit.h

/// Whether a combination has a design that meets its limits.
bool has_design(const optim::PartFound& part);

/// Every combination of choices that a search looked at, the best first: what was chosen, the
/// objective, how far it is from the best and, where that was asked for, from what a free law
/// reaches, the verdict and what holds it. Empty where there is nothing to choose. Each is judged
/// with proofs, up to the deadline; those behind it are as the search has left them, which is told.
Document combinations_document(const Answer& answer, const FreeLimit* free = nullptr,
                               const optim::Deadline& deadline = optim::Deadline({}, nullptr));

Document answer_document(const Answer& answer);

/// The sizes that variables and limits are divided by, and the tolerances.
Table scaling_table(const optim::Problem& problem);

}  // namespace camlaw::cli
