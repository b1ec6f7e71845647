// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "optim/solvers/native_options.h"
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
  const std::atomic<bool>* stop = nullptr;
  std::function<void(const Progress&)> progress = {};
  NativeOptions native = {};  ///< what this method alone understands (Solver::native_rules)
};

/// A point to begin at, with multipliers where an earlier solve left them.
struct WarmStart {
  std::vector<double> y;
  /// Multipliers, empty where unknown, with Ipopt's signs: the gradients of the objective and of
  /// rows * row - lower * y + upper * y add up to zero; lower and upper are not negative.
  std::vector<double> rows, lower, upper;
};

struct Solution {
  Status status = Status::Failed;
  std::string message = {};    ///< the solver's own words
  std::vector<double> y = {};  ///< the last or best point; empty if there is none
  /// Multipliers, empty where the method has none.
  std::vector<double> rows = {}, lower = {}, upper = {};
  int iterations = 0;
  long evaluations = 0;           ///< of the objective
  std::exception_ptr error = {};  ///< what the model threw, if it did, or the method itself
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
  /// Whether it ends at the optimum of a linear program, as far as doubles go, and not near it.
  virtual bool solves_linear_programs() const { return false; }
  /// Whether it ends at an optimum of what it takes, as far as doubles go, with multipliers that
  /// hold it there.
  virtual bool is_sharp() const { return solves_linear_programs(); }
  /// Why this method cannot take the program, in words; empty where it can.
  virtual std::optional<std::string> refusal(const Program& program) const = 0;
  /// The options that it has beside those of SolverOptions.
  virtual std::vector<NativeRule> native_rules() const { return {}; }

  /// Searches, and keeps of what the method says only what can be true: a point that is finite and
  /// has as many numbers as the program has variables, multipliers likewise, and that the objective
  /// falls without end only from a point that is far out. Whatever is thrown on the way, by the
  /// model or by the method, is kept in Solution::error. Throws std::invalid_argument for native
  /// options that the method does not accept.
  Solution solve(const Program& program, const SolverOptions& options,
                 const WarmStart* warm = nullptr) const;

 private:
  /// From warm, where it is given, else from the program's start. The native options have been
  /// checked. What the model throws may be let through.
  virtual Solution search(const Program& program, const SolverOptions& options,
                          const WarmStart* warm) const = 0;
};

/// Throws std::invalid_argument where the solver does not accept one of these (native_options.h).
void check_native_options(const Solver& solver, const NativeOptions& options);

/// "ipopt", "slsqp", ..., and those that were registered; throws std::invalid_argument listing the
/// known names.
const Solver& find_solver(std::string_view name);

/// Makes a solver known by its name to everything that knows solvers, for as long as the program
/// runs. Other threads may search meanwhile. Throws std::invalid_argument for none at all, for a
/// name that is taken, and for one that problem files could not have: it is made of the letters
/// a to z, digits and -, begins with a letter, and is neither "auto" nor a key of [solver].
void register_solver(std::unique_ptr<const Solver> solver);
/// Whether the solver was registered: processes that were not copied from this one do not know it.
bool is_registered(std::string_view name);

/// The libraries behind the solvers with the versions in use: "ipopt 3.11.9".
std::vector<std::string> solver_versions();

/// The back ends' own lists.
const Solver& clp_solver();
const Solver& ipopt_solver();
const std::vector<const Solver*>& nlopt_solvers();
std::string clp_version();
std::string ipopt_version();
std::string nlopt_version();

}  // namespace camlaw::optim
