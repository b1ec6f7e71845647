// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "machines/model/possibility.h"
#include "numerics/scalar/scalar.h"

namespace camlaw {

/// A disc spring, with or without contact flats (Almen and Laszlo; DIN 2092, EN 16984;
/// docs/theory.md, "Disc springs"). Fields in SI units. Valid for deflections from 0 to flat.
/// Edges of the section: I upper inner, II lower inner, III lower outer, IV upper outer; the force
/// acts on I and III. OM is the middle of the upper side. Tension is positive.
template <class T>
struct DiscSpring {
  T outer_diameter;                       ///< D_e, m
  T inner_diameter;                       ///< D_i, m
  T thickness;                            ///< t, m
  T cone_height;                          ///< h_0 = l_0 - t, m; l_0 is the free height
  T youngs_modulus = number<T>(2.06e11);  ///< E, Pa
  T poisson_ratio = number<T>(0.3);       ///< mu
  /// t'/t: 1 without flats; with flats the disc is thinner, at the same l_0.
  T thickness_ratio = number<T>(1);

  T ratio() const { return outer_diameter / inner_diameter; }
  /// t'.
  T reduced_thickness() const { return thickness * thickness_ratio; }
  /// h_0' = l_0 - t', the deflection to flat.
  T flat_deflection() const { return cone_height + thickness * (number<T>(1) - thickness_ratio); }
  auto conditions() const {
    return std::to_array<Condition<T>>(
        {{inner_diameter, "inner_diameter must be above 0"},
         {outer_diameter - inner_diameter, "outer_diameter must be above inner_diameter"},
         {thickness, "thickness must be above 0"},
         {cone_height, "cone_height must be 0 or above", true},
         {thickness_ratio, "thickness_ratio must be above 0"},
         {flat_deflection(), "cone_height + thickness * (1 - thickness_ratio) must be 0 or above",
          true}});
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
  /// (W13) K_4^2, 1 without flats: a disc with flats has at 3/4 of h_0 the force that one of the
  /// thickness t without flats has.
  T k4_squared() const {
    using std::sqrt;
    const T one = number<T>(1), r = thickness_ratio, h = cone_height / thickness;
    if (is_number(r, 1)) return one;
    const T a = (number<T>(0.25) * h + one - r) * (number<T>(0.625) * h + one - r) / (r * r);
    const T c = (number<T>(0.15625) * h * h + one) / (r * r * r);
    return number<T>(2) * c / (one + sqrt(one + number<T>(4) * a * c));
  }

  /// (W3), (W14) Force, N, at the deflection s, m: with t', h_0' for t, h_0
  /// F = 4 E t^4 / ((1 - mu^2) K_1 D_e^2) K_4^2 (s/t) (K_4^2 (h_0/t - s/t) (h_0/t - s/(2 t)) + 1).
  template <class X>
  X force(const X& s) const {
    const T t = reduced_thickness(), h = flat_deflection() / t, k = k4_squared();
    const X x = s / t;
    return scale() * integer_power(t, 4) * k *
           (x * (k * ((h - x) * (h - number<T>(0.5) * x)) + number<T>(1)));
  }
  /// (W4) Rate dF/ds, N/m: 4 E t^3 / ((1 - mu^2) K_1 D_e^2) K_4^2 (K_4^2 ((h_0/t)^2 - 3 (h_0/t)
  /// (s/t) + 3/2 (s/t)^2) + 1).
  template <class X>
  X rate(const X& s) const {
    const T t = reduced_thickness(), h = flat_deflection() / t, k = k4_squared();
    const X x = s / t;
    return scale() * integer_power(t, 3) * k *
           (k * (number<T>(1.5) * (x * x) - number<T>(3) * h * x + h * h) + number<T>(1));
  }
  /// (W5) Work stored up to s, J: the integral of the force.
  template <class X>
  X work(const X& s) const {
    const T t = reduced_thickness(), h = flat_deflection() / t, k = k4_squared();
    const X x = s / t, left = h - number<T>(0.5) * x;
    return scale() * integer_power(t, 5) * k *
           (number<T>(0.5) * (x * x) * (k * (left * left) + number<T>(1)));
  }

  /// (W6) sigma_I, Pa: compression, the greatest stress in size.
  template <class X>
  X stress_upper_inner(const X& s) const {
    return stress(s, k2(), k3());
  }
  /// (W11) sigma_OM, Pa: compression; a static load is judged by it.
  template <class X>
  X stress_upper_middle(const X& s) const {
    return stress(s, number<T>(0), number<T>(3) / pi<T>());
  }
  /// (W12) sigma_II and sigma_III, Pa: tension up to flat at III, at II where
  /// h_0/t is not large; cracks begin there. sigma_IV.
  template <class X>
  X stress_lower_inner(const X& s) const {
    return stress(s, k2(), -k3());
  }
  template <class X>
  X stress_lower_outer(const X& s) const {
    return stress(s, outer_k2(), -k3() / ratio());
  }
  template <class X>
  X stress_upper_outer(const X& s) const {
    return stress(s, outer_k2(), k3() / ratio());
  }

  /// kg, of a section t' (D_e - D_i) / 2, from the density, kg/m^3.
  T mass(const T& density) const {
    return density * pi<T>() / number<T>(4) * reduced_thickness() *
           (outer_diameter - inner_diameter) * (outer_diameter + inner_diameter);
  }

 private:
  /// 4 E / ((1 - mu^2) K_1 D_e^2).
  T scale() const {
    const T one = number<T>(1);
    return number<T>(4) * youngs_modulus /
           ((one - poisson_ratio * poisson_ratio) * k1() * outer_diameter * outer_diameter);
  }
  /// (K_2 - 2 K_3) / delta.
  T outer_k2() const { return (k2() - number<T>(2) * k3()) / ratio(); }
  /// - scale t'^2 K_4 (s/t') (K_4 turned (h_0'/t' - s/(2 t')) + bent).
  template <class X>
  X stress(const X& s, const T& turned, const T& bent) const {
    using std::sqrt;
    const T t = reduced_thickness(), h = flat_deflection() / t, k = sqrt(k4_squared());
    const X x = s / t;
    return -(scale() * t * t * k * (x * (k * turned * (h - number<T>(0.5) * x) + bent)));
  }
};

}  // namespace camlaw
