// SPDX-License-Identifier: MIT
#include <ClpConfig.h>
#include <fmt/format.h>

#include <ClpEventHandler.hpp>
#include <ClpSimplex.hpp>
#include <CoinPackedMatrix.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include "optim/solvers/read_off.h"
#include "optim/solvers/run_end.h"

/// Clp: the simplex method for linear programs. What a program's functions are is asked for once,
/// at the start: a linear function is told by one value and one gradient.
namespace camlaw::optim {
namespace {

using Clock = std::chrono::steady_clock;

double open_end(double bound) {
  return std::isinf(bound) ? std::copysign(COIN_DBL_MAX, bound) : bound;
}

std::vector<double> open_ends(const Eigen::VectorXd& bounds) {
  std::vector<double> result(static_cast<std::size_t>(bounds.size()));
  std::transform(bounds.begin(), bounds.end(), result.begin(), open_end);
  return result;
}

/// By rows, as Clp takes it.
CoinPackedMatrix matrix_of(const QuadraticProgram& linear) {
  const auto& rows = linear.rows;
  std::vector<CoinBigIndex> begins(rows.outerIndexPtr(), rows.outerIndexPtr() + rows.rows() + 1);
  std::vector<int> lengths;
  for (std::size_t r = 0; r + 1 < begins.size(); ++r) lengths.push_back(begins[r + 1] - begins[r]);
  return {false,
          static_cast<int>(rows.cols()),
          static_cast<int>(rows.rows()),
          static_cast<CoinBigIndex>(rows.nonZeros()),
          rows.valuePtr(),
          rows.innerIndexPtr(),
          begins.data(),
          lengths.data()};
}

/// Ends a run when the user or the clock says so.
class EndOnRequest final : public ClpEventHandler {
 public:
  EndOnRequest(const SolverOptions& options, Clock::time_point began)
      : options_(&options), began_(began) {}

  int event(Event) override { return is_stopped(*options_) || is_late(*options_, began_) ? 1 : -1; }
  ClpEventHandler* clone() const override { return new EndOnRequest(*this); }

 private:
  const SolverOptions* options_;
  Clock::time_point began_;
};

/// The basis of an earlier solve, as far as its multipliers tell: what pushes is at its bound. Clp
/// mends a basis that has too few columns, or too many.
void begin_at(const Program& program, const WarmStart& warm, ClpSimplex& model) {
  using Status = ClpSimplex::Status;
  model.createStatus();
  model.setColSolution(warm.y.data());
  for (std::size_t i = 0; i < program.variables(); ++i) {
    const Status status = warm.lower[i] > 0   ? Status::atLowerBound
                          : warm.upper[i] > 0 ? Status::atUpperBound
                                              : Status::basic;
    model.setColumnStatus(static_cast<int>(i), status);
  }
  for (std::size_t r = 0; r < program.rows(); ++r) {
    const Status status = warm.rows[r] < 0   ? Status::atLowerBound
                          : warm.rows[r] > 0 ? Status::atUpperBound
                                             : Status::basic;
    model.setRowStatus(static_cast<int>(r), status);
  }
}

/// The basis of a start that is a vertex, or lies on an edge between two: what stands at its bound
/// is there in the basis too. False where the start is no such place.
bool begin_at_vertex(const Program& program, const QuadraticProgram& linear,
                     std::span<const double> y, ClpSimplex& model) {
  // Clp's own tolerances leave a variable at its bound as near as that.
  constexpr double kStands = 1e-9;
  using Status = ClpSimplex::Status;
  const std::size_t n = program.variables(), m = program.rows();
  const auto status_of = [&](double value, double lower, double upper) {
    const auto stands = [&](double bound) {
      return std::isfinite(bound) && std::abs(value - bound) <= kStands * (1 + std::abs(bound));
    };
    if (stands(lower)) return Status::atLowerBound;
    if (stands(upper)) return Status::atUpperBound;
    return Status::basic;
  };
  const Eigen::VectorXd activity =
      linear.rows * Eigen::Map<const Eigen::VectorXd>(y.data(), linear.cost.size());
  std::vector<Status> columns, rows;
  for (std::size_t i = 0; i < n; ++i)
    columns.push_back(status_of(y[i], program.lower()[i], program.upper()[i]));
  for (Eigen::Index r = 0; r < activity.size(); ++r)
    rows.push_back(status_of(activity[r], linear.row_lower[r], linear.row_upper[r]));
  const auto stand = [](const std::vector<Status>& all) {
    return static_cast<std::size_t>(
        std::count_if(all.begin(), all.end(), [](Status s) { return s != Status::basic; }));
  };
  const std::size_t standing = stand(columns) + stand(rows);
  constexpr std::size_t kFew = 30;  // variables: there is little to gain
  if (n <= kFew || standing > n || 4 * standing < 3 * n) return false;
  model.createStatus();
  model.setColSolution(y.data());
  for (std::size_t i = 0; i < n; ++i) model.setColumnStatus(static_cast<int>(i), columns[i]);
  for (std::size_t r = 0; r < m; ++r) model.setRowStatus(static_cast<int>(r), rows[r]);
  return true;
}

/// Options by the names of Clp's own functions.
std::vector<NativeRule> clp_rules() {
  using Kind = NativeRule::Kind;
  const char* own = "it follows from the tolerances of the problem's limits and objective";
  return {
      {.name = "dual_bound", .lower = 0, .above_lower = true},
      {.name = "factorization_frequency", .kind = Kind::Integer, .lower = 1, .upper = 10000},
      {.name = "perturbation", .kind = Kind::Integer, .lower = 50, .upper = 102},
      {.name = "scaling", .kind = Kind::Integer, .lower = 0, .upper = 4},
      reserved_option("dual_tolerance", own),
      reserved_option("log_level", "standard output is reserved for the answer"),
      reserved_option("maximum_iterations", "the limit of iterations is common to all solvers"),
      reserved_option("maximum_seconds", "the time limit is common to all solvers (time_limit)"),
      reserved_option("primal_tolerance", own)};
}

void set_native_options(const NativeOptions& native, ClpSimplex& model) {
  for (const auto& [name, value] : native) {
    const double number = number_of(value);
    const int whole = static_cast<int>(std::min(number, 1e9));
    if (name == "dual_bound") model.setDualBound(number);
    if (name == "factorization_frequency") model.setFactorizationFrequency(whole);
    if (name == "perturbation") model.setPerturbation(whole);
    if (name == "scaling") model.scaling(whole);
  }
}

RunEnd run_end(const ClpSimplex& model, const SolverOptions& options) {
  switch (model.status()) {
    case 0:
      return {Status::Solved, "optimal to tolerance"};
    case 1:
      return {Status::Infeasible, "the limits contradict one another"};
    case 2:
      return {Status::Unbounded, "the objective decreases without bound"};
    case 3:
    case 5:
      if (is_stopped(options)) return {Status::Stopped, "stopped"};
      if (model.hitMaximumIterations()) return {Status::IterationLimit, "limit of iterations"};
      return {Status::TimeLimit, "time limit"};
    default:
      return {Status::Failed, "the simplex method failed"};
  }
}

/// Point and multipliers with Ipopt's signs: Clp's prices are those of the rows' bounds, and its
/// reduced costs the rest of the gradient.
void take(const ClpSimplex& model, Solution& solution) {
  const auto n = static_cast<std::size_t>(model.numberColumns());
  const auto m = static_cast<std::size_t>(model.numberRows());
  const double* y = model.getColSolution();
  const double* price = model.getRowPrice();
  const double* reduced = model.getReducedCost();
  solution.y.assign(y, y + n);
  for (std::size_t r = 0; r < m; ++r) solution.rows.push_back(-price[r]);
  for (std::size_t i = 0; i < n; ++i) {
    solution.lower.push_back(std::max(reduced[i], 0.0));
    solution.upper.push_back(std::max(-reduced[i], 0.0));
  }
}

/// Clp stays at the vertex from which the objective falls without end: goes far out along the edge.
void follow_ray(const ClpSimplex& model, std::vector<double>& y) {
  constexpr double kFar = 1e6;  // scaled: far beyond any box, and what run_end takes for far out
  const std::unique_ptr<const double[]> ray(model.unboundedRay());
  if (ray == nullptr) return;
  double longest = 0;
  for (std::size_t i = 0; i < y.size(); ++i) longest = std::max(longest, std::abs(ray[i]));
  if (!(longest > 0)) return;
  for (std::size_t i = 0; i < y.size(); ++i) y[i] += kFar / longest * ray[i];
}

/// Pivots until an optimum is found, or most of them are made; how many they were. The primal
/// method ends what the dual one's scaling may leave.
int pivoted(ClpSimplex& model, int most, bool primal_first) {
  constexpr int kEnded = 5;  // by the event handler
  model.setMaximumIterations(most);
  int begun = 0;
  if (primal_first) {
    model.primal();
    begun = model.numberIterations();
    if (model.status() == 0 || model.status() == kEnded || begun >= most) return begun;
    model.setMaximumIterations(most - begun);
  }
  model.dual();
  const int first = begun + model.numberIterations();
  if ((model.status() != 0 && model.status() != 10) || first >= most) return first;
  model.setMaximumIterations(most - first);
  model.primal();
  return first + model.numberIterations();
}

void load(const QuadraticProgram& linear, const SolverOptions& options, ClpSimplex& model) {
  constexpr double kTightest = 1e-10;  // its pivots round to about as much
  model.setLogLevel(0);
  model.loadProblem(matrix_of(linear), open_ends(linear.lower).data(),
                    open_ends(linear.upper).data(), linear.cost.data(),
                    open_ends(linear.row_lower).data(), open_ends(linear.row_upper).data());
  model.setPrimalTolerance(std::max(options.tolerance, kTightest));
  model.setDualTolerance(std::max(options.tolerance, kTightest));
  set_native_options(options.native, model);
}

/// How many pivots a limit of iterations stands for: so many cost about as much as a step of other
/// methods.
constexpr int kPivots = 100;
int most_pivots(const SolverOptions& options) {
  constexpr long long kMost = 2'000'000'000;
  return static_cast<int>(std::min(1LL * kPivots * options.max_iterations, kMost));
}

/// More pivots than programs of this size take: the method goes round among vertices that rounding
/// does not tell apart.
int pivots_of_sense(const QuadraticProgram& linear) {
  constexpr Eigen::Index kLeast = 1000, kEach = 20, kMost = 100'000'000;
  return static_cast<int>(
      std::min(kLeast + kEach * (linear.rows.rows() + linear.rows.cols()), kMost));
}

class ClpSolver final : public Solver {
 public:
  std::string name() const override { return "clp"; }
  bool is_global() const override { return false; }
  bool solves_linear_programs() const override { return true; }
  std::vector<NativeRule> native_rules() const override { return clp_rules(); }

  std::optional<std::string> refusal(const Program& program) const override {
    if (program.is_linear()) return {};
    return "clp takes only linear problems, and this one is not known to be linear";
  }

 private:
  Solution search(const Program& program, const SolverOptions& options,
                  const WarmStart* warm) const override {
    const auto began = Clock::now();
    Solution solution;
    if (const auto why = refusal(program)) {
      solution.message = *why;
      return solution;
    }
    const std::span<const double> start = warm != nullptr ? warm->y : program.start();
    const auto read = read_at_start(program, start, solution);
    if (!read) return solution;
    const QuadraticProgram& linear = *read;
    ClpSimplex model;
    load(linear, options, model);
    const EndOnRequest handler(options, began);
    model.passInEventHandler(&handler);
    bool at_vertex = false;
    if (warm != nullptr && !warm->rows.empty()) {
      begin_at(program, *warm, model);
    } else {
      at_vertex = begin_at_vertex(program, linear, start, model);
    }
    const int allowed = most_pivots(options), sensible = pivots_of_sense(linear);
    const int pivots = pivoted(model, std::min(allowed, sensible), at_vertex);
    RunEnd end = run_end(model, options);
    if (end.status == Status::IterationLimit && sensible < allowed)
      end = {Status::Stalled, "cycles among vertices"};
    solution.status = end.status;
    solution.message = end.message;
    solution.iterations = 1 + pivots / kPivots;
    take(model, solution);
    if (solution.status == Status::Unbounded) follow_ray(model, solution.y);
    if (options.progress) {
      options.progress({solution.iterations,
                        program.unscaled_objective(program.objective(solution.y)),
                        model.sumPrimalInfeasibilities()});
    }
    return solution;
  }
};

}  // namespace

const Solver& clp_solver() {
  static const ClpSolver solver;
  return solver;
}

std::string clp_version() { return "clp " CLP_VERSION; }

}  // namespace camlaw::optim
