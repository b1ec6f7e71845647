// SPDX-License-Identifier: MIT
#include "output/answers/judged_words.h"

#include <fmt/format.h>

#include "output/document/formatting.h"
#include "problems/results/judged_design.h"

namespace camlaw::cli {

std::vector<std::string> judged_words(const problems::ReadDesign& read) {
  const auto held = problems::held_problem(read);
  if (!held) return {};
  const optim::Assessment found = problems::judged(*held);
  if (optim::is_feasible(found)) {
    return {fmt::format("judged again: {}", optim::to_string(found.verdict))};
  }
  std::vector<std::string> words{"judged again: the design does not meet its limits"};
  for (const optim::LimitReport& limit : found.limits) {
    if (limit.met) continue;
    words.push_back(fmt::format("{} is {}, and its limit is {} {}", limit.name,
                                with_unit(in_digits(limit.value), limit.unit),
                                limit.is_upper ? "at most" : "at least",
                                with_unit(in_digits(limit.bound), limit.unit)));
  }
  return words;
}

}  // namespace camlaw::cli
