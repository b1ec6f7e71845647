// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "optim/cycle/scales.h"
#include "optim/problem/problem.h"
#include "optim/solvers/solver.h"
#include "optim/verdict/kkt.h"

/// One local search: a problem whose limits hold over the whole cycle, solved as a sequence of
/// programs with limits at a few angles each (the exchange method; docs/optimisation.md, "Exchange
/// method").
namespace camlaw::optim {

/// What is searched for: the objective's optimum, or the design whose largest violation, counted in
/// the constraints' scales, is least.
enum class Aim { Optimum, LeastViolation };

/// How a search ended.
struct Attempt {
  std::vector<double> x;  ///< empty where the model gave no numbers at all
  Status status = Status::Failed;
  std::string message;
  int rounds = 0;  ///< programs solved
  int iterations = 0;
  long evaluations = 0;  ///< of the objective
  std::size_t rows = 0;  ///< of the last program
  /// What held the design in the last program, where that was linear.
  std::vector<Push> told;
  std::exception_ptr error = {};
};

/// Searches from `start`. Peaks are found after each solve; angles where a limit is passed, or a
/// peak stands above the bound that the solver worked with, join the program, until none does.
Attempt exchange(const Problem& problem, const Scales& scales, Design start, const Solver& solver,
                 const SolverOptions& options, Aim aim = Aim::Optimum);

/// Why a solver cannot take the problem; empty where it can.
std::optional<std::string> refusal(const Problem& problem, const Scales& scales, Design start,
                                   const Solver& solver);

}  // namespace camlaw::optim
