// SPDX-License-Identifier: MIT
#include "problems/statement/program_timing.h"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "optim/cycle/extremes.h"
#include "optim/problem/check_derivatives.h"
#include "optim/search/optimise.h"
#include "problems/sensitivity/design_numbers.h"
#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"
#include "problems/statement/ranges.h"
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
  const char* const varied = "[variation.speed]\nplus = 1\n[[cases]]\nname = 'slow'\nspeed = 60\n";
  CHECK_THAT(complaint([&] { axis("cycle_time = '0.5 s'\n", varied); }), Contains("times_at"));
  CHECK_THAT(complaint([&] {
               axis("cycle_time = '0.5 s'\n", "[ranges.speed]\nlower = 60\nupper = 120\n");
             }),
             Contains("drop cycle_time"));
  CHECK_NOTHROW(axis("times_at = '120 rpm'\n", "[ranges.speed]\nlower = 60\nupper = 120\n"));
}

namespace {

/// Moves of a pure inertia in 100 and 150 ms; 2.9 ms of another segment are an angle.
std::string moves(const std::string& rest, const std::string& program = "") {
  return "mechanism = 'servo-axis'\n[program]\nmatched = 'velocity'\n" + program +
         "segments = [{name = 'up', time = '100 ms', law = 'parabolic'},\n"
         "{name = 'high', angle = 20},\n"
         "{name = 'down', time = '150 ms', law = 'parabolic'}, {name = 'low'}]\n" +
         rest;
}

const std::string kPure =
    "[constants]\nstroke = '90 deg'\nload_inertia = '0.02 kg m2'\ngear_efficiency = 1\n";
const std::string kLossy =
    "[constants]\nstroke = '90 deg'\nload_inertia = '0.02 kg m2'\nfriction_torque = '0.4 N m'\n"
    "load_torque = '1.5 N m'\nviscous_friction = '0.05 N m s'\n";

/// The rms torque of the moves: (J_M + J_G + J / i^2) i 4 S / T^2 over 2 T / t_c, as a designer
/// works it out.
double rms_by_hand(double rpm) {
  const double inertia = 1.6e-4 + 0.3e-4 + 0.02 / 100, stroke = 3.14159265358979 / 2;
  double sum = 0;
  for (const double time : {0.1, 0.15}) {
    const double torque = inertia * 10 * 4 * stroke / (time * time);
    sum += torque * torque * time;
  }
  return std::sqrt(sum * rpm / 60);
}

/// The value of a response, of a curve its highest.
double value_in(const ProblemStatement& problem, const std::string& response) {
  for (const EvaluatedResponse& r : evaluate(problem)) {
    if (r.name == response) return r.is_curve ? r.highest : r.value;
  }
  throw std::invalid_argument(response);
}

optim::Problem bound(const ProblemStatement& statement) {
  const BoundProblem problem(statement);
  return problem.problem(std::vector<std::size_t>(problem.choices().size(), 0));
}

}  // namespace

TEST_CASE("where an axis' speed is a variable, its angles follow it", "[program_timing]") {
  const std::string varies =
      "[variables.speed]\nlower = 40\nupper = 200\nstart = 90\n[objective]\nminimize = "
      "'torque_rms'\n";
  ProblemStatement problem = read_problem(moves(kPure + varies), "f.toml");
  CHECK_THAT(in_words(problem), Contains("At 90 rpm a turn takes 0.666667 s: up takes 0.1 s (54 "
                                         "deg) and down takes 0.15 s (81 deg). At other speeds "
                                         "the times stay"));
  for (const double rpm : {60., 90., 117., 200.}) {
    INFO(rpm);
    set_value(problem, fmt::format("speed={}", rpm));
    CHECK(value_in(problem, "torque_rms") == Approx(rms_by_hand(rpm)).epsilon(1e-9));
    CHECK(value_in(problem, "acceleration") == Approx(4 * 1.5707963267949 / 0.01).epsilon(1e-9));
    const optim::Problem made = bound(problem);
    const std::vector<double> x = made.start();
    REQUIRE(x == std::vector<double>{rpm});
    double slope = 0, bend = 0;
    const optim::Function& rms = made.objectives[0].response.function();
    CHECK(rms.hessian(x, {&slope, 1}, {&bend, 1}) == Approx(rms_by_hand(rpm)).epsilon(1e-9));
    CHECK(slope == Approx(rms_by_hand(rpm) / (2 * rpm)).epsilon(1e-7));
    CHECK(bend == Approx(-rms_by_hand(rpm) / (4 * rpm * rpm)).epsilon(1e-6));
    const optim::Bounds proved = rms.enclose(x);
    CHECK(proved.lower <= rms_by_hand(rpm) * (1 + 1e-12));
    CHECK(proved.upper >= rms_by_hand(rpm) * (1 - 1e-12));
    CHECK(proved.upper - proved.lower < 1e-6 * rms_by_hand(rpm));
  }
  // The times may vary too.
  set_values(problem, std::vector<std::string>{"speed=90", "up_time=120 ms"});
  CHECK(value_in(problem, "motor_acceleration") ==
        Approx(10 * 4 * 1.5707963267949 / (0.12 * 0.12)).epsilon(1e-9));
  // The program does not fit beyond 60 / 0.25 s less what 'high' takes.
  CHECK_THAT(complaint([&] { set_value(problem, "up_time=0.6 s"); }), Contains("no angle is left"));
}

TEST_CASE("derivatives by a speed go by the angles too: the differences of another speed",
          "[program_timing]") {
  std::string limits;
  const std::vector<std::string> names = {
      "torque_rms",        "mean_power",      "regenerated_energy",      "peak_torque",
      "peak_power",        "rms_utilisation", "peak_torque_utilisation", "peak jerk",
      "peak output_torque"};
  for (const std::string& name : names) {
    limits += "[[constraints]]\nresponse = '" + name + "'\nupper = 1e9\n";
  }
  const std::string rest =
      kLossy +
      "[objective]\nminimize = 'torque_rms'\n[variables.gear_ratio]\nlower = 4\nupper = "
      "20\nstart = 11\n";
  const std::string with_jerk =
      "segments = [{name = 'up', time = '100 ms', law = 'modified-sine'},\n"
      "{name = 'high', angle = 20},\n{name = 'down', time = '150 ms', "
      "law = '3-4-5'}, {name = 'low'}]\n";
  const std::string head = "mechanism = 'servo-axis'\n[program]\n";
  const ProblemStatement problem = read_problem(
      head + with_jerk + rest + "[variables.speed]\nlower = 40\nupper = 200\nstart = 97\n" + limits,
      "f.toml");
  const optim::Problem made = bound(problem);
  const auto derivatives = optim::check_derivatives(made, made.start());
  CHECK(derivatives.agrees);
  // The same machine at a speed that is fixed in its file, and set to another.
  std::string fixed = head + with_jerk + rest + limits;
  fixed.replace(fixed.find("[constants]\n"), 12, "[constants]\nspeed = '97 rpm'\n");
  const auto peak_at = [&](double rpm, const std::string& name) {
    ProblemStatement other = read_problem(fixed, "f.toml");
    set_value(other, fmt::format("speed={:.17g}", rpm));
    const optim::Problem its = bound(other);
    for (const optim::Constraint& c : its.constraints) {
      if (c.response.name != name) continue;
      if (!c.response.is_curve()) return c.response.function().value(its.start());
      return optim::highest(*c.response.curve().trace(its.start()), 1).value;
    }
    throw std::invalid_argument(name);
  };
  for (const optim::Constraint& c : made.constraints) {
    INFO(c.response.name);
    if (c.response.is_curve()) {
      const auto found = optim::highest(*c.response.curve().trace(made.start()), 1);
      CHECK(found.value == Approx(peak_at(97, c.response.name)).epsilon(1e-9));
      continue;
    }
    std::vector<double> slopes(c.response.function().inputs().size());
    const double value = c.response.function().gradient(made.start(), slopes);
    CHECK(value == Approx(peak_at(97, c.response.name)).epsilon(1e-9));
    constexpr double kStep = 0.05;
    const auto change = [&](double step) {
      return (peak_at(97 + step, c.response.name) - peak_at(97 - step, c.response.name)) /
             (2 * step);
    };
    const double slope = (4 * change(kStep) - change(2 * kStep)) / 3;
    REQUIRE(c.response.function().inputs() == std::vector<std::size_t>{0, 1});
    CHECK(slopes[1] == Approx(slope).epsilon(1e-6).margin(1e-7 * std::abs(value)));
  }
}

TEST_CASE("a speed among values to choose from brings the angles with it", "[program_timing]") {
  const ProblemStatement problem =
      read_problem(moves(kPure + "[variables.speed]\nvalues = [150, 60, 90]\n[objective]\nminimize "
                                 "= 'torque_rms'\n"),
                   "f.toml");
  const auto found = optim::optimise(BoundProblem(problem).space());
  CHECK(found.found.assessment.objective.value == Approx(rms_by_hand(60)).epsilon(1e-9));
  const ProblemStatement design = BoundProblem(problem).at(found.options, found.found.x);
  CHECK(constant_of(design, "speed") == 60);
  CHECK(value_in(design, "torque_rms") == Approx(rms_by_hand(60)).epsilon(1e-9));
}

TEST_CASE("each load case of an axis has the program of its speed", "[program_timing]") {
  const std::string rest =
      "[[cases]]\nname = 'slow'\nspeed = '75 rpm'\n[[cases]]\nname = 'fast'\nspeed = '150 rpm'\n"
      "[variables.gear_ratio]\nlower = 10\nupper = 20\nstart = 10\n"
      "[objective]\nminimize = 'torque_rms'\n"
      "[[constraints]]\nresponse = 'peak motor_torque'\nover = 'down'\nupper = 100\n";
  ProblemStatement problem = read_problem(moves(kPure + rest), "f.toml");
  CHECK(value_in(problem, "slow.torque_rms") == Approx(rms_by_hand(75)).epsilon(1e-9));
  CHECK(value_in(problem, "fast.torque_rms") == Approx(rms_by_hand(150)).epsilon(1e-9));
  CHECK(value_in(problem, "fast.acceleration") ==
        Approx(value_in(problem, "slow.acceleration")).epsilon(1e-9));
  set_value(problem, "slow.speed=60");
  CHECK(value_in(problem, "slow.torque_rms") == Approx(rms_by_hand(60)).epsilon(1e-9));
  CHECK_THAT(complaint([&] { set_value(problem, "fast.speed=239"); }),
             Contains("in case fast") && Contains("no angle is left"));
  // A limit in a segment is on where that lies in its case: 'down' is the slower move.
  const optim::Problem made = bound(problem);
  const double slow_move = (1.6e-4 + 0.3e-4 + 0.02 / 100) * 10 * 4 * 1.5707963267949 / 0.0225;
  std::size_t curves = 0;
  for (const optim::Constraint& c : made.constraints) {
    if (!c.response.is_curve()) continue;
    ++curves;
    INFO(c.response.name);
    const auto found = optim::highest(*c.response.curve().trace(made.start()), 1);
    CHECK(found.value == Approx(slow_move).epsilon(1e-6));
  }
  CHECK(curves == 2);
  CHECK_THAT(complaint(moves(kPure + "[[cases]]\nname = 'slow'\nspeed = '60 rpm'\n"
                                     "[[cases]]\nname = 'fast'\nspeed = '300 rpm'\n")),
             Contains("in case fast") && Contains("no angle is left"));
}

TEST_CASE("over a range of speeds an axis has the program of each", "[program_timing]") {
  // The way back takes what 100 and 60 ms leave of a turn: 80 ms at 250 rpm, the least.
  const auto axis = [](const std::string& upper, const std::string& rest) {
    return read_problem(
        "mechanism = 'servo-axis'\n[program]\nmatched = 'velocity'\nsegments = "
        "[{name = 'up', time = '100 ms', law = 'parabolic'},\n{name = 'high', time "
        "= '60 ms'}, {name = 'back', law = 'parabolic'}]\n" +
            kPure + "[ranges.speed]\nlower = 60\nupper = " + upper +
            "\n[variables.gear_ratio]\nlower = 10\nupper = 20\nstart = 10\n" + rest,
        "f.toml");
  };
  const double torque = (1.6e-4 + 0.3e-4 + 0.02 / 100) * 10 * 4 * 1.5707963267949;
  const std::string limits =
      "[objective]\nminimize = 'peak motor_torque'\n"
      "[[constraints]]\nresponse = 'motor_torque'\nupper = 100\n"
      "[[constraints]]\nresponse = 'motor_torque'\nover = 'up'\nupper = 100\n";
  const ProblemStatement problem = axis("250", limits);
  const optim::Problem made = bound(problem);
  CHECK(made.objectives[0].response.function().value(made.start()) ==
        Approx(torque / (0.08 * 0.08)).epsilon(1e-6));
  REQUIRE(made.constraints.size() == 2);
  CHECK(made.constraints[0].response.function().value(made.start()) ==
        Approx(torque / (0.08 * 0.08)).epsilon(1e-6));
  CHECK(made.constraints[1].response.function().value(made.start()) ==
        Approx(torque / (0.1 * 0.1)).epsilon(1e-6));
  CHECK_NOTHROW(design_numbers(
      problem, design_parameters(problem)));  // of a limit over a part of the cycle too
  const ConstraintStatement& limit = problem.constraints.front();
  const auto worst = worst_in_ranges(problem, limit.response, {});
  REQUIRE(worst.size() == 1);
  CHECK(worst.front().parameter == "speed");
  CHECK(worst.front().value == Approx(250));
  // At 400 rpm a turn takes 150 ms.
  CHECK_THAT(complaint([&] { axis("400", limits); }),
             Contains("at speed = 400 rpm") && Contains("no angle is left"));
  // Where a time varies, what the fastest turn leaves is a limit.
  const optim::Problem roomy = bound(
      axis("250",
           "[variables.up_time]\nlower = '20 ms'\nupper = '300 ms'\nstart = '100 ms'\n" + limits));
  const auto room = std::find_if(roomy.constraints.begin(), roomy.constraints.end(),
                                 [](const auto& c) { return c.lower == 0.0; });
  REQUIRE(room != roomy.constraints.end());
  CHECK(room->response.function().value(roomy.start()) == Approx(1 - 250 * 0.16 / 60));
}

TEST_CASE("a design without values is not nearer to a limit than one with them",
          "[program_timing]") {
  // At most designs of the box the times take more than a turn, and the energy has no value. Its
  // least, 9.306 J, is at the longest time and the least ratio, at any of the lower speeds.
  const ProblemStatement problem = read_problem(R"toml(
mechanism = "linear-servo-axis"
[constants]
stroke = "160 mm"
feed = "40 mm"
gear_inertia = 0.6
gear_efficiency = 0.83
mass = "23 kg"
load_force = "-70 N"
friction_force = "35 N"
viscous_friction = 60
motor_inertia = 1.1
continuous_torque = 2
maximum_torque = 6
corner_speed = 1500
maximum_speed = 4000
end_torque = 1.5
[program]
matched = "velocity"
[[program.segments]]
name = "out"
time = "210 ms"
law = "parabolic"
to = 1
[[program.segments]]
name = "dw"
angle = "3 deg"
[[program.segments]]
name = "back"
time = "330 ms"
law = "modified-sine"
to = 0.25
[[program.segments]]
name = "back2"
angle = "40 deg"
law = "cosine"
to = 0
[[program.segments]]
name = "rest"
[variables.speed]
lower = "20 rpm"
upper = "95 rpm"
start = "50 rpm"
[variables.out_time]
lower = "120 ms"
upper = "400 ms"
[variables.gear_ratio]
lower = 0.5
upper = 6
[objective]
maximize = "speed"
[[cases]]
name = "full"
mass = "30 kg"
[[cases]]
name = "empty"
mass = "9 kg"
load_force = "120 N"
[[constraints]]
response = "regenerated_energy"
upper = 8
)toml",
                                                "f.toml");
  const optim::Assessment a = optim::optimise(BoundProblem(problem).space()).found.assessment;
  CHECK(a.verdict == optim::Verdict::Infeasible);
  REQUIRE_FALSE(a.blamed.empty());
  CHECK(a.blamed.front() == "full.regenerated_energy");
}

TEST_CASE("a program at a speed that varies leaves room for its last segment", "[program_timing]") {
  const std::string rest = kPure +
                           "[variables.speed]\nlower = 40\nupper = 1000\nstart = 90\n"
                           "[objective]\nmaximize = 'speed'\n";
  const auto found = optim::optimise(BoundProblem(read_problem(moves(rest), "f.toml")).space());
  // 340 deg less the least angle of a segment, in 0.25 s.
  CHECK(found.found.x[0] == Approx((340 - 1e-3) / 360 * 60 / 0.25).epsilon(1e-8));
  CHECK(found.found.assessment.verdict == optim::Verdict::Certified);
  CHECK(found.found.assessment.global);
  // In the fastest case, where times vary.
  const std::string cases =
      kPure +
      "[[cases]]\nname = 'slow'\nspeed = 60\n[[cases]]\nname = 'fast'\nspeed = 150\n"
      "[variables.up_time]\nlower = '50 ms'\nupper = '900 ms'\nstart = '60 ms'\n"
      "[objective]\nminimize = 'torque_rms'\n";
  const auto longest = optim::optimise(BoundProblem(read_problem(moves(cases), "f.toml")).space());
  CHECK(longest.found.x[0] == Approx((340 - 1e-3) / 360 * 60 / 150 - 0.15).epsilon(1e-8));
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
      {moves(varies, "cycle_time = '1 s'\n"), "drop cycle_time"},
      {"mechanism = 'servo-axis'\n[program]\nsegments = [{name = 'up', time = '0.1 s', law = "
       "'cycloidal'}, {name = 'back', law = 'cycloidal', time = '0.1 s'}]\n" +
           varies,
       "leave its time out"},
      {"mechanism = 'servo-axis'\n[program]\nsegments = [{name = 'up', time = '0.1 s', law = "
       "'joining', points = [{time = '50 ms', to = 0.4}]}, {name = 'back', law = 'cycloidal'}]\n" +
           varies,
       "state them by angle"},
      {moves(varies + "[variables.cycle_speed]\nlower = 30\nupper = 60\n"),
       "no parameter 'cycle_speed'"},
      {moves(varies + "[variables.up_angle]\nlower = 30\nupper = 60\n"), "up_time"},
      {cam("time = '2 s'", "cycle_time = '1 s'\n"), "add up to 720 deg; they must"},
  };
  for (const Case& c : cases) {
    INFO(c.text);
    CHECK_THAT(complaint(c.text), Contains(c.part));
  }
}

}  // namespace camlaw::problems::program_timing_test
