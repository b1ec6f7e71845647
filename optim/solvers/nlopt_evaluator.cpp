// SPDX-License-Identifier: MIT
#include "optim/solvers/nlopt_evaluator.h"

#include <algorithm>
#include <cmath>

#include "optim/solvers/run_end.h"

namespace camlaw::optim {
namespace {

// Objectives are scaled to order one: nothing but a fall without end gets here.
constexpr double kBottomless = -1e12;
// Local methods end within about so many points of the last step that they tried.
constexpr long kLately = 10;

double largest_violation(const Program& program, std::span<const double> rows) {
  double largest = 0;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    largest =
        std::max({largest, rows[r] - program.row_upper()[r], program.row_lower()[r] - rows[r]});
  }
  return largest;
}

/// Feasible before infeasible, then the lower objective; among the infeasible the lesser violation.
bool better(const NloptPoint& a, const NloptPoint& b, double tolerance) {
  const bool feasible = a.violation <= tolerance;
  if (feasible != (b.violation <= tolerance)) return feasible;
  if (feasible || a.violation == b.violation) return a.objective < b.objective;
  return a.violation < b.violation;
}

}  // namespace

Evaluator::Evaluator(const Program& program, const SolverOptions& options, long evaluation_limit)
    : program_(program),
      options_(options),
      evaluation_limit_(evaluation_limit),
      gradient_(program.variables()),
      jacobian_(program.jacobian_pattern().size()) {
  last_.rows.resize(program.rows());
}

const NloptPoint& Evaluator::at(std::span<const double> y) {
  std::vector<double> inside(y.begin(), y.end());
  for (std::size_t i = 0; i < inside.size(); ++i) {
    inside[i] = std::min(std::max(inside[i], program_.lower()[i]), program_.upper()[i]);
  }
  if (evaluations_ > 0 && inside == last_.y) return last_;
  last_.y = std::move(inside);
  evaluate();
  return last_;
}

const NloptPoint& Evaluator::with_derivatives_at(std::span<const double> y) {
  at(y);
  if (last_.defined && !derived_) derive();
  return last_;
}

double Evaluator::rejected_objective() const {
  return worst_objective_ + (worst_objective_ - least_objective_) + 1;
}

bool Evaluator::undefined_lately() const {
  return last_undefined_ && evaluations_ - *last_undefined_ < kLately;
}

void Evaluator::evaluate() {
  last_.defined = derived_ = false;
  last_.violation = kInfinity;
  watch_limits();
  if (halt_ != Halt::None) return;
  ++evaluations_;
  const bool returned = guarded([&] {
    last_.objective = program_.objective(last_.y);
    program_.row_values(last_.y, last_.rows);
  });
  last_.defined = returned && std::isfinite(last_.objective) && all_finite(last_.rows);
  if (last_.defined) {
    remember();
  } else {
    last_undefined_ = evaluations_;
  }
}

void Evaluator::derive() {
  const bool returned = guarded([&] {
    program_.gradient(last_.y, gradient_);
    program_.jacobian(last_.y, jacobian_);
  });
  derived_ = true;
  last_.defined = returned && all_finite(gradient_) && all_finite(jacobian_);
  if (last_.defined) return;
  last_.violation = kInfinity;
  last_undefined_ = evaluations_;
}

void Evaluator::watch_limits() {
  if (halt_ != Halt::None) return;
  const std::chrono::duration<double> spent = Clock::now() - began_;
  if (is_stopped(options_)) {
    halt_ = Halt::Stopped;
  } else if (options_.time_limit && spent.count() >= *options_.time_limit) {
    halt_ = Halt::TimeLimit;
  } else if (evaluations_ >= evaluation_limit_) {
    halt_ = Halt::EvaluationLimit;
  }
}

void Evaluator::remember() {
  last_.violation = largest_violation(program_, last_.rows);
  last_defined_rows_ = last_.rows;
  least_objective_ = std::min(least_objective_, last_.objective);
  worst_objective_ = std::max(worst_objective_, last_.objective);
  worst_violation_ = std::max(worst_violation_, last_.violation);
  compare_with_best();
}

void Evaluator::compare_with_best() {
  if (best_.defined && !better(last_, best_, options_.tolerance)) return;
  best_ = last_;
  if (best_.violation <= kAcceptableViolation && best_.objective < kBottomless &&
      is_far_out(program_, best_.y)) {
    halt_ = Halt::Unbounded;
  }
  if (!options_.progress) return;
  guarded([&] {
    options_.progress({static_cast<int>(evaluations_), program_.unscaled_objective(best_.objective),
                       best_.violation});
  });
}

/// The first exception is kept and halts the search: none may fly through NLopt's C.
template <class Work>
bool Evaluator::guarded(Work work) {
  try {
    work();
    return true;
  } catch (...) {
    error_ = std::current_exception();
    halt_ = Halt::Threw;
    return false;
  }
}

}  // namespace camlaw::optim
