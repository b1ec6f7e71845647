// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "numerics/linear/band_order.h"
#include "numerics/linear/banded_lu.h"
#include "numerics/linear/newton_system.h"

namespace camlaw::optim {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// The symmetric matrix of variables, rows and equations, in this order.
Eigen::SparseMatrix<double> joined(const ProgramSides& sides) {
  const Index n = sides.variables(), m = sides.rows.rows(), e = sides.equations.rows();
  std::vector<Eigen::Triplet<double>> triplets;
  const auto add = [&](Index i, Index j, double value) {
    triplets.emplace_back(i, j, value);
    if (i != j) triplets.emplace_back(j, i, value);
  };
  const auto add_rows = [&](const ProgramSides::Rows& rows, Index first) {
    for (Index r = 0; r < rows.rows(); ++r) {
      for (ProgramSides::Rows::InnerIterator entry(rows, r); entry; ++entry)
        add(first + r, entry.col(), entry.value());
    }
  };
  for (Index i = 0; i < n + m + e; ++i) add(i, i, 0);
  add_rows(sides.rows, n);
  add_rows(sides.equations, n + m);
  for (Index j = 0; j < sides.curvature.outerSize(); ++j) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(sides.curvature, j); entry; ++entry)
      add(entry.row(), entry.col(), entry.value());
  }
  Eigen::SparseMatrix<double> matrix(n + m + e, n + m + e);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

/// Of an entry's row and column.
template <class Take>
void each_entry(const Eigen::SparseMatrix<double>& matrix, const Take& take) {
  for (Index j = 0; j < matrix.outerSize(); ++j) {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, j); entry; ++entry)
      take(entry.row(), entry.col(), entry.value());
  }
}

class AugmentedSystem final : public NewtonSystem {
 public:
  AugmentedSystem(const ProgramSides& sides, const Eigen::SparseMatrix<double>& matrix,
                  std::vector<Index> places, Index half)
      : sides_(sides), places_(std::move(places)), lu_(matrix.rows(), half) {
    entries_.assign(static_cast<std::size_t>(lu_.places()), 0.0);
    each_entry(matrix, [&](Index i, Index j, double value) {
      entries_[static_cast<std::size_t>(lu_.place(at(i), at(j)))] = value;
    });
    curvature_ = matrix.diagonal().head(sides.variables());
  }

  bool factor(const VectorXd& weights) override {
    weights_ = weights;
    const Index n = sides_.variables(), m = sides_.rows.rows();
    const auto diagonal = [&](Index i) -> double& {
      return entries_[static_cast<std::size_t>(lu_.place(at(i), at(i)))];
    };
    for (Index i = 0; i < n; ++i) diagonal(i) = curvature_[i] + weights[m + i];
    for (Index r = 0; r < m; ++r) diagonal(n + r) = -1 / weights[r];
    return lu_.factor(entries_);
  }

  NewtonStep solve(const VectorXd& slope, const VectorXd& its_push,
                   const VectorXd& demand) const override {
    const Index n = sides_.variables(), m = sides_.rows.rows();
    const VectorXd push = its_push.size() > 0 ? its_push : VectorXd::Zero(m + n).eval();
    VectorXd target(n + m + demand.size());
    for (Index i = 0; i < n; ++i) target[at(i)] = slope[i] - push[m + i];
    for (Index r = 0; r < m; ++r) target[at(n + r)] = -push[r] / weights_[r];
    for (Index k = 0; k < demand.size(); ++k) target[at(n + m + k)] = demand[k];
    const VectorXd solved = lu_.solve(std::move(target));
    NewtonStep step{VectorXd(n), VectorXd(m + n), VectorXd(demand.size())};
    for (Index i = 0; i < n; ++i) step.changes[m + i] = step.y[i] = solved[at(i)];
    for (Index r = 0; r < m; ++r)
      step.changes[r] = change_of_row(r, step.y, solved[at(n + r)], push[r]);
    for (Index k = 0; k < demand.size(); ++k) step.w[k] = solved[at(n + m + k)];
    return step;
  }

 private:
  Index at(Index unknown) const { return places_[static_cast<std::size_t>(unknown)]; }

  /// What a row changes by: as the sum of its terms, or from what it pushes with where the terms
  /// cancel to less than that.
  double change_of_row(Index r, const VectorXd& y, double pushes, double push) const {
    double sum = 0, size = 0;
    for (ProgramSides::Rows::InnerIterator entry(sides_.rows, r); entry; ++entry) {
      sum += entry.value() * y[entry.col()];
      size += std::abs(entry.value() * y[entry.col()]);
    }
    const bool cancels = std::abs(pushes) + std::abs(push) < weights_[r] * size;
    return cancels ? (pushes - push) / weights_[r] : sum;
  }

  const ProgramSides& sides_;
  VectorXd weights_;
  std::vector<Index> places_;  ///< of the unknowns in the band
  BandedLu lu_;
  std::vector<double> entries_;  ///< of the matrix
  VectorXd curvature_;           ///< its diagonal, without weights
};

}  // namespace

std::unique_ptr<NewtonSystem> augmented_system(const ProgramSides& sides) {
  constexpr Index kMostHalf = 40;  // of a band: rows of some ten variables each
  const Eigen::SparseMatrix<double> matrix = joined(sides);
  const std::vector<int> order = band_order(matrix);
  std::vector<Index> places(order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    places[static_cast<std::size_t>(order[k])] = static_cast<Index>(k);
  Index half = 0;
  each_entry(matrix, [&](Index i, Index j, double) {
    half = std::max(
        half, std::abs(places[static_cast<std::size_t>(i)] - places[static_cast<std::size_t>(j)]));
  });
  if (half > kMostHalf) return nullptr;
  return std::make_unique<AugmentedSystem>(sides, matrix, std::move(places), half);
}

}  // namespace camlaw::optim
