// SPDX-License-Identifier: MIT
#include "optim/solvers/program.h"

#include <algorithm>
#include <iterator>
#include <map>

#include "numerics/linear/dense.h"
#include "optim/solvers/run_end.h"

namespace camlaw::optim {
namespace {

/// Room for one function's derivatives.
struct Derivatives {
  std::vector<double> g, h;
  void fit_first(std::size_t inputs) {
    if (g.size() < inputs) g.resize(inputs);
  }
  void fit_second(std::size_t inputs) {
    fit_first(inputs);
    if (h.size() < packed_size(inputs)) h.resize(packed_size(inputs));
  }
};

/// Sets the negative eigenvalues of a packed symmetric matrix to 0, and what it does along a normal
/// that is not zero.
void leave_out_negative(std::span<double> packed_matrix, const Eigen::VectorXd& normal) {
  const Eigen::Index n = normal.size();
  const auto inputs = static_cast<std::size_t>(n);
  if (n == 0 || !all_finite(packed_matrix)) return;
  Eigen::MatrixXd A(n, n);
  for (std::size_t i = 0; i < inputs; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(j);
      A(row, column) = A(column, row) = packed_matrix[packed(i, j)];
    }
  }
  if (const double length = normal.norm(); length > 0 && std::isfinite(length)) {
    const Eigen::VectorXd unit = normal / length;
    A -= unit * (unit.transpose() * A).eval();
    A -= (A * unit).eval() * unit.transpose();
  }
  const SymmetricEigen eigen = symmetric_eigen(A);
  A = eigen.vectors * eigen.values.cwiseMax(0).asDiagonal() * eigen.vectors.transpose();
  for (std::size_t i = 0; i < inputs; ++i) {
    for (std::size_t j = 0; j <= i; ++j)
      packed_matrix[packed(i, j)] = A(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  }
}

}  // namespace

Program::Program(std::vector<ProgramColumn> columns, Function objective, double sign,
                 double objective_size, std::vector<Row> rows)
    : columns_(std::move(columns)),
      objective_(std::move(objective)),
      sign_(sign),
      objective_size_(objective_size),
      rows_(std::move(rows)),
      place_(columns_.size(), -1) {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const ProgramColumn& column = columns_[i];
    if (column.lower == column.upper) continue;
    place_[i] = static_cast<int>(free_.size());
    free_.push_back(i);
    lower_.push_back(column.lower / column.scale);
    upper_.push_back(column.upper / column.scale);
    start_.push_back(std::clamp(column.start, column.lower, column.upper) / column.scale);
  }
  for (const Row& row : rows_) {
    row_lower_.push_back(row.lower / row.size);
    row_upper_.push_back(row.upper / row.size);
  }
  lay_out();
}

void Program::lay_out() {
  std::map<std::vector<std::size_t>, int> sets;  // of inputs
  const auto add = [&](const Function& function) {
    const bool linear = function.shape() == Shape::Linear;
    places_of_.push_back(
        linear ? -1 : sets.emplace(function.inputs(), static_cast<int>(sets.size())).first->second);
  };
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const Row& row = rows_[r];
    for (const std::size_t input : row.function.inputs()) {
      if (place_[input] < 0) continue;
      jacobian_.rows.push_back(static_cast<int>(r));
      jacobian_.columns.push_back(place_[input]);
    }
    if (row.auxiliary && place_[row.auxiliary->first] >= 0) {
      jacobian_.rows.push_back(static_cast<int>(r));
      jacobian_.columns.push_back(place_[row.auxiliary->first]);
    }
    add(row.function);
  }
  add(objective_);
  std::vector<std::vector<int>> columns(free_.size());  // of each row of the Hessian
  for (const auto& [inputs, number] : sets) add_entries(inputs, columns);
  std::vector<int> begins;
  for (std::size_t row = 0; row < columns.size(); ++row) {
    begins.push_back(static_cast<int>(hessian_.rows.size()));
    hessian_.rows.insert(hessian_.rows.end(), columns[row].size(), static_cast<int>(row));
    hessian_.columns.insert(hessian_.columns.end(), columns[row].begin(), columns[row].end());
  }
  hessian_places_.resize(sets.size());
  for (const auto& [inputs, number] : sets) {
    std::vector<int>& places = hessian_places_[static_cast<std::size_t>(number)];
    places.reserve(packed_size(inputs.size()));
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        const int row = place_[inputs[i]], column = place_[inputs[j]];
        if (row < 0 || column < 0) {
          places.push_back(-1);
          continue;
        }
        const auto& known = columns[static_cast<std::size_t>(row)];
        const auto at = std::lower_bound(known.begin(), known.end(), column);
        places.push_back(begins[static_cast<std::size_t>(row)] +
                         static_cast<int>(at - known.begin()));
      }
    }
  }
}

/// The columns, increasing, in which a function of these inputs has second derivatives, added to
/// those known of each row of the lower triangle.
void Program::add_entries(const std::vector<std::size_t>& inputs,
                          std::vector<std::vector<int>>& columns) const {
  std::vector<int> places, both;
  for (const std::size_t input : inputs) {
    if (place_[input] < 0) continue;
    places.push_back(place_[input]);  // increasing, as inputs are
    auto& known = columns[static_cast<std::size_t>(place_[input])];
    both.clear();
    std::set_union(known.begin(), known.end(), places.begin(), places.end(),
                   std::back_inserter(both));
    if (both.size() > known.size()) known = both;
  }
}

bool Program::has_equations() const {
  for (std::size_t r = 0; r < rows(); ++r) {
    if (row_is_equation(r)) return true;
  }
  return false;
}

bool Program::is_linear() const {
  const auto linear = [](const Row& row) { return row.function.shape() == Shape::Linear; };
  return objective_.shape() == Shape::Linear && std::all_of(rows_.begin(), rows_.end(), linear);
}

std::vector<double> Program::design(std::span<const double> y) const {
  std::vector<double> x(columns_.size());
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const ProgramColumn& column = columns_[i];
    if (place_[i] < 0) {
      x[i] = column.lower;
      continue;
    }
    // Scaling rounds; a variable at its bound stays there.
    const auto k = static_cast<std::size_t>(place_[i]);
    x[i] = y[k] == lower_[k]   ? column.lower
           : y[k] == upper_[k] ? column.upper
                               : std::clamp(y[k] * column.scale, column.lower, column.upper);
    if (y[k] < lower_[k] || y[k] > upper_[k]) x[i] = y[k] * column.scale;
  }
  return x;
}

std::vector<double> Program::scaled(std::span<const double> x) const {
  std::vector<double> y;
  for (const std::size_t i : free_) y.push_back(x[i] / columns_[i].scale);
  return y;
}

double Program::objective(std::span<const double> y) const {
  return sign_ / objective_size_ * objective_.value(design(y));
}

double Program::gradient(std::span<const double> y, std::span<double> gradient) const {
  Derivatives d;
  d.fit_first(objective_.inputs().size());
  const double factor = sign_ / objective_size_;
  const double value = factor * objective_.gradient(design(y), d.g);
  std::fill(gradient.begin(), gradient.end(), 0.0);
  for (std::size_t k = 0; k < objective_.inputs().size(); ++k) {
    const std::size_t column = objective_.inputs()[k];
    if (place_[column] >= 0) {
      gradient[static_cast<std::size_t>(place_[column])] = factor * d.g[k] * columns_[column].scale;
    }
  }
  return value;
}

namespace {
double row_value(const Row& row, Design x) {
  const double linear = row.auxiliary ? row.auxiliary->second * x[row.auxiliary->first] : 0;
  return (row.function.value(x) + linear) / row.size;
}
}  // namespace

double Program::row(std::size_t row, std::span<const double> y) const {
  return row_value(rows_[row], design(y));
}

void Program::row_values(std::span<const double> y, std::span<double> values) const {
  const std::vector<double> x = design(y);
  for (std::size_t r = 0; r < rows_.size(); ++r) values[r] = row_value(rows_[r], x);
}

double Program::row_gradient(std::size_t index, std::span<const double> y,
                             std::span<double> gradient) const {
  const Row& row = rows_[index];
  const std::vector<double> x = design(y);
  Derivatives d;
  d.fit_first(row.function.inputs().size());
  double value = row.function.gradient(x, d.g);
  std::fill(gradient.begin(), gradient.end(), 0.0);
  const auto add = [&](std::size_t column, double slope) {
    if (place_[column] < 0) return;
    gradient[static_cast<std::size_t>(place_[column])] += slope * columns_[column].scale / row.size;
  };
  for (std::size_t k = 0; k < row.function.inputs().size(); ++k) {
    add(row.function.inputs()[k], d.g[k]);
  }
  if (row.auxiliary) {
    add(row.auxiliary->first, row.auxiliary->second);
    value += row.auxiliary->second * x[row.auxiliary->first];
  }
  return value / row.size;
}

void Program::jacobian(std::span<const double> y, std::span<double> entries) const {
  const std::vector<double> x = design(y);
  Derivatives d;
  std::size_t entry = 0;
  for (const Row& row : rows_) {
    const auto& inputs = row.function.inputs();
    d.fit_first(inputs.size());
    row.function.gradient(x, d.g);
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      if (place_[inputs[k]] < 0) continue;
      entries[entry++] = d.g[k] * columns_[inputs[k]].scale / row.size;
    }
    if (row.auxiliary && place_[row.auxiliary->first] >= 0) {
      entries[entry++] = row.auxiliary->second * columns_[row.auxiliary->first].scale / row.size;
    }
  }
}

void Program::hessian(std::span<const double> y, double weight, std::span<const double> multipliers,
                      std::span<double> entries) const {
  add_hessians(y, weight, multipliers, Curvature::Whole, entries);
}

void Program::convex_hessian(std::span<const double> y, double weight,
                             std::span<const double> multipliers, std::span<double> entries) const {
  add_hessians(y, weight, multipliers, Curvature::Convex, entries);
}

void Program::add_hessians(std::span<const double> y, double weight,
                           std::span<const double> multipliers, Curvature curvature,
                           std::span<double> entries) const {
  const std::vector<double> x = design(y);
  std::fill(entries.begin(), entries.end(), 0.0);
  Derivatives d;
  const auto add = [&](const Function& function, int list, double factor, bool is_limit) {
    if (list < 0 || factor == 0) return;
    const std::vector<int>& places = hessian_places_[static_cast<std::size_t>(list)];
    const auto& inputs = function.inputs();
    d.fit_second(inputs.size());
    function.hessian(x, d.g, d.h);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        const bool varies = places[packed(i, j)] >= 0;
        d.h[packed(i, j)] *=
            varies ? factor * columns_[inputs[i]].scale * columns_[inputs[j]].scale : 0;
      }
    }
    if (curvature == Curvature::Convex) {
      Eigen::VectorXd normal = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(inputs.size()));
      for (std::size_t i = 0; is_limit && i < inputs.size(); ++i) {
        if (places[packed(i, i)] >= 0)
          normal[static_cast<Eigen::Index>(i)] = d.g[i] * columns_[inputs[i]].scale;
      }
      leave_out_negative({d.h.data(), packed_size(inputs.size())}, normal);
    }
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        const int place = places[packed(i, j)];
        if (place >= 0) entries[static_cast<std::size_t>(place)] += d.h[packed(i, j)];
      }
    }
  };
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const bool is_limit = !rows_[r].auxiliary;  // else it tells the auxiliary's value
    add(rows_[r].function, places_of_[r], multipliers[r] / rows_[r].size, is_limit);
  }
  add(objective_, places_of_.back(), weight * sign_ / objective_size_, false);
}

}  // namespace camlaw::optim
