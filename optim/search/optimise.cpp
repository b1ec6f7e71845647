// SPDX-License-Identifier: MIT
#include "optim/search/optimise.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "optim/crew/crew.h"
#include "optim/search/combinations.h"
#include "optim/search/discrete.h"
#include "optim/search/hopeless.h"
#include "optim/search/tally.h"
#include "optim/verdict/subdivision.h"
#include "optim/verdict/verdict.h"

namespace camlaw::optim {
namespace {

/// What meets the limits of a combination, as far as is seen without a proof.
struct Contender {
  std::vector<std::size_t> options;
  IntegerDesign design;
  bool of_tree;
};

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
    if (!search.complete && !part.options.empty())
      tally_.unsettled.push_back(words_of(part.options));
    tally_.bounds_hold = tally_.bounds_hold && search.bounds_hold;
    tally_.enumerated = tally_.enumerated && search.enumerated;
    tally_.neighbours_tried =
        tally_.neighbours_tried && (search.enumerated || search.neighbours_tried);
    tally_.all_infeasible = tally_.all_infeasible && search.all_infeasible;
    const bool all_told = search.enumerated && search.complete &&
                          search.infeasible + search.designs.size() == search.solved;
    rest_infeasible_ = rest_infeasible_ && (search.all_infeasible || all_told);
    for (const IntegerDesign& design : search.designs)
      contenders_.push_back({part.options, design, !search.enumerated});
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
  std::string words_of(const std::vector<std::size_t>& options) const {
    std::string words;
    for (std::size_t i = 0; i < options.size(); ++i) {
      const Choice& choice = desk_->space().choices[i];
      const std::string& option = choice.options[options[i]];
      words += words.empty() ? "" : " ";
      words += choice.values.empty() ? option : fmt::format("{}={}", choice.name, option);
    }
    return words;
  }

  /// The winner, proved, and what is said of it.
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
    if (is_feasible(found.assessment) && !found.x.empty() && !deadline_.passed()) prove_best();
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

  /// Proves the best design. A proof may leave no design in its combination, or a worse one: then
  /// the best of the others, which may be better, is proved too.
  void prove_best() {
    std::stable_sort(contenders_.begin(), contenders_.end(), [&](const auto& a, const auto& b) {
      return signed_value(a.design.objective) < signed_value(b.design.objective);
    });
    std::vector<Found> proofs;
    std::optional<std::size_t> best;
    for (const Contender& next : contenders_) {
      if (best && !is_ahead(next.design.objective, proofs[*best].assessment)) break;
      if (best && deadline_.passed()) {
        tally_.complete = false;
        break;
      }
      const Problem fixed = with_start(problem_of(next), next.design);
      proofs.push_back(proved(fixed, next.design));
      const bool is_design = is_feasible(proofs.back().assessment);
      if (deadline_.passed() && !is_design && !best) {
        if (proofs.size() == 1) return;  // the best is as it was found
        proofs.back() = cut_short(fixed, next.design.x, deadline_.reason());
        best = proofs.size() - 1;
      } else if (is_design &&
                 (!best || better(fixed, proofs.back().assessment, proofs[*best].assessment))) {
        best = proofs.size() - 1;
      }
    }
    if (!proofs.empty()) take_proofs(std::move(proofs), best);
  }

  void take_proofs(std::vector<Found> proofs, std::optional<std::size_t> best) {
    bool all_infeasible = rest_infeasible_ && proofs.size() == contenders_.size();
    for (std::size_t i = 0; i < proofs.size(); ++i) {
      const Contender& contender = contenders_[i];
      const Assessment& a = proofs[i].assessment;
      // Nodes of a tree were cut by what was found.
      const bool is_worse = !is_feasible(a) || is_ahead(contender.design.objective, a);
      if (is_worse && contender.of_tree) tally_.complete = false;
      all_infeasible = all_infeasible && a.verdict == Verdict::Infeasible;
      if (i == best) continue;
      take_settled(contender, a);
      restate_part(i, proofs[i]);
    }
    if (!best) tally_.all_infeasible = all_infeasible;
    const std::size_t winner = best.value_or(0);
    if (winner > 0) {
      best_.problem = problem_of(contenders_[winner]);
      best_.options = contenders_[winner].options;
    }
    best_.found = std::move(proofs[winner]);
  }

  /// Whether a proof settles its combination, as the answer does not say where it is another one.
  void take_settled(const Contender& contender, const Assessment& a) {
    const bool is_empty = a.verdict == Verdict::Infeasible;
    tally_.bounds_hold = tally_.bounds_hold && (is_empty ? a.global.has_value() : a.is_global);
    if (is_empty || is_settled(a)) return;
    tally_.complete = false;
    const std::string words = words_of(contender.options);
    auto& unsettled = tally_.unsettled;
    const bool is_told = std::find(unsettled.begin(), unsettled.end(), words) != unsettled.end();
    if (!words.empty() && !is_told) unsettled.push_back(words);
  }

  /// Where what a combination of choices had was proved otherwise: what it has now, or the next
  /// best of its whole numbers.
  void restate_part(std::size_t contender, const Found& proof) {
    const Contender& of = contenders_[contender];
    const Assessment& a = proof.assessment;
    const auto part = std::find_if(best_.parts.begin(), best_.parts.end(), [&](const auto& p) {
      return p.options == of.options && p.x == of.design.x;
    });
    if (part == best_.parts.end()) return;
    const auto next = std::find_if(
        contenders_.begin() + static_cast<std::ptrdiff_t>(contender) + 1, contenders_.end(),
        [&](const Contender& other) { return other.options == of.options; });
    const bool is_next =
        next != contenders_.end() && (!is_feasible(a) || is_ahead(next->design.objective, a));
    if (is_next) {
      *part = {of.options, next->design.x, next->design.objective, Verdict::Feasible, {}};
    } else {
      const auto& held_by = a.verdict == Verdict::Infeasible ? a.blamed : a.active;
      *part = {of.options, proof.x, a.objective.value, a.verdict, held_by};
    }
  }

  /// What a search for the least sees of an objective's value.
  double signed_value(double objective) const {
    return best_.problem.objective().sense == Sense::Minimize ? objective : -objective;
  }

  /// Whether an objective is better than that of a judged design by more than counts.
  bool is_ahead(double objective, const Assessment& judged) const {
    const double value = judged.objective.value;
    const double gap = std::max(kBoundTolerance * std::abs(value), judged.objective.tolerance);
    return signed_value(objective) < signed_value(value) - gap;
  }

  const Problem& problem_of(const Contender& contender) {
    return contender.options == best_.options ? best_.problem : desk_->problem(contender.options);
  }

  /// The problem with its integer variables fixed at a design's, to be begun from there.
  static Problem with_start(const Problem& problem, const IntegerDesign& design) {
    Problem fixed = with_integers_fixed(problem, design.x);
    for (std::size_t i = 0; i < fixed.variables.size(); ++i) {
      fixed.variables[i].start = design.x[i];
    }
    return fixed;
  }

  /// A design, solved once more and proved; where that leads to none, itself.
  Found proved(const Problem& fixed, const IntegerDesign& design) {
    OptimiseOptions once = options_;
    once.starts = 1;
    Found found = search_continuous(fixed, once, deadline_, Depth::Whole);
    work_.add_work(found);
    found.starts = design.starts;
    found.agreed = design.agreed;
    const bool is_design = is_feasible(found.assessment);
    if ((is_design && found.assessment.verdict != Verdict::Failed) || deadline_.passed())
      return found;
    // What was found without a proof may break a limit where only a proof looks.
    Assessment own = assess(fixed, scales(fixed, design.x), design.x, true);
    if (found.assessment.verdict == Verdict::Infeasible && !is_feasible(own)) return found;
    found.x = design.x;
    found.assessment = std::move(own);
    return found;
  }

  /// Whether a design meets the limits of a problem that only asks for one: first from the design
  /// of least violation alone; where that is led to none, and it is not known that there is none,
  /// as any other search is.
  Assessment met_by_any(Problem posed, Found& nearest) {
    constexpr int kFewIterations = 200;  // of a solver: no optimum is asked for
    for (std::size_t i = 0; i < posed.variables.size(); ++i) {
      Variable& v = posed.variables[i];
      v.start = std::clamp(nearest.x[i], v.lower, v.upper);
    }
    OptimiseOptions how = options_;
    how.divides = false;
    how.max_iterations = std::min(how.max_iterations, kFewIterations);
    how.starts = 1;
    Assessment without;
    for (const auto& starts : {how.starts, options_.starts}) {
      how.starts = starts;
      Found found = search_continuous(posed, how, deadline_, Depth::Combination);
      work_.add_work(found);
      nearest.add_work(found);
      without = std::move(found.assessment);
      if (is_feasible(without) || without.global || options_.starts == 1) break;
    }
    return without;
  }

  void blame_fewest() {
    Found& found = best_.found;
    const bool is_known = found.assessment.verdict == Verdict::Infeasible && !found.x.empty();
    if (!is_known || !options_.narrows || deadline_.passed()) return;
    Problem whole = with_integers_fixed(best_.problem, found.x);
    // What is asked is whether any design meets the other limits, not which is best.
    whole.objectives = {no_objective()};
    narrow_blame(
        std::move(whole), [&](const Problem& others) { return met_by_any(others, found); },
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
  CombinationTally tally_;
  Optimum best_;
  bool started_ = false;
  std::vector<Contender> contenders_;
  bool rest_infeasible_ = true;  ///< all but the contenders are known to have no design
  Found work_;                   ///< what all combinations took, and nothing else
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
