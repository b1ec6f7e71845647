// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <type_traits>
#include <vector>

#include "machines/model/cycle_mean.h"
#include "machines/model/law_binding.h"
#include "numerics/polynomial/gauss_legendre.h"
#include "numerics/scalar/dual.h"
#include "optim/problem/function.h"

/// Mean squares of a law's derivatives over x from 0 to 1 (docs/theory.md, "Mean squares").
namespace camlaw::problems {

/// int_0^1 s^(order)(x)^2 dx, order 1 to 3: exact for pieces that are polynomials, and enclosed
/// where T is Interval; else by quadrature as of cycle_mean. Impossible where s^(order - 1) jumps
/// inside the stretch, and where it would with the parameters that T carries derivatives by: then
/// it is infinite.
template <class T>
Possible<T> mean_square(const Law<T>& law, int order);

/// The same over the variables of a law that is linear in them: a sum of squares of linear
/// functions, put together once from the pieces that each variable moves; no more for each piece
/// than variables that move it. Expanded, the squares of a law of many knots would be differences
/// of numbers that are some 10^15 times as large as the mean. Encloses as `exact` does. Not a
/// number where s^(order - 1) jumps with any values of the variables: then it is infinite but for
/// single laws.
std::shared_ptr<const optim::Kernel> mean_square_kernel(std::shared_ptr<const LawBinding> law,
                                                        int order,
                                                        std::shared_ptr<const optim::Kernel> exact);

// ---------------------------------------------------------------------------------------------

namespace detail {

inline constexpr const char* kJumps =
    "it is infinite: the next lower derivative jumps where pieces of the law meet";

/// The largest of a scalar's value and derivatives, as sizes.
inline double largest_part(double x) { return std::abs(x); }
inline double largest_part(const Interval& x) { return std::abs(value_of(x)); }
template <class T, int N>
double largest_part(const ceres::Jet<T, N>& x) {
  double largest = largest_part(x.a);
  for (int i = 0; i < N; ++i) largest = std::max(largest, largest_part(x.v[i]));
  return largest;
}

/// Whether a derivative jumps between pieces by more than rounding, or would with the parameters
/// that T carries derivatives by.
template <class T>
bool jumps_between(const Law<T>& law, int order) {
  // Splines of high degree cancel to seven or eight digits of their derivatives.
  constexpr double kRounding = 1e-7;
  const auto& pieces = law.pieces();
  const auto k = static_cast<std::size_t>(order);
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    const T left = derivatives<4>(pieces[i], pieces[i].end)[k];
    const T right = derivatives<4>(pieces[i + 1], pieces[i].end)[k];
    const double size = 1 + largest_part(left) + largest_part(right);
    if (!(largest_part(left - right) <= kRounding * size)) return true;
  }
  return false;
}

/// Derivative `order` of the piece's polynomial.
template <class T>
std::vector<T> derived(std::vector<T> a, int order) {
  for (int n = 0; n < order; ++n) {
    for (std::size_t k = 1; k < a.size(); ++k) a[k - 1] = number<T>(static_cast<double>(k)) * a[k];
    if (!a.empty()) a.pop_back();
  }
  return a;
}

/// The polynomial about a place `shift` further on.
template <class T>
void move_origin(std::vector<T>& a, const T& shift) {
  if (is_number(shift, 0)) return;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = a.size() - 1; k-- > i;) a[k] = a[k] + shift * a[k + 1];
  }
}

/// Encloses, from the powers about the middle: those odd add nothing, the even ones least rounding.
inline Interval polynomial_square(const Piece<Interval>& piece, int order) {
  std::vector<Interval> a = derived(piece.polynomial, order);
  const Interval half = Interval(0.5) * (piece.end - piece.begin);
  move_origin(a, Interval(0.5) * (piece.begin + piece.end) - piece.origin);
  Interval sum(0.0), power = half;
  for (std::size_t n = 0; n + 1 < 2 * a.size(); n += 2) {
    Interval product(0.0);
    for (std::size_t i = n + 1 > a.size() ? n + 1 - a.size() : 0; 2 * i < n; ++i) {
      product += Interval(2.0) * a[i] * a[n - i];
    }
    product += boost::numeric::square(a[n / 2]);
    sum += product * power * Interval(2.0) / Interval(static_cast<double>(n + 1));
    power *= half * half;
  }
  return sum;
}

/// By Gauss-Legendre quadrature with as many points as are exact: what it adds up is positive, so
/// that nothing cancels, as do the powers.
template <class T>
T square_by(const GaussLegendre& rule, const std::vector<T>& a, const T& middle, const T& half) {
  const auto value = [&](const T& t) {
    T result = number<T>(0);
    for (std::size_t k = a.size(); k-- > 0;) result = result * t + a[k];
    return result;
  };
  T sum = number<T>(0);
  for (std::size_t k = 0; k < rule.places.size(); ++k) {
    for (const double side : {-1.0, 1.0}) {
      const T f = value(middle + number<T>(side * rule.places[k]) * half);
      sum = sum + number<T>(rule.weights[k]) * f * f;
    }
  }
  return half * sum;
}

template <class T>
T polynomial_square(const Piece<T>& piece, int order) {
  const std::vector<T> a = derived(piece.polynomial, order);
  const T middle = number<T>(0.5) * (piece.begin + piece.end) - piece.origin;
  const T half = number<T>(0.5) * (piece.end - piece.begin);
  // Of more than 30 coefficients, which no law of the catalogue has, not quite exact.
  return square_by(gauss_legendre(a.size() <= 10 ? 10 : 30), a, middle, half);
}

}  // namespace detail

template <class T>
Possible<T> mean_square(const Law<T>& law, int order) {
  if (detail::jumps_between(law, order - 1)) return Impossible{detail::kJumps};
  const auto square = [order](const auto& motion, const auto&) {
    const auto& f = order == 1 ? motion.v : order == 2 ? motion.a : motion.j;
    return f * f;
  };
  T sum = number<T>(0);
  std::vector<MeanStep<T>> steps;  // of the other pieces
  for (std::size_t p = 0; p < law.pieces().size(); ++p) {
    const Piece<T>& piece = law.pieces()[p];
    if (piece.harmonics.empty() && piece.curves.empty()) {
      sum = sum + detail::polynomial_square(piece, order);
    } else if constexpr (std::is_same_v<T, Interval>) {
      sum = sum + detail::piece_integral(piece, square);
    } else {
      detail::add_steps(piece, piece.begin, piece.end, p, steps);
    }
  }
  if constexpr (!std::is_same_v<T, Interval>) {
    if (!steps.empty()) sum = sum + detail::integral_over(law, steps, square);
  }
  return sum;
}

}  // namespace camlaw::problems
