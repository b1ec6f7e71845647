// SPDX-License-Identifier: MIT
#include "optim/search/optimise.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>

#include "optim/cycle/sizes.h"
#include "optim/search/discrete.h"
#include "optim/search/interruptible.h"
#include "optim/search/memory.h"
#include "optim/solvers/solver.h"
#include "optim/verdict/subdivision.h"
#include "optim/verdict/verdict.h"

namespace camlaw::optim {
namespace {

/// The n-th option of a choice, counted from the one it starts with outwards: 5, 6, 4, 7, 3, ...
std::size_t nth_option(const Choice& choice, std::size_t n) {
  const std::size_t count = choice.options.size(), start = std::min(choice.start, count - 1);
  const std::size_t both = std::min(start, count - 1 - start);  // so far there are two sides
  if (n > 2 * both) return start > both ? count - 1 - n : n;
  return n % 2 == 1 ? start + (n + 1) / 2 : start - n / 2;
}

/// Options as digits of a counter, the last fastest; the first combination is the start's.
std::vector<std::size_t> options_at(const std::vector<Choice>& choices, std::size_t count) {
  std::vector<std::size_t> result(choices.size());
  for (std::size_t i = choices.size(); i-- > 0;) {
    result[i] = nth_option(choices[i], count % choices[i].options.size());
    count /= choices[i].options.size();
  }
  return result;
}

/// How the combinations went, for the words of the verdict.
struct Tally {
  std::size_t combinations = 0, solved = 0;
  bool all_infeasible = true, complete = true, bounds_hold = true, enumerated = true;
  std::string stopped = {};  ///< why the search ended early, where it did
};

/// The lower bound of an answer by dividing the box; none where the model throws on the way.
std::optional<Subdivision> division_of(const Problem& problem, const Sizes& there,
                                       const Found& found, const Deadline& deadline) {
  try {
    return subdivided(problem, there, found.x, [&] { return deadline.passed(); });
  } catch (...) {
    return {};
  }
}

/// A search from one design, which is kept where the search comes to nothing better.
Found search_from(const Problem& problem, const std::vector<double>& x, const OptimiseOptions& how,
                  const Deadline& deadline) {
  Problem again = problem;
  for (std::size_t k = 0; k < x.size(); ++k) again.variables[k].start = x[k];
  OptimiseOptions once = how;
  once.starts = 1;
  const Problem guarded = interruptible(problem, deadline);
  const Assessment own = assess(guarded, sizes(guarded, x), x, true);
  // A long first step may lead into the valley that was found before: then another method tries.
  Found found = search_continuous(again, once, deadline, true);
  if (better(problem, own, found.assessment) && how.solver == "auto" && !deadline.passed()) {
    once.solver = "ipopt";
    Found other = search_continuous(again, once, deadline, true);
    if (better(problem, other.assessment, found.assessment)) found = std::move(other);
  }
  if (better(problem, own, found.assessment)) {
    found.x = x;
    found.assessment = own;
  }
  return found;
}

/// Where no lower bound speaks for an answer, one by dividing the box. Where that comes upon a
/// better design, another search from there. Throws Interrupted, with what was found by then.
void look_everywhere(const Problem& problem, const OptimiseOptions& how, const Deadline& deadline,
                     Found& found) {
  constexpr int kTimes = 8;
  const Problem guarded = interruptible(problem, deadline);
  for (int i = 0; i <= kTimes && how.divides && !deadline.passed(); ++i) {
    const Assessment& a = found.assessment;
    const bool stands = a.verdict == Verdict::Certified || a.verdict == Verdict::Feasible;
    if (!stands || a.global) break;
    const Sizes there = sizes(guarded, found.x);
    const auto division = division_of(guarded, there, found, deadline);
    if (!division) break;
    if (!division->better) {
      take_subdivision(guarded, there, *division, found.assessment);
      break;
    }
    if (i == kTimes) break;
    Found other = search_from(problem, *division->better, how, deadline);
    if (!better(problem, other.assessment, found.assessment)) break;
    other.add_work(found);
    other.starts += found.starts;
    other.planned_starts += found.planned_starts;
    found = std::move(other);
  }
}

/// A search, and a look at what it may have missed while there is time.
Found search_everywhere(const Problem& problem, const OptimiseOptions& how,
                        const Deadline& deadline) {
  Found found = search_continuous(problem, how, deadline, true);
  try {
    look_everywhere(problem, how, deadline, found);
  } catch (const Interrupted&) {  // the answer stands without
  }
  return found;
}

/// What a search over combinations adds to the verdict of the best one.
void judge_combinations(const Tally& tally, Assessment& a) {
  if (tally.combinations == 1) return;
  a.best_possible.reset();  // what bounds one combination says nothing of the others
  const std::string how =
      tally.enumerated ? fmt::format("all {} combinations were solved", tally.combinations)
                       : fmt::format("{} combinations by branch and bound ({} problems solved)",
                                     tally.combinations, tally.solved);
  if (!tally.complete && a.verdict == Verdict::Certified) {
    a.verdict = Verdict::Feasible;
    a.reason = fmt::format("not every one of the {} combinations was settled", tally.combinations);
    if (!tally.stopped.empty()) a.reason = tally.stopped + "; " + a.reason;
    a.global.reset();
    return;
  }
  if (!tally.enumerated && !tally.bounds_hold && a.verdict == Verdict::Certified) {
    a.verdict = Verdict::Feasible;
    a.reason = "combinations were excluded by bounds that hold nearby only: the rest is not convex";
    a.global.reset();
    return;
  }
  if (a.verdict == Verdict::Infeasible) {
    if (!tally.all_infeasible || !tally.complete) {
      a.verdict = Verdict::Failed;
      a.reason = "no combination was solved, and not every one is infeasible";
      if (!tally.stopped.empty()) {
        a.reason = fmt::format("{} after {} of {} combinations, none of which can be met",
                               tally.stopped, tally.solved, tally.combinations);
      }
    } else {
      a.reason = fmt::format("{}, in the combination of least violation; none of {} can be met",
                             a.reason, tally.combinations);
    }
    a.global.reset();
    if (tally.bounds_hold && a.verdict == Verdict::Infeasible)
      a.global = how + ", each leaves a convex set, and all are empty";
    return;
  }
  if (a.verdict != Verdict::Certified) return;
  a.global.reset();
  if (tally.bounds_hold) a.global = how + ", each convex in the rest";
  a.reason = fmt::format("{}; {}", a.reason, how);
}

class Optimiser {
 public:
  Optimiser(const ProblemSpace& space, const OptimiseOptions& options)
      : space_(space),
        options_(options),
        deadline_(options.time_limit, options.stop, options.spent) {}

  Optimum run() {
    const std::size_t count = space_.parts();
    tally_.combinations = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (deadline_.passed() && i > 0) {
        tally_.complete = false;
        tally_.combinations += count - i;
        break;
      }
      std::vector<std::size_t> options = options_at(space_.choices, i);
      OptimiseOptions how = part_of_progress(i, count);
      if (options_.candidate) {
        how.candidate = [this, options](Candidate c) {
          c.options = options;
          options_.candidate(c);
        };
      }
      solve(std::move(options), how);
    }
    settle();
    return std::move(best_);
  }

 private:
  /// What is reported of one combination, as part of all.
  OptimiseOptions part_of_progress(std::size_t i, std::size_t count) const {
    OptimiseOptions result = options_;
    if (!options_.progress) return result;
    result.progress = [this, i, count](Progress progress) {
      progress.done = (static_cast<double>(i) + progress.done) / static_cast<double>(count);
      options_.progress(progress);
    };
    return result;
  }

  void solve(std::vector<std::size_t> options, const OptimiseOptions& how) {
    Problem problem = space_.problem(options);
    problem.check();
    if (problem.objectives.size() > 1) {
      throw std::invalid_argument(fmt::format(
          "optimise() takes one objective, but this problem has {}; use pareto() to find "
          "their front",
          problem.objectives.size()));
    }
    if (options_.memory) check_memory(problem, *options_.memory);
    const bool alone = space_.choices.empty() && !has_integers(problem);
    if (alone) {
      tally_.combinations = tally_.solved = 1;
      best_.problem = std::move(problem);
      best_.found = search_everywhere(best_.problem, how, deadline_);
      return;
    }
    IntegerOutcome search = search_integers(problem, how, deadline_);
    tally_.combinations += search.combinations;
    tally_.solved += search.solved;
    tally_.complete = tally_.complete && search.complete;
    tally_.bounds_hold = tally_.bounds_hold && search.bounds_hold;
    tally_.enumerated = tally_.enumerated && search.enumerated;
    tally_.all_infeasible = tally_.all_infeasible && search.all_infeasible;
    work_.add_work(search.found);
    if (!started_ || better(problem, search.found.assessment, best_.found.assessment)) {
      best_.options = std::move(options);
      best_.problem = std::move(problem);
      best_.found = std::move(search.found);
    }
    started_ = true;
  }

  static bool has_integers(const Problem& problem) {
    return std::any_of(problem.variables.begin(), problem.variables.end(),
                       [](const Variable& v) { return v.integer; });
  }

  /// The winner, solved once more with its integer variables fixed, and proved.
  void settle() {
    best_.combinations = tally_.combinations;
    if (deadline_.passed()) tally_.stopped = deadline_.reason();
    best_.solved = tally_.solved;
    if (!started_) return;
    Found& found = best_.found;
    if (is_feasible(found.assessment) && !found.x.empty() && !deadline_.passed()) {
      Problem fixed = with_integers_fixed(best_.problem, found.x);
      for (std::size_t i = 0; i < fixed.variables.size(); ++i) {
        fixed.variables[i].start = found.x[i];
      }
      OptimiseOptions once = options_;
      once.starts = 1;
      Found proved = search_continuous(fixed, once, deadline_, true);
      if (is_feasible(proved.assessment) && proved.assessment.verdict != Verdict::Failed) {
        proved.starts = found.starts;
        proved.agreed = found.agreed;
        found = std::move(proved);
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

  const ProblemSpace& space_;
  const OptimiseOptions& options_;
  Deadline deadline_;
  Tally tally_;
  Optimum best_;
  bool started_ = false;
  Found work_;  ///< what all combinations took, and nothing else
};

}  // namespace

Optimum optimise(const ProblemSpace& space, const OptimiseOptions& options) {
  check_solvers(options);
  if (options.starts && *options.starts < 1) {
    throw std::invalid_argument("starts: at least one is needed");
  }
  const auto began = std::chrono::steady_clock::now();
  Optimum result = Optimiser(space, options).run();
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - began;
  result.wall_s = spent.count();
  return result;
}

Optimum optimise(const Problem& problem, const OptimiseOptions& options) {
  return optimise(ProblemSpace::of(problem), options);
}

}  // namespace camlaw::optim
