// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "kinematics/scalar.h"

namespace camlaw {

/// A disc spring without contact flats (Almen and Laszlo; DIN 2092, EN 16984; docs/theory.md, "Disc
/// springs"). Fields in SI units. Valid for deflections from 0 to the cone height h0.
template <class T>
struct DiscSpring {
  T outer_diameter;                       ///< D_e, m
  T inner_diameter;                       ///< D_i, m
  T thickness;                            ///< t, m
  T cone_height;                          ///< h_0 = l_0 - t, m, the deflection to flat
  T youngs_modulus = number<T>(2.06e11);  ///< E, Pa
  T poisson_ratio = number<T>(0.3);       ///< mu

  T ratio() const { return outer_diameter / inner_diameter; }
  bool is_possible() const {
    return value_of(inner_diameter) > 0 && value_of(outer_diameter) > value_of(inner_diameter) &&
           value_of(thickness) > 0 && value_of(cone_height) >= 0;
  }

  /// (W1) K_1 = ((delta - 1) / delta)^2 / (pi ((delta + 1) / (delta - 1) - 2 / ln delta)).
  T k1() const {
    using std::log;
    const T one = number<T>(1), two = number<T>(2), d = ratio();
    const T share = (d - one) / d;
    return share * share / (pi<T>() * ((d + one) / (d - one) - two / log(d)));
  }
  /// (W2) K_2 = 6 / (pi ln delta) ((delta - 1) / ln delta - 1), K_3 = 3 (delta - 1) / (pi ln
  /// delta).
  T k2() const {
    using std::log;
    const T one = number<T>(1), d = ratio();
    return number<T>(6) / (pi<T>() * log(d)) * ((d - one) / log(d) - one);
  }
  T k3() const {
    using std::log;
    return number<T>(3) * (ratio() - number<T>(1)) / (pi<T>() * log(ratio()));
  }

  /// (W3) Force, N, at the deflection s, m:
  /// F = 4 E t^4 / ((1 - mu^2) K_1 D_e^2) (s/t) ((h_0/t - s/t) (h_0/t - s/(2 t)) + 1).
  template <class X>
  X force(const X& s) const {
    const X x = s / thickness;
    const T h = cone_height / thickness;
    const T cube = thickness * thickness * thickness;
    return scale() * cube * thickness * (x * ((h - x) * (h - number<T>(0.5) * x) + number<T>(1)));
  }
  /// (W4) Rate dF/ds, N/m: 4 E t^3 / ((1 - mu^2) K_1 D_e^2) ((h_0/t)^2 - 3 (h_0/t)(s/t) +
  /// 3/2 (s/t)^2 + 1).
  template <class X>
  X rate(const X& s) const {
    const X x = s / thickness;
    const T h = cone_height / thickness;
    const T cube = thickness * thickness * thickness;
    return scale() * cube *
           (number<T>(1.5) * (x * x) - number<T>(3) * h * x + (h * h + number<T>(1)));
  }
  /// (W5) Work stored up to s, J: the integral of the force.
  template <class X>
  X work(const X& s) const {
    const X x = s / thickness;
    const T h = cone_height / thickness;
    const T square = thickness * thickness, fifth = square * square * thickness;
    const X inner = number<T>(0.5) * (h * h + number<T>(1)) * (x * x) -
                    number<T>(0.5) * h * (x * x * x) + number<T>(0.125) * (x * x * x * x);
    return scale() * fifth * inner;
  }
  /// (W6) Stress at the edge I (inner, upper; where a static load is judged: its negative is
  /// compression), Pa: sigma_I = - scale t^2 (s/t) (K_2 (h_0/t - s/(2 t)) + K_3).
  template <class X>
  X stress_upper_inner(const X& s) const {
    const X x = s / thickness;
    const T h = cone_height / thickness;
    return -(scale() * thickness * thickness * (x * (k2() * (h - number<T>(0.5) * x) + k3())));
  }

 private:
  /// 4 E / ((1 - mu^2) K_1 D_e^2).
  T scale() const {
    const T one = number<T>(1);
    return number<T>(4) * youngs_modulus /
           ((one - poisson_ratio * poisson_ratio) * k1() * outer_diameter * outer_diameter);
  }
};

/// Disc springs in a stack: `parallel` of them nested, `series` such packets in a row, without
/// friction.
template <class T>
struct DiscSpringStack {
  DiscSpring<T> spring;
  T parallel = number<T>(1);
  T series = number<T>(1);

  template <class X>
  X force(const X& deflection) const {
    return parallel * spring.force(deflection / series);
  }
  template <class X>
  X rate(const X& deflection) const {
    return parallel / series * spring.rate(deflection / series);
  }
};

}  // namespace camlaw
