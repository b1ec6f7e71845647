// SPDX-License-Identifier: MIT
#include "machines/model/append.h"
#include "machines/model/responses.h"
#include "machines/model/usual_problem.h"
#include "machines/model/why_impossible.h"
#include "machines/springs/disc_spring_stack.h"

namespace camlaw::problems {
namespace {

/// A stack that works between two deflections.
struct DiscSprings {
  Given given = {};
  Expression outer_diameter =
      given({"outer_diameter", "D_e", "mm", "m", "outer diameter", 50, 1e-3, 1e5});
  Expression inner_diameter =
      given({"inner_diameter", "D_i", "mm", "m", "inner diameter", 25.4, 1e-3, 1e5});
  Expression thickness = given({"thickness", "t", "mm", "m", "thickness of a disc", 2, 1e-4, 1e4});
  Expression cone_height = given({"cone_height", "h_0", "mm", "m",
                                  "free height of a disc minus its thickness", 1.4, 1e-4, 1e4});
  Expression parallel =
      given({"parallel", "n", "1", "1", "discs nested in a packet", 1, 1, 1000, true});
  Expression series = given({"series", "i", "1", "1", "packets in series", 10, 1, 10000, true});
  Expression preload_deflection =
      given({"preload_deflection", "s_1", "mm", "m", "least deflection of the stack", 2.1, 0, 1e5});
  Expression working_deflection = given(
      {"working_deflection", "s_2", "mm", "m", "greatest deflection of the stack", 10.5, 0, 1e5});
  Expression youngs_modulus =
      given({"youngs_modulus", "E", "GPa", "Pa", "Young's modulus", 206, 1e-3, 1e4});
  Expression poisson_ratio =
      given({"poisson_ratio", "mu", "1", "1", "Poisson's ratio", 0.3, 0, 0.5});
  Expression density = given({"density", "rho", "kg/m3", "kg/m3", "density", 7850, 1, 1e5});
  Expression thickness_ratio =
      given({"thickness_ratio", "r_t", "1", "1",
             "reduced thickness over thickness; below 1 with contact flats", 1, 0.5, 1});
  Expression surface_friction =
      given({"surface_friction", "w_M", "1", "1", "fraction of force lost between nested discs",
             0.01, 0, 0.5});
  Expression edge_friction = given({"edge_friction", "w_R", "1", "1",
                                    "fraction of force lost at the loaded edges", 0.03, 0, 0.5});

  DiscSpring spring() const {
    return {outer_diameter, inner_diameter, thickness,      cone_height,
            youngs_modulus, poisson_ratio,  thickness_ratio};
  }
  DiscSpringStack stack() const {
    return {spring(), parallel, series, surface_friction, edge_friction};
  }
  auto conditions() const { return stack().conditions(); }
};

enum class At { Preload, Working };

const Expression& deflection(const DiscSprings& springs, At at) {
  return at == At::Preload ? springs.preload_deflection : springs.working_deflection;
}

template <class F>
MechanismResponse disc_number(ResponseAbout about, F formula) {
  return number_response<DiscSprings>(std::move(about), formula);
}

template <class F>
MechanismResponse loaded(At at, ResponseAbout about, F value) {
  return disc_number(std::move(about), [at, value](const auto& springs) {
    return value(springs.stack(), deflection(springs, at));
  });
}

/// The value at the working deflection less that at the preload.
template <class F>
MechanismResponse between(ResponseAbout about, F value) {
  return disc_number(std::move(about), [value](const auto& springs) {
    const auto stack = springs.stack();
    return value(stack, springs.working_deflection) - value(stack, springs.preload_deflection);
  });
}

std::vector<MechanismResponse> disc_forces() {
  const auto force = [](const auto& stack, const auto& s) { return stack.force(s); };
  const auto rate = [](const auto& stack, const auto& s) { return stack.rate(s); };
  return {
      loaded(At::Preload, {"preload_force", "N", "N", "force at the preload deflection"}, force),
      loaded(At::Working, {"working_force", "N", "N", "force at the working deflection"}, force),
      loaded(At::Working,
             {"loading_force", "N", "N",
              "force at the working deflection with friction, during loading"},
             [](const auto& stack, const auto& s) { return stack.loading_force(s); }),
      loaded(At::Preload,
             {"return_force", "N", "N",
              "force at the preload deflection with friction, during unloading"},
             [](const auto& stack, const auto& s) { return stack.return_force(s); }),
      loaded(At::Preload, {"preload_rate", "N/mm", "N/m", "rate at the preload deflection"}, rate),
      loaded(At::Working, {"working_rate", "N/mm", "N/m", "rate at the working deflection"}, rate),
      between({"work", "J", "J", "energy stored between the deflections"},
              [](const auto& stack, const auto& s) { return stack.work(s); })};
}

Expression stress_lower_inner(const DiscSpringStack& stack, const Expression& s) {
  return stack.spring.stress_lower_inner(s / stack.series);
}
Expression stress_lower_outer(const DiscSpringStack& stack, const Expression& s) {
  return stack.spring.stress_lower_outer(s / stack.series);
}

/// Stresses at the working deflection.
std::vector<MechanismResponse> disc_stresses() {
  const auto about = [](const char* name, const char* meaning) {
    return ResponseAbout{name, "MPa", "Pa", meaning};
  };
  const auto inner = [](const auto& stack, const auto& s) { return stress_lower_inner(stack, s); };
  const auto outer = [](const auto& stack, const auto& s) { return stress_lower_outer(stack, s); };
  return {
      loaded(At::Working,
             about("stress_OM", "stress in the middle of the upper side, negative: compression"),
             [](const auto& stack, const auto& s) {
               return stack.spring.stress_upper_middle(s / stack.series);
             }),
      loaded(At::Working,
             about("stress_I", "stress at the upper inner edge, negative: compression"),
             [](const auto& stack, const auto& s) {
               return stack.spring.stress_upper_inner(s / stack.series);
             }),
      loaded(At::Working, about("stress_II", "stress at the lower inner edge"), inner),
      loaded(At::Working, about("stress_III", "stress at the lower outer edge"), outer),
      loaded(At::Working, about("stress_IV", "stress at the upper outer edge"),
             [](const auto& stack, const auto& s) {
               return stack.spring.stress_upper_outer(s / stack.series);
             }),
      between({"stress_range_II", "MPa", "Pa",
               "stress at the lower inner edge minus that at the preload deflection"},
              inner),
      between({"stress_range_III", "MPa", "Pa",
               "stress at the lower outer edge minus that at the preload deflection"},
              outer)};
}

MechanismResponse flattening(At at, const char* name, const char* meaning) {
  return disc_number({name, "1", "1", meaning}, [at](const auto& springs) {
    return springs.stack().flattening(deflection(springs, at));
  });
}

std::vector<MechanismResponse> disc_sizes() {
  return {
      flattening(At::Preload, "preload_flattening",
                 "preload deflection over the deflection to flat"),
      flattening(At::Working, "flattening",
                 "working deflection over the deflection to flat; the discs are stopped at 1, when "
                 "they are flat"),
      disc_number({"stroke", "mm", "m", "working deflection minus preload deflection"},
                  [](const auto& springs) {
                    return springs.working_deflection - springs.preload_deflection;
                  }),
      disc_number({"springs", "1", "1", "number of discs"},
                  [](const auto& springs) { return springs.stack().springs(); }),
      disc_number({"free_length", "mm", "m", "free length of the stack"},
                  [](const auto& springs) { return springs.stack().free_length(); }),
      disc_number({"working_length", "mm", "m", "length of the stack at the working deflection"},
                  [](const auto& springs) {
                    return springs.stack().free_length() - springs.working_deflection;
                  }),
      disc_number({"flat_length", "mm", "m", "length of the stack when pressed flat"},
                  [](const auto& springs) { return springs.stack().flat_length(); }),
      disc_number({"mass", "kg", "kg", "mass of the stack"},
                  [](const auto& springs) { return springs.stack().mass(springs.density); })};
}

}  // namespace

Mechanism disc_springs_mechanism() {
  std::vector<MechanismResponse> responses = disc_forces();
  for (auto make : {&disc_stresses, &disc_sizes}) append(responses, make());
  return {.name = "disc-springs",
          .title = "stack of disc springs between two deflections",
          .source =
              "J. O. Almen, A. Laszlo, The uniform-section disk spring, Trans. ASME 58 "
              "(1936); DIN 2092, EN 16984",
          .parameters = parameters_of<DiscSprings>(),
          .responses = std::move(responses),
          .peaks = {},
          .moved_by = MovedBy::Nothing,
          .validity = {{"flattening", 1}},
          .why_impossible = why_impossible_as<DiscSprings>,
          .usual = usual_problem({.objective = "springs",
                                  .variables = {{"series", 12, 20, 16},
                                                {"preload_deflection", 0, 40, 5},
                                                {"working_deflection", 0, 50, 10}},
                                  .limits = {{"stroke", 8, kNone},
                                             {"preload_force", 5500, kNone},
                                             {"preload_flattening", 0.15, kNone},
                                             {"flattening", kNone, 0.75},
                                             {"stress_III", kNone, 1100}},
                                  .others = {"working_force", "stress_II", "stress_range_III",
                                             "free_length", "working_length", "mass"},
                                  .constants = {{"parallel", 2}}})};
}

}  // namespace camlaw::problems
