// SPDX-License-Identifier: MIT
// The life of a roller's bearing on each roller cam, from its curves summed up over the turn.
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
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

double lowest_of(const ProblemStatement& statement, const std::string& name) {
  for (const EvaluatedResponse& r : evaluate(statement)) {
    if (r.name == name) return r.lowest;
  }
  return std::nan("");
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

namespace {

/// A pair in which both cams bear, off the line of the shaft and with friction in the guide.
const char* const kPair =
    "speed = 400\nmass = 3\nload = 40\nspring_rate = 1\noffset = 6\nguide_friction = 0.1\n";

/// How far a roller goes on its own cam by radian, m, per m of its radius, and the cam's turn less:
/// from where its centre is, `below` m under the main one.
double turns_of_drawn(const Curves& curves, double degrees, double below) {
  const double base = 0.05, offset = 0.006, lowest = std::sqrt(base * base - offset * offset);
  const auto centre = [&](double at) {
    const double angle = at * kPi / 180;
    const std::complex<double> seen(offset, lowest + curves.at("displacement", at) / 1000 - below);
    return seen * std::polar(1.0, -angle);
  };
  const double h = 1e-3;
  const double way = std::abs(centre(degrees + h) - centre(degrees - h)) / (2 * h * kPi / 180);
  return way / 0.01 - 1;
}

}  // namespace

TEST_CASE("each roller of a pair bears its own part of the cycle", "[cams]") {
  const ProblemStatement statement = program_of("disc-cam-conjugate", kPair);
  const auto found = numbers_of(statement);
  const Curves curves(statement);
  struct Roller {
    double damage = 0, turns = 0, bears = 0;
  } main, second;
  for (int i = 0; i < kPoints; ++i) {
    const double place = 360 * (i + 0.5) / kPoints;
    const double force = curves.at("contact_force", place);
    const double of_main = curves.at("roller_speed", place) / 400;
    const double of_second = curves.at("second_roller_speed", place) / 400;
    if (i % 100 == 0) {
      CHECK(of_main == Approx(turns_of_drawn(curves, place, 0)).epsilon(1e-6));
      CHECK(of_second == Approx(turns_of_drawn(curves, place, 0.14)).epsilon(1e-6));
    }
    Roller& loaded = force > 0 ? main : second;
    loaded.damage +=
        std::pow(std::abs(force), kExponent) * (force > 0 ? of_main : of_second) / kPoints;
    loaded.bears += 1.0 / kPoints;
    main.turns += of_main / kPoints, second.turns += of_second / kPoints;
  }
  CHECK(main.bears > 0.1);
  CHECK(second.bears > 0.1);
  for (const auto& [roller, of] :
       {std::pair(main, std::string()), std::pair(second, std::string("second_"))}) {
    const double load = std::pow(roller.damage / roller.turns, 1 / kExponent);
    const double millions = std::pow(10000 / load, kExponent);
    CHECK(found.at(of + "equivalent_load") == Approx(load).epsilon(1e-5));
    CHECK(found.at(of + "life_revolutions") == Approx(millions).epsilon(1e-5));
    CHECK(found.at(of + "life") ==
          Approx(millions * 1e6 / (400 * roller.turns) / 60).epsilon(1e-5));
    CHECK(found.at(of + "speed_fraction") == Approx(found.at(of + "roller_speed") / 6000));
  }
  CHECK(found.at("static_fraction") * 10000 ==
        Approx(std::max(found.at("contact_force"), -lowest_of(statement, "contact_force"))));
}

TEST_CASE("the roller of a pair that never bears has no load", "[cams]") {
  // A load that inertia never passes: the main cam bears all round.
  const auto found =
      numbers_of(program_of("disc-cam-conjugate", "speed = 60\nload = 500\nmass = 1\n"));
  CHECK(found.at("equivalent_load") > 400);
  CHECK(found.at("second_equivalent_load") == 0);
  CHECK(std::isinf(found.at("second_life")));
  // As the main roller of a single cam with the same parts.
  const auto single = numbers_of(
      program_of("disc-cam-roller",
                 "speed = 60\nload = 500\nmass = 1\nspring_rate = 0\nspring_preload = 0\n"));
  for (const char* name : {"equivalent_load", "life_revolutions", "life"}) {
    CHECK(found.at(name) == Approx(single.at(name)).epsilon(1e-12));
  }
  const Mechanism& pair = find_mechanism("disc-cam-conjugate");
  testing::TestDesign design =
      testing::design_of(pair, "legendre c=-3,1", {"c"}, {"roller_distance", "mass"});
  design.binding.constants[pair.parameter("speed")] = 60;
  design.binding.constants[pair.parameter("load")] = 500;
  const auto f = testing::response_of(pair, "second_equivalent_load", design.binding).function();
  std::vector<double> slopes(f.inputs().size(), -1);
  CHECK(f.gradient(design.x, slopes) == 0);
  CHECK(slopes == std::vector<double>(slopes.size(), 0.0));
}

TEST_CASE("the lives of a pair have exact derivatives and close bounds", "[cams]") {
  const Mechanism& pair = find_mechanism("disc-cam-conjugate");
  testing::TestDesign design = testing::design_of(pair, "legendre c=-3,1", {"c"},
                                                  {"base_radius", "roller_distance", "mass"});
  design.binding.constants[pair.parameter("load")] = 2;
  design.binding.constants[pair.parameter("speed")] = 400;
  for (const char* name : {"life", "equivalent_load", "life_revolutions", "second_life",
                           "second_equivalent_load", "second_life_revolutions"}) {
    INFO(name);
    const auto f = testing::response_of(pair, name, design.binding).function();
    testing::check_derivatives(f, design.x, 1e-3, 1e-5);
    const auto bounds = f.enclose(design.x);
    const double value = f.value(design.x);
    // Gauss-Legendre is less exact beside the changeover, where the power 10/3 of the force begins.
    CHECK(bounds.lower <= value * (1 + 1e-9));
    CHECK(bounds.upper >= value * (1 - 1e-9));
    CHECK(bounds.upper - bounds.lower < 1e-4 * value);
  }
}

}  // namespace camlaw::problems::roller_life_test
