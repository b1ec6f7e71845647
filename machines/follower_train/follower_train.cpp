// SPDX-License-Identifier: MIT
#include "machines/follower_train/follower_train.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "numerics/scalar/dual.h"

namespace camlaw {
namespace {

/// A complex number of any scalar.
template <class T>
struct Complex {
  T re, im;
  friend Complex operator+(const Complex& a, const Complex& b) {
    return {a.re + b.re, a.im + b.im};
  }
  friend Complex operator-(const Complex& a, const Complex& b) {
    return {a.re - b.re, a.im - b.im};
  }
  friend Complex operator*(const Complex& a, const Complex& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  friend Complex operator*(const T& a, const Complex& b) { return {a * b.re, a * b.im}; }
  friend Complex operator/(const Complex& a, const Complex& b) {
    const T square = b.re * b.re + b.im * b.im;
    return {(a.re * b.re + a.im * b.im) / square, (a.im * b.re - a.re * b.im) / square};
  }
};

template <class T>
Complex<T> real(double x) {
  return {number<T>(x), number<T>(0)};
}

template <class T>
Complex<T> exponential(const Complex<T>& z) {
  using std::cos;
  using std::exp;
  using std::sin;
  const T length = exp(z.re);
  return {length * cos(z.im), length * sin(z.im)};
}

template <class T>
double size_of(const Complex<T>& z) {
  return std::hypot(value_of(z.re), value_of(z.im));
}

/// A sum with what is left out of it, no more than twice the last term: nothing in plain numbers.
template <class T>
Complex<T> with_remainder(const Complex<T>& sum, const Complex<T>& last) {
  if constexpr (std::is_same_v<T, Interval>) {
    const double most = 4 * std::max(magnitude(last.re), magnitude(last.im));
    const Interval rest(-most, most);
    return {sum.re + rest, sum.im + rest};
  } else {
    (void)last;
    return sum;
  }
}

/// phi_k(z) = integral of exp(z (1 - u)) u^(k-1) / (k-1)! du over [0, 1], phi_0 = exp; k from 0 to
/// `count` - 1. By recurrence where z is large beside k, else by the series sum z^j / (j + k)!.
template <class T>
std::vector<Complex<T>> phi(const Complex<T>& z, std::size_t count) {
  constexpr double kSeries = 8;
  const double size = size_of(z);
  std::vector<Complex<T>> result{exponential(z)};
  double factorial = 1;  // k!
  const auto over = [](double divisor) { return Complex<T>{ratio<T>(1, divisor), number<T>(0)}; };
  for (std::size_t k = 1; k < count; ++k) {
    const auto n = static_cast<double>(k);
    if (size > std::max(kSeries, n)) {
      result.push_back((result.back() - over(factorial)) / z);
      factorial *= n;
      continue;
    }
    factorial *= n;
    Complex<T> term = over(factorial), sum = term;
    for (int j = 1; j < 200; ++j) {
      term = ratio<T>(1, n + j) * (term * z);
      sum = sum + term;
      // The terms behind fall at least by half each from there on.
      if (n + j > 2 * size && size_of(term) <= 1e-18 * size_of(sum)) break;
    }
    result.push_back(with_remainder(sum, term));
  }
  return result;
}

/// Integral of exp(lambda (d - u)) f(u) du over [0, d], where f is the second derivative of a piece
/// at t = begin - origin + u.
template <class T>
Complex<T> driven(const Piece<T>& piece, const T& begin, const T& d, const Complex<T>& lambda) {
  Complex<T> sum = real<T>(0);
  const T start = begin - piece.origin;
  // The polynomial's second derivative about the beginning: a shift by Horner's scheme.
  std::vector<T> a;
  for (std::size_t k = 2; k < piece.polynomial.size(); ++k) {
    a.push_back(number<T>(static_cast<double>(k * (k - 1))) * piece.polynomial[k]);
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = a.size() - 1; k-- > i;) a[k] = a[k] + start * a[k + 1];
  }
  if (!a.empty()) {
    const auto phis = phi(d * lambda, a.size() + 1);
    T power = d;
    double factorial = 1;
    for (std::size_t k = 0; k < a.size(); ++k) {
      sum = sum + (number<T>(factorial) * a[k] * power) * phis[k + 1];
      power = power * d;
      factorial *= static_cast<double>(k + 1);
    }
  }
  for (const auto& h : piece.harmonics) {
    // -w^2 (sine sin + cosine cos)(start + u): the real part of c exp(i w u).
    using std::cos;
    using std::sin;
    const T w = h.frequency, minus = -(w * w);
    const T s = sin(w * start), c = cos(w * start);
    const Complex<T> up{minus * (h.sine * s + h.cosine * c),
                        -(minus * (h.sine * c - h.cosine * s))};
    const Complex<T> down{up.re, -up.im};
    // Half of c exp(i w u) and half of its conjugate: integral exp(mu u) = d phi_1(mu d).
    const Complex<T> carrier = exponential(d * lambda);
    for (const auto& [amplitude, frequency] : {std::pair{up, w}, std::pair{down, -w}}) {
      const Complex<T> mu{-lambda.re, frequency - lambda.im};
      sum = sum + (number<T>(0.5) * d) * (carrier * (amplitude * phi(d * mu, 2)[1]));
    }
  }
  return sum;
}

/// Whether the velocity jumps up to x, from rest before and to rest behind: the closed form knows
/// no pulse of the acceleration.
template <class T>
bool has_jump(const Law<T>& law, double x) {
  constexpr double kLevel = 1e-9;
  const auto velocity = [](const Piece<T>& piece, const T& at) {
    return value_of(derivatives<2>(piece, at)[1]);
  };
  double before = 0;
  for (const Piece<T>& piece : law.pieces()) {
    if (std::abs(velocity(piece, piece.begin) - before) > kLevel) break;
    before = velocity(piece, piece.end);
    if (value_of(piece.end) >= 1 && x >= 1 && std::abs(before) > kLevel) break;
    if (value_of(piece.end) >= std::min(x, 1.0)) return false;
  }
  return true;
}

}  // namespace

template <class T>
Possible<TrainState<T>> FollowerTrain<T>::at(const Law<T>& law, double x,
                                             TrainState<T> begin) const {
  using std::sqrt;
  if (!law.is_data()) {
    return Impossible{"elastic train: the law does not consist of polynomials and harmonics"};
  }
  const double tau = value_of(period_ratio), zeta = value_of(damping_ratio);
  if (!(tau > 0) || !(zeta >= 0 && zeta < 1)) {
    return Impossible{
        "elastic train: the period ratio must be above 0, the damping ratio from 0 to below 1"};
  }
  if (has_jump(law, x)) return Impossible{"elastic train: the velocity of the law jumps"};
  const T W = number<T>(2) * pi<T>() * period_ratio;
  const T damped = W * sqrt(number<T>(1) - damping_ratio * damping_ratio);
  const Complex<T> lambda{-(damping_ratio * W), damped};
  // v = z' - conj(lambda) z obeys v' = lambda v - s'', and its imaginary part is damped z.
  Complex<T> v{begin.rate - lambda.re * begin.z, damped * begin.z};
  for (const Piece<T>& piece : law.pieces()) {
    if (value_of(piece.begin) >= x) break;
    const T end = value_of(piece.end) <= x ? piece.end : number<T>(x);
    const T d = end - piece.begin;
    v = exponential(d * lambda) * v - driven(piece, piece.begin, d, lambda);
  }
  const T z = v.im / damped;
  return TrainState<T>{z, v.re + lambda.re * z};
}

template <class T>
Possible<TrainState<T>> FollowerTrain<T>::after(const Law<T>& law, TrainState<T> begin) const {
  return at(law, 1, begin);
}

template <class T>
T FollowerTrain<T>::amplitude(const TrainState<T>& state) const {
  using std::sqrt;
  const T W = number<T>(2) * pi<T>() * period_ratio;
  const T damped = W * sqrt(number<T>(1) - damping_ratio * damping_ratio);
  const T swing = (state.rate + damping_ratio * W * state.z) / damped;
  return sqrt(state.z * state.z + swing * swing);
}

template <class T>
T FollowerTrain<T>::residual_acceleration(const Law<T>& law) const {
  const T W = number<T>(2) * pi<T>() * period_ratio;
  return W * W * amplitude(after(law).value());
}

template struct FollowerTrain<double>;
template struct FollowerTrain<Dual>;
template struct FollowerTrain<Dual2>;
template struct FollowerTrain<Interval>;

}  // namespace camlaw
