// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "optim/solvers/nlopt_options.h"
#include "optim/solvers/nlopt_search.h"
#include "optim/solvers/run_end.h"

/// NLopt 2.7: local and global methods, with and without gradients.
namespace camlaw::optim {
namespace {

RunEnd run_end(Halt halt) {
  switch (halt) {
    case Halt::EvaluationLimit:
      return {Status::IterationLimit, "limit of evaluations"};
    case Halt::TimeLimit:
      return {Status::TimeLimit, "time limit"};
    case Halt::Stopped:
      return {Status::Stopped, "stopped"};
    case Halt::Unbounded:
      return {Status::Unbounded, "the objective decreases without bound"};
    case Halt::Threw:
    case Halt::None:
      break;
  }
  return {Status::Failed, "the model raised an error"};
}

RunEnd run_end(nlopt_result result, const char* words) {
  switch (result) {
    case NLOPT_SUCCESS:
      return {Status::Solved, "converged"};
    case NLOPT_FTOL_REACHED:
      return {Status::Solved, "the objective changes by less than its tolerance"};
    case NLOPT_XTOL_REACHED:
      return {Status::Solved, "steps are smaller than their tolerance"};
    case NLOPT_MAXEVAL_REACHED:
      return {Status::IterationLimit, "limit of evaluations"};
    case NLOPT_MAXTIME_REACHED:
      return {Status::TimeLimit, "time limit"};
    case NLOPT_ROUNDOFF_LIMITED:
      return {Status::Stalled, "rounding hinders further steps"};
    case NLOPT_FAILURE:
      return {Status::Stalled, "no step leads to a better point"};
    default:
      return {Status::Failed, words != nullptr ? words : nlopt_result_to_string(result)};
  }
}

/// Lower by more than a violation within kAcceptableViolation is likely to buy.
bool materially_lower(double objective, double than) {
  return objective < than - kAcceptableViolation * (1 + std::abs(than));
}

/// Why there is nothing to search from y; empty where there is.
std::optional<RunEnd> unfit_start(const NloptMethod& method, const Program& program,
                                  std::span<const double> y, Evaluator& evaluator) {
  const bool defined = evaluator.at(y).defined;
  if (evaluator.halt() != Halt::None) return run_end(evaluator.halt());
  if (!defined) return RunEnd{Status::NonFiniteStart, "not a number at the start"};
  if (program.variables() == 0) {
    const bool feasible = evaluator.best().violation <= kAcceptableViolation;
    return RunEnd{feasible ? Status::Solved : Status::Infeasible, "nothing varies"};
  }
  if (method.is_global || !method.uses_gradients) return {};
  const bool differentiable = evaluator.with_derivatives_at(y).defined;
  if (evaluator.halt() != Halt::None) return run_end(evaluator.halt());
  if (differentiable) return {};
  return RunEnd{Status::NonFiniteStart, "a derivative is not a number at the start"};
}

/// NLopt calls it a success where a method ends at an infeasible point or against a region where
/// the model is undefined, and where a global method could not go on.
RunEnd doubted(const RunEnd& claim, bool is_global, const NloptPoint& final,
               const Evaluator& evaluator) {
  const NloptPoint& best = evaluator.best();
  if (claim.status != Status::Solved) return claim;
  if (is_global) return {Status::Stalled, "the search has reached its finest resolution"};
  if (best.violation > kAcceptableViolation) {
    return {Status::Infeasible, "ended where the limits cannot be met"};
  }
  if (final.violation > kAcceptableViolation || materially_lower(best.objective, final.objective)) {
    return {Status::Stalled, "ended at a point worse than the best that it had found"};
  }
  if (evaluator.undefined_lately()) {
    return {Status::Stalled, "ended where the model is undefined"};
  }
  return claim;
}

Solution solution(const NloptPoint& point, RunEnd outcome, const Evaluator& evaluator) {
  Solution result;
  result.status = outcome.status;
  result.message = std::move(outcome.message);
  const bool threw = evaluator.error() != nullptr;
  if (point.violation > kAcceptableViolation && point.defined && !threw) {
    result.message += fmt::format("; a limit is violated by {:.2g} of its scale", point.violation);
  }
  result.y = point.y;
  result.evaluations = evaluator.evaluations();
  result.error = evaluator.error();
  return result;
}

Solution search_from(const NloptMethod& method, const Program& program,
                     const SolverOptions& options, std::vector<double> y) {
  Evaluator evaluator(program, options, evaluation_limit(method, options));
  if (const auto unfit = unfit_start(method, program, y, evaluator)) {
    return solution(evaluator.best(), *unfit, evaluator);
  }
  y = evaluator.best().y;  // the start, drawn into the box
  NloptSearch search(method, program, options, evaluator);
  const nlopt_result result = search.run(y);
  const NloptPoint& best = evaluator.best();
  const NloptPoint final = evaluator.at(y);
  if (evaluator.halt() != Halt::None) return solution(best, run_end(evaluator.halt()), evaluator);
  const bool prefer_final =
      final.violation <= kAcceptableViolation &&
      (best.violation > kAcceptableViolation || materially_lower(final.objective, best.objective));
  const NloptPoint& chosen = prefer_final ? final : best;
  RunEnd end = doubted(run_end(result, search.words()), method.is_global, final, evaluator);
  if (end.status == Status::Solved && chosen.violation > options.tolerance) {
    end.status = Status::Acceptable;
  }
  return solution(chosen, std::move(end), evaluator);
}

class NloptSolver final : public Solver {
 public:
  explicit NloptSolver(const NloptMethod& method) : method_(method) {}

  std::string name() const override { return method_.name; }
  bool is_global() const override { return method_.is_global; }
  std::optional<std::string> refusal(const Program& program) const override {
    return why_refused(method_, program);
  }

  std::vector<NativeRule> native_rules() const override { return nlopt_rules(method_); }

 private:
  Solution search(const Program& program, const SolverOptions& options,
                  const WarmStart* warm) const override {
    if (const auto why = refusal(program)) {
      Solution refused;
      refused.message = *why;
      return refused;
    }
    const bool warmed = warm != nullptr && warm->y.size() == program.variables();
    const std::span<const double> start = warmed ? warm->y : program.start();
    return search_from(method_, program, options, {start.begin(), start.end()});
  }

  const NloptMethod& method_;
};

}  // namespace

const std::vector<const Solver*>& nlopt_solvers() {
  static const std::vector<NloptSolver> solvers(nlopt_methods().begin(), nlopt_methods().end());
  static const std::vector<const Solver*> list = [] {
    std::vector<const Solver*> pointers;
    for (const NloptSolver& solver : solvers) pointers.push_back(&solver);
    return pointers;
  }();
  return list;
}

}  // namespace camlaw::optim
