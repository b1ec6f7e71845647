// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

#include "optim/solvers/solver.h"

/// A program for methods that know neither NaN nor exceptions nor a stop flag. For nlopt.cpp alone.
namespace camlaw::optim {

/// A point of the search. It is undefined where objective or a row is not a finite number, and
/// where the search has been halted.
struct NloptPoint {
  std::vector<double> y;
  bool defined = false;
  double objective = kInfinity;
  double violation = kInfinity;  ///< the largest of the rows
  std::vector<double> rows;
};

/// Why a search must end, apart from the method's own tests.
enum class Halt { None, EvaluationLimit, TimeLimit, Stopped, Unbounded, Threw };

/// Evaluates a point once, however many questions a method asks there, remembers the best, and
/// watches the limits.
class Evaluator {
 public:
  Evaluator(const Program& program, const SolverOptions& options, long evaluation_limit);

  /// Objective and rows at y, drawn into the box. Valid until the next call.
  const NloptPoint& at(std::span<const double> y);
  /// The same with derivatives: the point is undefined where one of those is not a finite number.
  const NloptPoint& with_derivatives_at(std::span<const double> y);
  std::span<const double> gradient() const { return gradient_; }
  std::span<const double> jacobian() const { return jacobian_; }

  /// What a method is told of an undefined point, so that it steps back: an objective and a
  /// violation of each row that are worse than all met so far. No worse than that calls for:
  /// methods that fit models to values lose all digits to a huge one.
  double rejected_objective() const;
  double rejected_violation() const { return 2 * worst_violation_ + 1; }
  /// The rows at the last point that was defined.
  std::span<const double> last_defined_rows() const { return last_defined_rows_; }

  /// Feasible to the tolerance with the lowest objective, else of the least violation.
  const NloptPoint& best() const { return best_; }
  Halt halt() const { return halt_; }
  long evaluations() const { return evaluations_; }
  /// Whether one of the latest points was undefined: the search presses against such a region.
  bool undefined_lately() const;
  std::exception_ptr error() const { return error_; }

 private:
  void evaluate();
  void derive();
  void watch_limits();
  void remember();
  void compare_with_best();
  template <class Work>
  bool guarded(Work work);

  using Clock = std::chrono::steady_clock;
  const Program& program_;
  const SolverOptions& options_;
  const long evaluation_limit_;
  const Clock::time_point began_ = Clock::now();
  long evaluations_ = 0;
  std::optional<long> last_undefined_;  // evaluation
  Halt halt_ = Halt::None;
  std::exception_ptr error_;
  NloptPoint last_, best_;
  bool derived_ = false;  // whether the last point's derivatives are known
  std::vector<double> gradient_, jacobian_, last_defined_rows_;
  double least_objective_ = kInfinity, worst_objective_ = -kInfinity, worst_violation_ = 0;
};

/// At the end of a search a violation up to this (of scaled rows) counts as the method's rounding.
inline constexpr double kAcceptableViolation = 1e-6;

}  // namespace camlaw::optim
