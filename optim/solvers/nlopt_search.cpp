// SPDX-License-Identifier: MIT
#include "optim/solvers/nlopt_search.h"

#include <algorithm>
#include <limits>

#include "optim/solvers/nlopt_options.h"

namespace camlaw::optim {
namespace {

// Line searches and inner iterations: a method with gradients has so many evaluations to each of
// max_iterations. NLopt knows no iterations.
constexpr long kEvaluationsPerIteration = 10;
// A Lagrangian around a global method gives each of its rounds one part of the evaluations: enough
// rounds for multipliers to settle, enough evaluations in each to search. With gradients (mlsl) a
// round needs fewer. Measured on Styblinski-Tang and Rastrigin, 2 and 5 variables, with rows.
constexpr long kRounds = 10, kRoundsWithGradients = 40;
constexpr long kMostEvaluations = std::numeric_limits<int>::max();  // that NLopt can count
// AGS looks at no stop flag, but at this value, which no objective of order one has.
constexpr double kStopValue = -1e299;

}  // namespace

long evaluation_limit(const NloptMethod& method, const SolverOptions& options) {
  if (method.is_global || !method.uses_gradients) return options.max_evaluations;
  return kEvaluationsPerIteration * options.max_iterations;
}

NloptSearch::NloptSearch(const NloptMethod& method, const Program& program,
                         const SolverOptions& options, Evaluator& evaluator)
    : method_(method),
      program_(program),
      options_(options),
      evaluation_limit_(evaluation_limit(method, options)),
      wrapped_(is_wrapped(method, program)),
      evaluator_(evaluator),
      round_(std::max(
          1L, evaluation_limit_ / (method.uses_gradients ? kRoundsWithGradients : kRounds))) {}

const NloptPoint& NloptSearch::evaluate(std::span<const double> y, bool with_derivatives) {
  const NloptPoint& point = with_derivatives ? evaluator_.with_derivatives_at(y) : evaluator_.at(y);
  if (evaluator_.halt() != Halt::None) nlopt_force_stop(opt_.get());
  return point;
}

double NloptSearch::objective(unsigned n, const double* y, double* gradient, void* data) {
  NloptSearch& search = *static_cast<NloptSearch*>(data);
  const NloptPoint& point = search.evaluate({y, n}, gradient != nullptr);
  if (gradient != nullptr) std::fill_n(gradient, n, 0.0);
  if (search.is_halted_ags()) return 10 * kStopValue;
  if (!point.defined) return search.evaluator_.rejected_objective() + search.offset_;
  if (gradient != nullptr) std::copy_n(search.evaluator_.gradient().begin(), n, gradient);
  return point.objective + search.offset_;
}

void NloptSearch::sides(unsigned m, double* values, unsigned n, const double* y, double* gradients,
                        void* data) {
  const Group& group = *static_cast<const Group*>(data);
  NloptSearch& search = *group.search;
  const NloptPoint& point = search.evaluate({y, n}, gradients != nullptr);
  for (std::size_t k = 0; k < m; ++k) {
    const Side& side = group.sides[k];
    values[k] = point.defined ? side.sign * (point.rows[side.row] - side.bound)
                              : search.undefined_side(side);
  }
  if (gradients == nullptr) return;
  std::fill_n(gradients, std::size_t{m} * n, 0.0);
  if (!point.defined) return;
  for (const Group::Slope& slope : group.slopes) {
    gradients[slope.place] += slope.sign * search.evaluator_.jacobian()[slope.entry];
  }
}

/// A Lagrangian may reward a violated equation (its multiplier has a sign): there an undefined
/// point has the rows of its neighbour and is rejected by its objective.
double NloptSearch::undefined_side(const Side& side) const {
  if (is_halted_ags()) return -1;
  if (!wrapped_) return evaluator_.rejected_violation();
  return side.sign * (evaluator_.last_defined_rows()[side.row] - side.bound);
}

bool NloptSearch::is_halted_ags() const {
  return method_.algorithm == NLOPT_GN_AGS && evaluator_.halt() != Halt::None;
}

/// With tolerances for local methods; global ones search until they are stopped. Methods without
/// gradients end by their steps alone: a step along a contour changes no objective. The objective's
/// tolerance is tighter than the steps', as near an optimum it is their square.
NloptHandle NloptSearch::create(nlopt_algorithm algorithm) const {
  NloptHandle opt(nlopt_create(algorithm, static_cast<unsigned>(program_.variables())));
  nlopt_set_lower_bounds(opt.get(), program_.lower().data());
  nlopt_set_upper_bounds(opt.get(), program_.upper().data());
  const bool searches_box = method_.is_global && algorithm != NLOPT_LD_LBFGS;
  if (searches_box) return opt;
  nlopt_set_xtol_rel(opt.get(), options_.tolerance);
  // Near an optimum the objective changes by the square of what the variables do.
  constexpr double kTighter = 1e-3;
  if (method_.uses_gradients) nlopt_set_ftol_rel(opt.get(), kTighter * options_.tolerance);
  return opt;
}

NloptHandle NloptSearch::create_inner() const {
  NloptHandle inner = create(method_.algorithm);
  NloptHandle helper;
  if (method_.algorithm == NLOPT_G_MLSL_LDS) {
    helper = create(NLOPT_LD_LBFGS);
    // By default LBFGS clears ten megabytes at each start. Twenty pairs are more than it needs.
    nlopt_set_vector_storage(helper.get(), 20);
  } else if (method_.algorithm == NLOPT_LD_MMA || method_.algorithm == NLOPT_LD_CCSAQ) {
    // What solves the dual problems. By default that is MMA with 100000 evaluations, which on 60
    // random convex programs was 50 times slower, and less accurate.
    helper = create(NLOPT_LD_TNEWTON_RESTART);
    constexpr double kLastDigits = 1e-14;  // an inexact dual makes the outer steps inexact
    constexpr int kMost = 3000;            // evaluations of a dual
    nlopt_set_ftol_rel(helper.get(), kLastDigits);
    nlopt_set_maxeval(helper.get(), kMost);
  }
  nlopt_set_vector_storage(inner.get(), 20);
  set_nlopt_options(method_, program_, options_.native, inner.get(), helper.get());
  if (helper) nlopt_set_local_optimizer(inner.get(), helper.get());
  return inner;
}

/// The augmented Lagrangian. NLopt's first penalty is 2 |objective| / violation^2, next to nothing
/// where the objective happens to be near zero: the objective is moved to 1 at the start.
NloptHandle NloptSearch::create_outer(const NloptHandle& inner) {
  NloptHandle outer = create(NLOPT_AUGLAG);
  if (method_.is_global) {
    nlopt_set_maxeval(inner.get(), static_cast<int>(std::min<long>(round_, kMostEvaluations)));
  }
  nlopt_set_local_optimizer(outer.get(), inner.get());
  offset_ = 1 - evaluator_.best().objective;
  return outer;
}

void NloptSearch::configure() {
  opt_ = create_inner();
  if (wrapped_) opt_ = create_outer(opt_);
  nlopt_set_min_objective(opt_.get(), objective, this);
  nlopt_set_stopval(opt_.get(), kStopValue);
  // The evaluator counts, and it counts repeated points once; this is for methods that come to
  // repeat themselves for ever, and for AGS, which needs a limit.
  const long most = std::min(evaluation_limit_, kMostEvaluations / 3) * 3;
  nlopt_set_maxeval(opt_.get(), static_cast<int>(most));
  if (options_.time_limit) nlopt_set_maxtime(opt_.get(), *options_.time_limit);
}

NloptSearch::Group NloptSearch::group(bool equations, std::vector<Side> sides) {
  Group result{this, equations, std::move(sides), {}};
  const Pattern& pattern = program_.jacobian_pattern();
  for (std::size_t e = 0; e < pattern.size(); ++e) {
    for (std::size_t k = 0; k < result.sides.size(); ++k) {
      if (static_cast<std::size_t>(pattern.rows[e]) != result.sides[k].row) continue;
      const auto column = static_cast<std::size_t>(pattern.columns[e]);
      result.slopes.push_back({e, k * program_.variables() + column, result.sides[k].sign});
    }
  }
  return result;
}

nlopt_result NloptSearch::add_rows() {
  groups_.clear();
  const std::vector<Side> inequalities = inequality_sides(program_);
  if (method_.algorithm == NLOPT_GN_AGS) {  // takes no vectors
    for (const Side& side : inequalities) groups_.push_back(group(false, {side}));
  } else {
    groups_.push_back(group(false, inequalities));
  }
  groups_.push_back(group(true, equation_sides(program_)));
  for (Group& g : groups_) {
    const auto size = static_cast<unsigned>(g.sides.size());
    const std::vector<double> tolerances(size, options_.tolerance);
    const auto add =
        g.equations ? nlopt_add_equality_mconstraint : nlopt_add_inequality_mconstraint;
    const nlopt_result result = add(opt_.get(), size, sides, &g, tolerances.data());
    if (result < 0) return result;
  }
  return NLOPT_SUCCESS;
}

nlopt_result NloptSearch::sweep(std::vector<double>& y) {
  configure();
  if (const nlopt_result result = add_rows(); result < 0) return result;
  double value = 0;
  return nlopt_optimize(opt_.get(), y.data(), &value);
}

/// A Lagrangian around a global method ends early where the rows leave its first optimum alone, or
/// where mlsl's local method fails. It is begun anew: from the best point, or with longer rounds.
nlopt_result NloptSearch::run(std::vector<double>& y) {
  nlopt_srand(static_cast<unsigned long>(options_.seed));
  const std::vector<double> start = y;
  nlopt_result result = sweep(y);
  if (!method_.is_global || !wrapped_) return result;
  bool retried = false;
  while (evaluator_.halt() == Halt::None && round_ < evaluation_limit_) {
    // An exact optimum makes mlsl's local method fail at once: it starts there but once in a row.
    retried = method_.uses_gradients && result < 0 && !retried;
    if (!retried) round_ *= 2;
    y = retried || !method_.uses_gradients ? evaluator_.best().y : start;
    result = sweep(y);
  }
  return result;
}

}  // namespace camlaw::optim
