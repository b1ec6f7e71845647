// SPDX-License-Identifier: MIT
// The problem files that ship, and the analytic limit of all laws, solved and compared with answers
// from elsewhere: closed forms, and searches over the exact peaks of laws.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "kinematics/laws/polynomial.h"
#include "kinematics/peaks.h"
#include "machines/model/law_binding.h"
#include "machines/registry.h"
#include "machines/spine_cutter.h"
#include "optim/problem/check_derivatives.h"
#include "optim/search/optimise.h"
#include "optim/verdict/verdict.h"
#include "problems/statement/bind.h"
#include "tests/paths.h"
#include "tests/plain.h"

namespace camlaw::problems::problem_files_test {
namespace {

using optim::Optimum;
using optim::Verdict;

/// "least_radius.toml" of the spine cutter, or "cams/flat_least_base.toml".
BoundProblem shipped(const std::string& name) {
  const std::string folder = name.find('/') == std::string::npos ? "spine_cutter/" : "";
  return BoundProblem(read_problem_file(testing::source("problems/") + folder + name));
}

const std::vector<const char*> kShipped = {"least_radius.toml",
                                           "least_force.toml",
                                           "least_force_legendre.toml",
                                           "least_moment.toml",
                                           "cutter.toml",
                                           "cams/roller_least_base.toml",
                                           "cams/flat_least_base.toml",
                                           "cams/end_rise_share.toml",
                                           "cams/oscillating_least_peak_angle.toml",
                                           "cams/oscillating_flat_least_base.toml",
                                           "cams/oscillating_end_least_radius.toml",
                                           "cams/linear_least_travel.toml",
                                           "cams/knife_edge_convex_base.toml",
                                           "cams/groove_least_stress.toml",
                                           "cams/conjugate_least_distance.toml",
                                           "cams/leading_least_base.toml",
                                           "cams/roller_from_catalogue.toml",
                                           "cams/free_rise_least_base.toml",
                                           "cams/load_cases.toml",
                                           "cams/speed_range.toml",
                                           "cams/tolerances.toml",
                                           "springs/lightest_helical.toml",
                                           "springs/follower_spring.toml",
                                           "balancing_cam/fewest_springs_spherical.toml",
                                           "balancing_cam/least_stress.toml",
                                           "geneva/fastest.toml",
                                           "geneva/fastest_spherical.toml",
                                           "die_press/least_approach.toml",
                                           "sheet_delivery/greatest_least_efficiency.toml",
                                           "signature_feeder/least_acceleration.toml",
                                           "own/slider_crank.toml",
                                           "own/bearing_load.toml",
                                           "shaft/two_cams.toml",
                                           "servo_axis/pick_and_place.toml",
                                           "servo_axis/cross_sealer.toml",
                                           "servo_axis/fastest_cycle.toml",
                                           "index_drives/parallel_eight.toml",
                                           "index_drives/barrel_eight.toml",
                                           "index_drives/globoidal_eight.toml"};

/// The machine of the force problems: SI units.
SpineCutter force_cutter() {
  SpineCutter cutter;
  cutter.stroke = 0.04, cutter.block_speed = 0.3, cutter.depth = 0.001, cutter.mass = 2.4;
  return cutter;
}
using testing::plain, testing::PlainNumbers;

TEST_CASE("every problem file is certified by our own verdict", "[problem-files][long]") {
  for (const char* name : kShipped) {
    INFO(name);
    const Optimum optimum = optim::optimise(shipped(name).space());
    const optim::Assessment& a = optimum.found.assessment;
    CHECK(a.verdict == Verdict::Certified);
    CHECK(a.kkt_residual <= optim::kKktTolerance);
    for (const optim::LimitReport& limit : a.limits) CHECK(limit.proved);
  }
}

TEST_CASE("derivatives and shapes of every problem file hold", "[problem-files]") {
  for (const char* name : kShipped) {
    INFO(name);
    const auto space = shipped(name).space();
    const auto problem = space.problem(std::vector<std::size_t>(space.choices.size(), 0));
    const auto check = optim::check_derivatives(problem, problem.start());
    CHECK(check.agrees);
    CHECK(check.shapes.empty());
  }
}

TEST_CASE("the least radius from the 3-4-5 to the cubic is the cubic's", "[problem-files]") {
  // B = 1.5 - 0.0375 alpha for alpha in [-10, 0]: least at 0. R = S B / (pi tan v).
  const Optimum optimum = optim::optimise(shipped("least_radius.toml").space());
  const double slope = std::tan(std::numbers::pi / 6);
  const double radius = 40 * 1.5 / (std::numbers::pi * slope);
  CHECK(optimum.found.x[0] == Approx(0).margin(1e-9));
  CHECK(optimum.found.x[1] == Approx(radius).epsilon(1e-9));
  CHECK(optimum.found.assessment.global);
  // One degree more: dR/dv = -R (1 + tan^2 v) / tan v.
  const double price = radius * (1 + slope * slope) / slope * std::numbers::pi / 180;
  CHECK(optimum.found.assessment.limits[0].multiplier == Approx(price).epsilon(1e-6));
}

TEST_CASE("the least force is that of alpha = -10/3", "[problem-files]") {
  const PlainNumbers numbers;
  // s'' = u (9 - 5 u^2) with u = 1 - 2x: greatest at u^2 = 3/5, C = 6 sqrt(3/5), where alpha does
  // not move it: d s''/d alpha = 0.6 P3(u) = 0.3 u (5 u^2 - 3) vanishes there.
  const Optimum optimum = optim::optimise(shipped("least_force.toml").space());
  const double C = 6 * std::sqrt(0.6);
  CHECK(optimum.found.x[0] == Approx(-10.0 / 3).epsilon(1e-8));
  CHECK(optimum.found.assessment.objective.value ==
        Approx(plain(force_cutter().peak_inertia_force(C))).epsilon(1e-10));
  for (double alpha = -10; alpha <= 10; alpha += 0.25) {
    CHECK(peaks(polynomial_5(alpha)).max_acceleration() >= C * (1 - 1e-12));
  }
}

TEST_CASE("the least force over Legendre laws has no better neighbour", "[problem-files]") {
  const PlainNumbers numbers;
  const SpineCutter cutter = force_cutter();
  const Optimum optimum = optim::optimise(shipped("least_force_legendre.toml").space());
  const auto& x = optimum.found.x;
  const auto best = peaks(legendre<double>(x));
  CHECK(optimum.found.assessment.objective.value ==
        Approx(plain(cutter.peak_inertia_force(best.max_acceleration()))).epsilon(1e-9));
  CHECK(plain(cutter.minimum_cam_radius(best.max_velocity())) == Approx(0.036).epsilon(1e-8));
  CHECK(optimum.found.assessment.global);
  // Linear programming on 4001 even x, a bound from below: 6.735524760 N.
  CHECK(optimum.found.assessment.objective.value >= 6.735524759);
  CHECK(optimum.found.assessment.objective.value == Approx(6.735524760).epsilon(1e-6));
  // The problem is convex: a design that is no worse than its neighbours all round is the best.
  for (int i = 0; i < 81; ++i) {
    for (const double step : {1e-3, 1e-1}) {
      std::vector<double> c = x;
      for (int k = 0, digits = i; k < 4; ++k, digits /= 3) {
        c[static_cast<std::size_t>(k)] += step * (digits % 3 - 1);
      }
      const auto other = peaks(legendre<double>(c));
      const bool fits = plain(cutter.minimum_cam_radius(other.max_velocity())) <= 0.036;
      CHECK((!fits || other.max_acceleration() >= best.max_acceleration() * (1 - 1e-9)));
    }
  }
}

TEST_CASE("the least moment is below every other on a grid", "[problem-files]") {
  const PlainNumbers numbers;
  const Optimum optimum = optim::optimise(shipped("least_moment.toml").space());
  const double Cm = peaks(legendre<double>(optimum.found.x)).max_dynamic_moment();
  CHECK(optimum.found.assessment.objective.value ==
        Approx(plain(force_cutter().peak_drive_torque(Cm))).epsilon(1e-9));
  for (double c3 = -8; c3 <= 8; c3 += 0.5) {
    for (double c5 = -8; c5 <= 8; c5 += 0.5) {
      CHECK(peaks(legendre<double>({c3, c5})).max_dynamic_moment() >= Cm * (1 - 1e-9));
    }
  }
}

TEST_CASE("the cutter has all the blades and the diameter at which one is in contact",
          "[problem-files]") {
  // z psi = 2 pi with sin(psi / 2)^2 = 4 h (D - h) / D^2: D = 2 h (1 + cos(pi / z)) / sin^2(pi /
  // z).
  const BoundProblem bound = shipped("cutter.toml");
  const Optimum optimum = optim::optimise(bound.space());
  REQUIRE(bound.space().choices.size() == 1);
  CHECK(bound.space().choices[0].values[optimum.options[0]] == 24);
  const double angle = std::numbers::pi / 24;
  const double diameter = 2 * 0.4 * (1 + std::cos(angle)) / std::pow(std::sin(angle), 2);
  CHECK(optimum.found.x[0] == Approx(diameter).epsilon(1e-8));
}

/// Least C at B <= b over splines with even knots, by default quadratic ones.
Optimum least_acceleration(double b, std::size_t knots, std::size_t degree = 2,
                           const std::string& solver = "auto") {
  Member member = find_law("b-spline");
  auto& values = member.arguments.values();
  values[0] = {static_cast<double>(degree)};
  values[1].clear();
  for (std::size_t i = 1; i <= knots; ++i) {
    values[1].push_back(static_cast<double>(i) / static_cast<double>(knots + 1));
  }
  const std::size_t count = knots + degree + 1;
  values[2].assign(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    values[2][i] = static_cast<double>(i) / static_cast<double>(count - 1);
  }
  values[2][1] = 0;          // at rest in the beginning
  values[2][count - 2] = 1;  // and in the end
  std::vector<LawVariable> variables;
  optim::Problem problem;
  for (std::size_t i = 2; i + 2 < count; ++i) {
    variables.push_back({2, i, variables.size()});
    problem.variables.push_back(
        {.name = "c", .lower = -1, .upper = 2, .start = values[2][i], .scale = 0.1});
  }
  const Mechanism& law = find_mechanism("law");
  Binding binding{{}, {}, {}, std::make_shared<LawBinding>(member, variables)};
  for (const auto& parameter : law.parameters) binding.constants.push_back(parameter.default_value);
  problem.objectives = {{make_response(law, find_response(law, "acceleration"), binding),
                         optim::Sense::Minimize, optim::Part::Magnitude}};
  problem.constraints = {{make_response(law, find_response(law, "velocity"), binding), {}, b}};
  return optim::optimise(problem, {.solver = solver});
}

TEST_CASE("the free law is certified where an interior point leaves every limit a little slack",
          "[problem-files]") {
  // Along plateaus of v and a many limits are met to 1e-8 and none exactly.
  struct Case {
    std::size_t knots, degree;
  };
  const double limit = 4.5;  // b^2 / (b - 1)
  for (const Case& c : {Case{31, 2}, Case{63, 2}, Case{15, 3}, Case{15, 5}}) {
    INFO(c.knots << " knots, degree " << c.degree);
    const Optimum optimum = least_acceleration(1.5, c.knots, c.degree, "ipopt");
    CHECK(optimum.found.assessment.verdict == Verdict::Certified);
    CHECK(optimum.found.assessment.global);
    CHECK(optimum.found.assessment.objective.value >= limit);
    CHECK(optimum.found.assessment.objective.value <= limit * 1.01);
  }
}

TEST_CASE("the free law approaches the least acceleration b^2 / (b - 1) as knots grow",
          "[problem-files]") {
  for (const double b : {1.5, 1.8}) {
    const double limit = b * b / (b - 1);
    double last = optim::kInfinity;
    for (const std::size_t knots : {7, 15, 31}) {
      INFO(b << " with " << knots);
      const Optimum optimum = least_acceleration(b, knots);
      const double C = optimum.found.assessment.objective.value;
      CHECK(optimum.found.assessment.verdict == Verdict::Certified);
      CHECK(optimum.found.assessment.global);
      CHECK(C >= limit * (1 - 1e-9));
      CHECK(C <= last * (1 + 1e-9));
      last = C;
    }
    CHECK(last <= limit * 1.01);
  }
}

}  // namespace
}  // namespace camlaw::problems::problem_files_test
