// SPDX-License-Identifier: MIT
#pragma once

#include "machines/contact/elliptic_contact.h"
#include "machines/contact/hertz.h"
#include "machines/contact/lubricant.h"

/// What a roller and a flank bear below their surfaces, and where the roller is crowned
/// (docs/theory.md, "Line contact", "Crowned rollers" and
/// "Lubricant film").
namespace camlaw {

/// A roller pressed on a flank.
struct PressedRoller {
  Expression force;   ///< F, N
  Expression across;  ///< sum of the curvatures square to the line of contact, without a crown, 1/m
  Expression rolling;  ///< the principal sum of the curvatures towards which the roller rolls, 1/m
  Expression along;    ///< the other one, of the crown
  Expression face_width;  ///< b, m
  LineContact material;

  /// (RB10)
  ContactEllipse ellipse() const {
    return contact_ellipse(force, rolling, along, material.plane_modulus());
  }
  Expression line_load() const { return force / face_width; }
  /// (K5), (K6) of the line contact: greatest shear, Pa, and its depth, m.
  Expression line_shear() const { return max_shear(material.pressure(line_load(), across)); }
  Expression line_shear_depth() const {
    return shear_depth(material.half_width(line_load(), across));
  }
  /// (RB16), (RB17) of the crowned roller.
  Expression shear() const {
    const ContactEllipse own = ellipse();
    return crown_shear(own.pressure, own.slenderness, material.poisson_ratio);
  }
  Expression depth_of_shear() const {
    const ContactEllipse own = ellipse();
    return crown_shear_depth(own.lesser_half_axis(), own.slenderness, material.poisson_ratio);
  }
  /// Length of the ellipse over the width of the face.
  Expression crown_fraction() const {
    return ellipse().half_length / (Expression(0.5) * face_width);
  }
};

/// One whose crown, 1/m, lies along the line of contact.
inline PressedRoller pressed_roller(const Expression& force, const Expression& across,
                                    const Expression& crown, const Expression& face_width,
                                    const LineContact& material) {
  return {force, across, across, crown, face_width, material};
}

/// (RB15) One on a line of contact whose angle to the roller's axis has the tangent `tilt`: the sum
/// of its curvatures is across + crown, their product across crown / (1 + tilt^2).
inline PressedRoller pressed_askew(const Expression& force, const Expression& across,
                                   const Expression& tilt, const Expression& crown,
                                   const Expression& face_width, const LineContact& material) {
  const Expression half = Expression(0.5) * (across + crown),
                   apart = Expression(0.5) * (across - crown);
  const Expression product = crown * (across / (1 + tilt * tilt));
  // half^2 - product, of which nothing cancels.
  const Expression greater = half + sqrt(apart * apart + product * (tilt * tilt));
  const Expression lesser = product / greater;
  return {force,      across,  by_side(apart, greater, lesser), by_side(apart, lesser, greater),
          face_width, material};
}

/// The greatest length by width of an ellipse, or width by length, at which the error of (RB9) is
/// told: alpha = 500.
inline constexpr double kKnownElongation = 46.63;

/// What a roller is pressed on with oil between, and the mean speed of the surfaces towards the
/// contact, m/s.
struct RollerFilm {
  Lubricant oil;
  PressedRoller roller;
  Expression speed;

  /// (RB7) Film of the line contact, m.
  Expression of_line() const {
    return oil.film(roller.force / roller.face_width, roller.across, speed,
                    roller.material.plane_modulus());
  }
  /// (RB18) Film of the crowned roller, m.
  Expression of_crown() const {
    return oil.point_film(roller.force, roller.rolling, roller.ellipse().elongation, speed,
                          roller.material.plane_modulus());
  }
};

inline RollerFilm roller_film(const Lubricant& oil, const PressedRoller& roller,
                              const Expression& speed) {
  return {oil, roller, speed};
}

}  // namespace camlaw
