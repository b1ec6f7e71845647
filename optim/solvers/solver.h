// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "optim/solvers/program.h"
#include "optim/solvers/status.h"

/// Back ends: what a solver is to the rest of camlaw. Solver headers are included in the back ends'
/// .cpp files alone.
namespace camlaw::optim {

struct SolverOptions {
  double tolerance = 1e-9;                ///< of scaled rows, gradients and complementarity
  int max_iterations = 1000;              ///< of a local method
  long max_evaluations = 20000;           ///< of a global or derivative-free method
  std::optional<double> time_limit = {};  ///< seconds
  std::uint64_t seed = 1;                 ///< of methods that draw numbers
  /// Ipopt alone: by how much bounds and rows are widened. Its own default, 1e-8, is what lets it
  /// answer problems with designs that they exclude.
  double bound_relaxation = 0;
  const std::atomic<bool>* stop = nullptr;
  std::function<void(const Progress&)> progress = {};
};

/// A point to begin at, with multipliers where an earlier solve left them.
struct WarmStart {
  std::vector<double> y;
  std::vector<double> rows, lower, upper;  ///< multipliers, Ipopt's signs; empty where unknown
};

struct Solution {
  Status status = Status::Failed;
  std::string message;                     ///< the solver's own words
  std::vector<double> y;                   ///< the last or best point; empty if there is none
  std::vector<double> rows, lower, upper;  ///< multipliers, empty where the method has none
  int iterations = 0;
  long evaluations = 0;           ///< of the objective
  std::exception_ptr error = {};  ///< what the model threw, if it did
};

/// A method. Const and without state: one method may solve in many threads at once. Ipopt takes one
/// of them at a time; the others wait (ipopt_mutex), unless stop or their time limit ends that.
/// What a model does that is called by Ipopt must not wait for another thread that searches.
class Solver {
 public:
  virtual ~Solver() = default;
  virtual std::string name() const = 0;
  /// Searches the whole box instead of following the slope from the start.
  virtual bool is_global() const = 0;
  /// Why this method cannot take the program, in words; empty where it can.
  virtual std::optional<std::string> refusal(const Program& program) const = 0;
  /// Never throws what the model throws: that is kept in Solution::error.
  virtual Solution solve(const Program& program, const SolverOptions& options,
                         const WarmStart* warm = nullptr) const = 0;
};

/// "ipopt", "slsqp", ...; throws std::invalid_argument listing the known names.
const Solver& find_solver(std::string_view name);

/// The libraries behind the solvers with the versions in use: "ipopt 3.11.9".
std::vector<std::string> solver_versions();

/// The back ends' own lists.
const Solver& ipopt_solver();
const std::vector<const Solver*>& nlopt_solvers();
std::string ipopt_version();
std::string nlopt_version();

}  // namespace camlaw::optim
