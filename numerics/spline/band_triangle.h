// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "numerics/spline/spline_basis.h"

/// Least squares with rows that lie in a band, but for a few last columns (the border) that any row
/// may touch: what splines give, the border being where a period closes.
namespace camlaw::optim {

/// Entries of a row that are kept side by side.
inline constexpr std::size_t kMostWidth = static_cast<std::size_t>(kMostDegree) + 2;

/// One equation: sum over k of band[k] x[first + k], plus the border's part, = right.
struct BandRow {
  std::size_t first = 0;
  std::array<double, kMostWidth> band{};
  std::array<double, kMostWidth> border{};
  double right = 0;
};

/// The triangle R of Q R = rows, taken in one by one by plane rotations; Q is not kept. A row costs
/// width^2 operations if rows come in the order of their first columns. So a million samples need
/// memory for the unknowns alone, and no normal equations are formed, whose condition is the
/// square.
class BandTriangle {
 public:
  /// `columns` in the band, rows up to `width` wide, and `border` columns behind them.
  BandTriangle(std::size_t columns, std::size_t width, std::size_t border);

  void add(BandRow row);
  /// Sum of the squares of `right` that no x reaches.
  double rest() const { return rest_; }

  std::size_t columns() const { return rows_.size(); }
  std::size_t width() const { return width_; }
  std::size_t border() const { return corner_.size(); }
  /// Row of R with what Q^T makes of `right`; those from columns() on are the border's own, with
  /// entries in `border` from the diagonal on.
  const BandRow& row(std::size_t i) const {
    return i < columns() ? rows_[i] : corner_[i - columns()];
  }
  std::size_t rows() const { return columns() + border(); }

  /// The least squares solution, the border's unknowns last; not finite where R is singular.
  std::vector<double> solve() const;
  /// |R x - Q^T right|^2: with rest() the sum of squares that x leaves.
  double misfit(const std::vector<double>& x) const;

 private:
  void add_to_corner(BandRow& row);

  std::size_t width_;
  std::vector<BandRow> rows_, corner_;
  double rest_ = 0;
};

/// The entries of Z = (R^T R)^-1 where R has entries (Takahashi, Fagan and Chin 1973), from
/// R Z = R^-T, the lower triangle of which is known: nothing but its diagonal counts. They are all
/// that is needed for the variance of a row that fits into the band.
class BandInverse {
 public:
  explicit BandInverse(const BandTriangle& triangle);

  /// row^T Z row.
  double form(const BandRow& row) const;

 private:
  /// Z[i, j] for a band column i and any j >= i of its row's pattern: k < width in the band, then
  /// the border.
  double& at(std::size_t i, std::size_t k) { return values_[i * stride_ + k]; }
  double at(std::size_t i, std::size_t k) const { return values_[i * stride_ + k]; }
  double between(std::size_t i, std::size_t k, std::size_t l) const;
  double corner(std::size_t k, std::size_t l) const { return corner_[k * border_ + l]; }
  void fill_corner(const BandTriangle& triangle);
  void fill_row(const BandTriangle& triangle, std::size_t i);

  std::size_t columns_, width_, border_, stride_;
  std::vector<double> values_, corner_;
};

}  // namespace camlaw::optim
