// SPDX-License-Identifier: MIT
#include "numerics/spline/band_triangle.h"

#include <algorithm>
#include <cmath>

namespace camlaw::optim {
namespace {

/// Rotates `row` against `kept`, whose entries line up, so that row's entry `head` vanishes.
void rotate(double& kept_head, double head, BandRow& kept, BandRow& row, std::size_t width,
            std::size_t border) {
  const double length = std::sqrt(kept_head * kept_head + head * head);
  const double c = kept_head / length, s = head / length;
  const auto turn = [&](double& a, double& b) {
    const double above = c * a + s * b;
    b = c * b - s * a;
    a = above;
  };
  for (std::size_t k = 0; k < width; ++k) turn(kept.band[k], row.band[k]);
  for (std::size_t k = 0; k < border; ++k) turn(kept.border[k], row.border[k]);
  turn(kept.right, row.right);
}

void shift(BandRow& row, std::size_t width) {
  for (std::size_t k = 0; k + 1 < width; ++k) row.band[k] = row.band[k + 1];
  row.band[width - 1] = 0;
  ++row.first;
}

bool is_zero(const BandRow& row, std::size_t width) {
  return std::all_of(row.band.begin(), row.band.begin() + static_cast<std::ptrdiff_t>(width),
                     [](double entry) { return entry == 0; });
}

}  // namespace

BandTriangle::BandTriangle(std::size_t columns, std::size_t width, std::size_t border)
    : width_(width), rows_(columns), corner_(border) {
  for (std::size_t i = 0; i < columns; ++i) rows_[i].first = i;
  for (std::size_t i = 0; i < border; ++i) corner_[i].first = columns;
}

void BandTriangle::add(BandRow row) {
  while (row.first < columns() && !is_zero(row, width_)) {
    if (row.band[0] != 0) {
      BandRow& kept = rows_[row.first];
      if (kept.band[0] == 0) {  // no row has come to rest here yet
        kept = row;
        return;
      }
      rotate(kept.band[0], row.band[0], kept, row, width_, border());
      row.band[0] = 0;
    }
    shift(row, width_);
  }
  add_to_corner(row);
}

void BandTriangle::add_to_corner(BandRow& row) {
  row.first = columns();
  for (std::size_t j = 0; j < border(); ++j) {
    if (row.border[j] == 0) continue;
    if (corner_[j].border[j] == 0) {
      corner_[j] = row;
      return;
    }
    rotate(corner_[j].border[j], row.border[j], corner_[j], row, 0, border());
    row.border[j] = 0;
  }
  rest_ += row.right * row.right;
}

std::vector<double> BandTriangle::solve() const {
  std::vector<double> x(rows());
  for (std::size_t i = rows(); i-- > 0;) {
    const BandRow& r = row(i);
    const bool banded = i < columns();
    double sum = r.right;
    for (std::size_t k = 1; banded && k < width_ && i + k < columns(); ++k) {
      sum -= r.band[k] * x[i + k];
    }
    for (std::size_t k = banded ? 0 : i - columns() + 1; k < border(); ++k) {
      sum -= r.border[k] * x[columns() + k];
    }
    x[i] = sum / (banded ? r.band[0] : r.border[i - columns()]);
  }
  return x;
}

double BandTriangle::misfit(const std::vector<double>& x) const {
  double sum = 0;
  for (std::size_t i = 0; i < rows(); ++i) {
    const BandRow& r = row(i);
    double left = -r.right;
    for (std::size_t k = 0; k < width_ && r.first + k < columns(); ++k) {
      left += r.band[k] * x[r.first + k];
    }
    for (std::size_t k = 0; k < border(); ++k) left += r.border[k] * x[columns() + k];
    sum += left * left;
  }
  return sum;
}

BandInverse::BandInverse(const BandTriangle& triangle)
    : columns_(triangle.columns()),
      width_(triangle.width()),
      border_(triangle.border()),
      stride_(width_ + border_),
      values_(columns_ * stride_, 0.0),
      corner_(border_ * border_, 0.0) {
  fill_corner(triangle);
  for (std::size_t i = columns_; i-- > 0;) fill_row(triangle, i);
}

void BandInverse::fill_corner(const BandTriangle& triangle) {
  for (std::size_t i = border_; i-- > 0;) {
    const auto& r = triangle.row(columns_ + i).border;
    for (std::size_t j = border_; j-- > i;) {
      double sum = i == j ? 1 / r[i] : 0;
      for (std::size_t k = i + 1; k < border_; ++k) sum -= r[k] * corner(k, j);
      corner_[i * border_ + j] = corner_[j * border_ + i] = sum / r[i];
    }
  }
}

/// Z[i + k, i + l] for places k, l of row i's pattern, k and l above 0.
double BandInverse::between(std::size_t i, std::size_t k, std::size_t l) const {
  if (k > l) std::swap(k, l);
  if (k >= width_) return corner(k - width_, l - width_);
  return l >= width_ ? at(i + k, l) : at(i + k, l - k);
}

void BandInverse::fill_row(const BandTriangle& triangle, std::size_t i) {
  const BandRow& r = triangle.row(i);
  const std::size_t end = std::min(width_, columns_ - i);
  std::array<double, 2 * kMostWidth> entry{};
  for (std::size_t k = 1; k < end; ++k) entry[k] = r.band[k];
  for (std::size_t k = 0; k < border_; ++k) entry[width_ + k] = r.border[k];
  for (std::size_t l = 1; l < stride_; ++l) {
    if (l >= end && l < width_) continue;
    double sum = 0;
    for (std::size_t k = 1; k < stride_; ++k) {
      if (k < end || k >= width_) sum -= entry[k] * between(i, k, l);
    }
    at(i, l) = sum / r.band[0];
  }
  double sum = 1 / r.band[0];
  for (std::size_t k = 1; k < stride_; ++k) sum -= entry[k] * at(i, k);
  at(i, 0) = sum / r.band[0];
}

double BandInverse::form(const BandRow& row) const {
  double sum = 0;
  const std::size_t end = row.first < columns_ ? std::min(width_, columns_ - row.first) : 0;
  for (std::size_t k = 0; k < end; ++k) {
    const std::size_t i = row.first + k;
    double part = 0.5 * row.band[k] * at(i, 0);
    for (std::size_t l = k + 1; l < end; ++l) part += row.band[l] * at(i, l - k);
    for (std::size_t l = 0; l < border_; ++l) part += row.border[l] * at(i, width_ + l);
    sum += 2 * row.band[k] * part;
  }
  for (std::size_t k = 0; k < border_; ++k) {
    for (std::size_t l = 0; l < border_; ++l) sum += row.border[k] * row.border[l] * corner(k, l);
  }
  return sum;
}

}  // namespace camlaw::optim
