// SPDX-License-Identifier: MIT
#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <vector>

#include "numerics/linear/newton_system.h"

namespace camlaw::optim {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

class NormalEquations final : public NewtonSystem {
 public:
  explicit NormalEquations(const ProgramSides& sides) : sides_(sides) {
    const Index n = sides.variables();
    std::vector<Eigen::Triplet<double>> triplets;
    each_entry([&](Index i, Index j) { triplets.emplace_back(i, j, 1.0); });
    K_.resize(n, n);
    K_.setFromTriplets(triplets.begin(), triplets.end());
    K_.makeCompressed();
    each_entry([&](Index i, Index j) {
      const int* begin = K_.innerIndexPtr() + K_.outerIndexPtr()[j];
      const int* end = K_.innerIndexPtr() + K_.outerIndexPtr()[j + 1];
      places_.push_back(std::lower_bound(begin, end, i) - K_.innerIndexPtr());
    });
    cholesky_.analyzePattern(K_);
  }

  bool factor(const VectorXd& weights) override {
    weights_ = weights;
    weigh();
    for (Index i = 0; i < K_.cols(); ++i) {
      double& d = K_.valuePtr()[K_.outerIndexPtr()[i]];
      d += 1e-15 * d + 1e-300;
    }
    cholesky_.factorize(K_);
    if (cholesky_.info() != Eigen::Success) return false;
    if (sides_.values.size() == 0) return true;
    along_ = cholesky_.solve(Eigen::MatrixXd(sides_.equations.transpose()));
    across_.compute(sides_.equations * along_);
    return true;
  }

  NewtonStep solve(const VectorXd& slope, const VectorXd& push,
                   const VectorXd& demand) const override {
    const Index n = sides_.variables(), m = sides_.rows.rows();
    NewtonStep step{cholesky_.solve(slope - sides_.rows.transpose() * push.head(m) - push.tail(n)),
                    VectorXd(m + n), VectorXd::Zero(demand.size())};
    if (demand.size() > 0) {
      step.w = across_.solve(sides_.equations * step.y - demand);
      step.y -= along_ * step.w;
    }
    step.changes << sides_.rows * step.y, step.y;
    return step;
  }

 private:
  /// Entries of the lower triangle of curvature + R^T W R, each as often as something adds to it.
  template <class Take>
  void each_entry(const Take& take) const {
    using Entry = ProgramSides::Rows::InnerIterator;
    for (Index r = 0; r < sides_.rows.rows(); ++r) {
      for (Entry k(sides_.rows, r); k; ++k) {
        for (Entry l(sides_.rows, r); l && l.col() <= k.col(); ++l) take(k.col(), l.col());
      }
    }
    for (Index i = 0; i < sides_.variables(); ++i) take(i, i);
    for (Index j = 0; j < sides_.curvature.outerSize(); ++j) {
      for (Eigen::SparseMatrix<double>::InnerIterator entry(sides_.curvature, j); entry; ++entry)
        take(entry.row(), entry.col());
    }
  }

  void weigh() {
    std::fill_n(K_.valuePtr(), K_.nonZeros(), 0.0);
    auto place = places_.begin();
    const Index m = sides_.rows.rows();
    for (Index r = 0; r < m; ++r) {
      const int begin = sides_.rows.outerIndexPtr()[r], end = sides_.rows.outerIndexPtr()[r + 1];
      const double* const entries = sides_.rows.valuePtr();
      for (int k = begin; k < end; ++k) {
        for (int l = begin; l <= k; ++l)
          K_.valuePtr()[*place++] += weights_[r] * entries[k] * entries[l];
      }
    }
    for (Index i = 0; i < sides_.variables(); ++i) K_.valuePtr()[*place++] += weights_[m + i];
    for (Index k = 0; k < sides_.curvature.nonZeros(); ++k)
      K_.valuePtr()[*place++] += sides_.curvature.valuePtr()[k];
  }

  const ProgramSides& sides_;
  VectorXd weights_;
  Eigen::SparseMatrix<double> K_;
  std::vector<Index> places_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> cholesky_;
  /// Of the equations: K^-1 E^T, and E K^-1 E^T.
  Eigen::MatrixXd along_;
  Eigen::LDLT<Eigen::MatrixXd> across_;
};

}  // namespace

std::unique_ptr<NewtonSystem> normal_equations(const ProgramSides& sides) {
  return std::make_unique<NormalEquations>(sides);
}

}  // namespace camlaw::optim
