// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "optim/pareto/task.h"
#include "optim/search/optimise.h"
#include "problems/statement/bind.h"

/// The design of a combination as a study records it: the values of its variables, then the number
/// of the option taken of each choice, so that one row says all of it.
namespace camlaw::problems {

/// A recorded design taken apart.
struct SplitDesign {
  std::vector<double> x;
  std::vector<std::size_t> options;
};

/// None where it is not a design of the problem.
std::optional<SplitDesign> split_of(const BoundProblem& bound, optim::Design recorded);

/// A problem whose last variables are the choices, which change nothing.
optim::Problem as_recorded(optim::Problem problem, const std::vector<optim::Choice>& choices);

/// The options that a search of the problem begins with.
std::vector<std::size_t> options_at_start(const BoundProblem& bound);

/// A problem without choices that begins at a design of a neighbour, within its bounds; none where
/// that has other variables, or there are choices.
std::optional<optim::Problem> beginning_at(const BoundProblem& bound, optim::Design recorded);

/// What came of a search: its design with margins and prices, or why there is none.
optim::Outcome outcome_of(const optim::Optimum& optimum, std::size_t part, long evaluations);

/// The design that the problem begins with, looked at.
optim::Outcome evaluated(const BoundProblem& bound, std::size_t part);

}  // namespace camlaw::problems
