// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

#include "optim/problem/function.h"
#include "problems/mechanism/cycle_mean.h"
#include "problems/mechanism/law_binding.h"

/// Mean squares of a law's derivatives over x from 0 to 1 (docs/theory.md, "Mean squares").
namespace camlaw::problems {

/// int_0^1 s^(order)(x)^2 dx, order 1 to 3: exact for pieces that are polynomials, and enclosed
/// where T is Interval; else by quadrature as of cycle_mean. Throws std::invalid_argument where
/// s^(order - 1) jumps inside the stretch: then it is infinite.
template <class T>
T mean_square(const Law<T>& law, int order);

/// The same over the variables of a law that is linear in them: a quadratic form, put together once
/// from the pieces that each variable moves. Value, slopes and second derivatives cost as much as
/// the matrix has entries that are not 0. Encloses as `exact` does.
std::shared_ptr<const optim::Kernel> mean_square_kernel(std::shared_ptr<const LawBinding> law,
                                                        int order,
                                                        std::shared_ptr<const optim::Kernel> exact);

// ---------------------------------------------------------------------------------------------

namespace detail {

/// Throws where a derivative jumps between pieces by more than rounding.
template <class T>
void check_no_jump(const Law<T>& law, int order) {
  constexpr double kRounding = 1e-7;
  const auto& pieces = law.pieces();
  const auto k = static_cast<std::size_t>(order);
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    const double left = value_of(derivatives<4>(pieces[i], pieces[i].end)[k]);
    const double right = value_of(derivatives<4>(pieces[i + 1], pieces[i].end)[k]);
    if (!(std::abs(left - right) <= kRounding * (1 + std::abs(left) + std::abs(right)))) {
      throw std::invalid_argument("a mean square is infinite: the derivative below it jumps");
    }
  }
}

/// The polynomial's derivative about the beginning of the piece.
template <class T>
std::vector<T> derivative_at_begin(const Piece<T>& piece, int order) {
  std::vector<T> a = piece.polynomial;
  for (int n = 0; n < order; ++n) {
    for (std::size_t k = 1; k < a.size(); ++k) a[k - 1] = number<T>(static_cast<double>(k)) * a[k];
    if (!a.empty()) a.pop_back();
  }
  const T start = piece.begin - piece.origin;
  if (is_number(start, 0)) return a;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = a.size() - 1; k-- > i;) a[k] = a[k] + start * a[k + 1];
  }
  return a;
}

template <class T>
T polynomial_square(const Piece<T>& piece, int order) {
  const std::vector<T> a = derivative_at_begin(piece, order);
  const T d = piece.end - piece.begin;
  T sum = number<T>(0), power = d;
  for (std::size_t n = 0; n + 1 < 2 * a.size(); ++n) {
    T product = number<T>(0);
    for (std::size_t i = n + 1 > a.size() ? n + 1 - a.size() : 0; i <= std::min(n, a.size() - 1);
         ++i) {
      product = product + a[i] * a[n - i];
    }
    sum = sum + product * power / number<T>(static_cast<double>(n + 1));
    power = power * d;
  }
  return sum;
}

}  // namespace detail

template <class T>
T mean_square(const Law<T>& law, int order) {
  detail::check_no_jump(law, order - 1);
  T sum = number<T>(0);
  for (const Piece<T>& piece : law.pieces()) {
    if (piece.harmonics.empty() && piece.curves.empty()) {
      sum = sum + detail::polynomial_square(piece, order);
      continue;
    }
    const auto square = [order](const auto& motion, const auto&) {
      const auto& f = order == 1 ? motion.v : order == 2 ? motion.a : motion.j;
      return f * f;
    };
    sum = sum + detail::piece_integral(piece, square);
  }
  return sum;
}

}  // namespace camlaw::problems
