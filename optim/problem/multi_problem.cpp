// SPDX-License-Identifier: MIT
#include "optim/problem/multi_problem.h"

#include <fmt/format.h>

#include <stdexcept>

#include "optim/problem/combinations.h"

namespace camlaw::optim {

Problem MultiProblem::alone(std::size_t objective) const {
  return {.name = name,
          .variables = variables,
          .objective = objectives.at(objective),
          .constraints = constraints};
}

void MultiProblem::check() const {
  if (objectives.size() < 2) {
    throw std::invalid_argument(
        fmt::format("a front needs two objectives or more; there is {}", objectives.size()));
  }
  for (std::size_t i = 0; i < objectives.size(); ++i) alone(i).check();
}

MultiSpace MultiSpace::of(MultiProblem problem) {
  return {{}, [problem = std::move(problem)](const auto&) { return problem; }};
}

std::size_t MultiSpace::parts() const { return combinations_of(choices); }

std::vector<std::size_t> MultiSpace::options(std::size_t part) const {
  std::vector<std::size_t> result(choices.size());
  for (std::size_t i = choices.size(); i-- > 0;) {
    result[i] = part % choices[i].options.size();
    part /= choices[i].options.size();
  }
  return result;
}

MultiSpace joined(const std::string& choice, const std::vector<std::string>& names,
                  const std::vector<MultiSpace>& spaces) {
  Choice all;
  all.name = choice;
  std::vector<std::pair<std::size_t, std::size_t>> behind;  // of each option: space and its part
  for (std::size_t s = 0; s < spaces.size(); ++s) {
    const std::size_t parts = spaces[s].parts();
    for (std::size_t part = 0; part < parts; ++part) {
      all.options.push_back(parts == 1 ? names[s] : fmt::format("{} {}", names[s], part + 1));
      behind.emplace_back(s, part);
    }
  }
  return {{all}, [spaces, behind](const std::vector<std::size_t>& options) {
            const auto& [space, part] = behind[options.front()];
            return spaces[space].problem(spaces[space].options(part));
          }};
}

double as_cost(const Objective& objective, double value) {
  return objective.sense == Sense::Minimize ? value : -value;
}

Constraint at_most(const Objective& objective, double cost) {
  Constraint limit;
  limit.response = objective.response;
  const double bound = as_cost(objective, cost);
  const bool from_below = objective.sense == Sense::Maximize;
  (from_below ? limit.lower : limit.upper) = bound;
  if (objective.part == Part::Magnitude) limit.lower = -bound;
  return limit;
}

}  // namespace camlaw::optim
