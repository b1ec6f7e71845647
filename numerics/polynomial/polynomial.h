// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "numerics/scalar/scalar.h"

/// Polynomials as coefficient lists c[0] + c[1] t + ...
namespace camlaw {

/// Re-expands a polynomial about t: afterwards c holds the coefficients of p(t + h) in h (Horner).
template <class T>
void shift_polynomial(std::vector<T>& c, const T& t) {
  for (std::size_t k = 0; k + 1 < c.size(); ++k) {
    for (std::size_t i = c.size() - 1; i-- > k;) c[i] = c[i] + t * c[i + 1];
  }
}

/// The primitive that vanishes at 0.
template <class T>
std::vector<T> integrate(const std::vector<T>& c) {
  std::vector<T> result{number<T>(0)};
  for (std::size_t k = 0; k < c.size(); ++k) {
    result.push_back(c[k] / number<T>(static_cast<double>(k + 1)));
  }
  return result;
}

template <class T>
std::vector<T> multiply(const std::vector<T>& a, const std::vector<T>& b) {
  std::vector<T> product(a.size() + b.size() - 1, number<T>(0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) product[i + k] = product[i + k] + a[i] * b[k];
  }
  return product;
}

}  // namespace camlaw
