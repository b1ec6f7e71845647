// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "cli/chart.h"
#include "cli/law_json.h"
#include "optim/search/optimise.h"
#include "problems/statement/bind.h"

/// The answer to a problem file, for people, for programs and as a picture.
namespace camlaw::cli {

/// An answer with what it answers.
struct Answer {
  const problems::BoundProblem& bound;
  const optim::ProblemSpace& space;
  const optim::Optimum& optimum;

  /// Option or variable by name, with units: the design.
  struct Value {
    std::string name, unit, text;
    double number;  ///< NaN for a choice in words
  };
  std::vector<Value> values() const;
};

std::string answer_text(const Answer& answer);
Json answer_json(const Answer& answer);

/// Every curve that the problem limits or seeks, over the cycle, with its limits.
Figure cycle_figure(const Answer& answer);

/// The sizes that variables and limits are divided by, and the tolerances.
std::string scaling_text(const optim::Problem& problem);

}  // namespace camlaw::cli
