// SPDX-License-Identifier: MIT
#include "optim/verdict/second_order.h"

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "numerics/linear/dense.h"
#include "optim/verdict/verdict.h"

namespace camlaw::optim {
namespace {

/// Entries that are added up, in a list while they are few, and else in a matrix: limits that see
/// every variable would make lists of far more entries than the matrix has.
class EntrySum {
 public:
  explicit EntrySum(int rows) : rows_(rows) {}

  void add(int row, int column, double value) {
    if (dense_.size() > 0) {
      dense_(row, column) += value;
      return;
    }
    few_.emplace_back(row, column, value);
    if (few_.size() > static_cast<std::size_t>(rows_) * static_cast<std::size_t>(rows_)) {
      dense_ = matrix();
      few_ = {};
    }
  }

  Eigen::SparseMatrix<double> matrix() const {
    if (dense_.size() > 0) return dense_.sparseView();
    Eigen::SparseMatrix<double> sum(rows_, rows_);
    sum.setFromTriplets(few_.begin(), few_.end());
    return sum;
  }

 private:
  int rows_;
  std::vector<Eigen::Triplet<double>> few_;
  Eigen::MatrixXd dense_;
};

/// Adds factor * second derivatives of a function, by typical changes.
void add_hessian(const SecondOrderPoint& point, const Function& f, double factor, EntrySum& H) {
  if (factor == 0 || f.shape() == Shape::Linear) return;
  const auto& inputs = f.inputs();
  std::vector<double> g(inputs.size()), h(packed_size(inputs.size()));
  f.hessian(point.x, g, h);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    for (std::size_t j = 0; j < inputs.size(); ++j) {
      const int row = point.layout.row[inputs[i]], column = point.layout.row[inputs[j]];
      const double second = h[packed(std::max(i, j), std::min(i, j))];
      if (row < 0 || column < 0 || second == 0) continue;
      H.add(
          row, column,
          factor * second * point.scales.variables[inputs[i]] * point.scales.variables[inputs[j]]);
    }
  }
}

/// A peak's place moves with the design: d(place)/dx = -g_xa / g_aa, which adds
/// g_xa g_xa^T / |g_aa| to the peak's second derivatives.
void add_peak_motion(const SecondOrderPoint& point, const ActiveLimit& limit, double multiplier,
                     EntrySum& H) {
  const double curvature = limit.sign * limit.curvature;
  if (limit.slope_gradient.empty() || multiplier == 0 || !(curvature < 0)) return;
  std::vector<std::pair<int, double>> slopes;
  for (std::size_t i = 0; i < limit.slope_gradient.size(); ++i) {
    const double slope = limit.slope_gradient[i] * point.scales.variables[i];
    if (slope != 0 && point.layout.row[i] >= 0) slopes.emplace_back(point.layout.row[i], slope);
  }
  for (const auto& [row, a] : slopes) {
    for (const auto& [column, b] : slopes) {
      H.add(row, column, multiplier * a * b / (-curvature * limit.size));
    }
  }
}

/// Gradients of the limits that hold the design: of those that push, and of those that are met
/// exactly without pushing and may be left to one side.
struct Held {
  Eigen::SparseMatrix<double> pushing, met;
};

/// A slope that the conditions of first order cannot tell from none holds nothing.
bool is_seen(double slope) { return std::abs(slope) > kKktTolerance; }

Eigen::SparseMatrix<double> gradients(const Layout& layout,
                                      const std::vector<const ActiveLimit*>& limits) {
  std::vector<Eigen::Triplet<double>> entries;
  int column = 0;
  for (const ActiveLimit* limit : limits) {
    for (const auto& [variable, slope] : limit->gradient) {
      if (layout.row[variable] >= 0 && is_seen(slope)) {
        entries.emplace_back(layout.row[variable], column, slope);
      }
    }
    if (limit->auxiliary != 0) entries.emplace_back(layout.auxiliary, column, limit->auxiliary);
    ++column;
  }
  Eigen::SparseMatrix<double> A(layout.rows, column);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

/// What a limit adds to the conditions of first order, by the variables; of a peak of the objective
/// the share of the objective that it is.
bool pushes(const ActiveLimit& limit, double multiplier) {
  // The conditions tell slopes above ten times kHeld from zero. An idle peak of an interior-point
  // method has less than kShare.
  constexpr double kHeld = 1e-8, kShare = 1e-4;
  double longest = 0;
  for (const auto& entry : limit.gradient) longest = std::max(longest, std::abs(entry.second));
  return std::abs(multiplier) * longest > kHeld || std::abs(multiplier * limit.auxiliary) > kShare;
}

Held held(const SecondOrderPoint& point, const std::vector<ActiveLimit>& limits,
          const std::vector<double>& multipliers) {
  constexpr double kMet = 1e-7;  // as near as a solver leaves a limit that holds
  // A limit that was told may have room, and then a multiplier that is idle: it holds nothing.
  constexpr double kRoom = 1e-4;
  std::vector<const ActiveLimit*> pushing, met;
  for (std::size_t j = 0; j < limits.size(); ++j) {
    const bool has_room = !limits[j].is_equation && limits[j].margin > kRoom;
    if (limits[j].is_equation || (pushes(limits[j], multipliers[j]) && !has_room)) {
      pushing.push_back(&limits[j]);
    } else if (limits[j].margin <= kMet) {
      met.push_back(&limits[j]);
    }
  }
  return {gradients(point.layout, pushing), gradients(point.layout, met)};
}

constexpr double kNegative = 1e-6;            // of the terms that a curvature is the sum of
constexpr double kDependentGradient = 1e-10;  // of the longest: what others leave of it

/// The quadratic form on a cone, by eigenvectors: the cone P^T d = 0, W^T d <= 0.
class ConeTest {
 public:
  /// `floor`: what counts as no curvature at all.
  ConeTest(const Eigen::MatrixXd& H, const Eigen::MatrixXd& P, const Eigen::MatrixXd& W,
           double floor)
      : H_(H), P_(P), W_(W), floor_(floor) {}

  SecondOrder run() {
    const bool whole = look(P_, true);  // with every limit that does not push left alone
    return {whole || (W_.cols() > 0 && holds_on_faces()), std::move(flat_)};
  }

 private:
  /// What counts as no curvature along d: rounding in the terms that d^T H d is the sum of.
  double nothing(const Eigen::VectorXd& d) const {
    return kNegative * d.cwiseAbs().dot(H_.cwiseAbs() * d.cwiseAbs()) + floor_;
  }

  /// Directions in the null space of A: whether none with a negative value lies in the cone. Where
  /// `everywhere`, none at all. Those of value zero in the cone are kept.
  bool look(const Eigen::MatrixXd& A, bool everywhere) {
    const Eigen::MatrixXd N = left_null_space(A, kDependentGradient);
    if (N.cols() == 0) return true;
    const auto [values, vectors] = symmetric_eigen(N.transpose() * H_ * N);
    bool holds = true;
    for (Eigen::Index k = 0; k < values.size(); ++k) {
      const Eigen::VectorXd d = N * vectors.col(k);
      const double none = nothing(d);
      if (values[k] > none) continue;
      const bool inside = in_cone(d);
      if (values[k] >= -none) {
        if (inside) flat_.push_back(d);
        continue;
      }
      // Of equal values every combination is one: they are not searched, and count against.
      const bool twin = k + 1 < values.size() && values[k + 1] - values[k] <= none;
      holds = holds && !(everywhere || inside || twin);
    }
    return holds;
  }

  bool in_cone(const Eigen::VectorXd& d) const {
    // Slopes are of length one: rounding of an eigenvector turns them by less.
    constexpr double kSlack = 1e-9;
    if (W_.cols() == 0) return true;
    const Eigen::VectorXd slopes = W_.transpose() * d;
    return slopes.maxCoeff() <= kSlack || slopes.minCoeff() >= -kSlack;
  }

  /// On the cone's part of the unit sphere the form is least at an eigenvector of the face in whose
  /// inside it lies. Faces: any of W held. Too many are not looked at: then it is not shown.
  bool holds_on_faces() {
    constexpr double kMostWork = 1e9;  // operations: about a second
    const double n = static_cast<double>(H_.rows());
    if (std::ldexp(n * n * n, static_cast<int>(W_.cols())) > kMostWork) return false;
    for (unsigned face = 0; face < (1U << W_.cols()); ++face) {
      Eigen::MatrixXd A(P_.rows(), P_.cols() + W_.cols());
      Eigen::Index columns = P_.cols();
      A.leftCols(columns) = P_;
      for (Eigen::Index j = 0; j < W_.cols(); ++j) {
        if ((face >> j & 1U) != 0) A.col(columns++) = W_.col(j);
      }
      if (!look(A.leftCols(columns), false)) return false;
    }
    return true;
  }

  const Eigen::MatrixXd &H_, &P_, &W_;
  double floor_;
  std::vector<Eigen::VectorXd> flat_;
};

/// Finsler: H is positive along the null space of A^T where H + rho A A^T is positive for some rho.
bool sparse_test(const Eigen::SparseMatrix<double>& H, const Eigen::SparseMatrix<double>& A) {
  // Row by row what counts as no curvature: then d^T D d is that of nothing(), or more.
  Eigen::VectorXd nothing = Eigen::VectorXd::Zero(H.rows());
  for (int k = 0; k < H.outerSize(); ++k) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(H, k); entry; ++entry) {
      nothing[entry.row()] += kNegative * std::abs(entry.value());
    }
  }
  const double largest = nothing.maxCoeff() / kNegative;
  if (largest == 0) return true;
  Eigen::SparseMatrix<double> D(H.rows(), H.cols());
  D.setIdentity();
  constexpr double kNeverSingular = 1e-9;  // where a variable is in no entry at all
  D.diagonal() = nothing.array() + kNeverSingular;
  const Eigen::SparseMatrix<double> outer = A * A.transpose();
  for (const double rho : {1e2, 1e5, 1e8}) {
    const Eigen::SparseMatrix<double> sum = H + (rho * largest) * outer + D;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(sum);
    if (factors.info() == Eigen::Success && factors.vectorD().minCoeff() > 0) return true;
  }
  return false;
}

}  // namespace

Eigen::SparseMatrix<double> lagrangian_hessian(const SecondOrderPoint& point,
                                               const std::vector<ActiveLimit>& limits,
                                               const std::vector<double>& multipliers) {
  EntrySum entries(point.layout.rows);
  const Objective& objective = point.problem.objective();
  if (point.layout.auxiliary < 0) {
    const double sign = objective.sense == Sense::Minimize ? 1 : -1;
    add_hessian(point, objective.response.function(), sign / point.scales.objective, entries);
  }
  for (std::size_t j = 0; j < limits.size(); ++j) {
    if (!limits[j].function) continue;
    const double factor = multipliers[j] * limits[j].sign / limits[j].size;
    add_hessian(point, *limits[j].function, factor, entries);
    add_peak_motion(point, limits[j], multipliers[j], entries);
  }
  return entries.matrix();
}

SecondOrder second_order(const SecondOrderPoint& point, const std::vector<ActiveLimit>& limits,
                         const std::vector<double>& multipliers) {
  // Dense eigenvalues take the cube of it; beyond, Finsler's lemma serves (SO5).
  constexpr int kDense = 300;
  if (point.layout.rows == 0) return {true, {}};
  const auto H = lagrangian_hessian(point, limits, multipliers);
  const Eigen::Map<const Eigen::VectorXd> entries(H.valuePtr(), H.nonZeros());
  if (H.nonZeros() > 0 && !entries.allFinite()) return {false, {}};
  const auto [P, W] = held(point, limits, multipliers);
  if (point.layout.rows > kDense) return {sparse_test(H, P), {}};
  const Eigen::MatrixXd dense_H = H, dense_P = P, dense_W = W;
  // Rounding in a response of this size.
  const double value = objective_value(point.problem.objective(), point.x);
  constexpr double kRounding = 1e-9;  // of the objective: what rounding may leave of the terms
  const double floor = kRounding * std::max(1.0, std::abs(value) / point.scales.objective);
  return ConeTest(dense_H, dense_P, dense_W, floor).run();
}

}  // namespace camlaw::optim
