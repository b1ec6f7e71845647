// SPDX-License-Identifier: MIT
#include "optim/search/trail.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <optional>

#include "optim/search/interruptible.h"
#include "optim/search/rescaling.h"
#include "optim/verdict/verdict.h"

namespace camlaw::optim {
namespace {

SolverOptions solver_options(const Solver& solver, const Setting& setting, const Found& found) {
  const OptimiseOptions& options = setting.options;
  SolverOptions result;
  result.max_iterations = options.max_iterations;
  result.max_evaluations = options.max_evaluations;
  result.time_limit = setting.deadline.left();
  result.seed = options.seed;
  result.stop = options.stop;
  if (const auto native = options.native.find(solver.name()); native != options.native.end())
    result.native = native->second;
  if (!options.progress) return result;
  result.progress = [&](Progress progress) {
    const int planned = std::max(found.planned_starts, 1);
    progress.done = static_cast<double>(std::max(found.starts - 1, 0)) / planned;
    options.progress(progress);
  };
  return result;
}

/// Whether a design is better, or as good to 1e-6 (by passing limits within their tolerance a
/// design may look better than the optimum) and the conditions of optimality hold where they did
/// not.
bool improves(const Problem& problem, const Scales& scales, const Assessment& fresh,
              const Assessment& old) {
  const double a = fresh.objective.value, b = old.objective.value;
  const bool alike = is_feasible(fresh) && is_feasible(old) &&
                     std::abs(a - b) <= 1e-6 * std::max(std::abs(b), scales.objective);
  if (alike && is_settled(fresh) != is_settled(old)) return is_settled(fresh);
  return better(problem, fresh, old);
}

/// An assessment with proofs, and the scales that it is in.
struct Judged {
  Scales scales;
  Assessment assessment;
};

/// The optimum of a linear problem is judged as an answer is, with proofs and in the scales of its
/// place, where these are like those of the search; none where that does not show at once that it
/// is the global one.
std::optional<Judged> judged_at_once(const Attempt& tried, const Solver& solver,
                                     const Setting& setting, const Scales& known) {
  const bool is_optimum = tried.status == Status::Solved && solver.solves_linear_programs();
  if (!setting.proves() || !is_optimum || tried.told.empty() || !is_linear(setting.problem))
    return {};
  Judged judged{scales(setting.problem, tried.x), {}};
  if (differ(judged.scales, known)) return {};
  judged.assessment = assess(setting.problem, judged.scales, tried.x, true, told_as(tried.told));
  const bool is_global =
      judged.assessment.verdict == Verdict::Certified && judged.assessment.global;
  return is_global ? std::optional(std::move(judged)) : std::nullopt;
}

}  // namespace

std::string words_of(const std::exception_ptr& error, const std::string& who) {
  try {
    std::rethrow_exception(error);
  } catch (const std::bad_alloc&) {
    return who + ": there is not enough memory";
  } catch (const std::exception& e) {
    return fmt::format("{}: {}", who, e.what());
  } catch (...) {
    return who + ": something that is not a std::exception";
  }
}

void Trail::count(const Attempt& attempt) {
  found.iterations += attempt.iterations;
  found.evaluations += attempt.evaluations;
  found.solves += attempt.rounds;
}

void Trail::join(const Problem& problem, Trail next) {
  const bool says_none = next.is_infeasible() && !is_within_limits();
  const bool is_better =
      !next.found.x.empty() &&
      (found.x.empty() || improves(problem, next.scales, next.found.assessment, found.assessment));
  Found work = found;
  work.add_work(next.found);
  if (says_none || is_better) {
    found = std::move(next.found);
    told = std::move(next.told);
    message = std::move(next.message);
  }
  is_judged = is_better && next.is_judged;  // the scales are those of the next
  found.starts = work.starts + 1;
  found.planned_starts = work.planned_starts;
  found.iterations = work.iterations;
  found.evaluations = work.evaluations;
  found.solves = work.solves;
  if (!next.scales.variables.empty()) scales = std::move(next.scales);
  if (!next.last.empty()) last = std::move(next.last);
  if (!next.thrown.empty()) thrown = std::move(next.thrown);
  in_vain = in_vain || next.in_vain;
  unbounded = unbounded || next.unbounded;
}

void Trail::take(std::vector<double> x, Scales its_scales, Assessment assessment) {
  found.x = std::move(x);
  found.assessment = std::move(assessment);
  scales = std::move(its_scales);
  told.clear();
  is_judged = false;
}

FirstStart told_of(const FromStart& first) {
  if (first.trail.is_within_limits()) return FirstStart::Led;
  return first.trail.in_vain ? FirstStart::InVain : FirstStart::NoDesign;
}

void Trail::fail(const std::string& why) {
  found.assessment.verdict = Verdict::Failed;
  found.assessment.reason = why;
}

Attempt attempt(Design start, const Solver& solver, const Setting& setting, Trail& trail, Aim aim) {
  // Where one start has used up its iterations in vain, there may be no design to be found.
  constexpr int kShare = 4;
  SolverOptions how = solver_options(solver, setting, trail.found);
  if (trail.in_vain && aim == Aim::Optimum && !trail.knows_design())
    how.max_iterations = 1 + how.max_iterations / kShare;
  Attempt result = exchange(setting.problem, trail.scales, start, solver, how, aim);
  trail.count(result);
  if (!result.x.empty()) trail.last = result.x;
  if (is_interruption(result.error)) throw Interrupted();
  if (result.error) trail.thrown = words_of(result.error, result.message);
  return result;
}

Attempt attempt(Design start, const Solver& solver, const Setting& setting, Trail& trail,
                Reached& reached) {
  Attempt tried = attempt(start, solver, setting, trail, Aim::Optimum);
  consider(tried, solver, setting, trail, reached);
  return tried;
}

void consider(const Attempt& tried, const Solver& solver, const Setting& setting, Trail& trail,
              Reached& reached) {
  const auto tell = [&](bool is_best) {
    if (!setting.options.candidate) return;
    setting.options.candidate({{}, tried.x, is_best, is_best ? reached.latest : Assessment{}});
  };
  Found& found = trail.found;
  reached.latest = {};
  trail.unbounded = trail.unbounded || tried.status == Status::Unbounded;
  if (tried.x.empty()) return;
  tell(false);
  std::optional<Judged> judged = judged_at_once(tried, solver, setting, trail.scales);
  reached.latest = judged
                       ? judged->assessment
                       : assess(setting.problem, trail.scales, tried.x, false, told_as(tried.told));
  if (improves(setting.problem, trail.scales, reached.latest, reached.best))
    reached.best = reached.latest;
  if (!found.x.empty() &&
      !improves(setting.problem, trail.scales, reached.latest, found.assessment))
    return;
  found.x = tried.x;
  trail.told = tried.told;
  trail.is_judged = judged.has_value();
  if (judged) trail.scales = std::move(judged->scales);
  found.assessment = reached.latest;
  found.status = tried.status;
  found.solver = solver.name();
  trail.message = tried.message;
  tell(true);
}

}  // namespace camlaw::optim
