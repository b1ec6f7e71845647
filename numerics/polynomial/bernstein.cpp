// SPDX-License-Identifier: MIT
#include "numerics/polynomial/bernstein.h"

#include <array>
#include <numeric>
#include <type_traits>

#include "numerics/polynomial/polynomial.h"

namespace camlaw::detail {
namespace {

/// Entry k: 2^k / (n over k).
template <class T>
std::vector<T> bernstein_weights(std::size_t n) {
  std::vector<T> result;
  T weight(1.0);
  for (std::size_t k = 0; k <= n; ++k) {
    result.push_back(weight);
    weight = weight * T(2.0 * static_cast<double>(k + 1)) / T(static_cast<double>(n - k));
  }
  return result;
}

/// (P3): quick, but it takes sums about the left end that cancel, by as much as 3^n.
template <class T>
void by_left_end(std::vector<T>& c) {
  constexpr std::size_t kCached = 41;  // higher degrees, which are rare, take their weights afresh
  static const auto cache = [] {
    std::array<std::vector<T>, kCached> weights;
    for (std::size_t n = 0; n < kCached; ++n) weights[n] = bernstein_weights<T>(n);
    return weights;
  }();
  const std::size_t n = c.size() - 1;
  shift_polynomial(c, T(-1.0));
  const std::vector<T> fresh = n < kCached ? std::vector<T>{} : bernstein_weights<T>(n);
  const std::vector<T>& weights = n < kCached ? cache[n] : fresh;
  for (std::size_t k = 1; k <= n; ++k) c[k] = c[k] * weights[k];
  for (std::size_t k = 1; k <= n; ++k) {
    for (std::size_t i = n; i >= k; --i) c[i] = c[i] + c[i - 1];
  }
}

/// Horner's scheme on Bernstein coefficients (P3a): no sum on the way is larger than that of |c|.
template <class T>
void by_horner(std::vector<T>& c) {
  std::vector<T> b{c.back()};
  for (std::size_t k = c.size() - 1; k-- > 0;) {
    const auto degree = static_cast<double>(b.size());
    b.push_back(T(0.0));
    for (std::size_t i = b.size(); i-- > 0;) {
      const auto place = static_cast<double>(i);
      const T risen = i > 0 ? T(place) * b[i - 1] : T(0.0);
      b[i] = (risen - T(degree - place) * b[i]) / T(degree) + c[k];
    }
  }
  c = std::move(b);
}

}  // namespace

template <class T>
double to_bernstein(std::vector<T>& c) {
  // Two digits may be lost for the quicker way; a rounding is half a unit of the last place.
  constexpr double kMuch = 100, kRounding = 0x1p-53;
  double sum = 0, amplified = 0, power = 1;
  for (const T& each : c) {
    sum += size(each);
    amplified += power * size(each);
    power *= 3;
  }
  const bool cancels = !(amplified <= kMuch * sum);
  const double terms = 4 + static_cast<double>(c.size()) / 2;
  cancels ? by_horner(c) : by_left_end(c);
  if constexpr (std::is_same_v<T, double>) {
    return kRounding * (cancels ? terms * sum : amplified);
  } else {
    return 0;
  }
}

template double to_bernstein(std::vector<double>&);
template double to_bernstein(std::vector<Interval>&);

template <class T>
Course course(const std::vector<T>& bernstein, double sign) {
  int changes = 0;
  int direction = 0;  // of the last step that was not level
  int first = 0;
  for (std::size_t k = 0; k + 1 < bernstein.size(); ++k) {
    const T step = T(sign) * (bernstein[k + 1] - bernstein[k]);
    const bool up = upper(step) > 0, down = lower(step) < 0;
    if (up && down) return Course::Unknown;
    const int next = up ? 1 : down ? -1 : 0;
    if (next == 0) continue;
    if (direction == 0) first = next;
    if (direction != 0 && next != direction) ++changes;
    direction = next;
  }
  if (changes == 0 || (changes == 1 && first < 0)) return Course::PeakAtEnd;
  return changes == 1 ? Course::PeakInside : Course::Unknown;
}

template Course course(const std::vector<double>&, double);
template Course course(const std::vector<Interval>&, double);

double turning_point(const std::vector<double>& c, double sign) {
  double low = -1, high = 1, u = 0;
  for (int pass = 0; pass < 80; ++pass) {
    double slope = 0, curvature = 0;
    for (std::size_t k = c.size(); k-- > 1;) {
      curvature = curvature * u + slope;
      slope = slope * u + static_cast<double>(k) * c[k];
    }
    if (slope == 0) return u;
    (sign * slope > 0 ? low : high) = u;
    double next = u - slope / curvature;
    if (!(next > low && next < high)) next = std::midpoint(low, high);
    if (std::abs(next - u) <= 2e-16) return next;
    u = next;
  }
  return u;
}

}  // namespace camlaw::detail
