// SPDX-License-Identifier: MIT
#include "problems/statement/program_timing.h"

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "optim/cycle/extremes.h"
#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"
#include "tests/problems/complaint.h"

namespace camlaw::problems::program_timing_test {

using Catch::Contains, testing::complaint;

namespace {

/// A rise of 20 mm, its length as `rise` says.
std::string cam(const std::string& rise, const std::string& program, const std::string& rest = "") {
  return "mechanism = 'disc-cam-roller'\n[program]\n" + program + "segments = [{name = 'rise', " +
         rise + ", law = 'modified-sine'}, {name = 'back', law = 'cycloidal'}]\n" + rest;
}

const std::string kTime = "time = '120 ms'";

double highest(const ProblemStatement& problem, const std::string& response) {
  for (const EvaluatedResponse& r : evaluate(problem)) {
    if (r.name == response) return r.highest;
  }
  throw std::invalid_argument(response);
}

}  // namespace

TEST_CASE("a cycle's time is the machine's speed, and times make the speeds they state",
          "[program_timing]") {
  // C_v h / t = 1.7596 * 20 mm / 120 ms, whatever else the machine does.
  const double right = 1.7596 * 0.020 / 0.120;
  for (const auto& [program, rest, speed] :
       std::vector<std::tuple<const char*, const char*, double>>{
           {"cycle_time = '1 s'\n", "", 60.},
           {"cycle_time = '0.5 s'\n", "", 120.},
           {"cycle_time = '1 s'\n", "[constants]\nspeed = '60 rpm'\n", 60.},
           {"cycle_time = '1 s'\n", "[constants]\nn = '1 Hz'\n", 60.},
           {"", "[constants]\nspeed = '75 rpm'\n", 75.}}) {
    const ProblemStatement problem = read_problem(cam(kTime, program, rest), "f.toml");
    INFO(in_words(problem));
    CHECK(constant_of(problem, "speed") == Approx(speed).epsilon(1e-12));
    CHECK(highest(problem, "velocity") == Approx(right).epsilon(1e-4));
    CHECK_THAT(in_words(problem),
               Contains(fmt::format("At {:g} rpm a turn takes {:g} s: rise takes 0.12 s ({:g} deg)",
                                    speed, 60 / speed, 0.12 * speed * 6)));
  }
}

TEST_CASE("without a time in any segment a cycle's time still is the speed", "[program_timing]") {
  const auto problem = read_problem(cam("angle = 120", "cycle_time = '0.2 s'\n"), "f.toml");
  CHECK(constant_of(problem, "speed") == Approx(300).epsilon(1e-12));
  CHECK_THAT(in_words(problem), Contains("At 300 rpm a turn takes 0.2 s.\n"));
  CHECK(highest(problem, "velocity") == Approx(1.7596 * 0.020 / (0.2 / 3)).epsilon(1e-4));
  CHECK(!read_problem(cam("angle = 120", ""), "f.toml").timing);
}

TEST_CASE("a cam is cut once: the angles that times have made stay at every speed",
          "[program_timing]") {
  const std::string varies = "[variables.speed]\nlower = 30\nupper = 600\n";
  ProblemStatement fixed = read_problem(cam(kTime, "cycle_time = '1 s'\n"), "f.toml");
  const double before = highest(fixed, "velocity");
  const double rise = fixed.laws.at(0).law()(0.06).s;
  set_value(fixed, "speed=120");
  CHECK(highest(fixed, "velocity") == Approx(2 * before).epsilon(1e-9));
  CHECK(fixed.laws.at(0).law()(0.06).s == rise);
  ProblemStatement free = read_problem(cam(kTime, "times_at = '60 rpm'\n", varies), "f.toml");
  CHECK(free.laws.at(0).law()(0.06).s == rise);
  set_value(free, "speed=60");
  CHECK(highest(free, "velocity") == Approx(before).epsilon(1e-9));
  // Times that hold at another speed than the one the machine runs at.
  const auto other = read_problem(
      cam(kTime, "times_at = '60 rpm'\n", "[constants]\nspeed = '120 rpm'\n"), "f.toml");
  CHECK(highest(other, "velocity") == Approx(2 * before).epsilon(1e-9));
}

TEST_CASE("an axis keeps its times at another speed, and its angles change", "[program_timing]") {
  const auto axis = [](const std::string& program, const std::string& rest = "") {
    return read_problem("mechanism = 'servo-axis'\n[program]\n" + program +
                            "segments = [{name = 'up', time = '100 ms', law = 'parabolic'},\n"
                            "{name = 'high', angle = 90},\n"
                            "{name = 'down', time = '150 ms', law = 'parabolic'}, {name = 'low'}]\n"
                            "matched = 'velocity'\n" +
                            rest,
                        "a.toml");
  };
  const auto up_angle = [](const ProblemStatement& problem) {
    return values_of(problem, find_parameter(problem, "up_angle", Owner::Law)).at(0);
  };
  // The greatest acceleration of the parabolic law is 4 S / t^2, of the shorter move.
  const double right = 4 * 90.0 / (0.1 * 0.1);
  for (const auto& [program, rest] : std::vector<std::pair<std::string, std::string>>{
           {"cycle_time = '0.5 s'\n", ""},
           {"", "[constants]\nspeed = '120 rpm'\n"},
           {"", "[constants]\nn = '2 Hz'\n"},
           {"cycle_time = '0.5 s'\n", "[constants]\nspeed = '120 rpm'\n"}}) {
    for (const char* setting : {"speed=60", "speed=60 rpm", "n=1 Hz"}) {
      INFO(program << rest << setting);
      ProblemStatement problem = axis(program, rest);
      CHECK(up_angle(problem) == Approx(72));
      const double before = highest(problem, "acceleration");
      set_value(problem, setting);
      CHECK(constant_of(problem, "speed") == Approx(60));
      CHECK(up_angle(problem) == Approx(36));
      CHECK(highest(problem, "acceleration") == Approx(before).epsilon(1e-9));
      set_value(problem, "speed=90");
      set_value(problem, "stroke=45 deg");
      CHECK(up_angle(problem) == Approx(54));
      CHECK(highest(problem, "acceleration") == Approx(before / 2).epsilon(1e-9));
    }
  }
  ProblemStatement problem = axis("cycle_time = '0.5 s'\n");
  CHECK(highest(problem, "acceleration") * 180 / 3.14159265358979 == Approx(right).epsilon(1e-6));
  CHECK_THAT(complaint([&] { set_value(problem, "speed=240 rpm"); }), Contains("add up to"));
  CHECK(up_angle(problem) == Approx(72));  // as it was
  // Where the file says so, the angles stay.
  ProblemStatement cut = axis("times_at = '120 rpm'\n");
  set_value(cut, "speed=60");
  CHECK(up_angle(cut) == Approx(72));
  for (const char* rest : {"[ranges.speed]\nlower = 60\nupper = 120\n",
                           "[[cases]]\nname = 'slow'\nspeed = 60\n[[cases]]\nname = 'fast'\n"
                           "speed = 120\n"}) {
    INFO(rest);
    CHECK_THAT(complaint([&] { axis("cycle_time = '0.5 s'\n", rest); }), Contains("times_at"));
    CHECK_NOTHROW(axis("times_at = '120 rpm'\n", rest));
  }
}

TEST_CASE("times that contradict the speed, or hold at none, are refused", "[program_timing]") {
  struct Case {
    std::string text, part;
  };
  const std::string varies = "[variables.speed]\nlower = 30\nupper = 600\n";
  const std::string symbol = "[variables.n]\nvalues = [30, 600]\n";
  const std::string owned = "[variables.machine.speed]\nlower = 30\nupper = 600\n";
  const std::vector<Case> cases = {
      {cam(kTime, "cycle_time = '1 s'\n", "[constants]\nspeed = '300 rpm'\n"),
       "f.toml:3: program.cycle_time: a turn of 1 s is a speed of 60 rpm, but constants.speed is "
       "300 rpm"},
      {cam("angle = 90", "cycle_time = '1 s'\n", "[constants]\nn = '300 rpm'\n"), "constants.n is"},
      {cam(kTime, ""), "write cycle_time = \"0.2 s\" in [program], or speed in [constants]"},
      {cam(kTime, "", varies), "such as times_at = \"60 rpm\""},
      {cam(kTime, "", symbol), "such as times_at = \"60 rpm\""},
      {cam(kTime, "", owned), "such as times_at = \"60 rpm\""},
      {cam(kTime, "cycle_time = '1 s'\n", varies), "write times_at = \"60 rpm\" instead"},
      {cam("angle = 90", "cycle_time = '1 s'\n", varies), "instead"},
      {cam("angle = 90", "times_at = '60 rpm'\n"), "the program has no times"},
      {cam(kTime, "times_at = '60 rpm'\ncycle_time = '1 s'\n"), "drop one of the two"},
      {cam(kTime, "times_at = '60 mm'\n"), "times_at"},
      {cam(kTime, "cycle_time = '1e-9 s'\n"), "it must be"},
      {cam(kTime, "cycle_time = '-1 s'\n"), "cycle_time"},
      {cam("time = '2 s'", "cycle_time = '1 s'\n"), "add up to 720 deg; they must"},
  };
  for (const Case& c : cases) {
    INFO(c.text);
    CHECK_THAT(complaint(c.text), Contains(c.part));
  }
}

}  // namespace camlaw::problems::program_timing_test
