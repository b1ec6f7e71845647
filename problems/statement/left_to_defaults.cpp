// SPDX-License-Identifier: MIT
#include "problems/statement/left_to_defaults.h"

#include <algorithm>

#include "problems/statement/parts.h"

namespace camlaw::problems {

std::set<std::size_t> used_parameters(const ProblemStatement& problem) {
  std::set<std::size_t> used;
  const auto use = [&](const ResponseName& name) {
    if (name.response == nullptr) used.insert(name.parameter);
    if (name.response != nullptr)
      used.insert(name.response->uses.begin(), name.response->uses.end());
  };
  for (const ObjectiveStatement& o : problem.objectives) use(o.response);
  for (const ConstraintStatement& constraint : problem.constraints) use(constraint.response);
  if (!problem.objectives.empty() || !problem.constraints.empty()) return used;
  for (std::size_t i = 0; i < problem.constants.size(); ++i) used.insert(i);
  return used;
}

bool is_constant(const ProblemStatement& problem, std::size_t parameter) {
  const bool varies =
      std::any_of(problem.variables.begin(), problem.variables.end(),
                  [&](const auto& v) { return !v.of_law && v.parameter == parameter; });
  const bool by_case =
      !problem.cases.empty() &&
      std::any_of(problem.cases.front().parameters.begin(), problem.cases.front().parameters.end(),
                  [&](const auto& set) { return set.first == parameter; });
  const bool by_range =
      std::any_of(problem.ranges.begin(), problem.ranges.end(),
                  [&](const ParameterRange& range) { return range.parameter == parameter; });
  const PartStatement* part = part_of(problem, parameter);
  return !varies && !by_case && !by_range && (part == nullptr || !part->is_chosen());
}

std::vector<std::size_t> left_to_defaults(const ProblemStatement& problem) {
  std::vector<std::size_t> left;
  for (const std::size_t i : used_parameters(problem)) {
    const bool is_told = problem.stated.contains(i) || problem.told_by_motion.contains(i) ||
                         part_of(problem, i) != nullptr;
    if (!is_told && is_constant(problem, i)) left.push_back(i);
  }
  return left;
}

}  // namespace camlaw::problems
