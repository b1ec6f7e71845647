// SPDX-License-Identifier: MIT
// The life of a roller's bearing on each roller cam, from its curves summed up over the turn.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>

#include "machines/registry.h"
#include "tests/machines/system_fixture.h"

namespace camlaw::problems::roller_life_test {
namespace {

constexpr double kPi = std::numbers::pi, kExponent = 10.0 / 3;
constexpr int kPoints = 36000;

ProblemStatement program_of(const std::string& mechanism, const std::string& constants) {
  return read_problem("mechanism = \"" + mechanism + "\"\n[constants]\n" + constants + R"(
[[program.segments]]
name = "rise"
law = "poly-4-5-6-7"
angle = "100 deg"
[[program.segments]]
name = "high"
angle = "50 deg"
[[program.segments]]
name = "return"
law = "modified-sine"
angle = "120 deg"
[[program.segments]]
name = "low"
)",
                      "cam");
}

std::map<std::string, double> numbers_of(const ProblemStatement& statement) {
  std::map<std::string, double> all;
  for (const EvaluatedResponse& r : evaluate(statement)) {
    all[r.name] = r.is_curve ? r.highest : r.value;
  }
  return all;
}

struct Curves {
  explicit Curves(const ProblemStatement& statement) : all(curves_of(statement)) {
    for (const auto& response : all) traces.push_back(response.curve().trace({}));
  }
  double at(const std::string& name, double degrees) const {
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].name == name) return traces[i]->at({degrees})[0];
    }
    FAIL("no curve " << name);
    return 0;
  }
  std::vector<optim::Response> all;
  std::vector<std::unique_ptr<optim::Trace>> traces;
};

struct RollerCase {
  const char *mechanism, *constants;
  double speed, turning = 0;  ///< rpm of the cam, and what it turns under a follower in a groove
};

const RollerCase kCases[] = {
    {"disc-cam-roller", "speed = 200\nspring_preload = 400\noffset = 5\n", 200},
    {"disc-cam-roller", "speed = 300\nspring_preload = 0\nspring_rate = 0\nload = 30\n", 300, 1},
    {"disc-cam-oscillating-roller", "speed = 200\nspring_preload = 20\n", 200},
    {"disc-cam-leading-roller", "speed = 200\nspring_preload = 20\n", 200},
    {"end-cam", "speed = 250\nmass = 3\nload = 20\n", 250},  // a groove: both flanks bear
    {"end-cam-oscillating", "speed = 250\ninertia = 0.02\nspring_preload = 60\n", 250},
    {"linear-cam", "speed = 200\nspring_preload = 400\n", 200}};

}  // namespace

TEST_CASE("a roller's life is that of its force and speed summed up over the turn", "[cams]") {
  for (const RollerCase& of : kCases) {
    INFO(of.mechanism);
    const ProblemStatement statement = program_of(of.mechanism, of.constants);
    const auto found = numbers_of(statement);
    const Curves curves(statement);
    double damage = 0, turns = 0, fastest = 0;
    for (int i = 0; i < kPoints; ++i) {
      const double place = 360 * (i + 0.5) / kPoints;
      const double own = curves.at("roller_speed", place);
      const double force = curves.at("contact_force", place);
      // On the outer flank of a groove the roller turns the other way.
      const double speed = own + (force < 0 ? 2 * of.turning * of.speed : 0);
      damage += std::pow(std::abs(force), kExponent) * speed / kPoints;
      turns += speed / kPoints;
      fastest = std::max(fastest, own);
    }
    const double load = std::pow(damage / turns, 1 / kExponent);
    const double millions = std::pow(10000 / load, kExponent);  // C = 10 kN
    CHECK(found.at("equivalent_load") == Approx(load).epsilon(1e-5));
    CHECK(found.at("life_revolutions") == Approx(millions).epsilon(1e-5));
    CHECK(found.at("life") == Approx(millions * 1e6 / turns / 60).epsilon(1e-5));
    CHECK(found.at("roller_speed") == Approx(fastest).epsilon(1e-4));
    CHECK(found.at("speed_fraction") == Approx(fastest / 6000).epsilon(1e-4));
  }
}

TEST_CASE("a roller on a cam that does not move its follower has one load and one speed",
          "[cams]") {
  const auto found =
      numbers_of(program_of("disc-cam-roller",
                            "stroke = 1e-6\nspring_preload = 2000\nspeed = 150\nbase_radius = 60\n"
                            "roller_radius = 15\nface_width = 20\nviscosity = 80\n"));
  CHECK(found.at("equivalent_load") == Approx(2000).epsilon(1e-6));
  CHECK(found.at("roller_speed") == Approx(150 * 60.0 / 15).epsilon(1e-6));
  CHECK(found.at("static_fraction") == Approx(0.2).epsilon(1e-6));
  CHECK(found.at("life_revolutions") == Approx(std::pow(5, kExponent)).epsilon(1e-6));
  CHECK(found.at("life") == Approx(std::pow(5, kExponent) * 1e6 / (600 * 60)).epsilon(1e-6));
  // Two cylinders of 60 and 15 mm: R = 12 mm, w = 100 N/mm, u = omega 60 mm.
  const double modulus = 2.1e11 / 0.91, load = 1e5, radius = 0.012, speed = 5 * kPi * 0.06;
  const double pressure = std::sqrt(load * modulus / (2 * kPi * radius));
  CHECK(found.at("contact_stress") == Approx(pressure / 1e6).epsilon(1e-6));
  CHECK(found.at("max_shear") == Approx(0.300283 * pressure / 1e6).epsilon(1e-5));
  const double width = std::sqrt(8 * load * radius / (kPi * modulus));
  CHECK(found.at("shear_depth") == Approx(0.786151 * width * 1e3).epsilon(1e-5));
  const double film = 2.65 * std::pow(2e-8, 0.54) * std::pow(0.08 * speed, 0.7) *
                      std::pow(radius, 0.43) / (std::pow(modulus, 0.03) * std::pow(load, 0.13));
  CHECK(found.at("film_thickness") == Approx(film * 1e6).epsilon(1e-6));
  CHECK(found.at("lambda_ratio") == Approx(film / 4e-7).epsilon(1e-6));
}

TEST_CASE("a flatter crown presses less over a longer contact", "[cams]") {
  const auto with = [](const char* crown) {
    return numbers_of(program_of("disc-cam-roller", std::string("spring_preload = 400\n") + crown));
  };
  const auto round = with("crown_radius = 100\n"), flat = with("crown_radius = 1000\n");
  CHECK(flat.at("crown_stress") < round.at("crown_stress"));
  CHECK(flat.at("crown_half_length") > 1.5 * round.at("crown_half_length"));
  CHECK(flat.at("crown_fraction") == Approx(flat.at("crown_half_length") / 7.5));
}

TEST_CASE("a roller's life has exact derivatives and close bounds", "[cams]") {
  const Mechanism& cam = find_mechanism("disc-cam-roller");
  testing::TestDesign design = testing::design_of(cam, "legendre c=-3,1", {"c"},
                                                  {"base_radius", "roller_radius", "spring_rate"});
  design.binding.constants[cam.parameter("spring_preload")] = 900;
  for (const char* name : {"life", "equivalent_load", "life_revolutions"}) {
    INFO(name);
    const auto f = testing::response_of(cam, name, design.binding).function();
    testing::check_derivatives(f, design.x, 1e-3, 1e-6);
    const auto bounds = f.enclose(design.x);
    const double value = f.value(design.x);
    CHECK((bounds.lower <= value && value <= bounds.upper));
    CHECK(bounds.upper - bounds.lower < 1e-6 * value);
  }
}

}  // namespace camlaw::problems::roller_life_test
