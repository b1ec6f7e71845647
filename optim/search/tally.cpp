// SPDX-License-Identifier: MIT
#include "optim/search/tally.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace camlaw::optim {
namespace {

/// "; rise=half-ellipse was not", for some of several.
std::string unsettled_words(const std::vector<std::string>& unsettled) {
  constexpr std::size_t kShown = 3;
  if (unsettled.empty()) return {};
  const std::size_t shown = std::min(kShown, unsettled.size());
  std::string words = fmt::format(
      "; {}",
      fmt::join(unsettled.begin(), unsettled.begin() + static_cast<std::ptrdiff_t>(shown), ", "));
  if (shown < unsettled.size()) words += fmt::format(" and {} more", unsettled.size() - shown);
  return words + (unsettled.size() == 1 ? " was not" : " were not");
}

/// "; 3 were not looked at".
std::string not_looked_at_words(std::size_t count) {
  if (count == 0) return {};
  return fmt::format("; {} {} not looked at", count, count == 1 ? "was" : "were");
}

/// What is known of a design whose combination was not found by trying all.
std::string neighbour_words(const CombinationTally& tally) {
  if (tally.enumerated || !tally.neighbours_tried) return {};
  return fmt::format(
      "; no search in those one step away in one integer variable, or in two at once, led to a "
      "better one ({} problems solved)",
      tally.solved);
}

}  // namespace

void judge_combinations(const CombinationTally& tally, Assessment& a) {
  if (tally.combinations == 1) return;
  a.best_possible.reset();  // what bounds one combination says nothing of the others
  const std::string how =
      tally.enumerated ? fmt::format("all {} combinations were solved", tally.combinations)
                       : fmt::format("{} combinations by branch and bound ({} problems solved)",
                                     tally.combinations, tally.solved);
  if (!tally.complete && a.verdict == Verdict::Certified) {
    a.verdict = Verdict::Feasible;
    a.reason = fmt::format("not all of the {} combinations were settled{}", tally.combinations,
                           unsettled_words(tally.unsettled) + not_looked_at_words(tally.missed));
    a.reason += neighbour_words(tally);
    if (!tally.stopped.empty()) a.reason = tally.stopped + "; " + a.reason;
    a.global.reset();
    return;
  }
  if (!tally.enumerated && !tally.bounds_hold && a.verdict == Verdict::Certified) {
    a.verdict = Verdict::Feasible;
    a.reason =
        "combinations were excluded by bounds that hold only locally, as the rest of the problem "
        "is not convex" +
        neighbour_words(tally);
    a.global.reset();
    return;
  }
  if (a.verdict == Verdict::Infeasible) {
    if (!tally.all_infeasible || !tally.complete) {
      a.verdict = Verdict::Failed;
      a.reason = "no combination was solved, and not all are infeasible";
      if (!tally.stopped.empty()) {
        a.reason = fmt::format("{} after {} of {} combinations, none of which can be met",
                               tally.stopped, tally.solved, tally.combinations);
      }
    } else {
      a.reason = fmt::format(
          "none of the {} combinations meets the limits; in the one that comes nearest, {}",
          tally.combinations, a.reason);
    }
    a.global.reset();
    if (tally.bounds_hold && a.verdict == Verdict::Infeasible)
      a.global = how + ", and each is known to have no design within the limits";
    return;
  }
  if (a.verdict != Verdict::Certified) return;
  a.global.reset();
  if (tally.bounds_hold) a.global = how + ", each convex in the other variables";
  a.reason = fmt::format("{}; {}", a.reason, how);
}

}  // namespace camlaw::optim
