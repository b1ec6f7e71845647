// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "machines/model/possibility.h"
#include "numerics/formula/expression.h"

namespace camlaw {

/// A disc spring, with or without contact flats (Almen and Laszlo; DIN 2092, EN 16984;
/// docs/theory.md, "Disc springs"). Fields in SI units. Valid for deflections from 0 to flat.
/// Edges of the section: I upper inner, II lower inner, III lower outer, IV upper outer; the force
/// acts on I and III. OM is the middle of the upper side. Tension is positive.
struct DiscSpring {
  Expression outer_diameter;                        ///< D_e, m
  Expression inner_diameter;                        ///< D_i, m
  Expression thickness;                             ///< t, m
  Expression cone_height;                           ///< h_0 = l_0 - t, m; l_0 is the free height
  Expression youngs_modulus = Expression(2.06e11);  ///< E, Pa
  Expression poisson_ratio = Expression(0.3);       ///< mu
  /// t'/t: 1 without flats; with flats the disc is thinner, at the same l_0.
  Expression thickness_ratio = 1;

  Expression ratio() const { return outer_diameter / inner_diameter; }
  /// t'.
  Expression reduced_thickness() const { return thickness * thickness_ratio; }
  /// h_0' = l_0 - t', the deflection to flat.
  Expression flat_deflection() const { return cone_height + thickness * (1 - thickness_ratio); }
  auto conditions() const {
    return std::to_array<Condition>(
        {{inner_diameter, "inner_diameter must be above 0"},
         {outer_diameter - inner_diameter, "outer_diameter must be above inner_diameter"},
         {thickness, "thickness must be above 0"},
         {cone_height, "cone_height must be 0 or above", true},
         {thickness_ratio, "thickness_ratio must be above 0"},
         {flat_deflection(), "cone_height + thickness * (1 - thickness_ratio) must be 0 or above",
          true}});
  }

  /// (W1) K_1 = ((delta - 1) / delta)^2 / (pi ((delta + 1) / (delta - 1) - 2 / ln delta)).
  Expression k1() const {
    const Expression d = ratio();
    const Expression share = (d - 1) / d;
    return share * share / (pi() * ((d + 1) / (d - 1) - 2 / log(d)));
  }
  /// (W2) K_2 = 6 / (pi ln delta) ((delta - 1) / ln delta - 1), K_3 = 3 (delta - 1) / (pi ln
  /// delta).
  Expression k2() const {
    const Expression d = ratio();
    return 6 / (pi() * log(d)) * ((d - 1) / log(d) - 1);
  }
  Expression k3() const { return 3 * (ratio() - 1) / (pi() * log(ratio())); }
  /// (W13) K_4^2, 1 without flats: a disc with flats has at 3/4 of h_0 the force that one of the
  /// thickness t without flats has.
  Expression k4_squared() const {
    const Expression r = thickness_ratio, h = cone_height / thickness;
    if (is_number(r, 1)) return 1;
    const Expression a = (Expression(0.25) * h + 1 - r) * (Expression(0.625) * h + 1 - r) / (r * r);
    const Expression c = (Expression(0.15625) * h * h + 1) / (r * r * r);
    return 2 * c / (1 + sqrt(1 + 4 * a * c));
  }

  /// (W3), (W14) Force, N, at the deflection s, m: with t', h_0' for t, h_0
  /// F = 4 E t^4 / ((1 - mu^2) K_1 D_e^2) K_4^2 (s/t) (K_4^2 (h_0/t - s/t) (h_0/t - s/(2 t)) + 1).
  Expression force(const Expression& s) const {
    const Expression t = reduced_thickness(), h = flat_deflection() / t, k = k4_squared();
    const Expression x = s / t;
    return scale() * integer_power(t, 4) * k *
           (x * (k * ((h - x) * (h - Expression(0.5) * x)) + 1));
  }
  /// (W4) Rate dF/ds, N/m: 4 E t^3 / ((1 - mu^2) K_1 D_e^2) K_4^2 (K_4^2 ((h_0/t)^2 - 3 (h_0/t)
  /// (s/t) + 3/2 (s/t)^2) + 1).
  Expression rate(const Expression& s) const {
    const Expression t = reduced_thickness(), h = flat_deflection() / t, k = k4_squared();
    const Expression x = s / t;
    return scale() * integer_power(t, 3) * k *
           (k * (Expression(1.5) * (x * x) - 3 * h * x + h * h) + 1);
  }
  /// (W5) Work stored up to s, J: the integral of the force.
  Expression work(const Expression& s) const {
    const Expression t = reduced_thickness(), h = flat_deflection() / t, k = k4_squared();
    const Expression x = s / t, left = h - Expression(0.5) * x;
    return scale() * integer_power(t, 5) * k *
           (Expression(0.5) * (x * x) * (k * (left * left) + 1));
  }

  /// (W6) sigma_I, Pa: compression, the greatest stress in size.
  Expression stress_upper_inner(const Expression& s) const { return stress(s, k2(), k3()); }
  /// (W11) sigma_OM, Pa: compression; a static load is judged by it.
  Expression stress_upper_middle(const Expression& s) const { return stress(s, 0, 3 / pi()); }
  /// (W12) sigma_II and sigma_III, Pa: tension up to flat at III, at II where
  /// h_0/t is not large; cracks begin there. sigma_IV.
  Expression stress_lower_inner(const Expression& s) const { return stress(s, k2(), -k3()); }
  Expression stress_lower_outer(const Expression& s) const {
    return stress(s, outer_k2(), -k3() / ratio());
  }
  Expression stress_upper_outer(const Expression& s) const {
    return stress(s, outer_k2(), k3() / ratio());
  }

  /// kg, of a section t' (D_e - D_i) / 2, from the density, kg/m^3.
  Expression mass(const Expression& density) const {
    return density * pi() / 4 * reduced_thickness() * (outer_diameter - inner_diameter) *
           (outer_diameter + inner_diameter);
  }

 private:
  /// 4 E / ((1 - mu^2) K_1 D_e^2).
  Expression scale() const {
    return 4 * youngs_modulus /
           ((1 - poisson_ratio * poisson_ratio) * k1() * outer_diameter * outer_diameter);
  }
  /// (K_2 - 2 K_3) / delta.
  Expression outer_k2() const { return (k2() - 2 * k3()) / ratio(); }
  /// - scale t'^2 K_4 (s/t') (K_4 turned (h_0'/t' - s/(2 t')) + bent).
  Expression stress(const Expression& s, const Expression& turned, const Expression& bent) const {
    const Expression t = reduced_thickness(), h = flat_deflection() / t, k = sqrt(k4_squared());
    const Expression x = s / t;
    return -(scale() * t * t * k * (x * (k * turned * (h - Expression(0.5) * x) + bent)));
  }
};

}  // namespace camlaw
