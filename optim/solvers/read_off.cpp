// SPDX-License-Identifier: MIT
#include "optim/solvers/read_off.h"

namespace camlaw::optim {
namespace {

Eigen::VectorXd vector_of(std::span<const double> values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// Whether costs, rows and what they say at the point are numbers.
bool is_finite(const QuadraticProgram& program) {
  const Eigen::Map<const Eigen::VectorXd> entries(program.rows.valuePtr(), program.rows.nonZeros());
  return entries.allFinite() && program.cost.allFinite() &&
         (program.row_lower.array() < kInfinity).all() &&
         (program.row_upper.array() > -kInfinity).all();
}

}  // namespace

Eigen::SparseMatrix<double, Eigen::RowMajor> jacobian_matrix(const Program& program,
                                                             std::span<const double> y) {
  const Pattern& pattern = program.jacobian_pattern();
  std::vector<double> entries(pattern.size());
  program.jacobian(y, entries);
  std::vector<Eigen::Triplet<double>> triplets;
  triplets.reserve(entries.size());
  for (std::size_t k = 0; k < entries.size(); ++k)
    triplets.emplace_back(pattern.rows[k], pattern.columns[k], entries[k]);
  Eigen::SparseMatrix<double, Eigen::RowMajor> result(
      static_cast<Eigen::Index>(program.rows()), static_cast<Eigen::Index>(program.variables()));
  result.setFromTriplets(triplets.begin(), triplets.end());
  return result;
}

QuadraticProgram read_off(const Program& program, std::span<const double> y) {
  const auto m = static_cast<Eigen::Index>(program.rows());
  QuadraticProgram result;
  result.rows = jacobian_matrix(program, y);
  result.cost.resize(result.rows.cols());
  program.gradient(y, {result.cost.data(), program.variables()});
  Eigen::VectorXd rest(m);
  program.row_values(y, {rest.data(), program.rows()});
  rest -= result.rows * vector_of(y);
  result.row_lower = vector_of(program.row_lower()) - rest;
  result.row_upper = vector_of(program.row_upper()) - rest;
  result.lower = vector_of(program.lower());
  result.upper = vector_of(program.upper());
  return result;
}

std::optional<QuadraticProgram> read_at_start(const Program& program, std::span<const double> start,
                                              Solution& solution) {
  QuadraticProgram linear = read_off(program, start);
  solution.evaluations = 1;
  if (is_finite(linear)) return linear;
  solution.status = Status::NonFiniteStart;
  solution.message = "not a number at the start";
  return {};
}

}  // namespace camlaw::optim
