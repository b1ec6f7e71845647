// SPDX-License-Identifier: MIT
#include "problems/statement/cases.h"

#include <algorithm>

#include "machines/model/load_case.h"
#include "machines/model/over_ranges.h"
#include "problems/statement/ranges.h"

namespace camlaw::problems {
namespace {

/// Where a name goes on behind the word for a part, "peak ".
std::size_t behind_part(const std::string& name) {
  for (const char* word : {"peak ", "highest ", "lowest "}) {
    if (name.starts_with(word)) return std::string_view(word).size();
  }
  return 0;
}

/// The response that a name is of, looked up anew.
const MechanismResponse* renewed(const Mechanism& mechanism, const ResponseName& name) {
  return find_response(mechanism, name.response->name).response;
}

/// Responses that others refer to.
using OwnedResponses = std::vector<std::shared_ptr<const MechanismResponse>>;

/// The response in each case over the problem's ranges; of the largest size of a curve both the
/// highest values and the lowest ones, for a mean as one curve.
void spread_over_ranges(const ProblemStatement& problem, bool highest, bool is_mean,
                        std::vector<ResponseName>& parts, OwnedResponses& owned) {
  std::vector<ResponseName> spread;
  const auto add = [&](ResponseName part, bool of_highest) {
    auto over = highest_over_ranges(problem, part, of_highest);
    if (over) {
      part.response = over.get();
      owned.push_back(std::move(over));
    }
    spread.push_back(std::move(part));
    return spread.back().response->over_ranges != nullptr;
  };
  for (const ResponseName& part : parts) {
    const bool is_size = part.part == optim::Part::Magnitude;
    const bool is_over = add(part, is_size || highest);
    if (is_size && is_over) add(part, false);
    if (!is_size || !is_over || !is_mean) continue;
    const std::vector<ResponseName> both(spread.end() - 2, spread.end());
    WorstCase size = worst_case(problem.mechanism, both, part.name, true);
    owned.push_back(std::move(size.response));
    spread.resize(spread.size() - 2);
    spread.push_back(std::move(size.name));
  }
  parts = std::move(spread);
}

/// The same as a part that is made has it, in numbers.
void spread_each_part(const ProblemStatement& problem, bool highest,
                      std::vector<ResponseName>& parts, OwnedResponses& owned) {
  for (ResponseName& part : parts) {
    auto over = of_part_over_ranges(problem, part, highest);
    if (!over) continue;
    part.response = over.get();
    owned.push_back(std::move(over));
  }
}

}  // namespace

std::string over_name(OverCases over, const std::string& name) {
  return (over == OverCases::Mean ? "mean " : "worst ") + name;
}

ResponseName in_case(const Mechanism& mechanism, const ResponseName& name, const LoadCase& load) {
  if (name.response == nullptr) return name;
  const std::string own = name_in_case(mechanism, name.response->name, load);
  if (own == name.response->name) return name;
  ResponseName result = name;
  result.response = find_response(mechanism, own).response;
  result.name.insert(behind_part(name.name), load.name + ".");
  return result;
}

std::vector<ConstraintStatement> in_cases(const ProblemStatement& problem,
                                          const ConstraintStatement& limit,
                                          const std::vector<std::string>& cases) {
  std::vector<ConstraintStatement> result;
  for (const LoadCase& load : problem.cases) {
    if (std::find(cases.begin(), cases.end(), load.name) == cases.end()) continue;
    ConstraintStatement own = limit;
    own.response = in_case(*problem.mechanism, limit.response, load);
    if (own.response.response == limit.response.response) return {limit};
    result.push_back(std::move(own));
  }
  if (result.empty()) result.push_back(limit);
  if (limit.reliability && result.size() > 1) {
    result = {limit};  // a part must hold it in all of them
    result.front().in_cases = cases;
  }
  return result;
}

ObjectiveStatement over_cases(const ProblemStatement& problem, ObjectiveStatement objective,
                              OverCases over) {
  std::vector<ResponseName> parts;
  for (const LoadCase& load : problem.cases) {
    parts.push_back(in_case(*problem.mechanism, objective.response, load));
    if (parts.back().response == objective.response.response) return objective;
  }
  if (parts.empty()) return objective;
  const std::string name = over_name(over, objective.response.name);
  const bool is_upper = objective.sense == optim::Sense::Minimize;
  OwnedResponses owned;
  if (objective.robust) {
    spread_each_part(problem, is_upper, parts, owned);
  } else {
    spread_over_ranges(problem, is_upper, over == OverCases::Mean, parts, owned);
  }
  WorstCase wanted = over == OverCases::Mean
                         ? mean_over_cases(problem.mechanism, std::move(parts), problem.cases, name)
                         : worst_case(problem.mechanism, std::move(parts), name, is_upper);
  owned.push_back(wanted.response);
  auto all = std::make_shared<const OwnedResponses>(std::move(owned));
  objective.of_cases = std::shared_ptr<const MechanismResponse>(all, all->back().get());
  objective.one_case = objective.response;
  objective.over = over;
  objective.response = std::move(wanted.name);
  return objective.robust ? over_parts(problem, std::move(objective)) : objective;
}

const LoadCase* find_case(const ProblemStatement& problem, std::string_view name) {
  const auto found = std::find_if(problem.cases.begin(), problem.cases.end(),
                                  [&](const LoadCase& load) { return load.name == name; });
  return found == problem.cases.end() ? nullptr : &*found;
}

void renew(ProblemStatement& problem) {
  const auto old = problem.mechanism;  // names refer to it until they are renewed
  if (problem.without_cases) {
    problem.mechanism =
        std::make_shared<const Mechanism>(with_cases(*problem.without_cases, problem.cases));
  }
  for (ConstraintStatement& limit : problem.constraints) {
    const bool is_own = limit.of_law || limit.response.response == nullptr;
    if (is_own) continue;
    if (is_quantile(limit)) {
      limit = over_ranges(problem, as_stated(problem, limit)).front();
      continue;
    }
    limit.response.response = renewed(*problem.mechanism, limit.response);
    if (!limit.of_range) continue;
    limit = over_ranges(problem, limit).front();  // it has one side
  }
  for (ObjectiveStatement& objective : problem.objectives) {
    if (objective.over) {
      objective.response = objective.one_case;
      objective.response.response = renewed(*problem.mechanism, objective.response);
      objective = over_cases(problem, objective, *objective.over);
    } else if (objective.response.response != nullptr) {
      if (objective.of_ranges) objective.response = objective.one_value;
      objective.response.response = renewed(*problem.mechanism, objective.response);
      if (objective.of_ranges) objective = over_ranges(problem, objective);
    }
  }
}

}  // namespace camlaw::problems
