// SPDX-License-Identifier: MIT
#include "machines/springs/helical_spring.h"

#include "machines/model/append.h"
#include "machines/model/responses.h"
#include "machines/model/usual_problem.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {
namespace {

/// A spring that works between two deflections, no longer than its least gaps ask for.
struct WorkingSpring {
  Given given = {};
  Expression wire_diameter =
      given({"wire_diameter", "d", "mm", "m", "diameter of the wire", 2, 1e-3, 1e3});
  Expression mean_diameter =
      given({"mean_diameter", "D", "mm", "m", "mean diameter of the coils", 24, 1e-3, 1e4});
  Expression active_coils = given({"active_coils", "n", "1", "1", "active coils", 8.5, 0.1, 1e4});
  Expression end_coils =
      given({"end_coils", "n_e", "1", "1", "inactive coils at the ends", 2, 0, 100});
  Expression preload_deflection =
      given({"preload_deflection", "s_1", "mm", "m", "least deflection", 10, 0, 1e5});
  Expression working_deflection =
      given({"working_deflection", "s_2", "mm", "m", "greatest deflection", 30, 0, 1e5});
  Expression shear_modulus =
      given({"shear_modulus", "G", "GPa", "Pa", "shear modulus", 81.5, 1e-3, 1e4});
  Expression youngs_modulus = given({"youngs_modulus", "E", "GPa", "Pa",
                                     "Young's modulus, above the shear modulus", 206, 1e-3, 1e4});
  Expression density = given({"density", "rho", "kg/m3", "kg/m3", "density", 7850, 1, 1e5});
  Expression gap_factor =
      given({"gap_factor", "k_a", "1", "1",
             "gaps between coils at the working deflection over the least permitted "
             "ones; 1.5 if the deflection varies",
             1, 0, 1000});
  Expression seating = given({"seating", "nu", "1", "1",
                              "buckling length over free length: 0.5, 0.7, 1 or 2", 1, 0.1, 10});

  HelicalSpring coil() const {
    return {wire_diameter, mean_diameter, active_coils,  shear_modulus,
            density,       end_coils,     youngs_modulus};
  }
  auto conditions() const { return coil().conditions(); }
  Expression gaps() const { return gap_factor * coil().least_gaps(); }
  Expression free_length() const { return coil().free_length(working_deflection, gap_factor); }
};

using S = optim::Shape;

template <class F>
MechanismResponse coil_number(ResponseAbout about, F formula) {
  return number_response<WorkingSpring>(std::move(about), formula);
}

/// Of a product of powers of the coils' diameter and number, all below 0.
ShapeStatement convex_in_coils() { return {{"mean_diameter", "active_coils"}, S::Convex, "DS6"}; }

/// Rate and forces.
std::vector<ShapeStatement> of_rate() {
  return {convex_in_coils(), {{"wire_diameter"}, S::Convex, "DS6"}};
}

/// What is a multiple of the wire's diameter besides.
std::vector<ShapeStatement> linear_in_wire() {
  return {convex_in_coils(), {{"wire_diameter"}, S::Linear, "DS6"}};
}

std::vector<MechanismResponse> coil_forces() {
  return {coil_number({"rate", "N/mm", "N/m", "rate", of_rate()},
                      [](const auto& spring) { return spring.coil().rate(); }),
          coil_number(
              {"preload_force", "N", "N", "force at the preload deflection", of_rate()},
              [](const auto& spring) { return spring.coil().force(spring.preload_deflection); }),
          coil_number(
              {"working_force", "N", "N", "force at the working deflection", of_rate()},
              [](const auto& spring) { return spring.coil().force(spring.working_deflection); }),
          coil_number({"stroke", "mm", "m", "working deflection minus preload deflection"},
                      [](const auto& spring) {
                        return spring.working_deflection - spring.preload_deflection;
                      }),
          coil_number({"work", "J", "J", "energy stored between the deflections"},
                      [](const auto& spring) {
                        return spring.coil().work(spring.working_deflection) -
                               spring.coil().work(spring.preload_deflection);
                      })};
}

std::vector<MechanismResponse> coil_stresses() {
  const auto corrected = [](const auto& spring, const auto& deflection) {
    return spring.coil().shear_stress(spring.coil().force(deflection));
  };
  const auto uncorrected = [](const auto& spring, const auto& deflection) {
    return spring.coil().uncorrected_stress(spring.coil().force(deflection));
  };
  return {
      coil_number({"preload_stress", "MPa", "Pa", "corrected stress at the preload deflection"},
                  [=](const auto& spring) { return corrected(spring, spring.preload_deflection); }),
      coil_number({"working_stress", "MPa", "Pa", "corrected stress at the working deflection"},
                  [=](const auto& spring) { return corrected(spring, spring.working_deflection); }),
      coil_number({"stress_range", "MPa", "Pa", "working stress minus preload stress"},
                  [=](const auto& spring) {
                    return corrected(spring, spring.working_deflection - spring.preload_deflection);
                  }),
      coil_number(
          {"static_stress", "MPa", "Pa", "stress at the working deflection, not corrected",
           linear_in_wire()},
          [=](const auto& spring) { return uncorrected(spring, spring.working_deflection); }),
      coil_number({"solid_stress", "MPa", "Pa", "stress at solid length, not corrected"},
                  [=](const auto& spring) {
                    return uncorrected(spring, spring.working_deflection + spring.gaps());
                  })};
}

std::vector<MechanismResponse> coil_sizes() {
  return {
      coil_number({"index", "1", "1", "mean diameter over wire diameter"},
                  [](const auto& spring) { return spring.coil().index(); }),
      coil_number({"outer_diameter", "mm", "m", "outer diameter without load"},
                  [](const auto& spring) { return spring.coil().outer_diameter(); }),
      coil_number({"inner_diameter", "mm", "m", "inner diameter without load"},
                  [](const auto& spring) { return spring.coil().inner_diameter(); }),
      coil_number({"solid_length", "mm", "m", "solid length, with all coils touching"},
                  [](const auto& spring) { return spring.coil().solid_length(); }),
      coil_number({"working_length", "mm", "m", "length at the working deflection"},
                  [](const auto& spring) { return spring.coil().solid_length() + spring.gaps(); }),
      coil_number(
          {"preload_length", "mm", "m", "length at the preload deflection"},
          [](const auto& spring) { return spring.free_length() - spring.preload_deflection; }),
      coil_number({"free_length", "mm", "m",
                   "free length that keeps the gaps between coils at the working deflection"},
                  [](const auto& spring) { return spring.free_length(); }),
      coil_number({"buckling", "1", "1",
                   "how near the working deflection comes to buckling; above 1 the spring buckles"},
                  [](const auto& spring) {
                    return spring.coil().buckling_fraction(spring.working_deflection,
                                                           spring.free_length(), spring.seating);
                  })};
}

std::vector<MechanismResponse> masses() {
  return {coil_number({"mass", "kg", "kg", "mass of the spring"},
                      [](const auto& spring) { return spring.coil().mass(); }),
          coil_number({"active_mass", "kg", "kg", "mass of the active coils"},
                      [](const auto& spring) { return spring.coil().active_mass(); }),
          coil_number({"surge_frequency", "Hz", "Hz", "lowest natural frequency, both ends held",
                       linear_in_wire()},
                      [](const auto& spring) { return spring.coil().surge_frequency(); })};
}

}  // namespace

Mechanism helical_spring_mechanism() {
  std::vector<MechanismResponse> responses = coil_forces();
  for (auto make : {&coil_stresses, &coil_sizes, &masses}) append(responses, make());
  return {.name = "helical-spring",
          .title = "helical compression spring of round wire between two deflections",
          .source =
              "EN 13906-1, Cylindrical helical springs made from round wire and bar, "
              "calculation and design, part 1: compression springs",
          .parameters = parameters_of<WorkingSpring>(),
          .responses = std::move(responses),
          .peaks = {},
          .moved_by = MovedBy::Nothing,
          .why_impossible = why_impossible_as<WorkingSpring>,
          .usual = usual_problem({.objective = "active_mass",
                                  .variables = {{"wire_diameter", 1, 8, 4},
                                                {"mean_diameter", 10, 100, 30},
                                                {"active_coils", 2, 30, 8},
                                                {"preload_deflection", 0, 60, 10},
                                                {"working_deflection", 0, 80, 25}},
                                  .limits = {{"stroke", 12, kNone},
                                             {"preload_force", 250, kNone},
                                             {"working_stress", kNone, 700},
                                             {"index", kNone, 7},
                                             {"surge_frequency", 400, kNone}},
                                  .others = {"rate", "outer_diameter", "free_length",
                                             "solid_stress", "buckling", "mass"}})};
}

}  // namespace camlaw::problems
