// SPDX-License-Identifier: MIT
#include "optim/solvers/program.h"

#include <algorithm>

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

}  // namespace

Program::Program(std::vector<Column> columns, Function objective, double sign,
                 double objective_size, std::vector<Row> rows)
    : columns_(std::move(columns)),
      objective_(std::move(objective)),
      sign_(sign),
      objective_size_(objective_size),
      rows_(std::move(rows)),
      place_(columns_.size(), -1) {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const Column& column = columns_[i];
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
  std::vector<std::pair<int, int>> entries;  // of the Hessian, row >= column
  std::vector<std::vector<std::pair<int, int>>> of_function;
  const auto add = [&](const Function& function) {
    of_function.emplace_back();
    if (function.shape() == Shape::Linear) return;
    const auto& inputs = function.inputs();
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        const int row = place_[inputs[i]], column = place_[inputs[j]];
        of_function.back().emplace_back(row, column);
        if (row >= 0 && column >= 0) entries.emplace_back(row, column);
      }
    }
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
  std::sort(entries.begin(), entries.end());
  entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
  for (const auto& [row, column] : entries) {
    hessian_.rows.push_back(row);
    hessian_.columns.push_back(column);
  }
  for (const auto& places : of_function) {
    hessian_places_.emplace_back();
    for (const auto& entry : places) {
      const bool seen = entry.first >= 0 && entry.second >= 0;
      const auto at = std::lower_bound(entries.begin(), entries.end(), entry);
      hessian_places_.back().push_back(seen ? static_cast<int>(at - entries.begin()) : -1);
    }
  }
}

bool Program::has_equations() const {
  for (std::size_t r = 0; r < rows(); ++r) {
    if (row_is_equation(r)) return true;
  }
  return false;
}

std::vector<double> Program::design(std::span<const double> y) const {
  std::vector<double> x(columns_.size());
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const Column& column = columns_[i];
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
  const std::vector<double> x = design(y);
  std::fill(entries.begin(), entries.end(), 0.0);
  Derivatives d;
  const auto add = [&](const Function& function, const std::vector<int>& places, double factor) {
    if (places.empty() || factor == 0) return;
    const auto& inputs = function.inputs();
    d.fit_second(inputs.size());
    function.hessian(x, d.g, d.h);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        const int place = places[packed(i, j)];
        if (place < 0) continue;
        entries[static_cast<std::size_t>(place)] +=
            factor * d.h[packed(i, j)] * columns_[inputs[i]].scale * columns_[inputs[j]].scale;
      }
    }
  };
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    add(rows_[r].function, hessian_places_[r], multipliers[r] / rows_[r].size);
  }
  add(objective_, hessian_places_.back(), weight * sign_ / objective_size_);
}

}  // namespace camlaw::optim
