// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "optim/problem/problem.h"
#include "optim/solvers/native_options.h"
#include "optim/solvers/status.h"
#include "optim/verdict/assessment.h"

/// The front door: a problem in, a judged design out.
namespace camlaw::optim {

/// A design that a search came to, for whoever wants to keep it.
struct Candidate {
  std::vector<std::size_t> options;  ///< the option taken of each choice
  std::vector<double> x;
  bool is_best = false;        ///< else nothing is known of it yet
  Assessment assessment = {};  ///< of the best one
};

struct OptimiseOptions {
  std::string solver = "auto";            ///< a name of solver_names(), or auto
  std::optional<int> starts = {};         ///< by default 1 where the problem is convex, else 8
  std::uint64_t seed = 1;                 ///< of starts and of methods that draw numbers
  std::optional<double> time_limit = {};  ///< seconds, for everything
  double spent = 0;                       ///< seconds of it that have passed before the search
  int max_iterations = 1000;              ///< of each local solve
  long max_evaluations = 20000;           ///< of each solve by a global or derivative-free method
  std::optional<double> memory = {};      ///< bytes that a search may take (memory.h)
  /// Of each solver by its name, wherever that solver runs.
  std::map<std::string, NativeOptions> native = {};
  bool divides = true;  ///< whether a lower bound is sought by dividing the box (subdivided)
  bool narrows = true;  ///< whether limits in no one's way are taken out of a blame (narrow_blame)
  const std::atomic<bool>* stop = nullptr;
  std::function<void(const Progress&)> progress = {};
  /// Called with designs that a search came to: before it is known what one is worth, and again
  /// where it proves better than all before it.
  std::function<void(const Candidate&)> candidate = {};
};

/// Throws std::invalid_argument for an unknown solver, and for native options that the solver of
/// that name does not accept.
void check_solvers(const OptimiseOptions& options);

/// What the search came to.
struct Found {
  std::vector<double> x;  ///< empty where the model gave no numbers anywhere
  Assessment assessment;
  Status status = Status::Failed;  ///< of the solve that led to it
  std::string solver;              ///< that led to it, "slsqp"
  std::string why_solver;          ///< where auto chose it
  int starts = 0;                  ///< searched from
  int planned_starts = 0;          ///< what it would have been, had nothing stopped it
  int agreed = 0;                  ///< ended at designs as good as the best (1e-6)
  int iterations = 0;
  long evaluations = 0;
  int solves = 0;

  /// Counts what another search took as its own.
  void add_work(const Found& other) {
    iterations += other.iterations;
    evaluations += other.evaluations;
    solves += other.solves;
  }
};

/// What was found in one combination of choices.
struct PartFound {
  std::vector<std::size_t> options;  ///< the option taken of each choice
  std::vector<double> x;
  double objective;
  Verdict verdict;
  std::vector<std::string> active;  ///< what holds it, or of an infeasible one what cannot be met
  /// Whether its integers were all tried, or left out by bounds that hold everywhere.
  bool is_settled = true;
};

/// The answer to a problem.
struct Optimum {
  std::vector<std::size_t> options;   ///< the option taken of each choice
  Problem problem;                    ///< the problem of those options
  Found found;                        ///< design, assessment, how it was found
  std::size_t combinations = 1;       ///< of options and integer values
  std::size_t solved = 1;             ///< of them, or of the nodes of a branch and bound
  std::vector<PartFound> parts = {};  ///< of every combination of choices that was looked at
  double wall_s = 0;
};

class Crew;

/// Solves a problem: continuous variables by a local or global method from one or several starts,
/// choices and integer variables by enumeration, or by branch and bound where there are too many
/// combinations. The verdict is the code's own (optim/verdict). Throws std::invalid_argument for a
/// problem that is not well posed, for an unknown solver and for native options that it does not
/// accept.
Optimum optimise(const ProblemSpace& space, const OptimiseOptions& options = {});
Optimum optimise(const Problem& problem, const OptimiseOptions& options = {});
/// The same where processes of a crew (optim/crew/crew.h) may search from the starts, and in the
/// combinations, side by side: with the same answer to the last bit. Where a worker is a program,
/// `space` is that of the problem that it is sent. Of a process that dies the verdict tells.
Optimum optimise(const ProblemSpace& space, const OptimiseOptions& options, Crew& crew);

}  // namespace camlaw::optim
