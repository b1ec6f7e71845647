// SPDX-License-Identifier: MIT
#include "optim/search/optimise.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "optim/crew/crew.h"
#include "optim/search/combinations.h"
#include "optim/search/discrete.h"
#include "optim/search/hopeless.h"
#include "optim/verdict/verdict.h"

namespace camlaw::optim {
namespace {

/// How the combinations went, for the words of the verdict.
struct StartTally {
  std::size_t combinations = 0, solved = 0, missed = 0;
  bool all_infeasible = true, complete = true, bounds_hold = true, enumerated = true;
  std::string stopped = {};                 ///< why the search ended early, where it did
  std::vector<std::string> unsettled = {};  ///< combinations of choices, in words
};

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

/// What a search over combinations adds to the verdict of the best one.
void judge_combinations(const StartTally& tally, Assessment& a) {
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
    if (!tally.stopped.empty()) a.reason = tally.stopped + "; " + a.reason;
    a.global.reset();
    return;
  }
  if (!tally.enumerated && !tally.bounds_hold && a.verdict == Verdict::Certified) {
    a.verdict = Verdict::Feasible;
    a.reason =
        "combinations were excluded by bounds that hold only locally, as the rest of the problem "
        "is not convex";
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

class Optimiser {
 public:
  Optimiser(const ProblemSpace& space, const OptimiseOptions& options)
      : options_(options),
        deadline_(options.time_limit, options.stop, options.spent),
        desk_(std::make_shared<SearchDesk>(space)),
        combinations_(options_, deadline_, desk_,
                      [this](SearchedPart part) { take(std::move(part)); }) {}
  Optimiser(const Optimiser&) = delete;
  Optimiser& operator=(const Optimiser&) = delete;

  Optimum run(Crew& crew) {
    crew.run(combinations_, search_service(desk_));
    combinations_.end_here();
    settle();
    return std::move(best_);
  }

 private:
  void take(SearchedPart part) {
    const IntegerOutcome& search = part.outcome;
    tally_.combinations += search.combinations;
    tally_.solved += search.solved;
    tally_.complete = tally_.complete && search.complete;
    if (!search.complete && !part.options.empty()) tally_.unsettled.push_back(words_of(part));
    tally_.bounds_hold = tally_.bounds_hold && search.bounds_hold;
    tally_.enumerated = tally_.enumerated && search.enumerated;
    tally_.all_infeasible = tally_.all_infeasible && search.all_infeasible;
    work_.add_work(search.found);
    const Assessment& a = search.found.assessment;
    best_.parts.push_back({part.options, search.found.x, a.objective.value, a.verdict,
                           a.verdict == Verdict::Infeasible ? a.blamed : a.active,
                           search.complete && (search.enumerated || search.bounds_hold)});
    if (started_ && !better(part.problem, search.found.assessment, best_.found.assessment)) return;
    started_ = true;
    best_.options = std::move(part.options);
    best_.problem = std::move(part.problem);
    best_.found = std::move(part.outcome.found);
  }

  /// The options of a combination, as a person chooses them.
  std::string words_of(const SearchedPart& part) const {
    std::string words;
    for (std::size_t i = 0; i < part.options.size(); ++i) {
      const Choice& choice = desk_->space().choices[i];
      const std::string& option = choice.options[part.options[i]];
      words += words.empty() ? "" : " ";
      words += choice.values.empty() ? option : fmt::format("{}={}", choice.name, option);
    }
    return words;
  }

  /// The winner, solved once more with its integer variables fixed, and proved.
  void settle() {
    tally_.missed = combinations_.not_looked_at();
    tally_.combinations += tally_.missed;
    tally_.complete = tally_.complete && combinations_.not_looked_at() == 0;
    best_.combinations = tally_.combinations;
    best_.solved = tally_.solved;
    if (deadline_.passed()) tally_.stopped = deadline_.reason();
    if (!combinations_.lost().empty()) tally_.complete = false;
    if (tally_.stopped.empty()) tally_.stopped = combinations_.lost();
    Found& found = best_.found;
    blame_fewest();
    if (combinations_.is_of_one()) return say_lost(found.assessment);
    if (is_feasible(found.assessment) && !found.x.empty() && !deadline_.passed()) {
      Problem fixed = with_integers_fixed(best_.problem, found.x);
      for (std::size_t i = 0; i < fixed.variables.size(); ++i) {
        fixed.variables[i].start = found.x[i];
      }
      OptimiseOptions once = options_;
      once.starts = 1;
      Found proved = search_continuous(fixed, once, deadline_, Depth::Whole);
      if (is_feasible(proved.assessment) && proved.assessment.verdict != Verdict::Failed) {
        proved.starts = found.starts;
        proved.agreed = found.agreed;
        found = std::move(proved);
      } else if (!deadline_.passed()) {
        // What was found without a proof may break a limit where only a proof looks.
        found.assessment = assess(fixed, scales(fixed, found.x), found.x, true);
      }
      work_.add_work(found);
    }
    found.evaluations = work_.evaluations;
    found.iterations = work_.iterations;
    found.solves = work_.solves;
    judge_combinations(tally_, found.assessment);
    Assessment& a = found.assessment;
    const bool told = tally_.stopped.empty() || a.reason.starts_with(tally_.stopped);
    if (a.verdict == Verdict::Feasible && !told) {
      a.reason = fmt::format("{}; {}", tally_.stopped, a.reason);
    }
  }

  void blame_fewest() {
    Found& found = best_.found;
    const bool is_known = found.assessment.verdict == Verdict::Infeasible && !found.x.empty();
    if (!is_known || deadline_.passed()) return;
    narrow_blame(
        with_integers_fixed(best_.problem, found.x),
        [&](const Problem& others) {
          Found without = search_continuous(others, options_, deadline_, Depth::Combination);
          work_.add_work(without);
          found.add_work(without);
          return std::move(without.assessment);
        },
        found.assessment);
    for (PartFound& part : best_.parts) {
      if (part.options == best_.options) part.active = found.assessment.blamed;
    }
  }

  /// Where the process of a start has died its answer might have been better.
  void say_lost(Assessment& a) const {
    const bool is_optimum = a.verdict == Verdict::Certified;
    const bool may_change = is_optimum || a.verdict == Verdict::Infeasible;
    if (combinations_.lost().empty() || !may_change || a.global) return;
    a.verdict = is_optimum ? Verdict::Feasible : Verdict::Failed;
    a.reason = fmt::format("{}; {}", combinations_.lost(), a.reason);
  }

  const OptimiseOptions& options_;
  Deadline deadline_;
  std::shared_ptr<SearchDesk> desk_;
  Combinations combinations_;
  StartTally tally_;
  Optimum best_;
  bool started_ = false;
  Found work_;  ///< what all combinations took, and nothing else
};

}  // namespace

Optimum optimise(const ProblemSpace& space, const OptimiseOptions& options) {
  Crew nobody_else({.workers = 1});
  return optimise(space, options, nobody_else);
}

Optimum optimise(const ProblemSpace& space, const OptimiseOptions& options, Crew& crew) {
  check_solvers(options);
  if (options.starts && *options.starts < 1) {
    throw std::invalid_argument("starts: at least one is needed");
  }
  const auto began = std::chrono::steady_clock::now();
  Optimum result = Optimiser(space, options).run(crew);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - began;
  result.wall_s = spent.count();
  return result;
}

Optimum optimise(const Problem& problem, const OptimiseOptions& options) {
  return optimise(ProblemSpace::of(problem), options);
}

}  // namespace camlaw::optim
