// SPDX-License-Identifier: MIT
#include "output/answers/search_facts.h"

#include <fmt/format.h>

#include "optim/verdict/verdict.h"

namespace camlaw::cli {

Facts facts_of_search(const Json& result) {
  Facts facts;
  const auto add = [&](const char* name, const char* key) {
    const auto at = result.find(key);
    if (at == result.end() || at->is_null()) return;
    facts.emplace_back(name, at->is_string() ? at->get<std::string>() : at->dump());
  };
  add("solver", "solver"), add("why", "why_solver"), add("seed", "seed"), add("starts", "starts");
  add("starts that agreed", "agreed"), add("combinations of choices", "combinations");
  add("evaluations", "evaluations");
  return facts;
}

std::string words_of_starts(const optim::Found& found) {
  if (found.assessment.verdict == optim::Verdict::Infeasible)
    return fmt::format("none of {} starts led to a design within the limits", found.starts);
  if (found.agreed == 0 && is_feasible(found.assessment)) {
    return fmt::format(
        "none of {} starts ended at this objective; sampling the rest of the box found the design",
        found.starts);
  }
  return fmt::format("{} of {} starts ended at this objective", found.agreed, found.starts);
}

}  // namespace camlaw::cli
