// SPDX-License-Identifier: MIT
// The contact of a follower with an elastic train, against a Fourier series and Hertz's formula
// that are written here once more, the rigid follower, and grids of speeds.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "machines/registry.h"
#include "problems/statement/bind.h"
#include "problems/statement/buildable.h"
#include "problems/statement/parameters.h"
#include "tests/machines/fourier_train.h"
#include "tests/machines/system_fixture.h"

namespace camlaw::problems::elastic_contact_test {
namespace {

using Catch::Contains;
using testing::design_of, testing::response_of, testing::TestDesign, testing::with_dwells;

constexpr double kPi = std::numbers::pi, kTurn = 2 * kPi;

/// The program of all cams here, behind "[" or "[cams.NAME.".
constexpr const char* kProgram =
    "program]\nsegments = [{name = 'rise', angle = 120, law = 'cycloidal'}, {name = 'high', angle "
    "= "
    "40}, {name = 'back', angle = 90, law = 'cycloidal'}, {name = 'low'}]\n";

/// A cam that rises over 120 deg, rests over 40, returns over 90 and rests, by cycloids.
std::string cam(const std::string& mechanism, const std::string& constants,
                const std::string& more = "") {
  return "mechanism = '" + mechanism + "'\n[constants]\n" + constants + "[" + kProgram + more;
}

ProblemStatement read(const std::string& text) { return read_problem(text, "elastic.toml"); }

/// s and two derivatives by the angle, rad, of that motion of the stroke h.
std::array<double, 3> lift(double h, double degrees) {
  const bool rises = degrees < 120, falls = degrees >= 160 && degrees < 250;
  if (!rises && !falls) return {degrees < 160 ? h : 0, 0, 0};
  const double length = (rises ? 120 : 90) * kPi / 180;
  const double u = (degrees - (rises ? 0 : 160)) * kPi / 180 / length, sign = rises ? 1 : -1;
  return {(rises ? 0 : h) + sign * h * (u - std::sin(kTurn * u) / kTurn),
          sign * h / length * (1 - std::cos(kTurn * u)),
          sign * h / (length * length) * kTurn * std::sin(kTurn * u)};
}

double value_of(const ProblemStatement& problem, const std::string& name, double angle) {
  const Mechanism& mechanism = *problem.mechanism;
  TestDesign design = design_of(mechanism, problem.laws.front(), {}, {});
  design.binding.constants = problem.constants;
  return response_of(mechanism, name.c_str(), design.binding).curve().at({angle}).value(design.x);
}

const BuildableAnswer& check_of(const Buildability& found, const std::string& name) {
  const BuildableAnswer* one = nullptr;
  for (const BuildableAnswer& answer : found.checks) {
    if (answer.check->name != name) continue;
    CHECK(one == nullptr);  // a design has one check of a name
    one = &answer;
  }
  REQUIRE(one != nullptr);
  return *one;
}

}  // namespace

TEST_CASE("the stress under an elastic follower is Hertz's under the force of its Fourier series",
          "[elastic-contact]") {
  // 600 rpm, 1.2 kg, 300 N/mm, all of the mass at the end.
  const double omega = 20 * kPi, mass = 1.2, stiffness = 3e5, h = 0.02, prime = 0.07;
  const double natural = std::sqrt(stiffness / mass), tau = natural / omega;
  const ProblemStatement problem =
      read(cam("disc-cam-roller",
               "speed = 600\nmass = 1.2\ntrain_stiffness = 300\ntrain_damping = 0\nbase_radius = "
               "60\nspring_rate = 20\nspring_preload = 900\nface_width = 12\n"));
  for (const double angle : {5.0, 33.0, 71.0, 100.0, 140.0, 171.0, 205.0, 240.0, 300.0}) {
    INFO(angle);
    const auto [s, ds, dds] = lift(h, angle);
    const double force =
        -mass * natural * natural * h *
            testing::fourier_deviation(tau, angle / 360, testing::rise_and_return) +
        2e4 * s + 900;
    const double y = prime + s;
    const double k = (y * y + 2 * ds * ds - y * dds) / std::pow(y * y + ds * ds, 1.5);
    const double pressed = force * std::hypot(1, ds / y) / 0.012;
    const double sum = 1 / (0.01 * (1 - 0.01 * k)), modulus = 2.1e11 / 0.91;
    CHECK(value_of(problem, "elastic_contact_stress", angle) ==
          Approx(std::sqrt(pressed * sum * modulus / kTurn) / 1e6).epsilon(1e-8));
  }
}

TEST_CASE("behind every cam a stiff train presses as a rigid one does", "[elastic-contact]") {
  int stresses = 0;
  for (const Mechanism& mechanism : mechanisms()) {
    for (const char* const name : {"contact_stress", "groove_stress", "tip_contact_stress"}) {
      const std::string elastic = std::string("elastic_") + name;
      const auto has_it = [&](const auto& response) { return response.name == elastic; };
      if (!std::ranges::any_of(mechanism.responses, has_it)) continue;
      INFO(mechanism.name << ", " << name);
      TestDesign design = design_of(mechanism, with_dwells("poly-5-6-7-8-9"), {}, {});
      const auto set = [&](const char* parameter, double value) {
        design.binding.constants[mechanism.parameter(parameter)] = value;
      };
      set("train_stiffness", 1e9);
      set(mechanism.advances ? "load_torque" : "load", 60);
      const auto of = [&](const std::string& response) {
        return response_of(mechanism, response.c_str(), design.binding).curve().trace({});
      };
      const auto rigid = of(name), soft = of(elastic);
      int known = 0;
      for (double angle = 3.3; angle < 360; angle += 13) {
        const double expected = rigid->at({angle})[0];
        if (std::isnan(expected)) continue;
        INFO(angle);
        CHECK(soft->at({angle})[0] == Approx(expected).epsilon(2e-4));
        ++known;
      }
      CHECK(known > 20);
      ++stresses;
    }
  }
  CHECK(stresses > 14);
}

TEST_CASE("the stress under an elastic follower has exact derivatives and bounds",
          "[elastic-contact]") {
  const Mechanism& roller = find_mechanism("disc-cam-roller");
  TestDesign design = design_of(
      roller, with_dwells("legendre c=-3,1,-0.3"), {"rise_c", "rise_angle"},
      {"mass", "speed", "stroke", "train_stiffness", "train_damping", "base_radius", "face_width"});
  design.binding.constants[roller.parameter("spring_preload")] = 3000;
  const std::vector<double>& x = design.x;
  const auto response = response_of(roller, "elastic_contact_stress", design.binding);
  const auto trace = response.curve().trace(x);
  for (const double place : {33.0, 140.0, 200.0, 333.0}) {
    INFO(place);
    testing::check_derivatives(response.curve().at({place}), x, 1e-4, 1e-5, 1e-10);
    const auto here = trace->at({place});
    CHECK(here[0] == Approx(response.curve().at({place}).value(x)).epsilon(1e-11));
    const auto value = [&](double by) { return trace->at({place + by})[0]; };
    const double size = std::abs(here[0]);
    CHECK(here[1] == Approx(testing::slope(value, 0.02)).epsilon(1e-6).margin(1e-6 * size));
    testing::check_bounds_close(*trace, place);
  }
}

TEST_CASE("an elastic follower that jumps is not said to hold", "[elastic-contact]") {
  const std::string cam_of_rigid =
      "speed = '600 rpm'\nbase_radius = '60 mm'\nmass = '1.2 kg'\nspring_rate = '10 "
      "N/mm'\nface_width = '15 mm'\n";
  const std::string allowed = "[buildable]\nallowable_pressure = '330 MPa'\n";
  const auto built = [&](const std::string& constants) {
    return buildability(
        read("mechanism = 'disc-cam-roller'\n[constants]\n" + cam_of_rigid + constants +
             "[program]\nsegments = [{name = 'up', angle = '110 deg', law = 'poly-4-5-6-7'}, {name "
             "= 'hi', angle = '50 deg'}, {name = 'down', angle = '110 deg', law = 'poly-4-5-6-7'}, "
             "{name = 'lo'}]\n" +
             allowed));
  };
  const std::string train = "train_stiffness = '300 N/mm'\n";
  const Buildability rigid = built("spring_preload = '120 N'\n");
  CHECK(check_of(rigid, "contact").check->response == "follower_force");
  CHECK(check_of(rigid, "contact").built == Built::Holds);
  CHECK(check_of(rigid, "stress").built == Built::Holds);
  // The same with a train: from -47 N to 496 N.
  const Buildability jumps = built("spring_preload = '120 N'\n" + train);
  CHECK(check_of(jumps, "contact").check->response == "elastic_force");
  CHECK(check_of(jumps, "contact").built == Built::Fails);
  CHECK(check_of(jumps, "contact").report.value == Approx(-47).margin(0.5));
  CHECK(check_of(jumps, "stress").built == Built::NotChecked);
  CHECK_THAT(check_of(jumps, "stress").why, Contains("contact fails"));
  // With a preload that holds it the stress counts, under what the train adds.
  const Buildability held = built("spring_preload = '180 N'\n" + train);
  CHECK(check_of(held, "contact").built == Built::Holds);
  CHECK(check_of(held, "stress").check->response == "elastic_contact_stress");
  CHECK(check_of(held, "stress").built == Built::Fails);
  CHECK(check_of(held, "stress").report.value > 345);
  CHECK(check_of(built("spring_preload = '180 N'\n"), "stress").built == Built::Holds);
  // A stiffness of 0 is that of a rigid follower.
  CHECK(check_of(built("spring_preload = '120 N'\ntrain_stiffness = 0\n"), "contact")
            .check->response == "follower_force");
}

TEST_CASE("of each cam with an elastic train its checks are those of the elastic follower",
          "[elastic-contact]") {
  const std::string loads =
      "speed = 300\nspring_rate = 1\nspring_preload = 200\nload = 10\nface_width = 15\n"
      "train_stiffness = 2000\n";
  for (const char* const mechanism :
       {"disc-cam-flat", "disc-cam-knife-edge", "disc-cam-oscillating-roller",
        "disc-cam-leading-roller", "disc-cam-oscillating-flat", "end-cam", "end-cam-oscillating",
        "linear-cam", "disc-cam-conjugate"}) {
    INFO(mechanism);
    const bool slides = find_mechanism(mechanism).parameters[0].name == "stroke";
    const bool presses = std::string(mechanism) != "disc-cam-knife-edge";
    const Buildability found =
        buildability(read(cam(mechanism, loads + (slides ? "mass = 1\n" : "inertia = 0.002\n"),
                              presses ? "[buildable]\nallowable_pressure = 2000\n" : "")));
    const bool by_force = std::string(mechanism) != "disc-cam-conjugate";
    if (by_force) {
      const BuildableAnswer& contact = check_of(found, "contact");
      CHECK(contact.check->response == (slides ? "elastic_force" : "elastic_torque"));
      CHECK(contact.built == Built::Holds);
    }
    if (presses) CHECK(check_of(found, "stress").check->response == "elastic_contact_stress");
  }
}

TEST_CASE("a limit on the stress under an elastic follower is proved over a range of speeds",
          "[elastic-contact]") {
  const std::string constants =
      "mass = 0.8\nbase_radius = 60\ntrain_stiffness = 800\nend_share = 0.8\nspring_rate = "
      "30\ntrain_damping = 0.1\nspring_preload = 400\n";
  const std::string ranges = "[ranges.speed]\nlower = '600 rpm'\nupper = '700 rpm'\n";
  double greatest = 0;
  for (double speed = 600; speed <= 700; speed += 0.5) {
    ProblemStatement problem =
        read(cam("disc-cam-roller", constants + fmt::format("speed = {}\n", speed)));
    const auto& response = *find_response(*problem.mechanism, "elastic_contact_stress").response;
    greatest = std::max(greatest, evaluate_response(problem, response).highest);
  }
  const auto limited = [&](double bound) {
    return standing(read(cam("disc-cam-roller", constants,
                             ranges + fmt::format("[[constraints]]\nresponse = "
                                                  "'elastic_contact_stress'\nupper = {}\n",
                                                  bound))));
  };
  const auto holds = limited(greatest * 1.01);
  REQUIRE_FALSE(holds.empty());
  CHECK(holds[0].value == Approx(greatest).epsilon(1e-4));
  CHECK(holds[0].met);
  CHECK(holds[0].proved);
  CHECK_FALSE(limited(greatest * 0.999)[0].met);
}

TEST_CASE("an elastic follower is checked in each load case, and on a shaft, as one alone",
          "[elastic-contact]") {
  const std::string constants =
      "base_radius = 60\nmass = 1.2\nspring_rate = 10\nspring_preload = 120\nface_width = 15\n"
      "train_stiffness = 300\n";
  const ProblemStatement cases =
      read(cam("disc-cam-roller", "speed = 100\n" + constants,
               "[buildable]\nallowable_pressure = 2000\n[[cases]]\nname = 'slow'\nspeed = "
               "60\n[[cases]]\nname = 'fast'\nspeed = 700\n"));
  const Buildability found = buildability(cases);
  CHECK(check_of(found, "contact in slow").built == Built::Holds);
  CHECK(check_of(found, "contact in fast").built == Built::Fails);
  CHECK(check_of(found, "stress in slow").built == Built::Holds);
  CHECK(check_of(found, "stress in fast").built == Built::NotChecked);
  CHECK(check_of(found, "stress in slow").check->response == "slow.elastic_contact_stress");
  const std::string program = std::string(".") + kProgram;
  const ProblemStatement shaft = read(
      "[constants]\nspeed = 60\n[cams.press]\nmechanism = 'disc-cam-roller'\n"
      "[cams.press.constants]\nphase = 30\n" +
      constants + "[cams.press" + program +
      "[cams.press.buildable]\nallowable_pressure = 2000\n[cams.feed]\nmechanism = "
      "'disc-cam-flat'\n[cams.feed.constants]\nmass = 1\n[cams.feed" +
      program);
  const Buildability on_shaft = buildability(shaft);
  const BuildableAnswer& stress = check_of(on_shaft, "press: stress");
  CHECK(stress.check->response == "press.elastic_contact_stress");
  CHECK(stress.built == Built::Holds);
  CHECK(check_of(on_shaft, "feed: contact").check->response == "feed.follower_force");
  const ProblemStatement alone = read(cam("disc-cam-roller", "speed = 60\n" + constants,
                                          "[buildable]\nallowable_pressure = 2000\n"));
  const Buildability of_one = buildability(alone);
  CHECK(stress.report.value == Approx(check_of(of_one, "stress").report.value).epsilon(1e-9));
}

TEST_CASE("each load case is judged by its own follower, rigid or elastic", "[elastic-contact]") {
  const std::string constants =
      "base_radius = 60\nmass = 1.2\nspring_rate = 10\nspring_preload = 420\nface_width = 15\n"
      "speed = 300\n";
  const std::string pressure = "[buildable]\nallowable_pressure = 2000\n";
  const std::string rigid_and_soft =
      "[[cases]]\nname = 'rigid'\ntrain_stiffness = 0\n"
      "[[cases]]\nname = 'soft'\ntrain_stiffness = 30\n";
  const auto value = [&](const std::string& stiffness, const char* check) {
    const ProblemStatement one = read(cam("disc-cam-roller", constants + stiffness, pressure));
    return check_of(buildability(one), check).report.value;
  };
  // Whatever the machine has beside its cases.
  for (const char* const beside : {"", "train_stiffness = 1000\n"}) {
    INFO("beside: " << beside);
    const ProblemStatement problem =
        read(cam("disc-cam-roller", constants + beside, pressure + rigid_and_soft));
    const Buildability found = buildability(problem);
    for (const char* const check : {"contact", "stress"}) {
      const BuildableAnswer& rigid = check_of(found, std::string(check) + " in rigid");
      const BuildableAnswer& soft = check_of(found, std::string(check) + " in soft");
      CHECK(rigid.check->only_without == "train_stiffness");
      CHECK(soft.check->only_with == "train_stiffness");
      CHECK(rigid.report.value == Approx(value("", check)).epsilon(1e-9));
      CHECK(soft.report.value == Approx(value("train_stiffness = 30\n", check)).epsilon(1e-9));
    }
  }
}

TEST_CASE("a train that is rigid at an end of its range is looked at as rigid, and not as elastic",
          "[elastic-contact]") {
  const std::string constants =
      "mass = 1.2\nspring_rate = 10\nspring_preload = 420\nface_width = 15\nspeed = 300\n";
  const std::string range = "[ranges.train_stiffness]\nlower = 0\nupper = 500\n";
  const std::string pressure = "[buildable]\nallowable_pressure = 2000\n";
  const ProblemStatement problem =
      read(cam("disc-cam-roller", constants + "base_radius = 60\n", range + pressure));
  const Buildability found = buildability(problem);
  for (const char* const name : {"contact", "stress"}) {
    INFO(name);
    std::vector<const BuildableAnswer*> both;
    for (const BuildableAnswer& answer : found.checks) {
      if (answer.check->name == name) both.push_back(&answer);
    }
    REQUIRE(both.size() == 2);
    CHECK(both[0]->check->only_without == "train_stiffness");
    CHECK(both[0]->built == Built::Holds);
    CHECK(both[1]->built == Built::NotChecked);
    CHECK_THAT(both[1]->why, Contains("begin at 0") && Contains("train_stiffness"));
  }
  // Limits of a search are those of one of the two.
  const std::string variable = "[variables.train_stiffness]\nlower = 0\nupper = 900\nstart = 0\n";
  for (const std::string& varied : {range, variable}) {
    CHECK_THROWS_WITH(read(cam("disc-cam-roller", constants,
                               varied +
                                   "[variables.base_radius]\nlower = 40\nupper = 90\n"
                                   "[objective]\nminimize = 'base_radius'\n" +
                                   pressure + "require = true\n")),
                      Contains("train_stiffness") && Contains("keep it at 0, or above 0"));
  }
}

TEST_CASE("a stress is required to have contact, and waits for it, under every face and roller",
          "[elastic-contact]") {
  int faces = 0;
  for (const Mechanism& mechanism : mechanisms()) {
    const auto& checks = mechanism.checks;
    const auto is_contact = [](const auto& check) { return check.name == "contact"; };
    if (!std::ranges::any_of(checks, is_contact)) continue;
    for (const BuildableCheck& check : checks) {
      if (check.name != "stress") continue;
      INFO(mechanism.name << ", " << check.response);
      CHECK(std::ranges::count(check.after, "contact") == 1);
      const auto& needs = find_response(mechanism, check.response).response->defined_while;
      CHECK(std::ranges::any_of(needs, [](const ValidityLimit& limit) {
        return limit.response.find("force") != std::string::npos ||
               limit.response.find("torque") != std::string::npos;
      }));
      ++faces;
    }
  }
  CHECK(faces > 5);
}

TEST_CASE("ranges are taken in each load case, and on a shaft, as of the machine alone",
          "[elastic-contact][long]") {
  const std::string constants =
      "mass = 0.8\nbase_radius = 60\nend_share = 0.8\nspring_rate = 30\nspring_preload = 3000\n"
      "speed = 600\ntrain_stiffness = 700\nface_width = 15\n";
  // About the resonance at 730 N/mm.
  const std::string stiffness = "[ranges.train_stiffness]\nlower = 600\nupper = 800\n";
  const std::string limit = "[[constraints]]\nresponse = 'elastic_contact_stress'\nupper = 1085\n";
  // The base machine's damping is no case's: dry resonates.
  const auto alone = standing(
      read(cam("disc-cam-roller", constants + "train_damping = 0.001\n", stiffness + limit)));
  const auto in_cases = standing(
      read(cam("disc-cam-roller", constants + "train_damping = 0.5\n",
               stiffness + limit +
                   "[[cases]]\nname = 'dry'\ntrain_damping = 0.001\n[[cases]]\nname = 'oiled'\n"
                   "train_damping = 0.5\n")));
  CHECK_FALSE(alone[0].met);
  REQUIRE(in_cases[0].name == "dry.elastic_contact_stress");
  CHECK_FALSE(in_cases[0].met);
  CHECK(in_cases[0].value == Approx(alone[0].value).epsilon(1e-4));
  // On a shaft with another cam, whose parameters have other numbers.
  const std::string program = std::string(".") + kProgram;
  const std::string press =
      "mass = 0.8\nbase_radius = 60\ntrain_stiffness = 800\nspring_rate = 30\n"
      "spring_preload = 400\nface_width = 15\n";
  const std::string speeds = "[ranges.speed]\nlower = 250\nupper = 300\n";
  const ProblemStatement shaft =
      read(speeds +
           "[cams.feed]\nmechanism = 'disc-cam-flat'\n[cams.feed.constants]\nmass = 1\n[cams.feed" +
           program +
           "[cams.press]\nmechanism = 'disc-cam-roller'\n[cams.press.constants]\nphase = 25\n" +
           press + "[cams.press" + program + "[cams.press.buildable]\nallowable_pressure = 900\n");
  const ProblemStatement one =
      read(cam("disc-cam-roller", press, speeds + "[buildable]\nallowable_pressure = 900\n"));
  const Buildability on_shaft = buildability(shaft);
  const Buildability of_one = buildability(one);
  CHECK(check_of(on_shaft, "press: stress").report.value ==
        Approx(check_of(of_one, "stress").report.value).epsilon(1e-6));
  CHECK(check_of(on_shaft, "press: stress").built == check_of(of_one, "stress").built);
}

}  // namespace camlaw::problems::elastic_contact_test
