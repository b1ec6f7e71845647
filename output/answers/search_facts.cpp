// SPDX-License-Identifier: MIT
#include "output/answers/search_facts.h"

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

}  // namespace camlaw::cli
