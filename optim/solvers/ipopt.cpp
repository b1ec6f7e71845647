// SPDX-License-Identifier: MIT
#include <IpoptConfig.h>
#include <fmt/format.h>

#include <IpTNLP.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>

#include "numerics/library_mutex.h"
#include "optim/solvers/exit_guard.h"
#include "optim/solvers/ipopt_options.h"
#include "optim/solvers/run_end.h"

/// Ipopt: interior point with exact sparse second derivatives. Its linear solver, MUMPS, has its
/// state in static variables: one thread at a time searches, in the whole process.
namespace camlaw::optim {
namespace {

using Ipopt::Index;
using Ipopt::Number;
using Clock = std::chrono::steady_clock;

constexpr Number kUnbounded = 2e19;  // Ipopt reads 1e19 and beyond as no bound

Number clipped(double bound) { return std::clamp(bound, -kUnbounded, kUnbounded); }

/// The program as Ipopt asks for it. Whatever is not a number makes a callback return false, on
/// which Ipopt shortens its step.
class Adapter final : public Ipopt::TNLP {
 public:
  Adapter(const Program& program, const SolverOptions& options, const WarmStart* warm)
      : program_(program), options_(options), warm_(warm), began_(Clock::now()) {}

  Solution solution;
  bool stopped = false, out_of_time = false;

  bool get_nlp_info(Index& n, Index& m, Index& jacobian, Index& hessian,
                    IndexStyleEnum& style) override {
    n = static_cast<Index>(program_.variables());
    m = static_cast<Index>(program_.rows());
    jacobian = static_cast<Index>(program_.jacobian_pattern().size());
    hessian = static_cast<Index>(program_.hessian_pattern().size());
    style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Index, Number* lower, Number* upper, Index, Number* row_lower,
                       Number* row_upper) override {
    std::transform(program_.lower().begin(), program_.lower().end(), lower, clipped);
    std::transform(program_.upper().begin(), program_.upper().end(), upper, clipped);
    std::transform(program_.row_lower().begin(), program_.row_lower().end(), row_lower, clipped);
    std::transform(program_.row_upper().begin(), program_.row_upper().end(), row_upper, clipped);
    return true;
  }

  bool get_starting_point(Index n, bool, Number* y, bool want_bounds, Number* z_lower,
                          Number* z_upper, Index m, bool want_rows, Number* rows) override {
    const auto start = warm_ != nullptr ? std::span<const double>(warm_->y) : program_.start();
    std::copy_n(start.begin(), n, y);
    if (warm_ != nullptr && want_bounds) {
      std::copy_n(warm_->lower.begin(), n, z_lower);
      std::copy_n(warm_->upper.begin(), n, z_upper);
    }
    if (warm_ != nullptr && want_rows) std::copy_n(warm_->rows.begin(), m, rows);
    return true;
  }

  bool eval_f(Index n, const Number* y, bool, Number& value) override {
    return guarded([&] {
      ++solution.evaluations;
      value = program_.objective({y, static_cast<std::size_t>(n)});
      return std::isfinite(value);
    });
  }

  bool eval_grad_f(Index n, const Number* y, bool, Number* gradient) override {
    const auto size = static_cast<std::size_t>(n);
    return guarded([&] {
      program_.gradient({y, size}, {gradient, size});
      return all_finite({gradient, size});
    });
  }

  bool eval_g(Index n, const Number* y, bool, Index m, Number* values) override {
    const std::span<double> rows(values, static_cast<std::size_t>(m));
    return guarded([&] {
      program_.row_values({y, static_cast<std::size_t>(n)}, rows);
      return all_finite(rows);
    });
  }

  bool eval_jac_g(Index n, const Number* y, bool, Index, Index entries, Index* rows, Index* columns,
                  Number* values) override {
    if (values == nullptr) {
      std::copy_n(program_.jacobian_pattern().rows.begin(), entries, rows);
      std::copy_n(program_.jacobian_pattern().columns.begin(), entries, columns);
      return true;
    }
    const std::span<double> out(values, static_cast<std::size_t>(entries));
    return guarded([&] {
      program_.jacobian({y, static_cast<std::size_t>(n)}, out);
      return all_finite(out);
    });
  }

  bool eval_h(Index n, const Number* y, bool, Number weight, Index m, const Number* multipliers,
              bool, Index entries, Index* rows, Index* columns, Number* values) override {
    if (values == nullptr) {
      std::copy_n(program_.hessian_pattern().rows.begin(), entries, rows);
      std::copy_n(program_.hessian_pattern().columns.begin(), entries, columns);
      return true;
    }
    const std::span<double> out(values, static_cast<std::size_t>(entries));
    return guarded([&] {
      program_.hessian({y, static_cast<std::size_t>(n)}, weight,
                       {multipliers, static_cast<std::size_t>(m)}, out);
      return all_finite(out);
    });
  }

  bool intermediate_callback(Ipopt::AlgorithmMode, Index iteration, Number objective,
                             Number violation, Number, Number, Number, Number, Number, Number,
                             Index, const Ipopt::IpoptData*,
                             Ipopt::IpoptCalculatedQuantities*) override {
    solution.iterations = iteration;
    if (options_.progress) {
      guarded([&] {
        options_.progress({iteration, program_.unscaled_objective(objective), violation});
        return true;
      });
    }
    return !must_end() && !solution.error;
  }

  /// Whether the user or the clock ends the search; keeps which of them.
  bool must_end() {
    stopped = is_stopped(options_);
    out_of_time = is_late(options_, began_);
    return stopped || out_of_time;
  }

  void finalize_solution(Ipopt::SolverReturn, Index n, const Number* y, const Number* z_lower,
                         const Number* z_upper, Index m, const Number*, const Number* rows, Number,
                         const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) override {
    solution.y.assign(y, y + n);
    solution.lower.assign(z_lower, z_lower + n);
    solution.upper.assign(z_upper, z_upper + n);
    solution.rows.assign(rows, rows + m);
  }

 private:
  /// Exceptions must not fly through the solver: the first is kept, and the run ends.
  template <class Work>
  bool guarded(Work work) {
    if (solution.error) return false;
    const ExitGuard model(nullptr);
    try {
      return work();
    } catch (...) {
      solution.error = std::current_exception();
      return false;
    }
  }

  const Program& program_;
  const SolverOptions& options_;
  const WarmStart* warm_;
  Clock::time_point began_;
};

RunEnd run_end(Ipopt::ApplicationReturnStatus status) {
  switch (status) {
    case Ipopt::Solve_Succeeded:
      return {Status::Solved, "optimal to tolerance"};
    case Ipopt::Solved_To_Acceptable_Level:
      return {Status::Acceptable, "optimal to the acceptable level"};
    case Ipopt::Infeasible_Problem_Detected:
      return {Status::Infeasible, "converged to a point of local infeasibility"};
    case Ipopt::Search_Direction_Becomes_Too_Small:
      return {Status::Stalled, "search direction becomes too small"};
    case Ipopt::Diverging_Iterates:
      return {Status::Unbounded, "iterates diverge"};
    case Ipopt::Maximum_Iterations_Exceeded:
      return {Status::IterationLimit, "limit of iterations"};
    case Ipopt::Restoration_Failed:
      return {Status::Stalled, "restoration failed"};
    case Ipopt::Error_In_Step_Computation:
      return {Status::Stalled, "no step could be computed"};
    case Ipopt::Not_Enough_Degrees_Of_Freedom:
      return {Status::Failed, "more equations than variables"};
    case Ipopt::Invalid_Option:
      return {Status::Failed, "this build of Ipopt cannot do what its options ask for"};
    case Ipopt::Invalid_Number_Detected:
      return {Status::Failed, "the model is undefined"};
    default:
      return {Status::Failed, "failed"};
  }
}

/// Whether objective and rows are numbers where the search begins; keeps what the model throws.
bool finite_start(const Program& program, std::span<const double> y, Solution& solution) {
  try {
    std::vector<double> rows(program.rows());
    program.row_values(y, rows);
    return std::isfinite(program.objective(y)) && all_finite(rows);
  } catch (...) {
    solution.error = std::current_exception();
    return false;
  }
}

class IpoptSolver final : public Solver {
 public:
  std::string name() const override { return "ipopt"; }
  bool is_global() const override { return false; }

  std::optional<std::string> refusal(const Program& program) const override {
    std::size_t equations = 0;
    for (std::size_t r = 0; r < program.rows(); ++r) equations += program.row_is_equation(r);
    if (equations > program.variables()) {
      return "ipopt needs at least as many variables as equations";
    }
    return {};
  }

  std::vector<NativeRule> native_rules() const override { return ipopt_rules(); }

 private:
  Solution search(const Program& program, const SolverOptions& options,
                  const WarmStart* warm) const override {
    const bool with_multipliers = warm != nullptr && warm->rows.size() == program.rows() &&
                                  warm->lower.size() == program.variables() &&
                                  warm->upper.size() == program.variables();
    Ipopt::SmartPtr<Adapter> adapter =
        new Adapter(program, options, with_multipliers ? warm : nullptr);
    Solution& solution = adapter->solution;
    const auto start = with_multipliers ? std::span<const double>(warm->y) : program.start();
    if (!finite_start(program, start, solution)) {
      solution.status = solution.error ? Status::Failed : Status::NonFiniteStart;
      solution.message = solution.error ? "the model raised an error" : "not a number at the start";
      return solution;
    }
    if (program.variables() == 0) {
      solution.status = Status::Solved;
      solution.message = "nothing varies";
      return solution;
    }
    if (ipopt_mutex().lock_unless([&] { return adapter->must_end(); })) {
      const std::lock_guard lock(ipopt_mutex(), std::adopt_lock);
      const ExitGuard guard("the linear solver of Ipopt");
      run(adapter, options, with_multipliers);
    }
    name_end(*adapter);
    return solution;
  }

  static void name_end(Adapter& adapter) {
    Solution& solution = adapter.solution;
    if (adapter.stopped) solution.status = Status::Stopped, solution.message = "stopped";
    if (adapter.out_of_time) solution.status = Status::TimeLimit, solution.message = "time limit";
    if (solution.error)
      solution.status = Status::Failed, solution.message = "the model raised an error";
  }

  static void run(const Ipopt::SmartPtr<Adapter>& adapter, const SolverOptions& options,
                  bool warm) {
    Solution& solution = adapter->solution;
    Ipopt::IpoptApplication application(false);
    set_ipopt_options(*application.Options(), options, warm);
    application.Initialize("");
    const auto status = application.OptimizeTNLP(GetRawPtr(adapter));
    const auto result = run_end(status);
    solution.status = result.status;
    solution.message = result.message;
    if (status == Ipopt::Invalid_Option) {
      for (const auto& [name, value] : options.native) {
        solution.message += fmt::format(", {} {}", name, to_text(value));
      }
    }
  }
};

}  // namespace

LibraryMutex& ipopt_mutex() {
  static LibraryMutex mutex;
  return mutex;
}

const Solver& ipopt_solver() {
  static const IpoptSolver solver;
  return solver;
}

std::string ipopt_version() { return "ipopt " IPOPT_VERSION; }

}  // namespace camlaw::optim
