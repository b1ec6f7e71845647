// SPDX-License-Identifier: MIT
#include <cmath>

#include "kinematics/law.h"
#include "machines/contact/hertz.h"
#include "machines/model/append.h"
#include "machines/model/responses.h"
#include "machines/model/usual_problem.h"

namespace camlaw::problems {
namespace {

/// Line contact as the die-press paper computes it: the coefficients of Poisson's ratio 0.3,
/// rounded. Equations (Jn) are those of docs/theory.md, "Die press". Of two steel cylinders with
/// radii R1 and R2 under the line load w.
struct PublishedLineContact {
  Expression youngs_modulus;  ///< E, Pa
  Expression poisson_ratio;   ///< mu; only (J3) has it, 0.42 and 1.52 stand for 0.3
  Expression radius;          ///< R1, m
  Expression other_radius;    ///< R2, m

  /// 1 / R1 + 1 / R2, 1/m.
  Expression curvature() const { return 1 / radius + 1 / other_radius; }
  /// (J1) Contact stress, Pa: sigma = 0.42 sqrt(w E (R1 + R2) / (R1 R2)). NaN for a load below 0.
  Expression stress(const Expression& line_load) const {
    return ratio(42, 100) * sqrt(youngs_modulus * curvature() * line_load);
  }
  /// (J2) Half the contact's width, m: a = 1.52 sqrt(w R1 R2 / ((R1 + R2) E)).
  Expression half_width(const Expression& line_load) const {
    return width_factor() * sqrt(line_load / (youngs_modulus * curvature()));
  }
  /// (J3) Elastic approach, m: delta = 2 (1 - mu^2) / (pi E) w (ln(4 R1 R2 / a^2) + 0.815), with
  /// (J2) put in: 4 R1 R2 / a^2 = 4 (R1 + R2) E / (1.52^2 w). For a load above 0.
  Expression approach(const Expression& line_load) const {
    const Expression plane = 1 - poisson_ratio * poisson_ratio;
    const Expression factor = 2 * plane / (pi() * youngs_modulus);
    const Expression scale =
        4 * (radius + other_radius) * youngs_modulus / (width_factor() * width_factor());
    return factor * (line_load * (log(1 / line_load * scale) + ratio(815, 1000)));
  }

 private:
  static Expression width_factor() { return ratio(152, 100); }
};

/// The contact of cam and rollers in the drive of a flat die-cutting press: a cam parts two rollers
/// on wedging levers that raise the platen, a spring keeps them on the cam.
///
/// Fields in SI units. Source: "Study of the elastic deformation amount of the flat die-cutting
/// press parts being in constant contact", Ukrainian Academy of Printing. The first three fields
/// are a load as the paper gives it, a force on the cam and a spring force; stroke and what follows
/// it make the load from a law. The paper prints no mass, stroke, speed or spring: those here give
/// the cosine law an inertia force of 754 N, near its printed 750 N.
struct DiePress {
  Given given = {};
  Expression cam_force =
      given({"cam_force", "F_k", "N", "N", "given force on the cam", 815.48, 0, 1e9});
  Expression spring_force =
      given({"spring_force", "F_s", "N", "N", "given force of the spring", 354.08, 0, 1e9});
  Expression load_factor = given(
      {"load_factor", "k", "1", "1", "fraction of the spring's force in the load", 0.8, 0, 10});
  Expression roller_radius =
      given({"roller_radius", "R1", "mm", "m", "radius of the roller", 50, 1e-3, 1e5});
  Expression segment_radius =
      given({"segment_radius", "R2", "mm", "m", "radius of the cam's segment", 350, 1e-3, 1e5});
  Expression face_width = given(
      {"face_width", "b", "mm", "m", "width of the contact along the cam's axis", 30, 1e-3, 1e4});
  Expression youngs_modulus = given(
      {"youngs_modulus", "E", "GPa", "Pa", "Young's modulus of cam and roller", 210, 1e-3, 1e4});
  Expression poisson_ratio =
      given({"poisson_ratio", "mu", "1", "1", "Poisson's ratio of cam and roller", 0.3, 0, 0.5});
  Expression stroke = given({"stroke", "h", "mm", "m", "stroke of the rollers", 40, 1e-6, 1e5});
  Expression angular_speed =
      given({"speed", "n", "rpm", "rad/s", "speed of the cam", 125, 1e-3, 1e6});
  Expression mass =
      given({"mass", "m", "kg", "kg", "moving mass, referred to the rollers' path", 220, 0, 1e6});
  Expression spring_rate =
      given({"spring_rate", "c", "N/mm", "N/m", "rate of the spring", 10, 0, 1e6});
  Expression spring_preload = given({"spring_preload", "F_0", "N", "N",
                                     "force of the spring at the lowest position", 700, 0, 1e9});

  PublishedLineContact published() const {
    return {youngs_modulus, poisson_ratio, roller_radius, segment_radius};
  }
  LineContact exact() const { return {youngs_modulus, poisson_ratio}; }

  /// (J4) Load of the contact, N: F = F_k + k F_s.
  Expression load() const { return cam_force + load_factor * spring_force; }
  /// Line load, N/m: w = F / b.
  Expression line_load(const Expression& force) const { return force / face_width; }
  /// (J5) Force between cam and roller from a law whose stretch takes half a turn, N:
  /// F = m h (omega / pi)^2 s'' + c h s + F_0. Below 0 the roller leaves the cam.
  Expression running_force(const Motion<Expression>& motion) const {
    const Expression frequency = angular_speed / pi();
    return mass * stroke * frequency * frequency * motion.a + spring_rate * stroke * motion.s +
           spring_preload;
  }

  /// (J1) to (J3) from a force, in SI units.
  Expression stress(const Expression& force) const { return published().stress(line_load(force)); }
  Expression half_width(const Expression& force) const {
    return published().half_width(line_load(force));
  }
  Expression approach(const Expression& force) const {
    return published().approach(line_load(force));
  }
  /// The same after Hertz, (K2) to (K4).
  Expression exact_stress(const Expression& force) const {
    return exact().pressure(line_load(force), published().curvature());
  }
  Expression exact_half_width(const Expression& force) const {
    return exact().half_width(line_load(force), published().curvature());
  }
  Expression exact_approach(const Expression& force) const {
    return exact().approach(line_load(force), roller_radius, segment_radius);
  }
};

using optim::Part;
using S = optim::Shape;

const Cycle& turn() {
  static const Cycle turn{"deg", {{0, 180}, {180, 360, true}}};
  return turn;
}

/// A quantity of the contact, of the given load and of the running force: formula(press, force).
template <class F>
std::vector<MechanismResponse> contact(const char* number, const char* curve, const char* unit,
                                       const char* stored, const char* meaning, S in_radii,
                                       F formula) {
  const std::vector<ShapeStatement> shapes{{{"roller_radius", "segment_radius"}, in_radii, "DS9"}};
  return {number_response<DiePress>({number, unit, stored, meaning, shapes},
                                    [formula](const auto& p) { return formula(p, p.load()); }),
          curve_response<DiePress>({curve, unit, stored, meaning, shapes}, turn(),
                                   [formula](const auto& p, const auto& motion) {
                                     return formula(p, p.running_force(motion));
                                   })};
}

std::vector<MechanismResponse> responses() {
  std::vector<MechanismResponse> all{
      number_response<DiePress>({"load", "N", "N", "contact load, F_k + k F_s"},
                                [](const auto& p) { return p.load(); }),
      number_response<DiePress>({"line_load", "N/mm", "N/m", "contact load per unit width"},
                                [](const auto& p) { return p.line_load(p.load()); }),
      curve_response<DiePress>({"running_force", "N", "N",
                                "force between cam and roller; below 0 the roller leaves the cam"},
                               turn(),
                               [](const auto& p, const auto& m) { return p.running_force(m); }),
      curve_response<DiePress>(
          {"displacement", "mm", "m", "travel of the rollers from their lowest position"}, turn(),
          [](const auto& p, const auto& m) { return p.stroke * m.s; })};
  append(all,
         contact("contact_stress", "running_stress", "MPa", "Pa", "contact stress, as published",
                 S::Convex, [](const auto& p, const auto& force) { return p.stress(force); }));
  append(all, contact("contact_half_width", "running_half_width", "mm", "m",
                      "half the contact's width, as published", S::Concave,
                      [](const auto& p, const auto& force) { return p.half_width(force); }));
  append(all, contact("elastic_approach", "running_approach", "um", "m",
                      "elastic approach of cam and roller, as published", S::Concave,
                      [](const auto& p, const auto& force) { return p.approach(force); }));
  append(all, contact("exact_contact_stress", "running_exact_stress", "MPa", "Pa",
                      "contact stress according to Hertz", S::Convex,
                      [](const auto& p, const auto& force) { return p.exact_stress(force); }));
  append(all, contact("exact_contact_half_width", "running_exact_half_width", "mm", "m",
                      "half the contact's width according to Hertz", S::Concave,
                      [](const auto& p, const auto& force) { return p.exact_half_width(force); }));
  append(all, contact("exact_elastic_approach", "running_exact_approach", "um", "m",
                      "approach of the axes according to Hertz", S::Concave,
                      [](const auto& p, const auto& force) { return p.exact_approach(force); }));
  return all;
}

}  // namespace

Mechanism die_press_mechanism() {
  return {
      .name = "die-press",
      .title = "cam and rollers of a flat die-cutting press",
      .source =
          "Study of the elastic deformation amount of the flat die-cutting press parts "
          "being in constant contact, Ukrainian Academy of Printing",
      .parameters = parameters_of<DiePress>(),
      .responses = responses(),
      .peaks = {{"least_force", "running_force", Part::Lowest,
                 "least force between cam and roller; above 0 the spring keeps contact"},
                {"peak_force", "running_force", Part::Highest,
                 "greatest force between cam and roller"},
                {"peak_stress", "running_stress", Part::Highest, "greatest contact stress"},
                {"peak_approach", "running_approach", Part::Highest, "greatest elastic approach"}},
      .usual = usual_problem(
          {.objective = "peak running_approach",
           .variables = {{"roller_radius", 20, 100, 50}, {"spring_preload", 0, 2000, 1000}},
           .limits = {{"lowest running_force", 100, kNone}, {"highest running_stress", kNone, 180}},
           .others = {"peak_force", "peak_stress", "peak_approach", "running_stress",
                      "running_force"},
           .law = "cosine"})};
}

}  // namespace camlaw::problems
