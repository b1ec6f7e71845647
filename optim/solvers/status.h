// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

/// What is seen of the solvers from outside: their names, how far they are, how they ended.
namespace camlaw::optim {

class LibraryMutex;

/// How a back end ended. It is a hint: whether a design is good the verdict says.
enum class Status {
  Solved,          ///< its own tests of optimality hold
  Acceptable,      ///< they hold to its looser tolerance
  Stalled,         ///< no more progress: steps too small, rounding
  IterationLimit,  ///< or limit of evaluations
  TimeLimit,
  Infeasible,      ///< it thinks that the rows contradict one another
  Unbounded,       ///< the objective falls without end
  NonFiniteStart,  ///< objective or rows are not numbers at the start
  Stopped,         ///< by the user
  Failed,          ///< anything else; the message says what
};
std::string_view to_string(Status status);

/// What is reported while a solver runs.
struct Progress {
  int iteration;
  double objective;  ///< scaled back to the problem's unit
  double violation;  ///< the largest of the scaled rows
  double done = 0;   ///< share of starts and combinations that are through; 0 where none can say
};

/// "ipopt", "slsqp", ...: what OptimiseOptions::solver may name.
std::vector<std::string> solver_names();

/// Held while Ipopt searches (numerics/library_mutex.h). A program that calls Ipopt or MUMPS itself
/// holds it meanwhile, where other threads may search.
LibraryMutex& ipopt_mutex();

}  // namespace camlaw::optim
