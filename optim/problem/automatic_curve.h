// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numeric>

#include "optim/problem/automatic.h"
#include "optim/problem/curve.h"

/// Curves from formulas written once, generic in the scalar.
namespace camlaw::optim {

/// A curve f(u, angle) from a generic callable: template <class T> T f(std::span<const T> u, T
/// angle), smooth over [from, to]. With an interval type it encloses too.
template <class F, class Enclosing = void>
class AutomaticCurve final : public Curve {
 public:
  AutomaticCurve(std::vector<std::size_t> inputs, double from, double to, F f, Shape shape)
      : inputs_(std::move(inputs)), from_(from), to_(to), f_(std::move(f)), shape_(shape) {}

  Function at(Place place) const override {
    return function<Enclosing>(
        inputs_,
        [f = f_, angle = place.angle](const auto& u) {
          using T = std::remove_cvref_t<decltype(u[0])>;
          return f(u, constant<T>(angle));
        },
        shape_);
  }

  std::vector<double> slope_gradient(Place place, Design x) const override {
    const auto slope = [&](const auto& u) {
      using T = std::remove_cvref_t<decltype(u[0])>;
      using Slope = ceres::Jet<T, 1>;
      std::vector<Slope> points;
      for (const T& value : u) points.push_back(Slope(value));
      return f_(std::span<const Slope>(points), Slope(constant<T>(place.angle), 0)).v[0];
    };
    std::vector<double> u, g(inputs_.size()), result(x.size(), 0.0);
    for (const std::size_t input : inputs_) u.push_back(x[input]);
    if (!u.empty()) automatic_gradient(slope, std::span<const double>(u), g);
    for (std::size_t i = 0; i < g.size(); ++i) result[inputs_[i]] = g[i];
    return result;
  }

  std::unique_ptr<Trace> trace(Design x) const override {
    std::vector<double> u;
    for (const std::size_t input : inputs_) u.push_back(x[input]);
    return std::make_unique<AutomaticTrace>(*this, std::move(u));
  }
  Shape shape() const override { return shape_; }

 private:
  class AutomaticTrace final : public Trace {
   public:
    AutomaticTrace(const AutomaticCurve& curve, std::vector<double> u)
        : f_(curve.f_), from_(curve.from_), to_(curve.to_), u_(std::move(u)) {}

    std::vector<double> breaks() const override { return {from_, to_}; }
    std::array<double, 3> at(Place place) const override {
      using First = ceres::Jet<double, 1>;
      using Second = ceres::Jet<First, 1>;
      std::vector<Second> points;
      for (const double value : u_) points.push_back(Second(First(value)));
      Second angle(First(place.angle, 0), 0);
      const Second result = f_(std::span<const Second>(points), angle);
      return {result.a.a, result.a.v[0], result.v[0].v[0]};
    }
    Bounds enclose(double from, double to) const override {
      if constexpr (std::is_void_v<Enclosing>) {
        return {};
      } else {
        // Over the whole stretch, and by the slope's bounds about the middle.
        using Slope = ceres::Jet<Enclosing, 1>;
        const Enclosing box(from, to), middle(std::midpoint(from, to));
        std::vector<Slope> points;
        std::vector<Enclosing> plain;
        for (const double value : u_) {
          points.push_back(Slope(Enclosing(value)));
          plain.push_back(Enclosing(value));
        }
        const Slope over = f_(std::span<const Slope>(points), Slope(box, 0));
        const Enclosing centre = f_(std::span<const Enclosing>(plain), middle);
        const Enclosing mean = centre + over.v[0] * (box - middle);
        const auto greater = [](double a, double b) { return a > b || b != b ? a : b; };
        return {greater(over.a.lower(), mean.lower()), -greater(-over.a.upper(), -mean.upper())};
      }
    }

   private:
    F f_;
    double from_, to_;
    std::vector<double> u_;
  };

  std::vector<std::size_t> inputs_;
  double from_, to_;
  F f_;
  Shape shape_;
};

/// curve({0, 1}, 0, 360, [](const auto& u, const auto& angle) { return u[0] * cos(angle) + u[1]; })
template <class Enclosing = void, class F>
std::shared_ptr<const Curve> curve(std::vector<std::size_t> inputs, double from, double to, F f,
                                   Shape shape = Shape::General) {
  return std::make_shared<AutomaticCurve<F, Enclosing>>(std::move(inputs), from, to, std::move(f),
                                                        shape);
}

}  // namespace camlaw::optim
