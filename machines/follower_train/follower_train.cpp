// SPDX-License-Identifier: MIT
#include "machines/follower_train/follower_train.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "numerics/scalar/by_side.h"
#include "numerics/scalar/dual.h"
#include "numerics/scalar/series.h"

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

/// exp(i angle).
template <class T>
Complex<T> rotation(const T& angle) {
  using std::cos;
  using std::sin;
  return {cos(angle), sin(angle)};
}

template <class T>
double size_of(const Complex<T>& z) {
  return std::hypot(value_of(z.re), value_of(z.im));
}

/// The square of the size, for where that is not too small: much quicker.
template <class T>
double square_of(const Complex<T>& z) {
  const double re = value_of(z.re), im = value_of(z.im);
  return re * re + im * im;
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

/// At |z| = 8 the series cancels to 1/370 of its largest term; the recurrence hardly cancels from
/// there on.
constexpr double kSeries = 8;

/// phi_k(z) = integral of exp(z (1 - u)) u^(k-1) / (k-1)! du over [0, 1], phi_0 = exp; k from 0 to
/// `count` - 1. By recurrence where z is large beside k, else by the series sum z^j / (j + k)!.
template <class T>
std::vector<Complex<T>> phi(const Complex<T>& z, std::size_t count) {
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
      if (n + j > 2 * size && square_of(term) <= 1e-36 * square_of(sum)) break;
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
      // Far from resonance the integral as it stands: exp(-lambda d) may be too large a number.
      const Complex<T> share = size_of(d * mu) > kSeries
                                   ? (rotation(T(frequency * d)) - carrier) / mu
                                   : d * (carrier * phi(d * mu, 2)[1]);
      sum = sum + number<T>(0.5) * (amplitude * share);
    }
  }
  return sum;
}

template <class T>
double velocity(const Piece<T>& piece, const T& at) {
  if constexpr (std::is_same_v<T, double>) return derivatives<2>(piece, at)[1];
  return velocity(piece_as<double>(piece), value_of(at));
}

/// Whether the velocity jumps up to x, from what it is before, and to rest behind where that is
/// asked: the closed form knows no pulse of the acceleration.
template <class T>
bool has_jump(const Law<T>& law, double x, double before, bool rests_behind) {
  // Velocities of pieces that join smoothly differ by rounding of the mean one, 1.
  constexpr double kLevel = 1e-9;
  for (const Piece<T>& piece : law.pieces()) {
    if (std::abs(velocity(piece, piece.begin) - before) > kLevel) break;
    before = velocity(piece, piece.end);
    if (rests_behind && value_of(piece.end) >= 1 && x >= 1 && std::abs(before) > kLevel) break;
    if (value_of(piece.end) >= std::min(x, 1.0)) return false;
  }
  return true;
}

/// Why a train has no motion along a law, where it has none.
template <class T>
std::optional<Impossible> fault_of(const FollowerTrain<T>& train, const Law<T>& law) {
  if (!law.is_data()) {
    return Impossible{"elastic train: the law does not consist of polynomials and harmonics"};
  }
  const double tau = value_of(train.period_ratio), zeta = value_of(train.damping_ratio);
  if (!(tau > 0)) {
    return Impossible{
        "elastic train: the period ratio must be above 0, but the train has no stiffness"};
  }
  if (std::isinf(tau)) {
    return Impossible{
        "elastic train: the period ratio must be a number, but the train's end has no mass"};
  }
  if (zeta >= 0 && zeta < 1) return {};
  return Impossible{"elastic train: the damping ratio must be from 0 to below 1"};
}

Impossible jump() { return {"elastic train: the velocity of the law jumps"}; }

/// Whether a piece is a dwell at all values: one that a program rests in has its level alone, and a
/// move that happens to stay where it is has coefficients of 0.
template <class T>
bool rests(const Piece<T>& piece) {
  return piece.polynomial.size() <= 1 && piece.harmonics.empty() && piece.curves.empty();
}

/// The larger one; of intervals, what holds the larger of any two numbers in them.
template <class T>
T larger(const T& a, const T& b) {
  if constexpr (std::is_same_v<T, Interval>) {
    return {std::max(a.lower(), b.lower()), std::max(a.upper(), b.upper())};
  } else {
    return value_of(a) < value_of(b) ? b : a;
  }
}

}  // namespace

template <class T>
TrainMotion<T>::TrainMotion(const FollowerTrain<T>& train, const Law<T>& law)
    : train_(train), law_(&law) {
  using std::sqrt;
  const T W = number<T>(2) * pi<T>() * train.period_ratio;
  decay_ = train.damping_ratio * W;
  damped_ = W * sqrt(number<T>(1) - train.damping_ratio * train.damping_ratio);
}

/// v itself turns with the damped frequency. What is added up is e^(-i W_d x) v, which does not:
/// intervals would widen by each turn of the box that they are.
template <class T>
void TrainMotion<T>::go(const TrainState<T>& begin, double until) {
  using std::exp;
  const Complex<T> lambda{-decay_, damped_};
  Complex<T> held{begin.rate + decay_ * begin.z, damped_ * begin.z};
  v_ = {{held.re, held.im}};
  for (const Piece<T>& piece : law_->pieces()) {
    if (value_of(piece.begin) >= until) break;
    const T end = value_of(piece.end) <= until ? piece.end : number<T>(until);
    const T d = end - piece.begin;
    held = exp(-(decay_ * d)) * held -
           rotation(T(-(damped_ * end))) * driven(piece, piece.begin, d, lambda);
    const Complex<T> v = rotation(T(damped_ * end)) * held;
    v_.push_back({v.re, v.im});
  }
}

template <class T>
Possible<TrainMotion<T>> TrainMotion<T>::from(const FollowerTrain<T>& train, const Law<T>& law,
                                              const TrainState<T>& begin, double until) {
  if (auto fault = fault_of(train, law)) return std::move(*fault);
  if (has_jump(law, until, 0, true)) return jump();
  TrainMotion motion(train, law);
  motion.go(begin, until);
  return motion;
}

template <class T>
Possible<TrainMotion<T>> TrainMotion<T>::periodic(const FollowerTrain<T>& train,
                                                  const Law<T>& law) {
  constexpr double kResonance = 1e-9;  // of what a cycle leaves of a vibration, against all
  if (auto fault = fault_of(train, law)) return std::move(*fault);
  const Piece<T>& final_piece = law.pieces().back();
  if (has_jump(law, 1, velocity(final_piece, final_piece.end), false)) return jump();
  TrainMotion motion(train, law);
  motion.go({number<T>(0), number<T>(0)}, 1);
  const Complex<T> lambda{-motion.decay_, motion.damped_};
  const Complex<T> lost = real<T>(1) - exponential(lambda);
  if (!(size_of(lost) > kResonance)) {
    return Impossible{
        "elastic train: without damping there is no steady state where the cycle lasts a whole "
        "number of natural periods"};
  }
  const Complex<T> begin = Complex<T>{motion.v_.back()[0], motion.v_.back()[1]} / lost;
  for (std::size_t i = 0; i < motion.v_.size(); ++i) {
    const bool is_end = i == law.pieces().size();
    const T x = is_end ? number<T>(1) : law.pieces()[i].begin;
    const Complex<T> left = exponential(x * lambda) * begin;
    motion.v_[i] = {motion.v_[i][0] + left.re, motion.v_[i][1] + left.im};
  }
  return motion;
}

template <class T>
TrainState<T> TrainMotion<T>::state(const V& v) const {
  const T z = v[1] / damped_;
  return {z, v[0] - decay_ * z};
}

template <class T>
typename TrainMotion<T>::V TrainMotion<T>::within(double x) const {
  const std::size_t i = law_->piece_at(x, Side::Left);
  const Piece<T>& piece = law_->pieces()[i];
  if (value_of(piece.end) <= x) return v_[i + 1];
  const Complex<T> lambda{-decay_, damped_};
  const T d = number<T>(x) - piece.begin;
  const Complex<T> v = exponential(d * lambda) * Complex<T>{v_[i][0], v_[i][1]} -
                       driven(piece, piece.begin, d, lambda);
  return {v.re, v.im};
}

template <class T>
TrainState<T> TrainMotion<T>::at(double x) const {
  return state(within(x));
}

template <class T>
TrainState<T> TrainMotion<T>::around(double middle, double radius,
                                     double peak) const requires std::is_same_v<T, Interval> {
  // (U4); backwards from the middle a free vibration grows.
  const V v = within(middle);
  const Interval r(radius), one(1.0);
  const Interval most =
      (Interval(magnitude(v[0])) + Interval(magnitude(v[1])) + r * Interval(peak)) *
      exp(r * decay_);
  const Interval z = most / damped_, rate = most * (one + decay_ / damped_);
  return {Interval(-z.upper(), z.upper()), Interval(-rate.upper(), rate.upper())};
}

template <class T>
Possible<T> TrainMotion<T>::swing_at_rest() const {
  std::optional<T> greatest;
  for (std::size_t i = 0; i < law_->pieces().size(); ++i) {
    if (!rests(law_->pieces()[i])) continue;
    const auto& [re, im] = v_[i];
    const T square = re * re + im * im;
    greatest = greatest ? larger(*greatest, square) : square;
  }
  if (!greatest) return Impossible{"elastic train: the motion never rests"};
  return T(root_of_squares(*greatest) / damped_);
}

template <class T>
Possible<TrainState<T>> FollowerTrain<T>::at(const Law<T>& law, double x,
                                             TrainState<T> begin) const {
  const auto motion = TrainMotion<T>::from(*this, law, begin, x);
  if (!motion) return motion.reason();
  return motion->last();
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
  return root_of_squares(T(state.z * state.z + swing * swing));
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
template class TrainMotion<double>;
template class TrainMotion<Dual>;
template class TrainMotion<Dual2>;
template class TrainMotion<Interval>;

// By what a train's lambda is moved (StandingTurn).
template <std::size_t N>
using Moved = TrainMotion<Series<double, N>>;
template Possible<Moved<2>> Moved<2>::periodic(const FollowerTrain<Series<double, 2>>&,
                                               const Law<Series<double, 2>>&);
template TrainState<Series<double, 2>> Moved<2>::at(double) const;
template Possible<Moved<3>> Moved<3>::periodic(const FollowerTrain<Series<double, 3>>&,
                                               const Law<Series<double, 3>>&);
template TrainState<Series<double, 3>> Moved<3>::at(double) const;

}  // namespace camlaw
