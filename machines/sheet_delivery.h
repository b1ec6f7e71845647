// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>

#include "kinematics/law.h"
#include "machines/model/given.h"
#include "machines/model/possibility.h"
#include "numerics/formula/expression.h"

namespace camlaw {

/// Whether friction terms count as dissipation, by their size, or signed as the paper prints them.
enum class Friction { Dissipates, AsPrinted };

/// Where the rod of a sheet delivery stands: sine, cosine and tangent of the rod angle alpha, the
/// same of the guide angle beta.
struct RodPlace {
  Expression sin_alpha, cos_alpha, tan_alpha, sin_beta, cos_beta, tan_beta;
};

/// The carriage of a sheet delivery, pulled by a rod from a chain link A that runs at constant
/// speed along a curved guide; the carriage B runs straight. The guide's offset follows a law, y =
/// y_max s(x), over one stretch x from 0 to 1, and y_max = l sin(alpha_max) for the rod's length l.
///
/// Fields in SI units. Equations (Nn) are those of docs/theory.md, "Sheet delivery"; source:
/// "Analytical study of the efficiency of sheet-delivery conveyors with curvilinear chain guides",
/// Polihrafiia i vydavnycha sprava, received 29.12.1982. Valid for 0 < alpha_max < 90 degrees and s
/// within 0 and 1; where an efficiency is not above 0, the drive locks itself.
struct SheetDelivery {
  Given given = {};
  Expression guide_ratio =
      given({"guide_ratio", "lambda", "1", "1",
             "offset of the guide over the length of its stretch", 0.4, 1e-3, 100});
  Expression rod_angle_max = given({"rod_angle_max", "alpha_max", "deg", "rad",
                                    "angle of the rod at the greatest offset", 60, 0.1, 89});
  Expression slide_friction_A =
      given({"slide_friction_A", "f_A'", "1", "1",
             "coefficient of friction of the chain's link in its guide", 0.1, 0, 10});
  Expression slide_friction_B =
      given({"slide_friction_B", "f_B'", "1", "1",
             "coefficient of friction of the carriage in its guide", 0.1, 0, 10});
  Expression joint_friction_A =
      given({"joint_friction_A", "f_A", "1", "1",
             "coefficient of friction in the joint of rod and link", 0.15, 0, 10});
  Expression joint_friction_B =
      given({"joint_friction_B", "f_B", "1", "1",
             "coefficient of friction in the joint of rod and carriage", 0.15, 0, 10});
  Expression joint_friction_O =
      given({"joint_friction_O", "f_O", "1", "1",
             "coefficient of friction in the sprocket's bearing", 0.15, 0, 10});
  Expression joint_radius_A =
      given({"joint_radius_A", "r_A", "1", "1",
             "radius of the joint of rod and link over the rod's length", 0.1, 0, 1});
  Expression joint_radius_B =
      given({"joint_radius_B", "r_B", "1", "1",
             "radius of the joint of rod and carriage over the rod's length", 0.1, 0, 1});
  Expression joint_radius_O = given({"joint_radius_O", "r_O", "1", "1",
                                     "radius of the bearing over that of the sprocket", 0.1, 0, 1});

  auto conditions() const {
    return std::to_array<Condition>(
        {{rod_angle_max, "rod_angle_max must be above 0"},
         {pi() / 2 - rod_angle_max, "rod_angle_max must be below 90 deg"}});
  }

  /// (N1) sin alpha = s sin(alpha_max), tan beta = lambda s'.
  RodPlace place(const Motion<Expression>& motion) const {
    RodPlace at;
    at.sin_alpha = sin_alpha_max() * motion.s;
    at.cos_alpha = sqrt((1 - at.sin_alpha) * (1 + at.sin_alpha));
    at.tan_alpha = at.sin_alpha / at.cos_alpha;
    at.tan_beta = guide_ratio * motion.v;
    at.cos_beta = 1 / sqrt(1 + at.tan_beta * at.tan_beta);
    at.sin_beta = at.tan_beta * at.cos_beta;
    return at;
  }
  Expression rod_angle(const Motion<Expression>& motion) const {
    return asin(sin_alpha_max() * motion.s);
  }
  Expression guide_angle(const Motion<Expression>& motion) const {
    return atan(guide_ratio * motion.v);
  }
  /// (N2) Turning of the rod, speed of B about A over that of the chain: sin beta / cos alpha.
  Expression relative_speed(const RodPlace& at) const { return at.sin_beta / at.cos_alpha; }
  /// (N3) Speed of the carriage over that of the chain, K = cos(alpha - beta) / cos alpha: running
  /// up, the rod draws aside ahead of the carriage.
  Expression speed_ratio(const RodPlace& at) const {
    return at.cos_beta + at.sin_beta * at.tan_alpha;
  }
  /// The same on the mirrored stretch, slowing down: cos(alpha + beta) / cos alpha.
  Expression slow_speed_ratio(const RodPlace& at) const {
    return at.cos_beta - at.sin_beta * at.tan_alpha;
  }
  /// (N4) By how much the carriage falls behind the chain in a stretch of slowing down, or gains in
  /// one of running up, over the stretch's length: lambda tan(alpha_max / 2).
  Expression slow_down() const { return guide_ratio * tan(rod_angle_max / 2); }

  /// (N5) Efficiency of the carriage's joint and guide, power from the motor to the carriage:
  /// 1 - f_B' tan alpha - f_B r_B sin beta / (K cos^2 alpha).
  Expression efficiency_B(const RodPlace& at, Friction friction) const {
    return 1 - loss_B(at, friction);
  }
  /// (N6) Of the link's: 1 / (1 + f_A' tan(alpha - beta) + f_A r_A sin beta / (cos alpha
  /// cos(alpha - beta))).
  Expression efficiency_A(const RodPlace& at, Friction friction) const {
    return 1 / (1 + loss_A(at, friction));
  }
  /// (N7) Of the sprocket's shaft: 1 / (1 + f_O r_O).
  Expression efficiency_O() const { return 1 / (1 + loss_O()); }
  /// Of all three.
  Expression efficiency(const RodPlace& at, Friction friction) const {
    return efficiency_O() * (efficiency_B(at, friction) * efficiency_A(at, friction));
  }
  /// (N8) The same with the power from the carriage to the motor:
  /// (1 - f_O r_O) (1 - loss_A) / (1 + loss_B).
  Expression reverse_efficiency(const RodPlace& at, Friction friction) const {
    return (1 - loss_O()) * ((1 - loss_A(at, friction)) / (1 + loss_B(at, friction)));
  }
  /// (N9) Efficiency where the guide is straight and the rod in line, s = s' = 0: eta_O alone.
  Expression straight_efficiency() const { return efficiency_O(); }
  /// (N10) Efficiency at the boundary of running up and slowing down, s = 1, s' = 0:
  /// eta_O (1 - f_B' tan alpha_max) / (1 + f_A' tan alpha_max).
  Expression boundary_efficiency() const {
    const Expression t = tan(rod_angle_max);
    return efficiency_O() * (1 - slide_friction_B * t) / (1 + slide_friction_A * t);
  }

 private:
  Expression sin_alpha_max() const { return sin(rod_angle_max); }
  Expression loss_O() const { return joint_friction_O * joint_radius_O; }
  static Expression counted(const Expression& term, Friction friction) {
    return friction == Friction::Dissipates ? absolute(term) : term;
  }
  /// Turning in a joint: sin beta / (K cos^2 alpha), which is sin beta / (cos alpha cos(alpha -
  /// beta)).
  Expression turning(const RodPlace& at) const {
    return at.sin_beta / (speed_ratio(at) * (at.cos_alpha * at.cos_alpha));
  }
  Expression loss_B(const RodPlace& at, Friction friction) const {
    return slide_friction_B * counted(at.tan_alpha, friction) +
           joint_friction_B * joint_radius_B * counted(turning(at), friction);
  }
  /// tan(alpha - beta) = (tan alpha - tan beta) / (1 + tan alpha tan beta).
  Expression loss_A(const RodPlace& at, Friction friction) const {
    const Expression slope = (at.tan_alpha - at.tan_beta) / (1 + at.tan_alpha * at.tan_beta);
    return slide_friction_A * counted(slope, friction) +
           joint_friction_A * joint_radius_A * counted(turning(at), friction);
  }
};

}  // namespace camlaw
