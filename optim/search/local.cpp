// SPDX-License-Identifier: MIT
#include "optim/search/local.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "optim/cycle/remembered.h"
#include "optim/cycle/watched.h"
#include "optim/problem/starts.h"
#include "optim/search/exchange.h"
#include "optim/search/interruptible.h"
#include "optim/search/least_violating.h"
#include "optim/search/plan.h"
#include "optim/search/rescaling.h"
#include "optim/search/with_numbers.h"
#include "optim/verdict/limits.h"
#include "optim/verdict/verdict.h"

namespace camlaw::optim {
namespace {

/// What a limit's tolerance depends on, and nothing else: every size but those of the variables
/// is 1. For a design that is looked at when there is no time left for more.
Sizes hasty_sizes(const Problem& problem, Design about) {
  Sizes result;
  result.variables = typical_scales(problem, about);
  result.objective = result.objective_typical = 1;
  result.constraints.assign(problem.constraints.size(), {1, 0, 0});
  return judged_at(problem, std::move(result), about);
}

std::string words_of(const std::exception_ptr& error) {
  try {
    std::rethrow_exception(error);
  } catch (const std::bad_alloc&) {
    return "there is not enough memory";
  } catch (const std::exception& e) {
    return e.what();
  } catch (...) {
    return "something that is not a std::exception";
  }
}

/// An exception of a search, and who let it out: the model, or a solver that was registered.
struct Thrown {
  std::exception_ptr error = {};
  std::string who = "the model threw";

  explicit operator bool() const { return error != nullptr; }
  std::string words() const { return fmt::format("{}: {}", who, words_of(error)); }
};

class Search {
 public:
  Search(const Problem& problem, const OptimiseOptions& options, const Deadline& deadline,
         bool prove)
      : original_(problem),
        guarded_(interruptible(problem, deadline)),
        problem_(remembered(guarded_)),
        options_(options),
        deadline_(deadline),
        prove_(prove),
        convex_(why_convex(problem).has_value()),
        convex_set_(convex_set(problem)),
        plan_(plan(problem, options.solver)) {
    found_.why_solver = plan_.why;
    found_.solver = plan_.solvers.front()->name();
  }

  Found run() {
    try {
      if (problem_.variables.empty()) return judge_alone();
      sizes_ = sizes(problem_, problem_.start());
      if (const auto why =
              optim::refusal(problem_, sizes_, problem_.start(), *plan_.solvers.front())) {
        return fail(*why);
      }
      if (judge_constants()) return std::move(found_);
      search_starts();
      finish();
    } catch (const Interrupted&) {
      return end_in_haste();
    } catch (...) {
      thrown_ = {std::current_exception()};
    }
    if (thrown_ && !is_feasible(found_.assessment)) {
      return fail(thrown_.words());
    }
    return std::move(found_);
  }

 private:
  /// A problem in which nothing varies: there is one design.
  Found judge_alone() {
    sizes_ = sizes(problem_, {});
    found_.starts = found_.agreed = 1;
    found_.status = Status::Solved;
    found_.assessment = assess(problem_, sizes_, {}, true);
    if (is_feasible(found_.assessment)) return std::move(found_);
    const Assessment blame = assess_least_violation(problem_, sizes_, {});
    if (blame.verdict == Verdict::Infeasible) found_.assessment = blame;
    return std::move(found_);
  }

  /// A limit that nothing moves which varies needs no search: where it is passed, that is all.
  bool judge_constants() {
    const std::vector<double> start = problem_.start();
    for (std::size_t i = 0; i < problem_.constraints.size(); ++i) {
      const Constraint& c = problem_.constraints[i];
      if (c.response.is_curve() || !is_constant(c.response.function())) continue;
      const double value = c.response.function().value(start);
      const double tolerance = sizes_.constraints[i].tolerance;
      const bool met = value >= c.lower.value_or(-kInfinity) - tolerance &&
                       value <= c.upper.value_or(kInfinity) + tolerance;
      if (met || std::isnan(value)) continue;
      found_.x = start;
      found_.starts = found_.agreed = found_.planned_starts = 1;
      found_.assessment = assess(problem_, sizes_, start, false);
      found_.assessment.verdict = Verdict::Infeasible;
      found_.assessment.blamed = {c.response.name};
      found_.assessment.reason =
          fmt::format("{} cannot be met: nothing that varies moves it", c.response.name);
      found_.assessment.global = fmt::format("{} is the same for every design", c.response.name);
      return true;
    }
    return false;
  }

  bool is_constant(const Function& f) const {
    return std::all_of(f.inputs().begin(), f.inputs().end(), [&](std::size_t i) {
      return problem_.variables[i].lower == problem_.variables[i].upper;
    });
  }

  Found fail(const std::string& why) {
    found_.assessment.verdict = Verdict::Failed;
    found_.assessment.reason = why;
    return std::move(found_);
  }

  SolverOptions solver_options() const {
    SolverOptions result;
    result.max_iterations = options_.max_iterations;
    result.max_evaluations = options_.max_evaluations;
    result.time_limit = deadline_.left();
    result.seed = options_.seed;
    result.stop = options_.stop;
    if (!options_.progress) return result;
    result.progress = [this](Progress progress) {
      const int planned = std::max(found_.planned_starts, 1);
      progress.done = static_cast<double>(std::max(found_.starts - 1, 0)) / planned;
      options_.progress(progress);
    };
    return result;
  }

  Attempt attempt(Design start, const Solver& solver, Aim aim = Aim::Optimum) {
    // Where one start has used up its iterations in vain, there may be no design to be found.
    constexpr int kShare = 4;
    SolverOptions how = solver_options();
    if (const auto native = options_.native.find(solver.name()); native != options_.native.end())
      how.native = native->second;
    if (in_vain_ && aim == Aim::Optimum && !is_feasible(found_.assessment))
      how.max_iterations = 1 + how.max_iterations / kShare;
    Attempt result = exchange(problem_, sizes_, start, solver, how, aim);
    found_.iterations += result.iterations;
    found_.evaluations += result.evaluations;
    found_.solves += result.rounds;
    if (!result.x.empty()) latest_design_ = result.x;
    if (is_interruption(result.error)) throw Interrupted();
    if (result.error) thrown_ = {result.error, result.message};
    return result;
  }

  void tell(const std::vector<double>& x, bool is_best) const {
    if (options_.candidate) options_.candidate({{}, x, is_best});
  }

  /// The best design so far, where there is no time to look at it closely.
  Found end_in_haste() {
    try {
      const Problem plain = remembered(original_);
      const auto consider_in_haste = [&](const std::vector<double>& x) {
        const bool sized = sizes_.constraints.size() == plain.constraints.size();
        Assessment a = assess_in_haste(plain, sized ? sizes_ : hasty_sizes(plain, x), x);
        if (!found_.x.empty() && !better(plain, a, found_.assessment)) return;
        found_.x = x;
        found_.assessment = std::move(a);
      };
      if (!latest_design_.empty() && latest_design_ != found_.x) consider_in_haste(latest_design_);
      consider_in_haste(plain.start());
    } catch (...) {
      thrown_ = {std::current_exception()};
      return fail(thrown_.words());
    }
    if (found_.assessment.verdict == Verdict::Infeasible) return std::move(found_);
    constexpr double kNothing = 1e-3;  // s, the least that a deadline says is left
    const bool late = deadline_.left().value_or(kInfinity) <= kNothing;
    found_.status = late ? Status::TimeLimit : Status::Stopped;
    judge();
    return std::move(found_);
  }

  /// Takes the design where it is better than what was found before.
  void consider(const Attempt& tried, const Solver& solver) {
    latest_ = {};
    unbounded_ = unbounded_ || tried.status == Status::Unbounded;
    if (tried.x.empty()) return;
    tell(tried.x, false);
    const Assessment assessment = assess(problem_, sizes_, tried.x, false);
    latest_ = assessment;
    if (improves(assessment, from_start_)) from_start_ = assessment;
    if (!found_.x.empty() && !improves(assessment, found_.assessment)) return;
    found_.x = tried.x;
    found_.assessment = assessment;
    found_.status = tried.status;
    found_.solver = solver.name();
    message_ = tried.message;
    tell(found_.x, true);
  }

  /// Better, or as good to 1e-6 (by passing limits within their tolerance a design may look better
  /// than the optimum) and the conditions of optimality hold where they did not.
  bool improves(const Assessment& fresh, const Assessment& old) const {
    const double a = fresh.objective.value, b = old.objective.value;
    const bool alike = is_feasible(fresh) && is_feasible(old) &&
                       std::abs(a - b) <= 1e-6 * std::max(std::abs(b), sizes_.objective);
    if (alike && is_settled(fresh) != is_settled(old)) return is_settled(fresh);
    return better(problem_, fresh, old);
  }

  /// One start, through the methods of the plan until the conditions of optimality hold. Scaled by
  /// the start; a search that ends far from it is done again, scaled by its end.
  void search_from(Design start) {
    std::vector<double> x(start.begin(), start.end());
    if (found_.solves > 0) sizes_ = sizes(problem_, x);  // of the first they are known
    for (const Solver* solver : plan_.solvers) {
      const Attempt tried = attempt(x, *solver);
      consider(tried, *solver);
      if (tried.error || deadline_.passed()) return;
      if (solver->is_global() && !tried.x.empty()) {
        x = tried.x;  // polished by the next
        continue;
      }
      // Where all iterations led to no design within the limits, other sizes lead to none either.
      const bool in_vain =
          tried.status == Status::IterationLimit && !is_feasible(found_.assessment);
      in_vain_ = in_vain_ || in_vain;
      const bool goes_on = !tried.x.empty() && tried.status != Status::Unbounded && !in_vain;
      if (!is_settled(latest_) && goes_on) search_rescaled(tried.x, *solver);
      if (is_settled(latest_) || thrown_ || deadline_.passed()) return;
      look_for_emptiness();
      if (is_settled(latest_) || found_.assessment.verdict == Verdict::Infeasible) return;
    }
  }

  /// From where a search has ended, in the sizes of that place, where they are others.
  void search_rescaled(std::vector<double> x, const Solver& solver) {
    constexpr int kTimes = 3;
    for (int i = 0; i < kTimes; ++i) {
      Sizes there = sizes(problem_, x);
      if (!differ(there, sizes_)) return;
      sizes_ = std::move(there);
      const Attempt tried = attempt(x, solver);
      consider(tried, solver);
      if (tried.error || tried.x.empty() || deadline_.passed() || is_settled(latest_)) return;
      x = tried.x;
    }
  }

  /// Where the set of designs is convex, the design of least violation tells at once whether there
  /// are any: then no other method, and no other start, needs to try.
  void look_for_emptiness() {
    if (!convex_set_ || found_.x.empty() || is_feasible(found_.assessment)) return;
    if (!deadline_.passed()) find_feasible();
  }

  void search_starts() {
    constexpr int kStarts = 8;
    const bool global = plan_.solvers.front()->is_global();
    const bool one_is_enough = convex_ && !needs_slope(problem_);
    const int count = options_.starts.value_or(one_is_enough || global ? 1 : kStarts);
    found_.planned_starts = count;
    for (const auto& start : starts(problem_, count, options_.seed)) {
      if (found_.starts > 0 && deadline_.passed()) break;
      ++found_.starts;
      from_start_ = {};
      search_from(start);
      objectives_.push_back(is_feasible(from_start_) ? from_start_.objective.value : kInfinity);
      const bool best_of_all = is_settled(found_.assessment) && found_.assessment.is_global;
      if (best_of_all || found_.assessment.verdict == Verdict::Infeasible) {
        found_.planned_starts = found_.starts;
        break;
      }
    }
  }

  bool is_proved(const Assessment& a) const {
    const Response& sought = problem_.objective().response;
    const bool searched =
        sought.is_curve() ? a.objective.angle.has_value() : sought.function().is_searched();
    if (!searched) return is_feasible(a);
    if (!std::isfinite(a.objective.proved.upper - a.objective.proved.lower)) return false;
    return is_feasible(a) &&
           (sought.is_curve() || a.objective.value == sought.function().value(found_.x));
  }

  /// Angles at which a proof found a limit passed, or the peak higher, that no search had seen:
  /// from now on every search looks there. A number for which a proof found more than its own
  /// search is worked out with proofs from now on. Whether there was anything new.
  bool watch_what_was_found() {
    bool any = false;
    const auto watch = [&](std::size_t index, double angle, const Response& original,
                           Response& response) {
      std::vector<double>& angles = watched_[index];
      if (std::find(angles.begin(), angles.end(), angle) != angles.end()) return;
      angles.push_back(angle);
      response = remembered(watched(original, angles));
      any = true;
    };
    const auto prove_number = [&](Response& response) {
      if (response.is_curve() || !response.function().is_searched()) return;
      const Function proved = response.function().proved();
      if (proved.value(found_.x) == response.function().value(found_.x)) return;
      response.measure = proved;
      any = true;
    };
    const Assessment& a = found_.assessment;
    watched_.resize(1 + a.limits.size());
    prove_number(problem_.objectives.front().response);
    if (a.objective.angle && std::isinf(a.objective.proved.upper - a.objective.proved.lower)) {
      watch(0, *a.objective.angle, guarded_.objective().response,
            problem_.objectives.front().response);
    }
    for (std::size_t i = 0; i < a.limits.size(); ++i) {
      prove_number(problem_.constraints[i].response);
      if (a.limits[i].met || !a.limits[i].worst_angle) continue;
      watch(i + 1, *a.limits[i].worst_angle, guarded_.constraints[i].response,
            problem_.constraints[i].response);
    }
    return any;
  }

  /// From the best design on, now that more is known of the curves.
  void search_again() {
    const Solver& solver = *plan_.solvers.back();
    const Attempt again = attempt(found_.x, solver);
    if (!again.x.empty()) {
      found_.x = again.x;
      found_.status = again.status;
      found_.solver = solver.name();
      message_ = again.message;
    }
    found_.assessment = assess(problem_, sizes_, found_.x, false);
  }

  /// Proves the best design, in its own sizes; where the proof finds an angle that breaks a limit,
  /// searches again.
  void prove_best() {
    constexpr int kRounds = 10;
    for (int round = 0; true; ++round) {
      if (found_.assessment.verdict == Verdict::Infeasible) return;
      settle_in_own_sizes();
      if (!is_feasible(found_.assessment) && !deadline_.passed()) find_feasible();
      if (!is_feasible(found_.assessment) || !prove_) return;
      found_.assessment = assess(problem_, sizes_, found_.x, true);
      if (is_proved(found_.assessment) || deadline_.passed() || round == kRounds) return;
      if (!watch_what_was_found()) return;
      search_again();
    }
  }

  /// Conditions that held in the sizes of a search may not hold in those of the design it led to:
  /// then the search goes on from there.
  void settle_in_own_sizes() {
    if (!is_feasible(found_.assessment)) return;
    Sizes own = sizes(problem_, found_.x);
    const bool known = is_settled(found_.assessment) && !differ(own, sizes_);
    sizes_ = std::move(own);
    if (known) return;
    found_.assessment = assess(problem_, sizes_, found_.x, false);
    const Solver& solver = *plan_.solvers.back();
    if (is_settled(found_.assessment) || solver.is_global() || deadline_.passed()) return;
    consider(attempt(found_.x, solver), solver);
  }

  /// Whether the answer is where the search began, or says itself that its conditions may hold by
  /// chance, and no lower bound speaks for it.
  bool is_doubtful() const {
    const Assessment& a = found_.assessment;
    if (!is_feasible(a) || a.global) return false;
    if (!a.sign.empty()) return true;
    const std::vector<double> start = problem_.start();
    for (std::size_t i = 0; i < start.size(); ++i) {
      const Variable& v = problem_.variables[i];
      const bool inside = v.lower == v.upper || (start[i] > v.lower && start[i] < v.upper);
      if (!inside || std::abs(found_.x[i] - start[i]) > 1e-9 * sizes_.variables[i]) return false;
    }
    return true;
  }

  /// A search that began once begins again elsewhere.
  void search_elsewhere() {
    constexpr int kStarts = 4;
    if (found_.starts > 1 || deadline_.passed() || !is_doubtful()) return;
    const auto more = starts(problem_, kStarts, options_.seed);
    for (std::size_t i = 1; i < more.size() && !deadline_.passed(); ++i) {
      from_start_ = {};
      search_from(more[i]);
    }
    prove_best();
  }

  static bool are_numbers(const Assessment& a) {
    return std::isfinite(a.objective.value) && !std::isinf(worst_violation(a.limits));
  }

  bool has_numbers() const { return !found_.x.empty() && are_numbers(found_.assessment); }

  /// Where the model gives no number at any start: a design within the limits that are numbers
  /// everywhere, such as those of validity, and a search from there. Where there is none, the
  /// problem has no design either, for the same reason.
  void seek_numbers() {
    constexpr double kRoom = 1e-3;
    OptimiseOptions own = options_;
    own.solver = "auto";
    const std::vector<double> start = problem_.start();
    Found valid;
    for (const double share : {kRoom, 0.0}) {  // only without room an empty set says something
      const auto seeking = with_numbers_only(problem_, start, share);
      if (!seeking || deadline_.passed()) return;
      valid = search_continuous(*seeking, own, deadline_, false);
      if (is_feasible(valid.assessment)) return search_from(valid.x);
    }
    if (valid.assessment.verdict != Verdict::Infeasible) return;
    const Sizes there = sizes(problem_, valid.x);
    found_.x = valid.x;
    found_.assessment = valid.assessment;
    found_.assessment.objective = objective_report(problem_, there, valid.x, false);
    found_.assessment.limits = limit_reports(problem_, there, valid.x, false);
    found_.assessment.reason = fmt::format("{}; {}", valid.assessment.reason,
                                           undefined_at(original_, valid.x, "the nearest design"));
  }

  /// Where no limit tells where the model gives numbers: from the first places of the box at which
  /// it does, evenly spread or by orders of magnitude.
  void seek_numbers_all_over() {
    constexpr int kPlaces = 128, kEnough = 3;
    const auto even = starts(problem_, kPlaces, options_.seed);
    const auto by_magnitude = starts_by_magnitude(problem_, kPlaces, options_.seed);
    int searched = 0;
    for (std::size_t i = 1; i < even.size(); ++i) {
      for (const auto* places : {&by_magnitude, &even}) {
        if (searched == kEnough || deadline_.passed()) return;
        const std::vector<double>& x = (*places)[i];
        if (!are_numbers(assess_in_haste(problem_, hasty_sizes(problem_, x), x))) continue;
        ++searched;
        search_from(x);
      }
    }
  }

  void finish() {
    if (!has_numbers()) seek_numbers();
    if (!has_numbers() && found_.assessment.verdict != Verdict::Infeasible) seek_numbers_all_over();
    const Assessment& best = found_.assessment;
    if (best.verdict == Verdict::Infeasible) {
      judge();
      return;
    }
    if (!has_numbers()) {
      fail_in_place(undefined_at(original_, problem_.start(), "the start"));
      return;
    }
    if (unbounded_ && is_feasible(best) && !is_settled(best)) {
      found_.status = Status::Unbounded;
      fail_in_place("the objective improves without end: a limit is missing");
      return;
    }
    prove_best();
    search_elsewhere();
    if (found_.assessment.verdict == Verdict::Infeasible) return;
    judge();
  }

  /// A design of least violation, and what is to be said of it.
  struct Least {
    Attempt attempt;  ///< without a design where no search led to one in time
    Assessment blame;
  };

  Least least_violation_from(Design start) {
    Least least;
    for (const Solver* solver : least_violation_plan(problem_)) {
      least.attempt = attempt(start, *solver, Aim::LeastViolation);
      if (least.attempt.x.empty() || deadline_.passed()) return {};
      least.blame = assess_least_violation(problem_, sizes_, least.attempt.x);
      if (is_feasible(least.blame) || least.blame.verdict == Verdict::Infeasible) break;
    }
    return least;
  }

  /// Where the limits leave no convex set, the least violation that was found may be one of
  /// several: searches from elsewhere, until one comes to a design within the limits. What the
  /// model throws there says nothing of what was found. In the nodes of a search over whole
  /// variables there is no such look.
  Least least_violation_of_all(Least least) {
    constexpr std::size_t kTried = 4;
    constexpr double kGain = 1e-6;
    if (convex_set_ || !prove_) return least;
    const Thrown thrown = thrown_;
    for (const auto& x :
         least_violating(problem_, sizes_, least.attempt.x, kTried, options_.seed)) {
      if (is_feasible(least.blame) || deadline_.passed()) break;
      Least other = least_violation_at(x);
      thrown_ = thrown;
      if (other.attempt.x.empty()) continue;
      const double gain = largest_violation(problem_, sizes_, least.attempt.x) -
                          largest_violation(problem_, sizes_, other.attempt.x);
      if (is_feasible(other.blame) || gain > kGain) least = std::move(other);
    }
    if (deadline_.passed() && !is_feasible(least.blame)) {  // not everywhere
      least.blame.verdict = Verdict::Failed;
      least.blame.reason = "no design was found that meets every limit";
    }
    return least;
  }

  /// The place itself, where it meets every limit, else where a search from it leads.
  Least least_violation_at(const std::vector<double>& x) {
    try {
      Least least;
      least.blame = assess(problem_, sizes_, x, false);
      if (!is_feasible(least.blame)) return least_violation_from(x);
      least.attempt.x = x;
      least.attempt.status = Status::Solved;
      least.attempt.message = "a place of the box that meets every limit";
      return least;
    } catch (...) {
      if (is_interruption(std::current_exception())) throw;
      return {};
    }
  }

  /// From the design of least violation on; or, where that violates still, the verdict of it.
  void find_feasible() {
    const Solver& ipopt = ipopt_solver();
    Least least = least_violation_from(found_.x);
    if (least.attempt.x.empty()) return;
    if (!is_feasible(least.blame)) least = least_violation_of_all(std::move(least));
    if (!is_feasible(least.blame)) {
      if (worst_violation(least.blame.limits) < worst_violation(found_.assessment.limits) ||
          least.blame.verdict == Verdict::Infeasible) {
        found_.assessment = least.blame;
        found_.x = least.attempt.x;
      }
      return;
    }
    consider(least.attempt, ipopt);
    found_.assessment.kkt_residual = kInfinity;
    for (const Solver* solver : {&find_solver("slsqp"), &ipopt}) {
      if (!is_settled(found_.assessment)) consider(attempt(least.attempt.x, *solver), *solver);
    }
    if (!is_settled(found_.assessment)) search_along_bounds(least.attempt.x);
  }

  /// Where a law loses a phase at a variable's bound, curves are others than beside it, and a
  /// search that leaves the bound does not come back: one with the variables held that stand at
  /// theirs.
  void search_along_bounds(const std::vector<double>& x) {
    constexpr double kAt = 1e-7;  // of a typical change: as near as solvers come
    Problem along = original_;
    bool any = false;
    for (std::size_t i = 0; i < x.size(); ++i) {
      Variable& v = along.variables[i];
      v.start = x[i];
      if (v.lower == v.upper) continue;
      for (const double bound : {v.lower, v.upper}) {
        if (!(std::abs(x[i] - bound) <= kAt * sizes_.variables[i])) continue;
        v.lower = v.upper = v.start = bound;
        any = true;
        break;
      }
    }
    if (!any || deadline_.passed()) return;
    OptimiseOptions once = options_;
    once.solver = "auto";
    once.starts = 1;
    once.progress = {};
    once.candidate = {};
    const Found found = search_continuous(along, once, deadline_, false);
    found_.add_work(found);
    if (!is_feasible(found.assessment)) return;
    Attempt there;
    there.x = found.x;
    there.status = found.status;
    there.message = "with the variables held that stand at their bounds";
    consider(there, find_solver(found.solver));
  }

  void fail_in_place(const std::string& why) {
    found_.assessment.verdict = Verdict::Failed;
    found_.assessment.reason = why;
  }

  /// Words for what the search adds to the assessment.
  void judge() {
    const double best = found_.assessment.objective.value;
    for (const double value : objectives_) {
      found_.agreed += std::abs(value - best) <= 1e-6 * std::max(std::abs(best), sizes_.objective);
    }
    Assessment& a = found_.assessment;
    if (found_.starts < found_.planned_starts) {
      a.reason = fmt::format("{} after {} of {} starts; {}", deadline_.reason(), found_.starts,
                             found_.planned_starts, a.reason);
    } else if (deadline_.passed() && a.verdict != Verdict::Certified) {
      a.reason = fmt::format("{}; {}", deadline_.reason(), a.reason);
    } else if (a.verdict == Verdict::Failed) {
      a.reason = fmt::format("{} ({}: {})", a.reason, found_.solver, message_);
    } else if (a.verdict == Verdict::Feasible && prove_ && found_.status != Status::Solved) {
      a.reason = fmt::format("{} ({}: {})", a.reason, found_.solver, message_);
    }
  }

  const Problem& original_;
  Problem guarded_;  ///< the same, which throws once the deadline has passed
  Problem problem_;  ///< its curves remembered, and watched where proofs found something
  const OptimiseOptions& options_;
  const Deadline& deadline_;
  bool prove_, convex_, convex_set_;
  Plan plan_;
  Sizes sizes_{};
  Found found_;
  std::string message_;
  bool in_vain_ = false;    ///< all iterations of a start led to no design within the limits
  bool unbounded_ = false;  ///< some solve has found that the objective improves without end
  Assessment from_start_;   ///< the best since the last start
  Assessment latest_;       ///< of the last attempt
  std::vector<double> objectives_;            ///< where each start ended
  std::vector<std::vector<double>> watched_;  ///< angles of the objective and of each constraint
  std::vector<double> latest_design_;         ///< where the last attempt ended
  Thrown thrown_;
};

}  // namespace

void check_solvers(const OptimiseOptions& options) {
  if (options.solver != "auto") find_solver(options.solver);
  for (const auto& [solver, native] : options.native) {
    check_native_options(find_solver(solver), native);
  }
}

Found search_continuous(const Problem& problem, const OptimiseOptions& options,
                        const Deadline& deadline, bool prove) {
  return Search(problem, options, deadline, prove).run();
}

Found cut_short(const Problem& problem, const std::vector<double>& x, const std::string& why) {
  const Problem plain = remembered(problem);
  Found found;
  found.x = x;
  found.assessment = assess_in_haste(plain, hasty_sizes(plain, x), x);
  found.assessment.reason = fmt::format("{}; {}", why, found.assessment.reason);
  return found;
}

}  // namespace camlaw::optim
