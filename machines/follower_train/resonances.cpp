// SPDX-License-Identifier: MIT
#include "machines/follower_train/resonances.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "machines/follower_train/law_boxes.h"
#include "numerics/scalar/extremes.h"

namespace camlaw {
namespace {

template <class T>
T squared(const T& x) {
  return x * x;
}

/// Bounds |r d/dr (r d/dr H)| for r from `low` to `high`, with H = N / Q, N = 1 + 2 i zeta r and
/// Q = 1 - r^2 + 2 i zeta r.
template <class T>
T transfer_bend(const T& zeta, const T& low, const T& high) {
  using std::sqrt;
  const T one = number<T>(1), two = number<T>(2), four = number<T>(4);
  const T off = greater_of(number<T>(0), greater_of(T(squared(low) - one), T(one - squared(high))));
  const T damped = two * zeta * high, square = squared(high);
  const T n = sqrt(one + squared(damped));
  const T q = sqrt(squared(off) + squared(T(two * zeta * low)));
  const T dq = sqrt(four * squared(square) + squared(damped));
  const T ddq = sqrt(four * four * squared(square) + squared(damped));
  return (damped + (two * damped * dq + n * ddq + two * n * squared(dq) / q) / q) / q;
}

/// From here on |r d/dr (r d/dr H)| <= 55 zeta / r + 21 / r^2 for zeta < 1.
constexpr double kFar = 4, kDampedFar = 55, kFreeFar = 21;

}  // namespace

double acceleration_variation(const Law<Interval>& law) {
  constexpr int kSecond = 2, kThird = 3;  // orders of the derivatives of s
  Interval sum(0.0);
  std::vector<Interval> begins, ends;
  for (const Piece<Interval>& piece : law.pieces()) {
    const PieceExpander expander(piece);
    begins.push_back(expander(piece.begin).over[kSecond]);
    ends.push_back(expander(piece.end).over[kSecond]);
  }
  visit_boxes(law, [&](const Interval&, const Interval& length, const auto& over) {
    sum += length * magnitude(over[kThird]);
  });
  for (std::size_t i = 0; i < begins.size(); ++i) {
    sum += abs(begins[(i + 1) % begins.size()] - ends[i]);
  }
  return std::isfinite(sum.upper()) ? sum.upper() : std::numeric_limits<double>::infinity();
}

template <class T>
T resonant_bend(const BoundedAcceleration<T>& acceleration, const T& damping_ratio, const T& slow,
                const T& fast) {
  const T by_harmonic = acceleration.variation / (number<T>(2) * pi<T>());
  const T& zeta = damping_ratio;
  const int last = static_cast<int>(std::ceil(kFar / value_of(slow))) + 1;
  T sum = number<T>(0);
  for (int k = 1; k <= last; ++k) {
    const T order = number<T>(k);
    sum = sum + lesser_of(acceleration.most, T(by_harmonic / order)) *
                    transfer_bend(zeta, T(order * slow), T(order * fast));
  }
  // Of 1 / k^2 and 1 / k^3 behind the last.
  const T far = number<T>(last);
  sum = sum + by_harmonic * (number<T>(kDampedFar) * zeta / (slow * far) +
                             number<T>(kFreeFar) / (number<T>(2) * squared(T(slow * far))));
  return number<T>(2) * sum;
}

template double resonant_bend(const BoundedAcceleration<double>&, const double&, const double&,
                              const double&);
template Interval resonant_bend(const BoundedAcceleration<Interval>&, const Interval&,
                                const Interval&, const Interval&);

}  // namespace camlaw
