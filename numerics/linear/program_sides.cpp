// SPDX-License-Identifier: MIT
#include "numerics/linear/program_sides.h"

#include <cmath>

namespace camlaw::optim {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

ProgramSides::Rows chosen(const ProgramSides::Rows& rows, const std::vector<Index>& which) {
  ProgramSides::Rows result(static_cast<Index>(which.size()), rows.cols());
  result.reserve(rows.nonZeros());
  for (std::size_t k = 0; k < which.size(); ++k) {
    result.startVec(static_cast<Index>(k));
    for (ProgramSides::Rows::InnerIterator entry(rows, which[k]); entry; ++entry)
      result.insertBack(static_cast<Index>(k), entry.col()) = entry.value();
  }
  result.finalize();
  return result;
}

}  // namespace

ProgramSides::ProgramSides(const QuadraticProgram& program)
    : cost(program.cost), curvature(program.curvature) {
  curvature.makeCompressed();
  const auto is_bounded = [](double lower, double upper) {
    return std::isfinite(lower) || std::isfinite(upper);
  };
  for (Index r = 0; r < program.rows.rows(); ++r) {
    if (program.row_lower[r] == program.row_upper[r]) {
      equation_rows.push_back(r);
    } else if (is_bounded(program.row_lower[r], program.row_upper[r])) {
      program_rows.push_back(r);
    } else {
      ++idle_;
    }
  }
  rows = chosen(program.rows, program_rows);
  equations = chosen(program.rows, equation_rows);
  values.resize(equations.rows());
  for (Index k = 0; k < values.size(); ++k)
    values[k] = program.row_upper[equation_rows[static_cast<std::size_t>(k)]];
  std::vector<double> levels;
  const auto add = [&](Index row, double lower, double upper) {
    if (std::isfinite(upper)) rows_.push_back(row), signs_.push_back(1), levels.push_back(upper);
    if (std::isfinite(lower)) rows_.push_back(row), signs_.push_back(-1), levels.push_back(-lower);
  };
  for (Index k = 0; k < rows.rows(); ++k) {
    const Index r = program_rows[static_cast<std::size_t>(k)];
    add(k, program.row_lower[r], program.row_upper[r]);
  }
  for (Index i = 0; i < variables(); ++i) add(rows.rows() + i, program.lower[i], program.upper[i]);
  level = Eigen::Map<const VectorXd>(levels.data(), static_cast<Index>(levels.size()));
}

Index ProgramSides::bound(Index side) const {
  const Index own = row(side), variable = own - rows.rows();
  const Index number = variable < 0 ? program_rows[static_cast<std::size_t>(own)]
                                    : bounds() / 2 - variables() + variable;
  return 2 * number + (sign(side) > 0 ? 1 : 0);
}

VectorXd ProgramSides::times(const VectorXd& y) const {
  VectorXd at(rows.rows());
  for (Index r = 0; r < at.size(); ++r) {
    double sum = 0;
    for (int k = rows.outerIndexPtr()[r]; k < rows.outerIndexPtr()[r + 1]; ++k)
      sum += rows.valuePtr()[k] * y[rows.innerIndexPtr()[k]];
    at[r] = sum;
  }
  VectorXd result(count());
  for (Index i = 0; i < count(); ++i)
    result[i] = sign(i) * (row(i) < at.size() ? at[row(i)] : y[row(i) - at.size()]);
  return result;
}

VectorXd ProgramSides::by_row(const VectorXd& z) const {
  VectorXd result = VectorXd::Zero(rows.rows() + variables());
  for (Index i = 0; i < count(); ++i) result[row(i)] += sign(i) * z[i];
  return result;
}

VectorXd ProgramSides::weights_by_row(const VectorXd& weights) const {
  VectorXd result = VectorXd::Zero(rows.rows() + variables());
  for (Index i = 0; i < count(); ++i) result[row(i)] += weights[i];
  return result;
}

VectorXd ProgramSides::transposed(const VectorXd& z) const {
  const VectorXd of_rows = by_row(z);
  VectorXd result = of_rows.tail(variables());
  for (Index r = 0; r < rows.rows(); ++r) {
    for (int k = rows.outerIndexPtr()[r]; k < rows.outerIndexPtr()[r + 1]; ++k)
      result[rows.innerIndexPtr()[k]] += rows.valuePtr()[k] * of_rows[r];
  }
  return result;
}

VectorXd ProgramSides::side_terms(const VectorXd& y) const {
  const VectorXd sizes = y.cwiseAbs(), at = rows.cwiseAbs() * sizes;
  VectorXd result(count());
  for (Index i = 0; i < count(); ++i)
    result[i] = row(i) < at.size() ? at[row(i)] : sizes[row(i) - at.size()];
  return result;
}

VectorXd ProgramSides::equation_terms(const VectorXd& y) const {
  return equations.cwiseAbs() * y.cwiseAbs();
}

VectorXd ProgramSides::column_terms(const VectorXd& z, const VectorXd& w) const {
  const VectorXd of_rows = weights_by_row(z.cwiseAbs());
  return rows.cwiseAbs().transpose() * of_rows.head(rows.rows()) + of_rows.tail(variables()) +
         equations.cwiseAbs().transpose() * w.cwiseAbs();
}

VectorXd ProgramSides::slope(const VectorXd& y) const {
  return is_linear() ? cost : cost + curvature.selfadjointView<Eigen::Lower>() * y;
}

double ProgramSides::objective(const VectorXd& y) const { return 0.5 * (cost + slope(y)).dot(y); }

}  // namespace camlaw::optim
