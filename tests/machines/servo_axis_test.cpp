// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "machines/registry.h"
#include "numerics/text/file_text.h"
#include "optim/search/optimise.h"
#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"
#include "tests/machines/system_fixture.h"

namespace camlaw::problems::servo_axis_test {
namespace {

using testing::design_of, testing::response_of, testing::TestDesign;
constexpr double kPi = std::numbers::pi;

/// Up in the first quarter of the cycle, back in the third one.
std::string program_of(const std::string& law) {
  return fmt::format(R"([program]
matched = "velocity"
segments = [{{name = "up", angle = "90 deg", law = "{0}"}}, {{name = "high", angle = "90 deg"}},
            {{name = "down", angle = "90 deg", law = "{0}"}}, {{name = "low"}}]
)",
                     law);
}

ProblemStatement axis(const std::string& mechanism, const std::string& constants,
                      const std::string& program, const std::string& rest = "") {
  return read_problem(
      fmt::format("mechanism = '{}'\n[constants]\n{}{}{}", mechanism, constants, program, rest),
      "axis.toml");
}

/// Values of everything that an axis has.
class Answers {
 public:
  explicit Answers(const ProblemStatement& statement) : all_(evaluate(statement)) {}
  const EvaluatedResponse& operator[](const std::string& name) const {
    for (const EvaluatedResponse& r : all_) {
      if (r.name == name) return r;
    }
    throw std::invalid_argument(name);
  }

 private:
  std::vector<EvaluatedResponse> all_;
};

constexpr const char* kPlain =
    "stroke = '180 deg'\nspeed = '60 rpm'\ngear_ratio = 5\ngear_inertia = '1 kg cm2'\n"
    "gear_efficiency = 1\nload_inertia = '0.01 kg m2'\nmotor_inertia = '2 kg cm2'\n";

/// An axis by the formulas that a designer writes down, apart from those of the machine.
struct ByHand {
  double turns, own, load, constant, coulomb, viscous, efficiency;
  double torque(double v, double a) const {
    const double side = v > 0 ? 1 : v < 0 ? -1 : 0;
    const double at_shaft = (load * a + viscous * v + coulomb * side + constant) / turns;
    const double factor = side == 0             ? 1
                          : at_shaft * side > 0 ? 1 / efficiency
                                                : efficiency;  // of the power
    return own * turns * a + at_shaft * factor;
  }
};

}  // namespace

TEST_CASE("a parabolic move has the rms torque, power and energy of a triangle of velocity",
          "[servo-axis]") {
  const Answers is(axis("servo-axis", kPlain, program_of("parabolic")));
  // A move of 0.25 s at +-4 S / T^2: (2e-4 + 1e-4 + 0.01 / 25) 5 a, for half of the cycle.
  const double a = 4 * kPi / (0.25 * 0.25), torque = 7e-4 * 5 * a, top = 5 * 2 * kPi / 0.25;
  CHECK(is["torque_rms"].value == Approx(torque * std::sqrt(0.5)).epsilon(1e-12));
  CHECK(is["rms_utilisation"].value == Approx(torque * std::sqrt(0.5) / 2.4).epsilon(1e-12));
  CHECK(is["mean_power"].value == Approx(0).margin(1e-12));
  CHECK(is["regenerated_energy"].value == Approx(2 * 0.5 * 7e-4 * top * top).epsilon(1e-12));
  CHECK(is["motor_torque"].highest == Approx(torque).epsilon(1e-12));
  CHECK(is["motor_speed"].highest == Approx(top * 30 / kPi).epsilon(1e-12));
  CHECK(is["motor_power"].highest == Approx(torque * top).epsilon(1e-9));
  CHECK(is["inertia_ratio"].value == Approx(5e-4 / 2e-4).epsilon(1e-12));
  CHECK(is["matched_ratio"].value == Approx(std::sqrt(0.01 / 3e-4)).epsilon(1e-12));
}

TEST_CASE("friction, gear losses and a constant load add what four phases say", "[servo-axis]") {
  const Answers is(axis("linear-servo-axis",
                        "stroke = '100 mm'\nspeed = '60 rpm'\nfeed = '20 mm'\ngear_ratio = 2\n"
                        "gear_inertia = 0\ngear_efficiency = 0.8\nmass = 20\nload_force = 100\n"
                        "friction_force = 60\nmotor_inertia = '2 kg cm2'\n",
                        program_of("parabolic")));
  const double k = 2 * kPi * 2 / 0.02, a = 4 * 0.1 / (0.25 * 0.25), top = 2 * 0.1 / 0.25;
  const double own = 2e-4 * k * a, eta = 0.8;
  // Up: 20 a + 160 N drives, 20 a - 160 drives back where it is above 0 before the sign is turned.
  const double phases[] = {
      own + (20 * a + 160) / k / eta,                               // up, faster
      -own + (-20 * a + 160) / k * (20 * a > 160 ? eta : 1 / eta),  // up, slower
      -own + (-20 * a + 40) / k * (20 * a > 40 ? 1 / eta : eta),    // down, faster
      own + (20 * a + 40) / k * eta};                               // down, slower
  const double hold = 100 / k;
  double square = hold * hold / 2, power = 0, back = 0;
  const double way[] = {1, 1, -1, -1};
  for (int i = 0; i < 4; ++i) {
    square += phases[i] * phases[i] / 8;
    const double work = phases[i] * way[i] * k * top / 2 / 8;
    power += work;
    back += std::max(0.0, -work);
  }
  CHECK(is["torque_rms"].value == Approx(std::sqrt(square)).epsilon(1e-12));
  CHECK(is["mean_power"].value == Approx(power).epsilon(1e-11));
  CHECK(is["regenerated_energy"].value == Approx(back).epsilon(1e-11));
  CHECK(is["motor_torque"].highest == Approx(phases[0]).epsilon(1e-12));
}

TEST_CASE("numbers and curves of any axis are those of a fine sum", "[servo-axis]") {
  std::mt19937_64 random(20261126);
  std::uniform_real_distribution<double> even(0, 1);
  const Mechanism& mechanism = find_mechanism("linear-servo-axis");
  for (int trial = 0; trial < 24; ++trial) {
    const double friction = trial % 3 == 0 ? 0 : 80 * even(random);
    const double efficiency = trial % 4 == 0 ? 1 : 0.5 + 0.5 * even(random);
    const std::string constants = fmt::format(
        "stroke = {}\nspeed = {}\nfeed = {}\ngear_ratio = {}\ngear_inertia = {}\n"
        "gear_efficiency = {}\nmass = {}\nload_force = {}\nfriction_force = {}\n"
        "viscous_friction = {}\nmotor_inertia = {}\n",
        50 + 300 * even(random), 30 + 60 * even(random), 20 + 150 * even(random),
        1 + 5 * even(random), even(random), efficiency, 2 + 30 * even(random),
        -100 + 200 * even(random), friction, 40 * even(random), 0.5 + 3 * even(random));
    INFO(constants);
    const char* const law[] = {"modified-sine", "cycloidal", "poly-3-4-5", "parabolic"};
    const ProblemStatement statement =
        axis("linear-servo-axis", constants, program_of(law[trial % 4]));
    const auto given = [&](const char* name) { return constant_of(statement, name); };
    const ByHand by{2 * kPi * given("gear_ratio") / (1e-3 * given("feed")),
                    1e-4 * (given("motor_inertia") + given("gear_inertia")),
                    given("mass"),
                    given("load_force"),
                    friction,
                    given("viscous_friction"),
                    efficiency};
    const Law<double> motion = statement.laws.front().law();
    const double cycle = 60 / given("speed"), stroke = 1e-3 * given("stroke");
    constexpr int kPoints = 400000;
    double square = 0, power = 0, back = 0, peak = 0, fastest = 0;
    for (int i = 0; i < kPoints; ++i) {
      const auto at = motion((i + 0.5) / kPoints);
      const double v = stroke * at.v / cycle, a = stroke * at.a / (cycle * cycle);
      const double torque = by.torque(v, a), rate = torque * by.turns * v;
      square += torque * torque / kPoints;
      power += rate / kPoints;
      back += cycle * std::max(0.0, -rate) / kPoints;
      peak = std::max(peak, std::abs(torque));
      fastest = std::max(fastest, std::abs(by.turns * v) * 30 / kPi);
    }
    const Answers is(statement);
    CHECK(is["torque_rms"].value == Approx(std::sqrt(square)).epsilon(1e-7));
    CHECK(is["mean_power"].value == Approx(power).epsilon(1e-7).margin(1e-7));
    CHECK(is["regenerated_energy"].value == Approx(back).epsilon(1e-7).margin(1e-7));
    CHECK(is["peak_motor_speed"].value == Approx(fastest).epsilon(2e-5));
    const auto& torque = is["motor_torque"];
    CHECK(std::max(torque.highest, -torque.lowest) == Approx(peak).epsilon(2e-5));
    // What intervals say of the means holds them, and closely.
    for (const char* name : {"torque_rms", "mean_power", "regenerated_energy"}) {
      INFO(name);
      Binding binding{
          {},
          {},
          {},
          std::make_shared<LawBinding>(statement.laws.front(), std::vector<LawVariable>{})};
      for (const auto& p : mechanism.parameters) binding.constants.push_back(given(p.name.c_str()));
      const auto f = response_of(mechanism, name, binding).function();
      const std::vector<double> nothing;
      const auto bounds = f.enclose(nothing);
      const double value = f.value(nothing), size = std::abs(value) + std::abs(power);
      CHECK((bounds.lower <= value + 1e-12 * size && value - 1e-12 * size <= bounds.upper));
      CHECK(bounds.upper - bounds.lower <= 1e-4 * size);
    }
  }
}

TEST_CASE("without losses a cycle takes no power, and what comes back is what was given",
          "[servo-axis]") {
  const Answers is(
      axis("servo-axis", std::string(kPlain) + "load_torque = 3\n", program_of("modified-sine")));
  CHECK(is["mean_power"].value == Approx(0).margin(1e-10));
  // Viscous friction takes d times the mean square of the velocity.
  const Answers viscous(axis("servo-axis", std::string(kPlain) + "viscous_friction = 0.2\n",
                             program_of("parabolic")));
  const double top = 2 * kPi / 0.25;
  CHECK(viscous["mean_power"].value == Approx(0.2 * top * top / 3 * 0.5).epsilon(1e-12));
}

TEST_CASE("the gear ratio of least torque reflects the inertia of motor and gear", "[servo-axis]") {
  const std::string rest = R"(
[variables.gear_ratio]
lower = 1
upper = 40
[objective]
minimize = "torque_rms"
)";
  std::string constants = kPlain;
  constants.erase(constants.find("gear_ratio"), std::string_view("gear_ratio = 5\n").size());
  const BoundProblem problem(axis("servo-axis", constants, program_of("modified-sine"), rest));
  const auto found = optim::optimise(problem.space()).found;
  CHECK(found.assessment.verdict == optim::Verdict::Certified);
  const double matched = std::sqrt(0.01 / 3e-4);
  CHECK(found.x[0] == Approx(matched).epsilon(1e-6));
  // Twice the ratio needs a quarter more.
  const auto f = problem.space().problem({}).objective().response.function();
  CHECK(f.value(std::vector{2 * matched}) == Approx(1.25 * f.value(std::vector{matched})));
}

TEST_CASE("a limit whose peak is where friction jumps at the start of a motion is searched with",
          "[servo-axis]") {
  // At 0 deg the velocity is 0 and friction with it, just beyond it is whole: a row of that place
  // does not see the peak. The least of regenerated energy is where the limit is reached.
  const std::string program = R"(
[program]
matched = "velocity"
segments = [{name = "up", angle = "110 deg", law = "cubic"}, {name = "high", angle = "50 deg"},
            {name = "down", angle = "130 deg", law = "poly-3-4-5"}, {name = "low"}]
)";
  for (const double start : {7.45, 8.0, 20.0}) {
    const std::string rest = fmt::format(
        "[variables.gear_ratio]\nlower = 1\nupper = 40\nstart = {}\n[objective]\n"
        "minimize = 'regenerated_energy'\n"
        "[[constraints]]\nresponse = 'torque_utilisation'\nupper = 1\n",
        start);
    const BoundProblem problem(
        axis("servo-axis",
             "stroke = '70 deg'\nspeed = '150 rpm'\nload_inertia = 0.06\nfriction_torque = 9\n"
             "viscous_friction = 0.5\ngear_efficiency = 0.8\n",
             program, rest));
    const auto found = optim::optimise(problem.space()).found;
    INFO("from " << start);
    CHECK(found.assessment.verdict == optim::Verdict::Certified);
    // The stroke of 70 deg in the time of 110 deg at 150 rpm: a = 6 s / T^2. The motor's torque at
    // the start is (J + J_g) i a + (J_L a + F) / (0.8 i), of 7.2 N m.
    const double T = 110.0 / (150 * 6), a = 6 * (70 * std::numbers::pi / 180) / (T * T);
    const double own = 1.9e-4 * a, load = (0.06 * a + 9) / 0.8;
    const double ratio = (7.2 - std::sqrt(7.2 * 7.2 - 4 * own * load)) / (2 * own);
    CHECK(found.x[0] == Approx(ratio).epsilon(1e-6));
  }
}

TEST_CASE("friction has the sign of the motion up to where it rests", "[servo-axis]") {
  // An axis that only moves forward: whatever rounding leaves of the velocity at the ends of its
  // moves, 5 N m of friction act against it, beside a load of 3 N m. Inertia takes less than 1 N m.
  for (const std::string law : {"modified-sine", "poly-3-4-5", "parabolic", "cycloidal", "scca"}) {
    for (const int angle : {137, 190, 200, 211}) {
      const std::string program = fmt::format(
          "[program]\nadvance = 1.37\nmatched = 'velocity'\nsegments = [{{name = 'a', angle = "
          "'{}.3 deg', law = '{}', to = 1}}, {{name = 'b', law = '{}', to = 1.37}}]\n",
          angle, law, law);
      const Answers answers(axis("servo-axis",
                                 "stroke = '90 deg'\nspeed = '60 rpm'\nload_inertia = 0.005\n"
                                 "friction_torque = 5\nload_torque = 3\n",
                                 program));
      INFO(law << " over " << angle);
      CHECK(answers["output_torque"].lowest > 7);
      CHECK(answers["output_torque"].highest < 9);
    }
  }
}

TEST_CASE("the motor's curve limits a shipped axis, and is proved to hold", "[servo-axis]") {
  const BoundProblem problem = testing::shipped("servo_axis/pick_and_place.toml");
  const auto found = optim::optimise(problem.space()).found;
  CHECK(found.assessment.verdict == optim::Verdict::Certified);
  const optim::LimitReport& limit = found.assessment.limits.front();
  REQUIRE(limit.name == "torque_utilisation");
  CHECK((limit.proved && limit.met));
  CHECK(limit.margin == Approx(0).margin(1e-8));
  CHECK(limit.multiplier > 0);
  // Beyond the corner speed, where 7.2 N m fall to 0.8 N m between 2800 and 5000 rpm.
  const auto& space = problem.space();
  const auto choices = std::vector<std::size_t>(space.choices.size(), 0);
  const optim::Problem stated = space.problem(choices);
  const auto at = [&](const std::string& name, double angle) {
    const ProblemStatement& statement = problem.statement();
    const ResponseName response = find_response(*statement.mechanism, name);
    ProblemStatement here = statement;
    for (std::size_t i = 0; i < found.x.size(); ++i) {
      set_value(here, fmt::format("{}={:.17g}", here.variables[i].name, found.x[i]));
    }
    for (const auto& curve : curves_of(here)) {
      if (curve.name == response.name) {
        return curve.curve().trace({})->at({angle})[0];
      }
    }
    throw std::invalid_argument(name);
  };
  const double worst = limit.worst_angle.value();
  const double speed = std::abs(at("motor_speed", worst));
  CHECK(speed > 2800);
  const double line = 7.2 - 6.4 * (speed - 2800) / 2200;
  CHECK(at("available_torque", worst) == Approx(line).epsilon(1e-9));
  CHECK(std::abs(at("motor_torque", worst)) == Approx(0.9 * line).epsilon(1e-6));
  CHECK(at("available_torque", 0) == 7.2);  // at rest
}

TEST_CASE("a move takes the time that its file states, and an axis may advance", "[servo-axis]") {
  const BoundProblem problem = testing::shipped("servo_axis/cross_sealer.toml");
  const ProblemStatement& statement = problem.statement();
  for (const auto& curve : curves_of(statement)) {
    const auto trace = curve.curve().trace({});
    if (curve.name == "displacement") {
      // After 90 ms of 300 ms, 0.6 m/s on 60 mm.
      CHECK(trace->at({108})[0] == Approx(0.6 * 0.09 / 0.06 * 180 / kPi).epsilon(1e-5));
      CHECK(trace->at({360, true})[0] == Approx(360).epsilon(1e-12));
    }
    if (curve.name == "velocity") CHECK(trace->at({50})[0] == Approx(10).epsilon(1e-5));
  }
  const auto found = optim::optimise(problem.space()).found;
  CHECK(found.assessment.verdict == optim::Verdict::Certified);
}

TEST_CASE("on a shaft too a move takes its time at every speed, and a cam keeps its angles",
          "[servo-axis]") {
  const std::string shaft =
      "[constants]\nspeed = '60 rpm'\n[cams.axis]\nmechanism = 'servo-axis'\n"
      "[cams.axis.constants]\nstroke = '90 deg'\n[cams.axis.program]\nsegments = [{name = 'go', "
      "time = '0.2 s', law = '3-4-5'}, {name = 'wait', time = '0.1 s'}, {name = 'back', time = "
      "'0.3 "
      "s', law = '3-4-5'}, {name = 'rest'}]\n[cams.press]\nmechanism = 'disc-cam-roller'\n"
      "[cams.press.constants]\nmass = '1 kg'\n[cams.press.program]\nsegments = [{name = 'down', "
      "time "
      "= '0.25 s', law = 'cycloidal'}, {name = 'up', law = 'cycloidal'}]\n";
  const auto highest = [](const ProblemStatement& problem, const std::string& name) {
    for (const auto& response : evaluate(problem)) {
      if (response.name == name) return std::pair(response.highest, response.highest_at);
    }
    FAIL("no response " + name);
    return std::pair(0.0, 0.0);
  };
  const ProblemStatement at_60 = read_problem(shaft, "shaft.toml");
  ProblemStatement at_30 = at_60;
  set_value(at_30, "speed=30 rpm");
  const auto fast = highest(at_60, "axis.velocity"), slow = highest(at_30, "axis.velocity");
  CHECK(slow.first == Approx(fast.first).epsilon(1e-12));
  CHECK(slow.second == Approx(fast.second / 2).epsilon(1e-9));
  // 90 deg in 0.25 s at 60 rpm, kept at 30 rpm.
  CHECK(highest(at_30, "press.displacement").second ==
        Approx(highest(at_60, "press.displacement").second).epsilon(1e-9));
}

TEST_CASE("speeds to choose from are begun with the least, in whatever order they stand",
          "[servo-axis]") {
  std::string text =
      file_text(testing::source("problems/servo_axis/fastest_cycle.toml"), "problem");
  const std::string range = "lower = \"100 rpm\"\nupper = \"400 rpm\"\nstart = \"150 rpm\"\n";
  REQUIRE(text.find(range) != std::string::npos);
  for (const char* const values : {"[100, 210, 300]", "[300, 210, 100]"}) {
    INFO(values);
    std::string chosen = text;
    chosen.replace(chosen.find(range), range.size(), std::string("values = ") + values + "\n");
    const BoundProblem problem(read_problem(chosen, "axis.toml"));
    CHECK(problem.statement().variables.front().start == 100);
    // 220.28 rpm is the fastest of all.
    CHECK(optim::optimise(problem.space()).found.assessment.objective.value == Approx(210));
  }
}

TEST_CASE("the fastest cycle of an axis is that of two equal moves at the matched ratio",
          "[servo-axis]") {
  // The mean square of the acceleration of the 3-4-5 over a move of T and S is 120 / 7 S^2 / T^4,
  // and at the matched ratio each unit of it takes 2 sqrt(J (J_M + J_G)). Two such moves in a cycle
  // of 2 T and 100 ms with the rms torque 0.8 * 2.4 N m: unequal moves of the same cycle heat more.
  const double per_acceleration = 2 * std::sqrt(0.01 * 1.9e-4), stroke = kPi / 2;
  const auto rms = [&](double time) {
    const double square = 120.0 / 7 * stroke * stroke / std::pow(time, 4);
    return per_acceleration * std::sqrt(square * 2 * time / (2 * time + 0.1));
  };
  double low = 0.01, high = 1;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (rms(middle) > 0.8 * 2.4 ? low : high) = middle;
  }
  const auto optimum = optim::optimise(testing::shipped("servo_axis/fastest_cycle.toml").space());
  const optim::Assessment& a = optimum.found.assessment;
  CHECK(a.verdict == optim::Verdict::Certified);
  CHECK(optimum.found.x[0] == Approx(60 / (2 * low + 0.1)).epsilon(1e-8));
  CHECK(optimum.found.x[1] == Approx(low).epsilon(1e-5));
  CHECK(optimum.found.x[2] == Approx(std::sqrt(0.01 / 1.9e-4)).epsilon(1e-5));
  // Along equal moves n = 60 / (2 T + 0.1 s), so dn/dT = -n^2 / 30, over that of the utilisation.
  const double step = 1e-6 * low;
  const double slope = (rms(low + step) - rms(low - step)) / (2 * step) / 2.4;
  const double speed = 60 / (2 * low + 0.1);
  const double price = -speed * speed / 30 / slope;
  for (const optim::LimitReport& limit : a.limits) {
    if (limit.name == "rms_utilisation") CHECK(limit.multiplier == Approx(price).epsilon(1e-5));
  }
}

TEST_CASE("derivatives of an axis that turns round inside a segment are exact", "[servo-axis]") {
  // From 0 by way of 1 to 0.4 and on to 0: it turns round inside, against Coulomb friction.
  const std::string program = R"([program]
[[program.segments]]
name = "over"
angle = "150 deg"
law = "joining"
to = 0.4
points = [{angle = "60 deg", to = 1}]
[[program.segments]]
name = "back"
angle = "120 deg"
law = "joining"
to = 0
[[program.segments]]
name = "low"
[variables.over_to]
lower = 0.2
upper = 0.6
[variables.gear_ratio]
lower = 1
upper = 40
[objective]
minimize = "torque_rms"
)";
  for (const char* sought : {"torque_rms", "regenerated_energy", "mean_power"}) {
    INFO(sought);
    std::string text = program;
    text.replace(text.find("torque_rms"), 10, sought);
    const BoundProblem problem(axis("servo-axis",
                                    "stroke = '180 deg'\nspeed = '60 rpm'\ngear_efficiency = 0.8\n"
                                    "friction_torque = 4\nload_torque = 1\n",
                                    text));
    const auto stated = problem.space().problem({});
    testing::check_derivatives(stated.objective().response.function(), stated.start(), 1e-4, 1e-5);
  }
}

TEST_CASE("a motor whose torque falls before it may is not possible", "[servo-axis]") {
  const Answers is(axis("servo-axis", "corner_speed = 6000\nmaximum_speed = 6000\n",
                        program_of("modified-sine")));
  CHECK(std::isnan(is["torque_rms"].value));
}

}  // namespace camlaw::problems::servo_axis_test
