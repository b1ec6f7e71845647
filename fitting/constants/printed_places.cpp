// SPDX-License-Identifier: MIT
#include "fitting/constants/printed_places.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "numerics/sampling/sobol_points.h"

namespace camlaw::problems {
namespace {

std::size_t count_for(std::size_t unknowns) {
  if (unknowns == 1) return 65;
  if (unknowns == 2) return 224;
  return unknowns == 3 ? 384 : 512;
}

/// On every third place one coordinate is at an end; the first are the corners, where they are few.
void onto_edges(std::size_t number, std::span<double> t) {
  // Corners double in number with each unknown. Two thirds of the places stay inside.
  constexpr std::size_t kFew = 3, kEvery = 3;
  const std::size_t n = t.size();
  if (n <= kFew && number < (std::size_t{1} << n)) {
    for (std::size_t i = 0; i < n; ++i) t[i] = ((number >> i) & 1) != 0 ? 1 : 0;
  } else if (number % kEvery == 0) {
    const std::size_t which = number / kEvery;
    t[which % n] = which / n % 2 == 0 ? 0 : 1;
  }
}

/// Shares of 1 that phases take, the last what they leave: even over the simplex, every other place
/// on one of its faces, edges or corners.
void onto_simplex(std::size_t number, std::span<double> t) {
  double sum = 0;
  for (double& share : t) sum += share = -std::log(share);
  if (number % 2 == 1) {
    const std::size_t faces = (std::size_t{1} << t.size()) - 1;
    const std::size_t face = 1 + number / 2 % faces;  // which of the shares are there
    for (std::size_t i = 0; i < t.size(); ++i) {
      if (((face >> i) & 1) == 0) t[i] = 0;
    }
    sum = 0;
    for (const double share : t) sum += share;
  }
  for (double& share : t) share /= sum;
}

}  // namespace

double SearchScale::at(double coordinate) const {
  if (coordinate <= 0) return lower;
  if (coordinate >= 1) return upper;
  const double low = std::asinh((lower - about) / size), high = std::asinh((upper - about) / size);
  return std::clamp(about + size * std::sinh(low + coordinate * (high - low)), lower, upper);
}

double SearchScale::coordinate(double x) const {
  const double low = std::asinh((lower - about) / size), high = std::asinh((upper - about) / size);
  return high > low ? (std::asinh((x - about) / size) - low) / (high - low) : 0;
}

std::vector<std::vector<double>> search_places(const std::vector<SearchScale>& unknowns,
                                               const std::optional<LawLimit>& limit,
                                               std::size_t first_of_law) {
  const std::size_t n = unknowns.size(), count = n == 0 ? 0 : count_for(n);
  std::vector<std::vector<double>> result(1);
  for (const SearchScale& u : unknowns) result.front().push_back(u.about);
  const bool on_simplex = limit && !limit->is_equal;
  const std::size_t of_law = n - first_of_law;
  SobolPoints points(std::max<std::size_t>(1, n + (on_simplex ? 1 : 0)), {});
  std::vector<double> t(n + (on_simplex ? 1 : 0)), x(n);
  if (n > 1) points.next(t);  // the middle: the first of the places stands for it
  for (std::size_t k = 0; result.size() < count + 1 && k < 2 * count; ++k) {
    if (n == 1) {
      t[0] = static_cast<double>(k) / static_cast<double>(count - 1);
    } else {
      points.next(t);
    }
    const std::span<double> shares(t.data() + (on_simplex ? first_of_law : n),
                                   t.size() - (on_simplex ? first_of_law : n));
    const std::span<double> free(t.data(), t.size() - shares.size());
    if (!free.empty() && n > 1) onto_edges(k, free);
    if (on_simplex) onto_simplex(k, shares);
    for (std::size_t i = 0; i < free.size(); ++i) x[i] = unknowns[i].at(free[i]);
    for (std::size_t i = 0; on_simplex && i < of_law; ++i) {
      x[first_of_law + i] = shares[i] / limit->factors[i];
    }
    if (limit && limit->is_equal) {  // the first makes what the others leave
      double rest = 1;
      for (std::size_t i = 1; i < of_law; ++i) rest -= limit->factors[i] * x[first_of_law + i];
      x[first_of_law] = rest / limit->factors[0];
    }
    bool inside = true;
    for (std::size_t i = 0; i < n; ++i) {
      inside = inside && x[i] >= unknowns[i].lower && x[i] <= unknowns[i].upper;
    }
    if (inside) result.push_back(x);
    if (n == 1 && k + 1 == count) break;
  }
  return result;
}

}  // namespace camlaw::problems
