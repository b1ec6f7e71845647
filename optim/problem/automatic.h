// SPDX-License-Identifier: MIT
#pragma once

#include <ceres/jet.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "optim/problem/function.h"

namespace camlaw::optim {

/// A plain number as the scalar of a formula, for where an operator will not do.
template <class T>
T constant(double c) {
  if constexpr (std::is_constructible_v<T, double>) {
    return T(c);
  } else {
    return T(constant<typename T::Scalar>(c));
  }
}

}  // namespace camlaw::optim

/// Lets formulas mix plain numbers with dual numbers over something else than plain numbers (dual
/// numbers of second order, of intervals), as ceres::Jet does for Jet<double, N>: 2.0 * u[0] + 1.0.
/// The operators stand in ceres, where they are found by the argument.
namespace ceres {

template <class T>
concept NotPlain = !std::is_arithmetic_v<T>;

template <NotPlain T, int N>
Jet<T, N> operator+(const Jet<T, N>& f, double c) {
  return f + camlaw::optim::constant<T>(c);
}
template <NotPlain T, int N>
Jet<T, N> operator+(double c, const Jet<T, N>& f) {
  return camlaw::optim::constant<T>(c) + f;
}
template <NotPlain T, int N>
Jet<T, N> operator-(const Jet<T, N>& f, double c) {
  return f - camlaw::optim::constant<T>(c);
}
template <NotPlain T, int N>
Jet<T, N> operator-(double c, const Jet<T, N>& f) {
  return camlaw::optim::constant<T>(c) - f;
}
template <NotPlain T, int N>
Jet<T, N> operator*(const Jet<T, N>& f, double c) {
  return f * camlaw::optim::constant<T>(c);
}
template <NotPlain T, int N>
Jet<T, N> operator*(double c, const Jet<T, N>& f) {
  return camlaw::optim::constant<T>(c) * f;
}
template <NotPlain T, int N>
Jet<T, N> operator/(const Jet<T, N>& f, double c) {
  return f / camlaw::optim::constant<T>(c);
}
template <NotPlain T, int N>
Jet<T, N> operator/(double c, const Jet<T, N>& f) {
  return camlaw::optim::constant<T>(c) / f;
}

}  // namespace ceres

/// Functions from formulas written once, generic in the scalar: derivatives come from dual numbers
/// (docs/optimisation.md, "Derivatives").
namespace camlaw::optim {

/// Directions carried by one pass; formulas with more inputs take several passes.
inline constexpr int kPassWidth = 4;
using PassDual = ceres::Jet<double, kPassWidth>;
using PassDual2 = ceres::Jet<PassDual, kPassWidth>;

/// Derivatives of a generic formula f(std::span<const T>) -> T in any number of inputs.
template <class F>
double automatic_gradient(const F& f, std::span<const double> u, std::span<double> g) {
  std::vector<PassDual> seeded(u.begin(), u.end());
  double value = 0;
  if (u.empty()) return f(u);
  for (std::size_t block = 0; block < u.size(); block += kPassWidth) {
    const std::size_t end = std::min(u.size(), block + kPassWidth);
    for (std::size_t i = block; i < end; ++i) seeded[i].v[static_cast<int>(i - block)] = 1;
    const PassDual result = f(std::span<const PassDual>(seeded));
    value = result.a;
    for (std::size_t i = block; i < end; ++i) {
      g[i] = result.v[static_cast<int>(i - block)];
      seeded[i] = PassDual(u[i]);
    }
  }
  return value;
}

template <class F>
double automatic_hessian(const F& f, std::span<const double> u, std::span<double> g,
                         std::span<double> h) {
  if (u.empty()) return f(u);
  double value = 0;
  std::vector<PassDual2> seeded(u.size());
  const auto in_block = [](std::size_t i, std::size_t block) {
    return i >= block && i < block + kPassWidth;
  };
  // Inner numbers carry the directions of one block, outer numbers those of another.
  for (std::size_t inner = 0; inner < u.size(); inner += kPassWidth) {
    for (std::size_t outer = inner; outer < u.size(); outer += kPassWidth) {
      for (std::size_t i = 0; i < u.size(); ++i) {
        seeded[i] = PassDual2(PassDual(u[i]));
        if (in_block(i, inner)) seeded[i].a.v[static_cast<int>(i - inner)] = 1;
        if (in_block(i, outer)) seeded[i].v[static_cast<int>(i - outer)] = PassDual(1.0);
      }
      const PassDual2 result = f(std::span<const PassDual2>(seeded));
      value = result.a.a;
      for (std::size_t i = outer; i < std::min(u.size(), outer + kPassWidth); ++i) {
        const PassDual& row = result.v[static_cast<int>(i - outer)];
        g[i] = row.a;
        for (std::size_t j = inner; j < std::min(u.size(), inner + kPassWidth); ++j) {
          if (j <= i) h[packed(i, j)] = row.v[static_cast<int>(j - inner)];
        }
      }
    }
  }
  return value;
}

/// Bounds that are numbers, or infinite ones.
template <class Enclosing>
Bounds bounds_of(const Enclosing& range) {
  if (!(range.lower() <= range.upper())) return {};
  return {range.lower(), range.upper()};
}

/// A kernel from a generic callable: template <class T> T f(std::span<const T> u). With an interval
/// type (anything with lower() and upper() that a double converts to) it encloses too. With a
/// series of intervals as well (c[0] the value, c[1] the slope; Directed::variable makes one) it
/// knows ranges over boxes: there f must decide nothing by the middle of an interval, but for where
/// it has no value.
template <class F, class Enclosing = void, class Directed = void>
class AutomaticKernel final : public Kernel {
 public:
  explicit AutomaticKernel(F f) : f_(std::move(f)) {}

  double value(std::span<const double> u) const override { return f_(u); }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    return automatic_gradient(f_, u, g);
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    return automatic_hessian(f_, u, g, h);
  }
  Bounds enclose(std::span<const double> u) const override {
    if constexpr (std::is_void_v<Enclosing>) {
      return Kernel::enclose(u);
    } else {
      const std::vector<Enclosing> points(u.begin(), u.end());
      const Enclosing result = f_(std::span<const Enclosing>(points));
      return {result.lower(), result.upper()};
    }
  }
  BoxRange range(std::span<const Bounds> box) const override {
    if constexpr (std::is_void_v<Directed>) {
      return Kernel::range(box);
    } else {
      BoxRange result = Kernel::range(box);
      const auto along = [&](std::size_t direction) {
        std::vector<Directed> points;
        for (std::size_t i = 0; i < box.size(); ++i) {
          points.push_back(Directed::variable(Enclosing(box[i].lower, box[i].upper),
                                              Enclosing(i == direction ? 1.0 : 0.0)));
        }
        return f_(std::span<const Directed>(points));
      };
      Directed over = along(0);
      result.value = bounds_of(over.c[0]);
      // Where the value is not known, as where the middle of the box has none, the slope of that
      // constant says nothing.
      const bool known = std::isfinite(result.value.lower) || std::isfinite(result.value.upper);
      for (std::size_t i = 0; known && i < box.size(); ++i) {
        if (i > 0) over = along(i);
        result.slopes[i] = bounds_of(over.c[1]);
      }
      return result;
    }
  }
  bool is_enclosed() const override { return !std::is_void_v<Enclosing>; }

 private:
  F f_;
};

/// A function of some variables from a formula written with auto:
///   function({0, 2}, [](const auto& u) { return u[0] * sin(u[1]); }, Shape::General)
/// u[k] is the variable inputs[k]. `function<Interval>(...)` also encloses, and
/// `function<Interval, Series<Interval, 2>>(...)` knows ranges over boxes.
template <class Enclosing = void, class Directed = void, class F>
Function function(std::vector<std::size_t> inputs, F f, Shape shape = Shape::General) {
  return Function(std::move(inputs),
                  std::make_shared<AutomaticKernel<F, Enclosing, Directed>>(std::move(f)), shape);
}

}  // namespace camlaw::optim
