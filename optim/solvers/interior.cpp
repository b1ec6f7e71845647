// SPDX-License-Identifier: MIT
#include "optim/solvers/interior.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <chrono>
#include <cmath>

#include "optim/solvers/run_end.h"

/// An interior-point method for linear programs whose rows are local, each in a few of many
/// variables: Mehrotra's predictor and corrector (1992) on sparse normal equations.
namespace camlaw::optim {
namespace {

using InteriorClock = std::chrono::steady_clock;
using Eigen::VectorXd;

/// minimise cost . y where G y <= h: each row of the program with a side for each of its bounds,
/// then the bounds of the variables. Rows are kept once; sides refer to them.
class Sides {
 public:
  Sides(const Program& program, std::span<const double> y) {
    const Pattern& pattern = program.jacobian_pattern();
    const std::size_t n = program.variables(), m = program.rows();
    entries_.resize(pattern.size());
    program.jacobian(y, entries_);
    std::vector<double> values(m);
    program.row_values(y, values);
    begins_.assign(m + 1, 0);
    for (const int r : pattern.rows) ++begins_[static_cast<std::size_t>(r) + 1];
    for (std::size_t r = 0; r < m; ++r) begins_[r + 1] += begins_[r];
    columns_ = pattern.columns;  // row by row, as the pattern is
    variables_ = n;
    cost.resize(static_cast<Eigen::Index>(n));
    program.gradient(y, {cost.data(), n});
    for (std::size_t r = 0; r < m; ++r) {
      double at = 0;
      for (std::size_t k = begins_[r]; k < begins_[r + 1]; ++k) {
        at += entries_[k] * y[static_cast<std::size_t>(columns_[k])];
      }
      const double rest = values[r] - at;
      add(r, program.row_lower()[r] - rest, program.row_upper()[r] - rest);
    }
    for (std::size_t i = 0; i < n; ++i) {
      entries_.push_back(1);
      columns_.push_back(static_cast<int>(i));
      begins_.push_back(entries_.size());
      add(m + i, program.lower()[i], program.upper()[i]);
    }
    is_finite = all_finite(entries_) && all_finite(values) && cost.allFinite();
    level = Eigen::Map<const VectorXd>(levels_.data(), static_cast<Eigen::Index>(levels_.size()));
  }

  std::size_t variables() const { return variables_; }
  std::size_t rows() const { return begins_.size() - 1; }
  Eigen::Index count() const { return level.size(); }
  std::size_t row(Eigen::Index side) const { return rows_[static_cast<std::size_t>(side)]; }
  double sign(Eigen::Index side) const { return signs_[static_cast<std::size_t>(side)]; }

  /// G y.
  VectorXd times(const VectorXd& y) const {
    std::vector<double> at(rows(), 0.0);
    for (std::size_t r = 0; r < rows(); ++r) {
      for (std::size_t k = begins_[r]; k < begins_[r + 1]; ++k)
        at[r] += entries_[k] * y[columns_[k]];
    }
    VectorXd result(count());
    for (Eigen::Index i = 0; i < count(); ++i) result[i] = sign(i) * at[row(i)];
    return result;
  }
  /// G^T z.
  VectorXd transposed(const VectorXd& z) const {
    std::vector<double> of_row(rows(), 0.0);
    for (Eigen::Index i = 0; i < count(); ++i) of_row[row(i)] += sign(i) * z[i];
    VectorXd result = VectorXd::Zero(static_cast<Eigen::Index>(variables_));
    for (std::size_t r = 0; r < rows(); ++r) {
      if (of_row[r] == 0) continue;
      for (std::size_t k = begins_[r]; k < begins_[r + 1]; ++k)
        result[columns_[k]] += entries_[k] * of_row[r];
    }
    return result;
  }

  /// Entries of G^T W G, lower triangle: one list of places for all weights.
  void lay_out(Eigen::SparseMatrix<double>& K, std::vector<int>& places) const {
    std::vector<Eigen::Triplet<double>> triplets;
    each_pair([&](int i, int j, double) { triplets.emplace_back(i, j, 1.0); });
    K.resize(static_cast<Eigen::Index>(variables_), static_cast<Eigen::Index>(variables_));
    K.setFromTriplets(triplets.begin(), triplets.end());
    K.makeCompressed();
    places.clear();
    each_pair([&](int i, int j, double) {
      const int* begin = K.innerIndexPtr() + K.outerIndexPtr()[j];
      const int* end = K.innerIndexPtr() + K.outerIndexPtr()[j + 1];
      places.push_back(static_cast<int>(std::lower_bound(begin, end, i) - K.innerIndexPtr()));
    });
  }
  void weigh(const VectorXd& weights, Eigen::SparseMatrix<double>& K,
             const std::vector<int>& places) const {
    std::vector<double> of_row(rows(), 0.0);
    for (Eigen::Index i = 0; i < count(); ++i) of_row[row(i)] += weights[i];
    std::fill_n(K.valuePtr(), K.nonZeros(), 0.0);
    std::size_t next = 0;
    for (std::size_t r = 0; r < rows(); ++r) {
      for (std::size_t k = begins_[r]; k < begins_[r + 1]; ++k) {
        for (std::size_t l = begins_[r]; l <= k; ++l)
          K.valuePtr()[places[next++]] += of_row[r] * entries_[k] * entries_[l];
      }
    }
  }

  VectorXd cost, level;
  bool is_finite = true;

 private:
  void add(std::size_t row, double lower, double upper) {
    if (std::isfinite(upper)) rows_.push_back(row), signs_.push_back(1), levels_.push_back(upper);
    if (std::isfinite(lower)) rows_.push_back(row), signs_.push_back(-1), levels_.push_back(-lower);
  }
  template <class Take>
  void each_pair(const Take& take) const {
    for (std::size_t r = 0; r < rows(); ++r) {
      for (std::size_t k = begins_[r]; k < begins_[r + 1]; ++k) {
        for (std::size_t l = begins_[r]; l <= k; ++l) {
          take(std::max(columns_[k], columns_[l]), std::min(columns_[k], columns_[l]), 0);
        }
      }
    }
  }

  std::size_t variables_ = 0;
  std::vector<std::size_t> begins_;
  std::vector<int> columns_;
  std::vector<double> entries_;
  std::vector<std::size_t> rows_;  ///< of the sides
  std::vector<double> signs_, levels_;
};

/// Point, slacks and multipliers on the way.
class Interior {
 public:
  struct Step {
    VectorXd y, s, z;
  };

  Interior(const Sides& sides, std::span<const double> start) : sides_(sides) {
    now_.y = Eigen::Map<const VectorXd>(start.data(), static_cast<Eigen::Index>(start.size()));
    // Slacks of order one, as rows are scaled to be; small multipliers, which were seen to take
    // fewer iterations than those of order one.
    constexpr double kSlack = 1, kMultiplier = 1e-3;
    now_.s = (sides.level - sides.times(now_.y)).cwiseMax(kSlack);
    now_.z = VectorXd::Constant(sides.count(), kMultiplier);
    sides.lay_out(K_, places_);
    cholesky_.analyzePattern(K_);
  }

  const Step& now() const { return now_; }
  double objective() const { return sides_.cost.dot(now_.y); }
  double gap() const { return now_.s.dot(now_.z); }
  /// Over the objective, as far as that is not nearly zero.
  double relative_gap() const {
    constexpr double kLeast = 1e-9;
    return gap() / std::max(std::abs(objective()), kLeast);
  }
  /// The largest residual of a row; of a column.
  double primal() const {
    return (sides_.times(now_.y) + now_.s - sides_.level).cwiseAbs().maxCoeff();
  }
  double dual() const { return (sides_.cost + sides_.transposed(now_.z)).cwiseAbs().maxCoeff(); }

  bool step() {
    const VectorXd weights = now_.z.cwiseQuotient(now_.s);
    sides_.weigh(weights, K_, places_);
    for (Eigen::Index i = 0; i < K_.cols(); ++i) {
      double& d = K_.valuePtr()[K_.outerIndexPtr()[i]];
      d += 1e-15 * d + 1e-300;
    }
    cholesky_.factorize(K_);
    if (cholesky_.info() != Eigen::Success) return false;
    const VectorXd dual = sides_.cost + sides_.transposed(now_.z);
    const VectorXd primal = sides_.times(now_.y) + now_.s - sides_.level;
    const double mean = gap() / static_cast<double>(now_.s.size());
    const VectorXd products = now_.s.cwiseProduct(now_.z);
    const Step foresight = solve(dual, primal, products);
    const double ahead = (now_.s + reach(now_.s, foresight.s) * foresight.s)
                             .dot(now_.z + reach(now_.z, foresight.z) * foresight.z) /
                         static_cast<double>(now_.s.size());
    const double centring = std::pow(std::max(ahead, 0.0) / mean, 3);
    const VectorXd aimed = products + foresight.s.cwiseProduct(foresight.z) -
                           VectorXd::Constant(now_.s.size(), centring * mean);
    const Step step = solve(dual, primal, aimed);
    if (!step.y.allFinite() || !step.z.allFinite()) return false;
    const double primal_reach = short_of(reach(now_.s, step.s));
    const double dual_reach = short_of(reach(now_.z, step.z));
    now_.y += primal_reach * step.y;
    now_.s += primal_reach * step.s;
    now_.z += dual_reach * step.z;
    return std::max(primal_reach, dual_reach) > 1e-8;
  }

 private:
  static double reach(const VectorXd& x, const VectorXd& step) {
    double result = 1;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      if (step[i] < 0) result = std::min(result, -x[i] / step[i]);
    }
    return result;
  }
  static double short_of(double reach) { return reach < 1 ? 0.995 * reach : 1; }

  /// G dy + ds = -primal, G^T dz = -dual, z ds + s dz = -products.
  Step solve(const VectorXd& dual, const VectorXd& primal, const VectorXd& products) const {
    // Once more for what rounding left: normal equations square the condition.
    Step step = solve_once(dual, primal, products);
    const Step more =
        solve_once(dual + sides_.transposed(step.z), primal + sides_.times(step.y) + step.s,
                   products + now_.z.cwiseProduct(step.s) + now_.s.cwiseProduct(step.z));
    step.y += more.y;
    step.s += more.s;
    step.z += more.z;
    return step;
  }
  Step solve_once(const VectorXd& dual, const VectorXd& primal, const VectorXd& products) const {
    Step step;
    const VectorXd pull = (now_.z.cwiseProduct(primal) - products).cwiseQuotient(now_.s);
    step.y = cholesky_.solve(-dual - sides_.transposed(pull));
    step.s = -primal - sides_.times(step.y);
    step.z = (-products - now_.z.cwiseProduct(step.s)).cwiseQuotient(now_.s);
    return step;
  }

  const Sides& sides_;
  Step now_;
  Eigen::SparseMatrix<double> K_;
  std::vector<int> places_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> cholesky_;
};

class InteriorSolver final : public Solver {
 public:
  std::string name() const override { return "interior"; }
  bool is_global() const override { return false; }
  LinearEnd linear_end() const override { return LinearEnd::Sharp; }
  std::optional<std::string> refusal(const Program& program) const override {
    if (!program.is_linear()) {
      return "interior takes linear problems alone, and this one is not known to be linear";
    }
    if (program.has_equations()) return "interior takes no equations";
    return {};
  }

 private:
  Solution search(const Program& program, const SolverOptions& options,
                  const WarmStart* warm) const override {
    Solution solution;
    if (const auto why = refusal(program)) {
      solution.message = *why;
      return solution;
    }
    const std::span<const double> start = warm != nullptr ? warm->y : program.start();
    const Sides sides(program, start);
    solution.evaluations = 1;
    if (!sides.is_finite) {
      solution.status = Status::NonFiniteStart;
      solution.message = "not a number at the start";
      return solution;
    }
    if (sides.count() == 0) {
      solution.message = "nothing is bounded";
      return solution;
    }
    Interior interior(sides, start);
    const RunEnd end = followed(interior, program, options, solution.iterations);
    solution.status = end.status;
    solution.message = end.message;
    take(sides, interior.now(), program, solution);
    return solution;
  }

  /// Steps until the gap is closed or nothing is gained.
  static RunEnd followed(Interior& interior, const Program& program, const SolverOptions& options,
                         int& iterations) {
    constexpr double kGap = 2e-11, kLeft = 1e-9, kGood = 1e-7, kGain = 0.9;
    constexpr int kPatience = 8, kMost = 200;
    const auto began = InteriorClock::now();
    double least = kInfinity;
    for (int idle = 0;;) {
      const double gap = interior.relative_gap();
      const double left = std::max(interior.primal(), interior.dual());
      if (gap <= kGap && left <= kLeft) return {Status::Solved, "optimal to tolerance"};
      idle = gap < kGain * least ? 0 : idle + 1;
      least = std::min(least, gap);
      if (iterations >= std::min(options.max_iterations, kMost))
        return {Status::IterationLimit, "limit of iterations"};
      if (idle > kPatience || !interior.step()) {
        const bool good = gap <= kGood && left <= kGood;
        return {good ? Status::Acceptable : Status::Stalled, "no more progress"};
      }
      ++iterations;
      if (options.progress) {
        options.progress(
            {iterations, program.unscaled_objective(interior.objective()), interior.primal()});
      }
      const std::chrono::duration<double> spent = InteriorClock::now() - began;
      if (options.stop != nullptr && options.stop->load()) return {Status::Stopped, "stopped"};
      if (options.time_limit && spent.count() > *options.time_limit)
        return {Status::TimeLimit, "time limit"};
    }
  }

  static void take(const Sides& sides, const Interior::Step& now, const Program& program,
                   Solution& solution) {
    solution.y.assign(now.y.data(), now.y.data() + now.y.size());
    solution.rows.assign(program.rows(), 0.0);
    solution.lower.assign(program.variables(), 0.0);
    solution.upper.assign(program.variables(), 0.0);
    for (Eigen::Index i = 0; i < sides.count(); ++i) {
      const std::size_t row = sides.row(i);
      if (row < program.rows()) {
        solution.rows[row] += sides.sign(i) * now.z[i];
      } else {
        (sides.sign(i) > 0 ? solution.upper : solution.lower)[row - program.rows()] += now.z[i];
      }
    }
  }
};

}  // namespace

const Solver& interior_solver() {
  static const InteriorSolver solver;
  return solver;
}

}  // namespace camlaw::optim
