// SPDX-License-Identifier: MIT
// What no law passes, as the ruler of fronts over B, C and D.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "kinematics/peaks.h"
#include "problems/fronts/front_study.h"
#include "problems/fronts/ruler.h"
#include "tests/problems/front_files.h"
#include "tests/sets/fronts/known_fronts.h"

namespace camlaw::problems::front_ruler_test {
namespace {

using optim::Costs;
using testing::front_of;
using testing::kCutter;
using testing::kLaw;
using testing::shipped_front;

/// A law whose acceleration is continuous, into rest as well.
const std::string kSmoothLaw =
    "mechanism = 'law'\n[law]\nname = 'polynomial-7'\n"
    "[variables.A]\nlower = 6\nupper = 60\nstart = 40\n";

std::optional<FrontRuler> ruler_of(const std::string& text) {
  return front_ruler(read_problem(text, "f.toml"));
}

/// What the ruler of B and C says, by a dense list of points of its own curve.
double by_points(const FrontRuler& ruler, const Costs& reference) {
  const auto [velocity, acceleration] = ruler.pair();
  std::vector<std::pair<double, double>> points;
  const double most = reference[velocity.objective] / velocity.factor;
  constexpr int kPoints = 400'000;
  for (int i = 1; i <= kPoints; ++i) {
    const double v = (1 + (most - 1) * i / kPoints) * velocity.factor;
    const double a = ruler.least(v);
    if (a < reference[acceleration.objective]) points.emplace_back(v, a);
  }
  return sets::area_dominated(points, reference[velocity.objective],
                              reference[acceleration.objective]);
}

/// The measure of what lambda <= 1 allows up to a reference, by counting: of an even grid of
/// values (two objectives) or of values by chance (three).
double by_counting(const FrontRuler& ruler, const Costs& low, const Costs& reference, int count) {
  std::mt19937_64 random(7);
  double box = 1;
  for (std::size_t i = 0; i < low.size(); ++i) box *= reference[i] - low[i];
  long inside = 0;
  for (int i = 0; i < count; ++i) {
    Costs values;
    for (std::size_t k = 0; k < low.size(); ++k) {
      values.push_back(std::uniform_real_distribution<>(low[k], reference[k])(random));
    }
    inside += ruler.limit_index(values) <= 1;
  }
  return box * static_cast<double>(inside) / count;
}

}  // namespace

TEST_CASE("the ruler of the spine cutter: radius by B, force by C", "[fronts]") {
  const std::string R = "minimize minimum_cam_radius", F = "minimize peak_inertia_force";
  for (const bool swapped : {false, true}) {
    const auto ruler = ruler_of(swapped ? front_of(kCutter, {F, R}) : front_of(kCutter, {R, F}));
    REQUIRE(ruler);
    CHECK(ruler->pair().first.objective == (swapped ? 1 : 0));
    CHECK(ruler->pair().second.objective == (swapped ? 0 : 1));
  }
  const FrontStudy study(shipped_front(), "front.toml", {.points = 12});
  const auto ruler = front_ruler(study.bound().statement());
  REQUIRE(ruler);
  const optim::Front front = optim::pareto(study.space(), study.options());
  // No law is below, and the areas agree.
  for (const auto& p : front.points) {
    CHECK(p.costs[1] >= ruler->least(p.costs[0]) * (1 - 1e-9));
    const Member law = *study.law(p);
    CHECK(p.costs[0] ==
          Approx(ruler->pair().first.factor * peaks(law.law()).max_velocity()).epsilon(1e-9));
    CHECK(p.costs[1] ==
          Approx(ruler->pair().second.factor * peaks(law.law()).max_acceleration()).epsilon(1e-9));
  }
  CHECK(front.hypervolume < ruler->hypervolume(front.reference));
  CHECK(ruler->hypervolume(front.reference) ==
        Approx(by_points(*ruler, front.reference)).epsilon(1e-4));
}

TEST_CASE("the ruler of a law alone: B and C themselves", "[fronts]") {
  const auto ruler = ruler_of(front_of(kLaw, {"minimize B", "minimize C"}));
  REQUIRE(ruler);
  CHECK(ruler->pair().first.factor == Approx(1).epsilon(1e-12));
  CHECK(ruler->pair().second.factor == Approx(1).epsilon(1e-12));
  for (const Costs& reference :
       std::vector<Costs>{{1.5, 6}, {1.9, 5}, {2, 4.2}, {2.5, 6}, {3, 100}, {1.05, 100}}) {
    CHECK(ruler->hypervolume(reference) ==
          Approx(by_points(*ruler, reference)).epsilon(2e-4).margin(1e-4));
  }
  // Beyond what any law reaches there is nothing.
  for (const Costs& reference :
       std::vector<Costs>{{1, 100}, {0.5, 6}, {3, 4}, {3, 3}, {1.2, 7.1}, {-1, -1}}) {
    CHECK(ruler->hypervolume(reference) == 0);
  }
  // However far the reference: (B - 2) (C - 4) and a little at its edge.
  for (const double far : {1e6, 1e9, 1e12, 1e16, 1e18}) {
    INFO(far);
    CHECK(ruler->hypervolume({3, far}) == Approx(2 * far).epsilon(1e-4));
    CHECK(ruler->hypervolume({far, 6}) == Approx(2 * far).epsilon(1e-4));
  }
}

TEST_CASE("the rulers of jerk: with velocity, with acceleration, with both", "[fronts]") {
  struct Case {
    std::vector<std::string> objectives;
    Costs low, reference;
  };
  const std::vector<Case> cases{
      {{"minimize B", "minimize D"}, {1, 32}, {2.5, 300}},
      {{"minimize B", "minimize D"}, {1, 32}, {1.4, 4000}},
      {{"minimize C", "minimize D"}, {4, 32}, {7, 90}},
      {{"minimize D", "minimize C"}, {32, 4}, {60, 12}},
      {{"minimize B", "minimize C", "minimize D"}, {1, 4, 32}, {1.8, 7, 200}},
      {{"minimize D", "minimize B", "minimize C"}, {32, 1, 4}, {500, 2.4, 15}},
      {{"minimize C", "minimize B", "minimize D"}, {4, 1, 32}, {40, 1.3, 900}},
  };
  for (const Case& one : cases) {
    const auto ruler = ruler_of(front_of(kSmoothLaw, one.objectives));
    REQUIRE(ruler);
    const double limit = ruler->hypervolume(one.reference);
    INFO(limit << " up to " << one.reference.back());
    CHECK(limit > 0);
    CHECK(limit == Approx(by_counting(*ruler, one.low, one.reference, 400'000)).epsilon(0.01));
    // Up to the least that there is, nothing is left.
    CHECK(ruler->hypervolume(one.low) == 0);
  }
  const auto of_both = ruler_of(front_of(kSmoothLaw, {"minimize B", "minimize D"}));
  for (const double b : {1.1, 1.5, 1.9, 2.0, 2.7}) {
    CHECK(of_both->limit_index({b, of_both->least(b)}) == Approx(1).epsilon(1e-12));
  }
  CHECK(of_both->least(2) == Approx(32).epsilon(1e-14));
  // No law passes it, the S-curve of least jerk comes near.
  const Law<double> law = find_law("poly-3-4-5").law();
  const Peaks<double> its = peaks(law);
  CHECK(of_both->limit_index({its.max_velocity(), its.max_jerk()}) < 1);
}

TEST_CASE("other pairs have no ruler", "[fronts]") {
  const std::string R = "minimize minimum_cam_radius", F = "minimize peak_inertia_force",
                    M = "minimize peak_drive_torque";
  CHECK_FALSE(ruler_of(front_of(kCutter, {R, M})));
  CHECK_FALSE(ruler_of(front_of(kCutter, {M, F})));
  CHECK_FALSE(ruler_of(front_of(kCutter, {R, F, M})));
  CHECK_FALSE(ruler_of(front_of(kCutter, {R, "maximize lowest inertia_force"})));
  CHECK_FALSE(ruler_of(front_of(kLaw, {"minimize C", "minimize Cm"})));
  CHECK_FALSE(ruler_of(front_of(kLaw, {"minimize B", "minimize highest acceleration"})));
  CHECK_FALSE(ruler_of(kCutter + "[objective]\nminimize = 'minimum_cam_radius'\n"));
  // The same two by other words.
  CHECK(ruler_of(
      front_of(kCutter, {"minimize peak required_cam_radius", "minimize peak inertia_force"})));
}

TEST_CASE("what moves the objectives beside the law takes the ruler away", "[fronts]") {
  const std::vector<std::string> both{"minimize minimum_cam_radius", "minimize peak_inertia_force"};
  const auto with = [&](const std::string& name, const std::string& bounds) {
    return ruler_of(front_of(kCutter + "[variables." + name + "]\n" + bounds, both));
  };
  CHECK_FALSE(with("mass", "lower = '1 kg'\nupper = '3 kg'\n"));
  CHECK_FALSE(with("stroke", "lower = '30 mm'\nupper = '50 mm'\n"));
  CHECK_FALSE(with("pressure_angle", "lower = '20 deg'\nupper = '40 deg'\n"));
  CHECK_FALSE(with("mass", "values = ['1 kg', '3 kg']\n"));
  // What moves neither leaves it.
  CHECK(with("blades", "values = [17, 21]\n"));
}

TEST_CASE("the ruler is of laws from rest to rest", "[fronts]") {
  const auto of_law = [](const std::string& law) {
    return ruler_of(front_of("mechanism = 'law'\n[law]\n" + law, {"minimize B", "minimize C"}));
  };
  const std::string bounds = "lower = 0\nupper = 1\nstart = 0\n";
  CHECK(of_law("name = 'boundary-5'\n[variables.a0]\n" + bounds));
  CHECK_FALSE(of_law("name = 'boundary-5'\nv0 = 0.5\n[variables.a0]\n" + bounds));
  CHECK_FALSE(of_law("name = 'boundary-5'\n[variables.v0]\n" + bounds));
  CHECK_FALSE(of_law("name = 'boundary-5'\n[variables.v1]\n" + bounds));
  CHECK_FALSE(
      of_law("name = ['polynomial-5', 'constant-velocity']\n[variables.alpha]\n"
             "lower = -5\nupper = 5\nstart = -3\n"));
  CHECK(
      of_law("name = ['polynomial-5', 'cycloidal']\n[variables.alpha]\n"
             "lower = -5\nupper = 5\nstart = -3\n"));
}

TEST_CASE("the ruler is of laws without jumps of the velocity, that of jerk of none", "[fronts]") {
  const auto of_law = [](const std::string& law, const std::string& other) {
    return ruler_of(front_of("mechanism = 'law'\n[law]\n" + law, {"minimize B", other}))
        .has_value();
  };
  const std::string bounds = "[variables.'coefficients[3]']\nlower = 0.3\nupper = 0.6\n";
  const std::string jumping =
      "name = 'b-spline degree=2 knots=0.5,0.5 coefficients=0,0,0.4,1,1'\n" + bounds;
  CHECK_FALSE(of_law(jumping, "minimize C"));
  const std::string meeting =
      "name = 'b-spline degree=2 knots=0.25,0.5,0.75 coefficients=0,0,0.5,0.5,1,1'\n" + bounds;
  CHECK(of_law(meeting, "minimize C"));
  // The acceleration jumps at rest, inside, or not at all.
  CHECK_FALSE(ruler_of(front_of(kLaw, {"minimize B", "minimize D"})));
  CHECK_FALSE(ruler_of(front_of(kLaw, {"minimize B", "minimize peak jerk"})));
  CHECK_FALSE(of_law(meeting, "minimize D"));
  const std::string free = "name = 'free'\n[free]\nknots = 3\n";
  CHECK(of_law(free, "minimize D"));
  CHECK_FALSE(of_law(free + "begin = 'U'\n", "minimize D"));
}

}  // namespace camlaw::problems::front_ruler_test
