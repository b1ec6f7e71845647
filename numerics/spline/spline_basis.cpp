// SPDX-License-Identifier: MIT
#include "numerics/spline/spline_basis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace camlaw::optim {
namespace {

/// The places with as many knots as the degree on either side.
std::vector<double> extended(int degree, const std::vector<double>& places, bool periodic) {
  const auto p = static_cast<std::size_t>(degree);
  const std::size_t last = places.size() - 1;
  const double period = places.back() - places.front();
  std::vector<double> knots;
  knots.reserve(places.size() + 2 * p);
  for (std::size_t k = p; k > 0; --k) {
    knots.push_back(periodic ? places[last - k] - period : places.front());
  }
  knots.insert(knots.end(), places.begin(), places.end());
  for (std::size_t k = 1; k <= p; ++k) {
    knots.push_back(periodic ? places[k] + period : places.back());
  }
  return knots;
}

}  // namespace

std::optional<Impossible> SplineBasis::fault(int degree, const std::vector<double>& places,
                                             bool periodic) {
  if (degree < 1 || degree > kMostDegree) {
    return Impossible{fmt::format("spline: degree {} is not from 1 to {}", degree, kMostDegree)};
  }
  const std::size_t least = periodic ? static_cast<std::size_t>(degree) + 2 : 2;
  if (places.size() < least) {
    return Impossible{fmt::format("spline: {} knots are too few, degree {} needs {}{}",
                                  places.size(), degree, least, periodic ? " over a period" : "")};
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (std::isfinite(places[i]) && (i == 0 || places[i] > places[i - 1])) continue;
    return Impossible{
        fmt::format("spline: knots must increase, but knot {} is {:.6g}", i, places[i])};
  }
  return {};
}

SplineBasis::SplineBasis(int degree, std::vector<double> places, bool periodic)
    : degree_(degree), periodic_(periodic), places_(std::move(places)) {
  if (const auto why = fault(degree_, places_, periodic_)) throw std::invalid_argument(why->why);
  knots_ = extended(degree_, places_, periodic_);
}

std::size_t SplineBasis::coefficients() const {
  return periodic_ ? spans() : spans() + static_cast<std::size_t>(degree_);
}

double SplineBasis::inside(double x) const {
  const double begin = places_.front(), end = places_.back();
  if (x >= begin && x <= end) return x;
  if (!periodic_ || !std::isfinite(x)) return std::numeric_limits<double>::quiet_NaN();
  const double period = end - begin;
  return std::clamp(x - period * std::floor((x - begin) / period), begin, end);
}

std::size_t SplineBasis::span_at(double x) const {
  const auto next = std::upper_bound(places_.begin() + 1, places_.end() - 1, x);
  return static_cast<std::size_t>(next - places_.begin()) - 1;
}

SplineBasis::Row SplineBasis::row_in(std::size_t span, double x, int order) const {
  Row row{span, {}};
  if (order > degree_) return row;
  auto& v = row.values;
  const double* t = knots_.data() + span + static_cast<std::size_t>(degree_);  // t[0] <= x <= t[1]
  v[0] = 1;
  int d = 1;
  for (; d <= degree_ - order; ++d) {  // Cox and de Boor's recurrence
    double carried = 0;
    for (int r = 0; r < d; ++r) {
      const double share = v[r] / (t[r + 1] - t[r + 1 - d]);
      v[r] = carried + (t[r + 1] - x) * share;
      carried = (x - t[r + 1 - d]) * share;
    }
    v[d] = carried;
  }
  for (; d <= degree_; ++d) {  // (B1), read by the functions
    double carried = 0;
    for (int r = 0; r < d; ++r) {
      const double slope = d * v[r] / (t[r + 1] - t[r + 1 - d]);
      v[r] = carried - slope;
      carried = slope;
    }
    v[d] = carried;
  }
  return row;
}

double SplineBasis::value(const Row& row, const std::vector<double>& coefficients) const {
  double sum = 0;
  for (std::size_t k = 0; k <= static_cast<std::size_t>(degree_); ++k) {
    sum += row.values[k] * coefficients[(row.span + k) % coefficients.size()];
  }
  return sum;
}

}  // namespace camlaw::optim
