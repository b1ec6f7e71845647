// SPDX-License-Identifier: MIT
#include "output/answers/next_better.h"

#include <fmt/format.h>

#include "output/document/formatting.h"
#include "problems/statement/parameters.h"

namespace camlaw::cli {

std::string next_better(const Answer& answer) {
  const std::vector<optim::Choice>& choices = answer.space.choices;
  const optim::Objective& sought = answer.optimum.problem.objective();
  const std::string& name = answer.bound.statement().objectives.front().response.name;
  if (choices.size() != 1 || choices.front().name != name) return "";
  const std::vector<double>& values = choices.front().values;
  if (values.empty()) return "";
  const double sense = sought.sense == optim::Sense::Minimize ? 1 : -1;
  const auto rank = [&](const optim::PartFound& part) { return sense * values[part.options[0]]; };
  const optim::PartFound* next = nullptr;
  for (const optim::PartFound& part : answer.optimum.parts) {
    const bool is_better = rank(part) < sense * values[answer.optimum.options[0]];
    if (!is_better || (next != nullptr && rank(part) < rank(*next))) continue;
    next = &part;
  }
  if (next == nullptr || next->verdict != optim::Verdict::Infeasible || next->active.empty()) {
    return "";
  }
  const std::string limits = problems::listed(next->active);
  return fmt::format("{} = {} is not possible: {}\n", choices.front().name,
                     with_unit(in_digits(values[next->options[0]]), choices.front().unit),
                     next->active.size() == 1 ? limits + " cannot be met with it"
                                              : limits + " contradict one another with it");
}

}  // namespace camlaw::cli
