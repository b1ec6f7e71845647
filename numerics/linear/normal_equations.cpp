// SPDX-License-Identifier: MIT
#include <Eigen/Cholesky>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <vector>

#include "numerics/linear/newton_system.h"

namespace camlaw::optim {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Matrix = Eigen::SparseMatrix<double>;

/// The lower triangle's places of curvature + R^T R and its diagonal, column by column.
Matrix pattern_of(const ProgramSides& sides) {
  const Index n = sides.variables();
  const ProgramSides::Rows& rows = sides.rows;
  const Matrix columns = rows;
  std::vector<int> seen(static_cast<std::size_t>(n), -1), found;
  Matrix pattern(n, n);
  pattern.reserve(4 * n + rows.nonZeros());
  for (Index j = 0; j < n; ++j) {
    found.clear();
    const auto add = [&](Index i) {
      int& last = seen[static_cast<std::size_t>(i)];
      if (i < j || last == j) return;
      last = static_cast<int>(j);
      found.push_back(static_cast<int>(i));
    };
    add(j);
    if (sides.curvature.outerSize() > 0) {
      for (Matrix::InnerIterator entry(sides.curvature, j); entry; ++entry) add(entry.row());
    }
    for (Matrix::InnerIterator row(columns, j); row; ++row) {
      const int end = rows.outerIndexPtr()[row.row() + 1];
      for (int k = end; k-- > rows.outerIndexPtr()[row.row()] && rows.innerIndexPtr()[k] > j;)
        add(rows.innerIndexPtr()[k]);
    }
    std::sort(found.begin(), found.end());
    pattern.startVec(j);
    for (const int i : found) pattern.insertBack(i, j) = 1;
  }
  pattern.finalize();
  return pattern;
}

/// Rows with each column at its place, increasing in each row.
ProgramSides::Rows with_columns_at(const ProgramSides::Rows& rows, const Eigen::VectorXi& place) {
  ProgramSides::Rows result(rows.rows(), rows.cols());
  result.reserve(rows.nonZeros());
  std::vector<std::pair<int, double>> row;
  for (Index r = 0; r < rows.rows(); ++r) {
    row.clear();
    for (ProgramSides::Rows::InnerIterator entry(rows, r); entry; ++entry)
      row.emplace_back(place[entry.col()], entry.value());
    std::sort(row.begin(), row.end());
    result.startVec(r);
    for (const auto& [column, value] : row) result.insertBack(r, column) = value;
  }
  result.finalize();
  return result;
}

using Order = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int>;

/// The upper triangle of a matrix whose lower one is stored, with rows and columns in an order,
/// increasing in each column.
Matrix in_order(const Matrix& lower, const Order& order) {
  Matrix upper(lower.rows(), lower.cols());
  upper.selfadjointView<Eigen::Upper>() =
      lower.selfadjointView<Eigen::Lower>().twistedBy(order.inverse());
  const Matrix sorted = upper.transpose();
  return sorted.transpose();
}

/// All in the order in which factors stay sparse: variable i is at place_[i].
class NormalEquations final : public NewtonSystem {
 public:
  explicit NormalEquations(const ProgramSides& sides) : variables_(sides.variables()) {
    const Index n = variables_;
    const Matrix pattern = pattern_of(sides);
    Order order;
    Eigen::AMDOrdering<int>()(pattern.selfadjointView<Eigen::Lower>(), order);
    place_ = order.inverse().eval().indices();
    rows_ = with_columns_at(sides.rows, place_);
    equations_ = with_columns_at(sides.equations, place_);
    K_ = in_order(pattern, order);
    curvature_ = sides.curvature.outerSize() > 0 ? in_order(sides.curvature, order) : Matrix(n, n);
    find_columns();
    cholesky_.analyzePattern(K_);
  }

  bool factor(const VectorXd& weights) override {
    weigh(weights);
    cholesky_.factorize(K_);
    if (cholesky_.info() != Eigen::Success) return false;
    if (equations_.rows() == 0) return true;
    along_ = cholesky_.solve(Eigen::MatrixXd(equations_.transpose()));
    across_.compute(equations_ * along_);
    return true;
  }

  NewtonStep solve(const VectorXd& slope, const VectorXd& push,
                   const VectorXd& demand) const override {
    const Index n = variables_, m = rows_.rows();
    VectorXd target(n);
    for (Index i = 0; i < n; ++i) target[place_[i]] = slope[i];
    if (push.size() > 0) {
      for (Index i = 0; i < n; ++i) target[place_[i]] -= push[m + i];
      subtract_transposed(rows_, push.data(), target);
    }
    VectorXd y = cholesky_.solve(target);
    NewtonStep step{VectorXd(n), VectorXd(m + n), VectorXd::Zero(demand.size())};
    if (demand.size() > 0) {
      step.w = across_.solve(equations_ * y - demand);
      y -= along_ * step.w;
    }
    multiply(rows_, y, step.changes.data());
    for (Index i = 0; i < n; ++i) step.changes[m + i] = step.y[i] = y[place_[i]];
    return step;
  }

 private:
  /// Where each column's entries stand among the rows'.
  void find_columns() {
    begins_.assign(static_cast<std::size_t>(variables_) + 1, 0);
    const int count = static_cast<int>(rows_.nonZeros());
    const int* const columns = rows_.innerIndexPtr();
    for (int k = 0; k < count; ++k) ++begins_[static_cast<std::size_t>(columns[k]) + 1];
    for (std::size_t j = 0; j + 1 < begins_.size(); ++j) begins_[j + 1] += begins_[j];
    entries_.resize(static_cast<std::size_t>(count));
    std::vector<int> next(begins_.begin(), begins_.end() - 1);
    for (int r = 0; r < rows_.rows(); ++r) {
      for (int k = rows_.outerIndexPtr()[r]; k < rows_.outerIndexPtr()[r + 1]; ++k)
        entries_[static_cast<std::size_t>(next[static_cast<std::size_t>(columns[k])]++)] = {r, k};
    }
    column_ = VectorXd::Zero(variables_);
  }

  /// K = curvature + R^T W R, column by column, and a little more so that it has factors.
  void weigh(const VectorXd& weights) {
    const Index m = rows_.rows();
    const int *const begins = rows_.outerIndexPtr(), *const columns = rows_.innerIndexPtr();
    const double* const values = rows_.valuePtr();
    double* const sums = column_.data();
    VectorXd own(variables_);
    for (Index i = 0; i < variables_; ++i) own[place_[i]] = weights[m + i];
    for (Index j = 0; j < variables_; ++j) {
      const int first = begins_[static_cast<std::size_t>(j)],
                last = begins_[static_cast<std::size_t>(j) + 1];
      for (int e = first; e < last; ++e) {
        const Entry entry = entries_[static_cast<std::size_t>(e)];
        const double weight = weights[entry.row] * values[entry.at];
        for (int k = begins[entry.row]; k <= entry.at; ++k) sums[columns[k]] += weight * values[k];
      }
      for (Matrix::InnerIterator entry(curvature_, j); entry; ++entry)
        sums[entry.row()] += entry.value();
      const int end = K_.outerIndexPtr()[j + 1] - 1;  // the diagonal
      sums[j] += own[j];
      sums[j] += 1e-15 * sums[j] + 1e-300;
      for (int k = K_.outerIndexPtr()[j]; k <= end; ++k) {
        const int row = K_.innerIndexPtr()[k];
        K_.valuePtr()[k] = sums[row];
        sums[row] = 0;
      }
    }
  }

  static void multiply(const ProgramSides::Rows& rows, const VectorXd& y, double* result) {
    const int *const begins = rows.outerIndexPtr(), *const columns = rows.innerIndexPtr();
    const double* const values = rows.valuePtr();
    for (Index r = 0; r < rows.rows(); ++r) {
      double sum = 0;
      for (int k = begins[r]; k < begins[r + 1]; ++k) sum += values[k] * y[columns[k]];
      result[r] = sum;
    }
  }
  static void subtract_transposed(const ProgramSides::Rows& rows, const double* push,
                                  VectorXd& target) {
    const int *const begins = rows.outerIndexPtr(), *const columns = rows.innerIndexPtr();
    const double* const values = rows.valuePtr();
    for (Index r = 0; r < rows.rows(); ++r) {
      for (int k = begins[r]; k < begins[r + 1]; ++k) target[columns[k]] -= values[k] * push[r];
    }
  }

  /// One of the rows' entries: its row, and where it stands among all.
  struct Entry {
    int row, at;
  };

  Index variables_;
  Eigen::VectorXi place_;
  ProgramSides::Rows rows_, equations_;
  std::vector<int> begins_;     ///< of each column among `entries_`
  std::vector<Entry> entries_;  ///< column by column
  Matrix curvature_, K_;        ///< upper triangles
  VectorXd column_;             ///< zero between columns
  Eigen::SimplicialLDLT<Matrix, Eigen::Upper, Eigen::NaturalOrdering<int>> cholesky_;
  /// Of the equations: K^-1 E^T, and E K^-1 E^T.
  Eigen::MatrixXd along_;
  Eigen::LDLT<Eigen::MatrixXd> across_;
};

}  // namespace

std::unique_ptr<NewtonSystem> normal_equations(const ProgramSides& sides) {
  return std::make_unique<NormalEquations>(sides);
}

}  // namespace camlaw::optim
