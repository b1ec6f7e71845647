// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "optim/problem/curve.h"
#include "optim/problem/function.h"

/// The smooth program that back ends see: one objective, rows with bounds, all scaled. It is the
/// one place where indexes, signs and scales are worked out.
namespace camlaw::optim {

/// A row of the program: lower <= function(x) + coefficient * x[auxiliary] <= upper.
struct Row {
  Function function;
  double lower = -kInfinity;
  double upper = kInfinity;
  double size = 1;  ///< in the response's unit: what counts as a change of order one
  /// A variable that enters linearly beside the function (a peak's bound, a violation).
  std::optional<std::pair<std::size_t, double>> auxiliary = {};
  std::optional<std::size_t> constraint = {};  ///< of the problem; none: the objective's peak
  bool at_rest = false;                        ///< a leading coefficient (cycle/rest_weights.h)
  std::optional<Place> place = {};             ///< of a curve, whose value there the function is
  std::optional<std::size_t> rest = {};        ///< of a leading coefficient: which of the curve's
};

/// A variable of the program. Fixed variables (lower == upper) are not seen by the solvers.
struct ProgramColumn {
  double lower = -kInfinity;
  double upper = kInfinity;
  double start = 0;
  double scale = 1;
};

/// Entries of a sparse matrix: row and column of each.
struct Pattern {
  std::vector<int> rows, columns;
  std::size_t size() const { return rows.size(); }
};

/// minimise objective(x) subject to rows and bounds. Solvers work with y, the free columns divided
/// by their scales, and with rows divided by their sizes. The objective is divided by its size.
class Program {
 public:
  /// Minimises `objective` (maximises where `sign` is -1) of size `objective_size`.
  Program(std::vector<ProgramColumn> columns, Function objective, double sign,
          double objective_size, std::vector<Row> rows);

  std::size_t variables() const { return free_.size(); }
  std::size_t rows() const { return rows_.size(); }
  std::span<const double> lower() const { return lower_; }  ///< of y
  std::span<const double> upper() const { return upper_; }
  std::span<const double> start() const { return start_; }
  std::span<const double> row_lower() const { return row_lower_; }
  std::span<const double> row_upper() const { return row_upper_; }
  bool row_is_equation(std::size_t row) const { return row_lower_[row] == row_upper_[row]; }
  bool row_is_linear(std::size_t row) const { return rows_[row].function.shape() == Shape::Linear; }
  bool has_equations() const;
  /// Whether objective and rows are known to be linear.
  bool is_linear() const;

  double objective(std::span<const double> y) const;
  /// Returns the value; gradient has variables() entries.
  double gradient(std::span<const double> y, std::span<double> gradient) const;
  double row(std::size_t row, std::span<const double> y) const;
  void row_values(std::span<const double> y, std::span<double> values) const;
  /// Returns the value; writes the whole gradient of one row.
  double row_gradient(std::size_t row, std::span<const double> y, std::span<double> gradient) const;
  /// Rows' gradients, entry by entry of jacobian_pattern().
  const Pattern& jacobian_pattern() const { return jacobian_; }
  void jacobian(std::span<const double> y, std::span<double> entries) const;
  /// weight * objective + sum multipliers[i] * row i: second derivatives, lower triangle.
  const Pattern& hessian_pattern() const { return hessian_; }
  void hessian(std::span<const double> y, double weight, std::span<const double> multipliers,
               std::span<double> entries) const;
  /// The same with negative eigenvalues of each function's second derivatives, as they are
  /// weighted, set to 0; of a row without auxiliary only what it does across its own gradient.
  void convex_hessian(std::span<const double> y, double weight, std::span<const double> multipliers,
                      std::span<double> entries) const;

  /// Between the program's y and the problem's x.
  std::vector<double> design(std::span<const double> y) const;
  std::vector<double> scaled(std::span<const double> x) const;
  /// The program's objective in the problem's unit and sign.
  double unscaled_objective(double value) const { return sign_ * objective_size_ * value; }
  const std::vector<Row>& row_list() const { return rows_; }
  const std::vector<ProgramColumn>& columns() const { return columns_; }
  /// The column of an entry of y.
  std::size_t column(std::size_t variable) const { return free_[variable]; }
  double objective_size() const { return objective_size_; }

 private:
  enum class Curvature { Whole, Convex };
  void lay_out();
  void add_hessians(std::span<const double> y, double weight, std::span<const double> multipliers,
                    Curvature curvature, std::span<double> entries) const;
  void add_entries(const std::vector<std::size_t>& inputs,
                   std::vector<std::vector<int>>& columns) const;

  std::vector<ProgramColumn> columns_;
  Function objective_;
  double sign_, objective_size_;
  std::vector<Row> rows_;
  std::vector<std::size_t> free_;  // y index -> column
  std::vector<int> place_;         // column -> y index, -1 where fixed
  std::vector<double> lower_, upper_, start_, row_lower_, row_upper_;
  Pattern jacobian_, hessian_;
  /// The entry of each packed second derivative, -1 where an input is fixed: one list for each set
  /// of inputs, which many rows have in common; and for each function (rows, then the objective)
  /// the number of its list, -1 where the function is linear.
  std::vector<std::vector<int>> hessian_places_;
  std::vector<int> places_of_;
};

}  // namespace camlaw::optim
