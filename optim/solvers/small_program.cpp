// SPDX-License-Identifier: MIT
#include "optim/solvers/small_program.h"

#include <ClpSimplex.hpp>
#include <CoinPackedMatrix.hpp>
#include <vector>

namespace camlaw::optim {

std::optional<Eigen::VectorXd> greatest_gain(const Eigen::VectorXd& gain,
                                             const Eigen::MatrixXd& rows,
                                             const Eigen::VectorXd& limits) {
  constexpr double kTolerance = 1e-11;  // of entries of order one
  constexpr double kRounding = 1e-13;   // of a row: such an entry is 0
  Eigen::MatrixXd entries = rows;
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const double least = kRounding * rows.row(i).cwiseAbs().maxCoeff();
    entries.row(i) = (rows.row(i).array().abs() < least).select(0, rows.row(i));
  }
  const auto m = static_cast<int>(rows.rows()), n = static_cast<int>(rows.cols());
  std::vector<int> all(static_cast<std::size_t>(m)), lengths(static_cast<std::size_t>(n), m);
  std::vector<CoinBigIndex> begins;
  std::vector<int> places;
  for (int i = 0; i < m; ++i) all[static_cast<std::size_t>(i)] = i;
  for (int j = 0; j < n; ++j) {
    begins.push_back(j * m);
    places.insert(places.end(), all.begin(), all.end());
  }
  begins.push_back(n * m);
  const CoinPackedMatrix matrix(true, m, n, n * m, entries.data(), places.data(), begins.data(),
                                lengths.data());
  const Eigen::VectorXd costs = -gain, zeros = Eigen::VectorXd::Zero(n);
  const std::vector<double> open(static_cast<std::size_t>(n), COIN_DBL_MAX),
      below(static_cast<std::size_t>(m), -COIN_DBL_MAX);
  ClpSimplex solver;
  solver.setLogLevel(0);
  solver.setPrimalTolerance(kTolerance);
  solver.setDualTolerance(kTolerance);
  solver.loadProblem(matrix, zeros.data(), open.data(), costs.data(), below.data(), limits.data());
  solver.scaling(0);  // rows and columns are of order one
  solver.primal();
  if (!solver.isProvenOptimal()) return {};
  return Eigen::Map<const Eigen::VectorXd>(solver.primalColumnSolution(), n).cwiseMax(0.0);
}

}  // namespace camlaw::optim
