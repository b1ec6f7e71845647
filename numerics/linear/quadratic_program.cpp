// SPDX-License-Identifier: MIT
#include "numerics/linear/quadratic_program.h"

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace camlaw::optim {
namespace {

using Eigen::VectorXd;

/// minimise cost . y + y . curvature y / 2 where G y <= h and E y = e: each row of the program with
/// a side for each of its bounds, then the bounds of the variables. Rows are kept once; sides refer
/// to them. Equations are few.
class Sides {
 public:
  explicit Sides(const QuadraticProgram& program)
      : cost(program.cost),
        curvature(program.curvature),
        variables_(static_cast<std::size_t>(program.cost.size())) {
    Eigen::SparseMatrix<double, Eigen::RowMajor> rows = program.rows;
    rows.makeCompressed();
    curvature.makeCompressed();
    entries_.assign(rows.valuePtr(), rows.valuePtr() + rows.nonZeros());
    columns_.assign(rows.innerIndexPtr(), rows.innerIndexPtr() + rows.nonZeros());
    begins_.assign(rows.outerIndexPtr(), rows.outerIndexPtr() + rows.rows() + 1);
    const auto m = static_cast<std::size_t>(rows.rows());
    counts_.assign(m + variables_, true);
    std::vector<double> demanded;
    for (Eigen::Index r = 0; r < rows.rows(); ++r) {
      if (program.row_lower[r] == program.row_upper[r]) {
        counts_[static_cast<std::size_t>(r)] = false;
        equations_.push_back(r);
        demanded.push_back(program.row_upper[r]);
      } else {
        add(static_cast<std::size_t>(r), program.row_lower[r], program.row_upper[r]);
      }
    }
    equations.resize(static_cast<Eigen::Index>(equations_.size()), rows.cols());
    for (std::size_t k = 0; k < equations_.size(); ++k)
      equations.row(static_cast<Eigen::Index>(k)) = rows.row(equations_[k]);
    values = Eigen::Map<const VectorXd>(demanded.data(), equations.rows());
    for (std::size_t i = 0; i < variables_; ++i) {
      entries_.push_back(1);
      columns_.push_back(static_cast<int>(i));
      begins_.push_back(entries_.size());
      const auto at = static_cast<Eigen::Index>(i);
      add(m + i, program.lower[at], program.upper[at]);
    }
    level = Eigen::Map<const VectorXd>(levels_.data(), static_cast<Eigen::Index>(levels_.size()));
  }

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

  /// The gradient of the cost.
  VectorXd slope(const VectorXd& y) const {
    return is_linear() ? cost : cost + curvature.selfadjointView<Eigen::Lower>() * y;
  }
  double objective(const VectorXd& y) const { return 0.5 * (cost + slope(y)).dot(y); }
  bool is_linear() const { return curvature.nonZeros() == 0; }

  /// Entries of curvature + G^T W G, lower triangle: one list of places for all weights.
  void lay_out(Eigen::SparseMatrix<double>& K, std::vector<int>& places) const {
    std::vector<Eigen::Triplet<double>> triplets;
    each_pair([&](int i, int j) { triplets.emplace_back(i, j, 1.0); });
    K.resize(static_cast<Eigen::Index>(variables_), static_cast<Eigen::Index>(variables_));
    K.setFromTriplets(triplets.begin(), triplets.end());
    K.makeCompressed();
    places.clear();
    each_pair([&](int i, int j) {
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
      if (!counts_[r]) continue;
      for (std::size_t k = begins_[r]; k < begins_[r + 1]; ++k) {
        for (std::size_t l = begins_[r]; l <= k; ++l)
          K.valuePtr()[places[next++]] += of_row[r] * entries_[k] * entries_[l];
      }
    }
    for (Eigen::Index k = 0; k < curvature.nonZeros(); ++k)
      K.valuePtr()[places[next++]] += curvature.valuePtr()[k];
  }

  /// The rows that are equations, in order.
  const std::vector<Eigen::Index>& equation_rows() const { return equations_; }

  VectorXd cost, level;
  Eigen::SparseMatrix<double> curvature;  ///< compressed; of size 0 where there is none
  Eigen::MatrixXd equations;              ///< equations y = values
  VectorXd values;

 private:
  void add(std::size_t row, double lower, double upper) {
    if (std::isfinite(upper)) rows_.push_back(row), signs_.push_back(1), levels_.push_back(upper);
    if (std::isfinite(lower)) rows_.push_back(row), signs_.push_back(-1), levels_.push_back(-lower);
  }
  template <class Take>
  void each_pair(const Take& take) const {
    for (std::size_t r = 0; r < rows(); ++r) {
      if (!counts_[r]) continue;
      for (std::size_t k = begins_[r]; k < begins_[r + 1]; ++k) {
        for (std::size_t l = begins_[r]; l <= k; ++l) {
          take(std::max(columns_[k], columns_[l]), std::min(columns_[k], columns_[l]));
        }
      }
    }
    for (Eigen::Index j = 0; j < curvature.outerSize(); ++j) {
      for (Eigen::SparseMatrix<double>::InnerIterator entry(curvature, j); entry; ++entry)
        take(static_cast<int>(entry.row()), static_cast<int>(entry.col()));
    }
  }

  std::size_t variables_ = 0;
  std::vector<std::size_t> begins_;
  std::vector<int> columns_;
  std::vector<double> entries_;
  std::vector<bool> counts_;  ///< whether a row counts in G^T W G: all but equations do
  std::vector<Eigen::Index> equations_;
  std::vector<std::size_t> rows_;  ///< of the sides
  std::vector<double> signs_, levels_;
};

/// Point, slacks and multipliers on the way.
class Interior {
 public:
  struct Step {
    VectorXd y, s, z;
    VectorXd w = {};  ///< multipliers of the equations
  };

  Interior(const Sides& sides, const VectorXd& start) : sides_(sides) {
    now_.y = start;
    // Slacks of order one, as rows are scaled to be. Of linear programs small multipliers, which
    // were seen to take fewer iterations than those of order one; of quadratic ones they take more.
    // Mehrotra's own start takes a tenth fewer where it works, and was seen to stall.
    const double kSlack = 1, kMultiplier = sides.is_linear() ? 1e-3 : 1;
    now_.s = (sides.level - sides.times(now_.y)).cwiseMax(kSlack);
    now_.z = VectorXd::Constant(sides.count(), kMultiplier);
    now_.w = VectorXd::Zero(sides.values.size());
    sides.lay_out(K_, places_);
    cholesky_.analyzePattern(K_);
    look();
  }

  const Step& now() const { return now_; }
  double objective() const { return sides_.objective(now_.y); }
  double gap() const { return now_.s.dot(now_.z); }
  /// The largest residual of a row; of a column.
  double primal() const {
    const double rows = primal_.cwiseAbs().maxCoeff();
    return equation_.size() == 0 ? rows : std::max(rows, equation_.cwiseAbs().maxCoeff());
  }
  double dual() const { return dual_.cwiseAbs().maxCoeff(); }

  bool step() {
    if (!factor(now_.z.cwiseQuotient(now_.s))) return false;
    const double mean = gap() / static_cast<double>(now_.s.size());
    const VectorXd products = now_.s.cwiseProduct(now_.z);
    const Step foresight = solve_once(dual_, primal_, equation_, products);
    const double ahead = (now_.s + reach(now_.s, foresight.s) * foresight.s)
                             .dot(now_.z + reach(now_.z, foresight.z) * foresight.z) /
                         static_cast<double>(now_.s.size());
    const double centring = std::pow(std::max(ahead, 0.0) / mean, 3);
    const VectorXd aimed = products + foresight.s.cwiseProduct(foresight.z) -
                           VectorXd::Constant(now_.s.size(), centring * mean);
    const Step step = solve(aimed);
    if (!step.y.allFinite() || !step.z.allFinite() || !step.w.allFinite()) return false;
    double primal_reach = short_of(reach(now_.s, step.s));
    double dual_reach = short_of(reach(now_.z, step.z));
    // The slope of a quadratic cost goes with the point, so that the multipliers must keep up.
    if (!sides_.is_linear()) primal_reach = dual_reach = std::min(primal_reach, dual_reach);
    now_.y += primal_reach * step.y;
    now_.s += primal_reach * step.s;
    now_.z += dual_reach * step.z;
    now_.w += dual_reach * step.w;
    look();
    return std::max(primal_reach, dual_reach) > 1e-8;
  }

  /// One step for the columns alone, which balances them to rounding: a lower bound that the
  /// multipliers tell goes by what is left of these. Each changes in proportion to what it is over
  /// its slack.
  void balance_columns() {
    const VectorXd weights = now_.z.cwiseQuotient(now_.s);
    if (!factor(weights)) return;
    const double before = dual(), gap_before = gap(), primal_before = primal();
    const Step last = now_;
    VectorXd dy = cholesky_.solve(-dual_);
    if (now_.w.size() > 0) {
      const VectorXd dw = across_.solve(sides_.equations * dy);
      dy -= along_ * dw;
      now_.w += dw;
    }
    const VectorXd change = sides_.times(dy);
    now_.y += dy;
    now_.s -= change;
    now_.z = (now_.z + weights.cwiseProduct(change)).cwiseMax(0);
    look();
    constexpr double kMore = 2, kRounding = 1e-12;
    const bool holds = now_.s.minCoeff() > 0 && gap() <= kMore * gap_before &&
                       primal() <= kMore * primal_before + kRounding;
    if (holds && dual() < before) return;
    now_ = last;
    look();
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

  /// K = curvature + G^T W G, and what the equations need of it.
  bool factor(const VectorXd& weights) {
    sides_.weigh(weights, K_, places_);
    for (Eigen::Index i = 0; i < K_.cols(); ++i) {
      double& d = K_.valuePtr()[K_.outerIndexPtr()[i]];
      d += 1e-15 * d + 1e-300;
    }
    cholesky_.factorize(K_);
    if (cholesky_.info() != Eigen::Success) return false;
    if (sides_.values.size() == 0) return true;
    along_ = cholesky_.solve(sides_.equations.transpose());
    across_.compute(sides_.equations * along_);
    return true;
  }

  /// What is left of the conditions where the point is now.
  void look() {
    dual_ =
        sides_.slope(now_.y) + sides_.transposed(now_.z) + sides_.equations.transpose() * now_.w;
    primal_ = sides_.times(now_.y) + now_.s - sides_.level;
    equation_ = sides_.equations * now_.y - sides_.values;
  }

  /// G dy + ds = -primal, E dy = -equation, curvature dy + G^T dz + E^T dw = -dual, z ds + s dz =
  /// -products.
  Step solve(const VectorXd& products) const {
    // Once more for what rounding left: normal equations square the condition.
    Step step = solve_once(dual_, primal_, equation_, products);
    const Step more =
        solve_once(dual_ + (sides_.slope(step.y) - sides_.cost) + sides_.transposed(step.z) +
                       sides_.equations.transpose() * step.w,
                   primal_ + sides_.times(step.y) + step.s, equation_ + sides_.equations * step.y,
                   products + now_.z.cwiseProduct(step.s) + now_.s.cwiseProduct(step.z));
    step.y += more.y;
    step.s += more.s;
    step.z += more.z;
    step.w += more.w;
    return step;
  }
  Step solve_once(const VectorXd& dual, const VectorXd& primal, const VectorXd& equation,
                  const VectorXd& products) const {
    Step step;
    const VectorXd pull = (now_.z.cwiseProduct(primal) - products).cwiseQuotient(now_.s);
    step.y = cholesky_.solve(-dual - sides_.transposed(pull));
    step.w = VectorXd::Zero(equation.size());
    if (equation.size() > 0) {
      step.w = across_.solve(sides_.equations * step.y + equation);
      step.y -= along_ * step.w;
    }
    step.s = -primal - sides_.times(step.y);
    step.z = (-products - now_.z.cwiseProduct(step.s)).cwiseQuotient(now_.s);
    return step;
  }

  const Sides& sides_;
  Step now_;
  VectorXd dual_, primal_, equation_;  ///< residuals
  Eigen::SparseMatrix<double> K_;
  std::vector<int> places_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> cholesky_;
  /// Of the equations: K^-1 E^T, and E K^-1 E^T.
  Eigen::MatrixXd along_;
  Eigen::LDLT<Eigen::MatrixXd> across_;
};

InteriorSolution with_multipliers(const Sides& sides, const Interior::Step& now,
                                  Eigen::Index rows) {
  const Eigen::Index variables = now.y.size();
  InteriorSolution solution{now.y, VectorXd::Zero(rows), VectorXd::Zero(variables),
                            VectorXd::Zero(variables)};
  for (Eigen::Index i = 0; i < sides.count(); ++i) {
    const auto row = static_cast<Eigen::Index>(sides.row(i));
    if (row < rows) {
      solution.row_multipliers[row] += sides.sign(i) * now.z[i];
    } else {
      (sides.sign(i) > 0 ? solution.upper_multipliers : solution.lower_multipliers)[row - rows] +=
          now.z[i];
    }
  }
  for (std::size_t k = 0; k < sides.equation_rows().size(); ++k)
    solution.row_multipliers[sides.equation_rows()[k]] = now.w[static_cast<Eigen::Index>(k)];
  return solution;
}

/// Steps until the gap is closed or nothing is gained.
InteriorEnd followed(Interior& interior, const InteriorOptions& options, int& iterations) {
  constexpr double kGap = 2e-11, kLeft = 1e-9, kGood = 1e-7, kGain = 0.9;
  constexpr int kPatience = 15;
  double least_gap = std::numeric_limits<double>::infinity(), least_left = least_gap;
  for (int idle = 0;;) {
    const double gap =
        interior.gap() / std::max(std::abs(interior.objective()), options.least_objective);
    const double primal = interior.primal();
    if (iterations > 0 && options.goes_on &&
        !options.goes_on(iterations, interior.objective(), primal)) {
      return InteriorEnd::Ended;
    }
    const double left = std::max(primal, interior.dual());
    if (gap <= kGap && left <= kLeft) return InteriorEnd::Optimal;
    idle = gap < kGain * least_gap || left < kGain * least_left ? 0 : idle + 1;
    least_gap = std::min(least_gap, gap);
    least_left = std::min(least_left, left);
    if (iterations >= options.most_iterations) return InteriorEnd::IterationLimit;
    if (idle > kPatience || !interior.step()) {
      const bool good = gap <= kGood && left <= kGood;
      return good ? InteriorEnd::Acceptable : InteriorEnd::Stalled;
    }
    ++iterations;
  }
}

}  // namespace

InteriorSolution solve_by_interior_point(const QuadraticProgram& program, const VectorXd& start,
                                         const InteriorOptions& options) {
  const Sides sides(program);
  if (sides.count() == 0 || start.size() == 0) {
    const auto none = [](Eigen::Index size) { return VectorXd::Zero(size).eval(); };
    return {start, none(program.rows.rows()), none(start.size()), none(start.size())};
  }
  Interior interior(sides, start);
  int iterations = 0;
  const InteriorEnd end = followed(interior, options, iterations);
  if (sides.is_linear() && end == InteriorEnd::Optimal) interior.balance_columns();
  InteriorSolution solution = with_multipliers(sides, interior.now(), program.rows.rows());
  solution.end = end;
  solution.iterations = iterations;
  return solution;
}

}  // namespace camlaw::optim
