// SPDX-License-Identifier: MIT
#include "kinematics/peak_model.h"

namespace camlaw::detail {
namespace {

/// Entry k: 1 / k!.
template <class T>
const std::array<T, kTaylorOrder + 2>& inverse_factorials() {
  static const auto table = [] {
    std::array<T, kTaylorOrder + 2> result;
    double factorial = 1;
    for (std::size_t k = 0; k < result.size(); ++k) {
      if (k > 1) factorial *= static_cast<double>(k);  // exact up to 18!
      result[k] = T(1.0) / T(factorial);
    }
    return result;
  }();
  return table;
}

/// Degrees of a product beyond this go into the remainder.
constexpr std::size_t kProductDegree = 18;

/// Part of a polynomial's size that its last terms may hold and still go into the remainder.
constexpr double kNegligible = 1e-16;

template <class T>
double sum_of_sizes(const std::vector<T>& c, std::size_t from = 0) {
  T sum(0.0);
  for (std::size_t k = from; k < c.size(); ++k) sum = sum + T(size(c[k]));
  return upper(sum);
}

/// Moves last terms that do not matter into the remainder.
template <class T>
void drop_negligible(TaylorModel<T>& model) {
  const double limit = kNegligible * sum_of_sizes(model.c);
  while (model.c.size() > 1 && size(model.c.back()) <= limit) {
    model.remainder = upper(T(model.remainder) + T(size(model.c.back())));
    model.c.pop_back();
  }
}

}  // namespace

template <class T>
void BoxModels<T>::expand(const Piece<T>& piece, const PeakBox& box) {
  ready_.fill(false);
  has_ranges_ = !piece.is_data();
  if (has_ranges_) {
    expand_natural(piece, box);
  } else {
    expand_data(piece, box);
  }
  radius_powers_.assign(1, T(1.0));
  while (radius_powers_.size() < taylor_.size()) {
    radius_powers_.push_back(radius_powers_.back() * T(box.radius));
  }
}

template <class T>
void BoxModels<T>::expand_data(const Piece<T>& piece, const PeakBox& box) {
  const T t = T(box.middle) - piece.origin;
  taylor_.assign(piece.polynomial.begin(), piece.polynomial.end());
  shift_polynomial(taylor_, t);
  const std::size_t order = piece.harmonics.empty() ? 0 : kTaylorOrder;
  // s''' must exist, and degree 1 be seen, in every model.
  taylor_.resize(std::max({taylor_.size(), order + 1, std::size_t{5}}), T(0.0));
  remainders_.fill(0);
  const auto& inverse = inverse_factorials<T>();
  for (const auto& h : piece.harmonics) {
    std::array<T, kTaylorOrder + 1> d;
    d.fill(T(0.0));
    add_harmonic(h, t, d);
    for (std::size_t k = 0; k <= kTaylorOrder; ++k) taylor_[k] = taylor_[k] + d[k] * inverse[k];
    // |s^(m) - its Taylor polynomial| <= amplitude w^m (w r)^(n-m) / (n-m)!, n = order + 1
    const T frequency = T(size(h.frequency));
    T term = T(size(h.sine)) + T(size(h.cosine));
    for (std::size_t i = 0; i <= kTaylorOrder; ++i) term = term * frequency;
    for (std::size_t m = 0; m < remainders_.size(); ++m) {
      const std::size_t left = kTaylorOrder + 1 - m;
      T bound = term * inverse[left];
      for (std::size_t i = 0; i < left; ++i) bound = bound * T(box.radius);
      remainders_[m] = upper(T(remainders_[m]) + bound);
    }
  }
}

template <class T>
void BoxModels<T>::expand_natural(const Piece<T>& piece, const PeakBox& box) {
  const auto d = derivatives<kCurveOrders>(piece, T(box.middle));
  const auto range =
      derivatives<kCurveOrders, T, Interval, Interval>(piece, Interval(box.low, box.high));
  constexpr std::size_t kLast = kCurveOrders - 1;  // bounds the remainder
  taylor_.clear();
  const auto& inverse = inverse_factorials<T>();
  for (std::size_t k = 0; k < kLast; ++k) taylor_.push_back(d[k] * inverse[k]);
  for (std::size_t m = 0; m < remainders_.size(); ++m) {
    T bound = T(magnitude(range[kLast])) * inverse[kLast - m];
    for (std::size_t i = 0; i + m < kLast; ++i) bound = bound * T(box.radius);
    remainders_[m] = upper(bound);
    ranges_[m] = range[m];
  }
}

/// models_[order - 1] from the Taylor coefficients of s.
template <class T>
void BoxModels<T>::differentiate(std::size_t order) {
  TaylorModel<T>& model = models_[order - 1];
  model.c.resize(taylor_.size() - order);
  for (std::size_t i = 0; i < model.c.size(); ++i) {
    double falling = static_cast<double>(i + 1);
    for (std::size_t k = 2; k <= order; ++k) falling *= static_cast<double>(i + k);
    model.c[i] = T(falling) * taylor_[i + order] * radius_powers_[i];
  }
  model.remainder = remainders_[order];
  drop_negligible(model);
  const double spread = upper(T(sum_of_sizes(model.c, 1)) + T(model.remainder));
  model.range = Interval(lower(model.c[0]), upper(model.c[0])) + Interval(-spread, spread);
  if (has_ranges_) {
    // Where the remainder has no bound the sum is not a number, and the natural range is all there
    // is.
    const bool bounded = std::isfinite(spread);
    model.range = bounded ? boost::numeric::intersect(model.range, ranges_[order]) : ranges_[order];
  }
}

/// The product of the models of s' and s'', what lies beyond kProductDegree in the remainder.
template <class T>
void BoxModels<T>::multiply_moment() {
  const TaylorModel<T>& v = quantity(Quantity::Velocity);
  const TaylorModel<T>& a = quantity(Quantity::Acceleration);
  TaylorModel<T>& model = models_[static_cast<std::size_t>(Quantity::Moment)];
  const std::size_t full = v.c.size() + a.c.size() - 1;
  const bool exact = v.remainder == 0 && a.remainder == 0;
  const std::size_t kept = exact ? full : std::min(full, kProductDegree + 1);
  model.c.assign(kept, T(0.0));
  T beyond(0.0);
  for (std::size_t i = 0; i < v.c.size(); ++i) {
    for (std::size_t k = 0; k < a.c.size(); ++k) {
      if (i + k < kept) {
        model.c[i + k] = model.c[i + k] + v.c[i] * a.c[k];
      } else {
        beyond = beyond + T(size(v.c[i]) * size(a.c[k]) * (1 + 1e-15));
      }
    }
  }
  const T rv(v.remainder), ra(a.remainder);
  model.remainder = upper(T(sum_of_sizes(v.c)) * ra + T(sum_of_sizes(a.c)) * rv + rv * ra + beyond);
  drop_negligible(model);
  model.range = range(Quantity::Moment);
}

template <class T>
Interval BoxModels<T>::range(Quantity q) {
  if (q != Quantity::Moment) return quantity(q).range;
  return quantity(Quantity::Velocity).range * quantity(Quantity::Acceleration).range;
}

template <class T>
const TaylorModel<T>& BoxModels<T>::quantity(Quantity q) {
  const auto i = static_cast<std::size_t>(q);
  if (!ready_[i]) {
    ready_[i] = true;
    if (q == Quantity::Moment) {
      multiply_moment();
    } else {
      differentiate(i + 1);
    }
  }
  return models_[i];
}

template class BoxModels<double>;
template class BoxModels<Interval>;

}  // namespace camlaw::detail
