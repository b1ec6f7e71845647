// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "problems/statement/bind.h"
#include "problems/statement/ranges.h"

// Limits over ranges whose worst value lies inside, beside changes of sign.
namespace camlaw::problems::worst_inside_test {

namespace {

ProblemStatement read(const std::string& text) { return read_problem(text, "f.toml"); }

}  // namespace

TEST_CASE("A worst speed this side of a change of the force's sign is found and proved there") {
  // The power of a face in a guide with friction: omega F s' / (1 - q), F = H + m omega^2 s'' with
  // s'' below 0. Where the window begins it is highest at omega^2 = H / (3 m |s''|); at the root of
  // three times that speed F changes its sign, and beyond q has another one.
  const std::string machine =
      "mechanism = 'disc-cam-flat'\n[constants]\nstroke = '20 mm'\nmass = '1 kg'\n"
      "base_radius = '40 mm'\nspring_rate = '5 N/mm'\nspring_preload = '50 N'\n"
      "guide_friction = 0.2\nguide_length = '80 mm'\n"
      "[ranges.speed]\nlower = '200 rpm'\nupper = '900 rpm'\n[program]\n"
      "segments = [{name = 'rise', angle = 90, law = 'modified-sine'}, {name = 'high', angle = "
      "40}, {name = 'back', angle = 100, law = 'cycloidal'}, {name = 'low'}]\n";
  const auto limit = [&](const std::string& upper) {
    return read(machine + "[[constraints]]\nresponse = 'drive_power'\nupper = '" + upper +
                " W'\nfrom = '60 deg'\nto = '85 deg'\n");
  };
  const ProblemStatement problem = limit("66.52");
  const auto close = standing(problem).front();
  CHECK(close.value == Approx(66.5193453).epsilon(1e-8));  // by hand from the law's formula
  CHECK(close.proved);
  CHECK(*close.worst_angle == Approx(60));
  const auto worst = worst_in_ranges(problem, problem.constraints[0].response, close.worst_angle);
  REQUIRE(worst.size() == 1);
  CHECK(worst.front().value == Approx(366.9408716).epsilon(1e-7));
  const auto broken = standing(limit("66.519")).front();
  CHECK_FALSE(broken.met);
  CHECK_FALSE(broken.proved);
}

TEST_CASE("A worst value at a kink inside the range is found and proved there") {
  const std::string machine =
      "[machine]\nmoved_by = 'law'\n[machine.parameters.b]\ndefault = 1\nlower = -5\nupper = 5\n"
      "[responses.f]\nformula = 'v - 2 * abs(b - v)'\n[law]\nname = 'cosine'\n"
      "[ranges.b]\nlower = -1\nupper = 4\n";
  const double v = std::acos(-1.0) / 2;
  const ProblemStatement problem =
      read(machine + fmt::format("[[constraints]]\nresponse = 'f'\nupper = {}\n", v + 1e-5));
  const auto limit = standing(problem).front();
  CHECK(limit.value == Approx(v).epsilon(1e-9));
  CHECK(limit.proved);
}

TEST_CASE("A curve over ranges is at many places what it is at each of them") {
  const ProblemStatement problem = read(
      "mechanism = 'disc-cam-roller'\n[constants]\nstroke = '30 mm'\nspeed = '200 rpm'\n"
      "mass = '1.2 kg'\nspring_rate = '6 N/mm'\nspring_preload = '60 N'\n"
      "roller_radius = '8 mm'\n[variables.base_radius]\nlower = '30 mm'\nupper = '90 mm'\n"
      "start = '52 mm'\n[objective]\nminimize = 'base_radius'\n"
      "[ranges.speed]\nlower = '50 rpm'\nupper = '400 rpm'\n"
      "[ranges.spring_preload]\nlower = '40 N'\nupper = '90 N'\n[program]\n"
      "segments = [{name = 'rise', angle = 80, law = 'cycloidal'}, {name = 'high', angle = "
      "60}, {name = 'back', angle = 100, law = 'modified-sine'}, {name = 'low'}]\n"
      "[[constraints]]\nresponse = 'follower_force'\nlower = '0 N'\n"
      "[[constraints]]\nresponse = 'drive_torque'\nupper = '40 N m'\n");
  const BoundProblem bound(problem);
  const optim::Problem first = bound.space().problem(bound.space().options(0));
  const std::vector<double> x{first.variables.front().start};
  for (const optim::Constraint& constraint : first.constraints) {
    INFO(constraint.response.name);
    const auto trace = constraint.response.curve().trace(x);
    const std::vector<double> breaks = trace->breaks();
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
      const auto places = optim::even_places(breaks[k], breaks[k + 1], 12);
      const auto even = trace->even(breaks[k], breaks[k + 1], 12);
      const auto values = trace->values(places);
      REQUIRE(even.size() == places.size());
      REQUIRE(values.size() == places.size());
      for (std::size_t i = 0; i < places.size(); ++i) {
        const auto alone = trace->at(places[i]);
        const double size = std::abs(alone[0]) + 1;
        CHECK(values[i] == even[i][0]);
        CHECK(even[i][0] == Approx(alone[0]).margin(1e-12 * size));
      }
    }
  }
}

}  // namespace camlaw::problems::worst_inside_test
