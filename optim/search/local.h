// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "optim/search/deadline.h"
#include "optim/solvers/solver.h"
#include "optim/verdict/verdict.h"

/// Search in the continuous variables of one problem.
namespace camlaw::optim {

/// A design that a search came to, for whoever wants to keep it.
struct Candidate {
  std::vector<std::size_t> options;  ///< the option taken of each choice
  std::vector<double> x;
  bool is_best = false;  ///< else nothing is known of it yet
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

/// Searches from one or several starts, proves the best design over the cycle, and where no design
/// meets the limits looks for the one of least violation. Once the deadline has passed, the best
/// design of those that were found is judged in haste, and the reason says so. Integer variables
/// count as continuous; fix them by equal bounds. Never throws what the model throws: that is a
/// failed assessment. `prove`: as of assess(); without, the best design is not proved.
Found search_continuous(const Problem& problem, const OptimiseOptions& options,
                        const Deadline& deadline, bool prove);

/// What is said of a design on which a search was cut short.
Found cut_short(const Problem& problem, const std::vector<double>& x, const std::string& why);

}  // namespace camlaw::optim
