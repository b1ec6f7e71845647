// SPDX-License-Identifier: MIT
// Springs as mechanisms, and the problem files about them against answers found by hand.
#include <cmath>
#include <numbers>

#include "machines/registry.h"
#include "machines/springs/disc_spring_stack.h"
#include "machines/springs/helical_spring.h"
#include "tests/machines/system_fixture.h"
#include "tests/plain.h"

namespace camlaw::problems::springs_test {
namespace {

using testing::plain, testing::PlainNumbers;

using testing::design_of, testing::response_of, testing::root, testing::TestDesign;
constexpr double kPi = std::numbers::pi;

const Mechanism& discs() { return find_mechanism("disc-springs"); }
const Mechanism& helical() { return find_mechanism("helical-spring"); }

TestDesign all_vary(const Mechanism& mechanism) {
  return design_of(mechanism, "constant-velocity", {}, testing::all_parameters(mechanism));
}

double value_of(const Mechanism& mechanism, const char* name, const TestDesign& design) {
  return response_of(mechanism, name, design.binding).function().value(design.x);
}

/// The file solved as it says, every limit proved.
optim::Optimum solved(const BoundProblem& bound) {
  const auto optimum = optim::optimise(bound.space(), {.starts = bound.statement().solver.starts});
  CHECK(optimum.found.assessment.verdict == optim::Verdict::Certified);
  for (const auto& limit : optimum.found.assessment.limits) CHECK(limit.proved);
  return optimum;
}

/// What a follower's spring must do, and the lightest that does it.
struct FollowerSpring {
  double stroke = 0.012, preload = 250, stress = 700e6, index = 7, surge = 400;
  double modulus = 81.5e9, density = 7850;

  double correction() const { return (index + 0.5) / (index - 0.75); }
  /// The mass of the moving coils is 2 rho G (k F / tau)^2 / R: it grows with the force at the end,
  /// and is least, where R is free, at R = F_1 / h. The surge frequency sqrt(R / m) / 2 =
  /// tau R / (2 k (F_1 + R h) sqrt(2 rho G)) asks for R = F_1 / (c - h).
  double rate() const {
    const double c = stress / (2 * correction() * surge * std::sqrt(2 * density * modulus));
    return std::max(preload / stroke, preload / (c - stroke));
  }
  double force() const { return preload + rate() * stroke; }
  double mass() const {
    return 2 * density * modulus * std::pow(correction() * force() / stress, 2) / rate();
  }
  double wire() const { return std::sqrt(8 * correction() * index * force() / (kPi * stress)); }
  double coils() const { return modulus * wire() / (8 * std::pow(index, 3) * rate()); }
};

}  // namespace

TEST_CASE("numbers of springs have exact derivatives and bounds", "[springs]") {
  testing::check_numbers(discs(), all_vary(discs()));
  testing::check_numbers(helical(), all_vary(helical()));
}

TEST_CASE("numbers of disc springs are those of the stack", "[springs]") {
  TestDesign design = all_vary(discs());
  const auto set = [&](const char* name, double value) {
    const std::size_t parameter = discs().parameter(name);
    for (std::size_t k = 0; k < design.binding.parameters.size(); ++k) {
      if (design.binding.parameters[k] == parameter) {
        design.x[design.binding.variables[k]] = value;
      }
    }
  };
  set("parallel", 2), set("surface_friction", 0.02), set("edge_friction", 0.03);
  set("thickness_ratio", 0.94);
  const PlainNumbers numbers;
  DiscSpring spring{0.05, 0.0254, 0.002, 0.0014};
  spring.thickness_ratio = 0.94;
  const DiscSpringStack stack{spring, 2, 10, 0.02, 0.03};
  const double s1 = 0.0021, s2 = 0.0105;
  const auto is = [&](const char* name, double expected) {
    INFO(name);
    CHECK(value_of(discs(), name, design) == Approx(expected).epsilon(1e-12));
  };
  is("preload_force", plain(stack.force(s1)));
  is("working_force", plain(stack.force(s2)));
  is("loading_force", plain(stack.force(s2)) / 0.95);
  is("return_force", plain(stack.force(s1)) / 1.05);
  is("preload_rate", plain(stack.rate(s1)) / 1e3);
  is("working_rate", plain(stack.rate(s2)) / 1e3);
  is("work", plain(stack.work(s2)) - plain(stack.work(s1)));
  is("stress_OM", plain(spring.stress_upper_middle(s2 / 10)) / 1e6);
  is("stress_I", plain(spring.stress_upper_inner(s2 / 10)) / 1e6);
  is("stress_II", plain(spring.stress_lower_inner(s2 / 10)) / 1e6);
  is("stress_III", plain(spring.stress_lower_outer(s2 / 10)) / 1e6);
  is("stress_IV", plain(spring.stress_upper_outer(s2 / 10)) / 1e6);
  is("stress_range_II",
     (plain(spring.stress_lower_inner(s2 / 10)) - plain(spring.stress_lower_inner(s1 / 10))) / 1e6);
  is("stress_range_III",
     (plain(spring.stress_lower_outer(s2 / 10)) - plain(spring.stress_lower_outer(s1 / 10))) / 1e6);
  is("preload_flattening", plain(stack.flattening(s1)));
  is("flattening", plain(stack.flattening(s2)));
  is("stroke", 8.4);
  is("springs", 20);
  is("free_length", plain(stack.free_length()) * 1e3);
  is("working_length", (plain(stack.free_length()) - s2) * 1e3);
  is("flat_length", plain(stack.flat_length()) * 1e3);
  is("mass", plain(stack.mass(7850)));
}

TEST_CASE("numbers of a helical spring are the spring's", "[springs]") {
  const TestDesign design = all_vary(helical());
  const PlainNumbers numbers;
  const HelicalSpring spring{0.002, 0.024, 8.5};
  const double s1 = 0.01, s2 = 0.03, length = plain(spring.free_length(s2, 1));
  const auto is = [&](const char* name, double expected) {
    INFO(name);
    CHECK(value_of(helical(), name, design) == Approx(expected).epsilon(1e-12));
  };
  is("rate", plain(spring.rate()) / 1e3);
  is("preload_force", plain(spring.rate()) * s1);
  is("working_force", plain(spring.rate()) * s2);
  is("stroke", 20);
  is("work", plain(spring.rate()) * (s1 + s2) / 2 * (s2 - s1));
  is("preload_stress", plain(spring.shear_stress(plain(spring.rate()) * s1)) / 1e6);
  is("working_stress", plain(spring.shear_stress(plain(spring.rate()) * s2)) / 1e6);
  is("stress_range", plain(spring.shear_stress(plain(spring.rate()) * (s2 - s1))) / 1e6);
  is("static_stress", plain(spring.uncorrected_stress(plain(spring.rate()) * s2)) / 1e6);
  is("solid_stress",
     plain(spring.uncorrected_stress(spring.rate() * (Expression(s2) + spring.least_gaps()))) /
         1e6);
  is("index", 12);
  is("outer_diameter", 26);
  is("inner_diameter", 22);
  is("solid_length", 21);
  is("working_length", 21 + 5.372);
  is("preload_length", 21 + 5.372 + 20);
  is("free_length", 21 + 5.372 + 30);
  is("buckling", plain(spring.buckling_fraction(s2, length, 1)));
  is("mass", plain(spring.mass()));
  is("active_mass", plain(spring.active_mass()));
  is("surge_frequency", plain(spring.surge_frequency()));
}

TEST_CASE("a spring that cannot be is not a design", "[springs]") {
  const TestDesign coil = design_of(helical(), "constant-velocity", {}, {"mean_diameter"});
  const auto rate = response_of(helical(), "rate", coil.binding).function();
  CHECK(std::isfinite(rate.value(std::vector{2.1})));
  CHECK(std::isnan(rate.value(std::vector{1.9})));
  const TestDesign stiff = design_of(helical(), "constant-velocity", {}, {"shear_modulus"});
  const auto buckling = response_of(helical(), "buckling", stiff.binding).function();
  CHECK(std::isfinite(buckling.value(std::vector{100.0})));
  CHECK(std::isnan(buckling.value(std::vector{206.0})));
  const TestDesign ring = design_of(discs(), "constant-velocity", {}, {"inner_diameter"});
  const auto force = response_of(discs(), "working_force", ring.binding).function();
  CHECK(std::isfinite(force.value(std::vector{49.0})));
  CHECK(std::isnan(force.value(std::vector{50.0})));
}

TEST_CASE("derivatives and shapes of the springs' problem files hold", "[springs][problem-files]") {
  for (const char* file : {"fewest_discs", "lightest_helical", "follower_spring"}) {
    INFO(file);
    const auto space = testing::shipped(std::string("springs/") + file + ".toml").space();
    const auto problem = space.problem(std::vector<std::size_t>(space.choices.size(), 0));
    const auto check = optim::check_derivatives(problem, problem.start());
    CHECK(check.agrees);
    CHECK(check.shapes.empty());
  }
}

TEST_CASE("the fewest disc springs are those of a count by hand", "[springs][problem-files]") {
  const PlainNumbers numbers;
  const DiscSpring disc{0.05, 0.0254, 0.002, 0.0014};
  // Of one disc: from where its force suffices to where its stress or its flattening ends it. Both
  // grow with the deflection, for h_0 / t < sqrt 2 the force does.
  const double h = plain(disc.cone_height);
  const double last = std::min(
      0.75 * h, root([&](double s) { return plain(disc.stress_lower_outer(s)) - 1100e6; }, 0, h));
  int fewest = 1000, ties = 0, best_parallel = 0;
  for (int n = 1; n <= 3; ++n) {
    const double first =
        std::max(0.15 * h, root([&](double s) { return n * plain(disc.force(s)) - 5500; }, 0, h));
    for (int i = 1; i <= 25; ++i) {
      if (i * (last - first) < 0.008 || n * i > fewest) continue;
      ties = n * i == fewest ? ties + 1 : 1;
      fewest = n * i, best_parallel = n;
    }
  }
  CHECK(ties == 1);
  const BoundProblem bound = testing::shipped("springs/fewest_discs.toml");
  const auto optimum = solved(bound);
  CHECK(optimum.combinations == 75);
  CHECK(optimum.found.assessment.objective.value == Approx(fewest));
  const ProblemStatement best = bound.at(optimum.options, optimum.found.x);
  CHECK(best.constants[discs().parameter("parallel")] == best_parallel);
  CHECK(best.constants[discs().parameter("series")] == fewest / best_parallel);
}

TEST_CASE("the lightest helical spring of a rate is as wide as it may be",
          "[springs][problem-files]") {
  // At the force F = R s the stress gives d = sqrt(8 k w F / (pi tau)), and d (w + 1) = 40 mm.
  const double rate = 20e3, force = rate * 0.03, stress = 700e6;
  const auto wire = [&](double w) {
    return std::sqrt(8 * (w + 0.5) / (w - 0.75) * w * force / (kPi * stress));
  };
  const double w = root([&](double x) { return wire(x) * (x + 1) - 0.04; }, 3, 30), d = wire(w);
  const PlainNumbers numbers;
  const HelicalSpring spring{d, w * d, 81.5e9 * d / (8 * w * w * w * rate)};
  CHECK(plain(spring.rate()) == Approx(rate));
  const BoundProblem bound = testing::shipped("springs/lightest_helical.toml");
  const auto optimum = solved(bound);
  CHECK(optimum.found.assessment.objective.value ==
        Approx(plain(spring.active_mass())).epsilon(1e-8));
  CHECK(optimum.found.x[0] == Approx(d * 1e3).epsilon(1e-6));
  CHECK(optimum.found.x[1] == Approx(w * d * 1e3).epsilon(1e-6));
  CHECK(optimum.found.x[2] == Approx(plain(spring.active_coils)).epsilon(1e-6));
  // Of the springs with that rate and stress all narrower ones are heavier.
  for (double x = 3; x < w; x += 0.25) {
    const double thin = wire(x);
    const HelicalSpring other{thin, x * thin, 81.5e9 * thin / (8 * x * x * x * rate)};
    CHECK(plain(other.active_mass()) > plain(spring.active_mass()));
  }
}

TEST_CASE("the lightest follower spring and what its limits cost are the closed form's",
          "[springs][problem-files]") {
  const FollowerSpring best;
  CHECK(best.rate() > best.preload / best.stroke);  // the surge frequency asks for more
  const auto optimum = solved(testing::shipped("springs/follower_spring.toml"));
  const auto& x = optimum.found.x;
  CHECK(optimum.found.assessment.objective.value == Approx(best.mass()).epsilon(1e-8));
  CHECK(x[0] == Approx(best.wire() * 1e3).epsilon(1e-6));
  CHECK(x[1] == Approx(best.index * best.wire() * 1e3).epsilon(1e-6));
  CHECK(x[2] == Approx(best.coils()).epsilon(1e-6));
  CHECK(x[3] == Approx(best.preload / best.rate() * 1e3).epsilon(1e-6));
  CHECK(x[4] == Approx(best.force() / best.rate() * 1e3).epsilon(1e-6));
  // The price of a limit is the slope of the closed form.
  const auto price = [&](double FollowerSpring::*limit, double unit) {
    const double h = 1e-4 * best.*limit;
    return std::abs(testing::slope(
                        [&](double t) {
                          FollowerSpring other = best;
                          other.*limit += t * h;
                          return other.mass();
                        },
                        1) /
                    h * unit);
  };
  const auto& limits = optimum.found.assessment.limits;
  REQUIRE(limits.size() == 5);
  CHECK(limits[0].multiplier == Approx(price(&FollowerSpring::stroke, 1e-3)).epsilon(1e-5));
  CHECK(limits[1].multiplier == Approx(price(&FollowerSpring::preload, 1)).epsilon(1e-5));
  CHECK(limits[2].multiplier == Approx(price(&FollowerSpring::stress, 1e6)).epsilon(1e-5));
  CHECK(limits[3].multiplier == Approx(price(&FollowerSpring::index, 1)).epsilon(1e-5));
  CHECK(limits[4].multiplier == Approx(price(&FollowerSpring::surge, 1)).epsilon(1e-5));
  // Without the surge the force doubles over the lift.
  FollowerSpring slow = best;
  slow.surge = 1;
  CHECK(slow.force() == Approx(2 * slow.preload));
  CHECK(slow.mass() < best.mass());
}

}  // namespace camlaw::problems::springs_test
