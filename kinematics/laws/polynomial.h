// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "kinematics/laws/build.h"
#include "kinematics/shape.h"
#include "numerics/polynomial/polynomial.h"

/// Laws that are one polynomial. Equations: docs/theory.md, "Polynomials".
namespace camlaw {

/// s = x, between constant velocities.
template <class T>
Law<T> constant_velocity() {
  return polynomial_law<T>({number<T>(0), number<T>(1)}, {End::Velocity, End::Velocity});
}

/// The law of whole coefficients c[0], c[1], ..., divided by `denominator`.
template <class T>
Law<T> polynomial_law_of(std::initializer_list<double> coefficients, Ends ends = {},
                         double denominator = 1) {
  std::vector<T> c;
  for (const double k : coefficients) {
    c.push_back(denominator == 1 ? number<T>(k) : ratio<T>(k, denominator));
  }
  return polynomial_law<T>(std::move(c), ends);
}

template <class T>
Law<T> cubic() {
  return polynomial_law_of<T>({0, 0, 3, -2});
}

template <class T>
Law<T> poly_3_4_5() {
  return polynomial_law_of<T>({0, 0, 0, 10, -15, 6});
}

template <class T>
Law<T> poly_4_5_6_7() {
  return polynomial_law_of<T>({0, 0, 0, 0, 35, -84, 70, -20});
}

template <class T>
Law<T> poly_5_6_7_8_9() {
  return polynomial_law_of<T>({0, 0, 0, 0, 0, 126, -420, 540, -315, 70});
}

/// Rothbart's eighth-degree polynomial, dwell to turn.
template <class T>
Law<T> rothbart_8() {
  return polynomial_law_of<T>({0, 0, 0, 609755, 0, -2078040, 2673155, -1360965, 256095},
                              {End::Rest, End::Reversal}, 100000);
}

/// 10 x^4 - 14 x^5 + 5 x^6, dwell to turn.
template <class T>
Law<T> quick_return() {
  return polynomial_law_of<T>({0, 0, 0, 0, 10, -14, 5}, {End::Rest, End::Reversal});
}

/// s' = a q + b q^2 + c q^3 with q = x (1 - x): symmetric, at rest at both ends.
template <class T>
Law<T> law_in_q(const T& a, const T& b, const T& c) {
  const std::vector<T> q{number<T>(0), number<T>(1), number<T>(-1)};
  const auto q2 = multiply(q, q), q3 = multiply(q2, q);
  std::vector<T> velocity(7, number<T>(0));
  for (std::size_t i = 0; i < q.size(); ++i) velocity[i] = velocity[i] + a * q[i];
  for (std::size_t i = 0; i < q2.size(); ++i) velocity[i] = velocity[i] + b * q2[i];
  for (std::size_t i = 0; i < q3.size(); ++i) velocity[i] = velocity[i] + c * q3[i];
  while (is_number(velocity.back(), 0)) velocity.pop_back();
  return polynomial_law<T>(integrate(velocity));
}

/// The spine-cutter study's polynomial of degree 5: s' = q (6 + 0.6 alpha - 3 alpha q).
/// alpha = 0 is the cubic, alpha = -10 the 3-4-5.
template <class T>
Law<T> polynomial_5(const T& alpha) {
  return law_in_q<T>(number<T>(6) + ratio<T>(3, 5) * alpha, number<T>(-3) * alpha, number<T>(0));
}

/// The spine-cutter study's polynomial of degree 7: s' = A q^2 + (140 - 14 A / 3) q^3.
/// A = 0 is the 4-5-6-7, A = 30 the 3-4-5.
template <class T>
Law<T> polynomial_7(const T& A) {
  return law_in_q<T>(number<T>(0), A, number<T>(140) - ratio<T>(14, 3) * A);
}

/// The polynomial of least degree whose derivatives 0, 1, 2, ... at x = 0 are `begin` and at x = 1
/// are `end` (two-point Hermite interpolation; docs/theory.md, "Boundary polynomials"). Impossible
/// where a coefficient is not finite.
template <class T>
Possible<Law<T>> possible_boundary_polynomial(const std::vector<T>& begin,
                                              const std::vector<T>& end) {
  const std::size_t m = begin.size(), n = end.size();
  std::vector<T> low(m + n, number<T>(0));  // Taylor polynomial at 0
  T factorial = number<T>(1);
  for (std::size_t k = 0; k < m; ++k) {
    if (k > 1) factorial = factorial * number<T>(static_cast<double>(k));
    low[k] = begin[k] / factorial;
  }
  // s = low + x^m q; about x = 1 the series of q is that of (s - low) (1 + h)^-m.
  std::vector<T> rest = low;
  shift_polynomial(rest, number<T>(1));
  factorial = number<T>(1);
  for (std::size_t k = 0; k < n; ++k) {
    if (k > 1) factorial = factorial * number<T>(static_cast<double>(k));
    rest[k] = end[k] / factorial - rest[k];
  }
  std::vector<T> q(n, number<T>(0));
  for (std::size_t k = 0; k < n; ++k) {
    double binomial = 1;  // (-m over i)
    for (std::size_t i = 0; i <= k; ++i) {
      q[k] = q[k] + number<T>(binomial) * rest[k - i];
      binomial *= -static_cast<double>(m + i) / static_cast<double>(i + 1);
    }
  }
  shift_polynomial(q, number<T>(-1));
  for (std::size_t k = 0; k < n; ++k) low[m + k] = q[k];
  const auto law = possible_polynomial_law<T>(std::move(low));
  if (!law) return law;
  const Ends found = natural_ends(law->template as<double>());
  // What was given at an end is exact; what was not is read off the polynomial.
  const auto kind = [](const std::vector<T>& given, End otherwise) {
    if (given.size() < 3) return otherwise;
    const bool still = value_of(given[1]) == 0, steady = value_of(given[2]) == 0;
    if (still) return steady ? End::Rest : End::Reversal;
    return steady ? End::Velocity : End::Motion;
  };
  return law->with_ends({kind(begin, found.begin), kind(end, found.end)});
}

/// Throws std::invalid_argument where a coefficient is not finite.
template <class T>
Law<T> boundary_polynomial(const std::vector<T>& begin, const std::vector<T>& end) {
  return possible_boundary_polynomial(begin, end).value();
}

/// Stoddart's rule: s = sum C_p x^p over the exponents, C_p the product of q / (q - p) over the
/// other exponents q; s = 1 and all derivatives that the number of exponents allows are 0 at x = 1.
/// Exponents need not be integers. Impossible unless there are two or more, all different and at
/// least 2.
template <class T>
Possible<Law<T>> possible_stoddart(std::vector<double> exponents) {
  std::sort(exponents.begin(), exponents.end());
  if (exponents.size() < 2) return Impossible{"exponents: at least two are needed"};
  Piece<T> piece{number<T>(0), number<T>(1), number<T>(0), {}, {}, {}};
  for (const double& p : exponents) {
    if (!(p >= 2)) return Impossible{"exponents: each must be at least 2"};
    T c = number<T>(1);
    for (const double& q : exponents) {
      if (&q == &p) continue;
      if (q == p) return Impossible{"exponents: all must be different"};
      c = c * number<T>(q) / (number<T>(q) - number<T>(p));
    }
    if (p == std::floor(p)) {
      const auto power = static_cast<std::size_t>(p);
      if (piece.polynomial.size() <= power) piece.polynomial.resize(power + 1, number<T>(0));
      piece.polynomial[power] = c;
    } else {
      piece.curves.push_back({c, number<T>(1), number<T>(0), Power<T>{p}});
    }
  }
  const auto law = Law<T>::possible({piece}, {});
  if (!law) return law;
  return law->with_ends(natural_ends(law->template as<double>()));
}

/// Throws std::invalid_argument where the exponents make no law.
template <class T>
Law<T> stoddart(std::vector<double> exponents) {
  return possible_stoddart<T>(std::move(exponents)).value();
}

namespace detail {

/// Taylor coefficients of the Legendre polynomial P_n about u = 1 - 2 middle, each the double
/// nearest to the true one: the three-term recurrence (k + 1) P_(k+1) = (2 k + 1) u P_k - k P_(k-1)
/// on series, in a hundred digits. Kept from call to call.
const std::vector<double>& legendre_taylor(int n, double middle);

/// A correctly rounded constant: itself, or the interval to its neighbours.
template <class T>
T rounded(double x) {
  if constexpr (std::is_same_v<T, Interval>) {
    return x == 0 ? Interval(0.0) : Interval(step_down(x), step_up(x));
  } else {
    return number<T>(x);
  }
}

}  // namespace detail

/// The general symmetric polynomial: s'' = 6 P_1(u) + c[0] P_3(u) + c[1] P_5(u) + ..., u = 1 - 2x.
/// Any length of c. Beyond degree 11 the law is laid down in several pieces, so that rounding does
/// not grow with the order (docs/theory.md, "Legendre laws").
template <class T>
Law<T> legendre(const std::vector<T>& c) {
  const int order = 1 + 2 * static_cast<int>(c.size());
  const int count = order <= 9 ? 1 : order / 2;
  std::vector<Piece<T>> pieces;
  for (int i = 0; i < count; ++i) {
    // Breaks where a Chebyshev grid has them: the polynomials turn faster near the ends.
    const auto place = [&](int k) {
      return k == 0 ? 0.0 : k == count ? 1.0 : 0.5 - 0.5 * std::cos(std::numbers::pi * k / count);
    };
    const double begin = place(i), end = place(i + 1);
    const double middle = std::midpoint(begin, end);
    std::vector<T> s(static_cast<std::size_t>(order) + 3, number<T>(0));
    const auto add = [&](const T& factor, int n) {
      const auto& p = detail::legendre_taylor(n, middle);
      for (std::size_t m = 0; m < p.size(); ++m) {
        s[m] = s[m] + factor * detail::rounded<T>(p[m]);
      }
    };
    add(ratio<T>(1, 2), 0);
    add(ratio<T>(-1, 2), 1);
    for (int k = 1; k <= order; k += 2) {
      // d/dx = -2 d/du, so a term c_k P_k of s'' adds c_k G_k / 4 to s, with G_k'' = P_k:
      // (2k+1) G_k = (P_(k+2) - P_k) / (2k+3) - (P_k - P_(k-2)) / (2k-1), the last pair for k > 1.
      const T weight = (k == 1 ? number<T>(6) : c[static_cast<std::size_t>((k - 3) / 2)]) *
                       ratio<T>(1, 4 * (2 * k + 1));
      const T upper_share = weight * ratio<T>(1, 2 * k + 3);
      const T lower_share = k == 1 ? number<T>(0) : weight * ratio<T>(1, 2 * k - 1);
      add(upper_share, k + 2);
      add(-(upper_share + lower_share), k);
      if (k > 1) add(lower_share, k - 2);
    }
    T scale = number<T>(1);
    for (T& coefficient : s) {  // from the variable u - u0 to x - x0 = -(u - u0) / 2
      coefficient = coefficient * scale;
      scale = scale * number<T>(-2);
    }
    pieces.push_back({number<T>(begin), number<T>(end), number<T>(middle), s, {}, {}});
  }
  return Law<T>(std::move(pieces), {});
}

}  // namespace camlaw
