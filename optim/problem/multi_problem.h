// SPDX-License-Identifier: MIT
#pragma once

#include "optim/problem/problem.h"

/// Problems with several objectives. Within optim/pareto each objective is counted as a cost, which
/// is to be small: of what is to be great the negative.
namespace camlaw::optim {

struct MultiProblem {
  std::string name;
  std::vector<Variable> variables;
  std::vector<Objective> objectives;  ///< two or more
  std::vector<Constraint> constraints;

  /// With one objective, the others left out.
  Problem alone(std::size_t objective) const;
  /// Throws std::invalid_argument as Problem::check() does, for each objective.
  void check() const;
};

/// A problem for each combination of choices.
struct MultiSpace {
  std::vector<Choice> choices;
  std::function<MultiProblem(const std::vector<std::size_t>& options)> problem;

  /// A space of one problem.
  static MultiSpace of(MultiProblem problem);
  /// Number of combinations. Throws std::invalid_argument for a choice without options and for more
  /// than kMostCombinations.
  std::size_t parts() const;
  /// The options of a combination: digits of a counter, the last choice's fastest.
  std::vector<std::size_t> options(std::size_t part) const;
};

/// Several spaces as one with a choice among them, by these names; their objectives are the same.
/// The options of a part are those of all combinations of all spaces in turn.
MultiSpace joined(const std::string& choice, const std::vector<std::string>& names,
                  const std::vector<MultiSpace>& spaces);

/// A value of an objective as a cost, or a cost as a value.
double as_cost(const Objective& objective, double value);

/// The limit that an objective's cost is at most `cost`; of a peak at every angle.
Constraint at_most(const Objective& objective, double cost);

}  // namespace camlaw::optim
