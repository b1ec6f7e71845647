// SPDX-License-Identifier: MIT
// What the parameters of a law must leave together is a limit like others: the best law may stand
// at it.
#include "problems/statement/law_rooms.h"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "optim/search/optimise.h"
#include "problems/statement/bind.h"

namespace camlaw::problems::law_rooms_test {
namespace {

using optim::Verdict;

std::string law_problem(const std::string& law, const std::string& wanted,
                        const std::vector<std::string>& variables) {
  std::string text = fmt::format("mechanism = 'law'\n[law]\n{}\n", law);
  for (const std::string& v : variables) {
    text += fmt::format("[variables.{}\n", v);
  }
  return text + wanted;
}

std::string between(const std::string& name, double lower, double upper) {
  return fmt::format("{}]\nlower = {}\nupper = {}", name, lower, upper);
}

optim::Optimum solved(const std::string& text) {
  return optim::optimise(BoundProblem(read_problem(text, "test.toml")).space());
}

double value_of_limit(const optim::Optimum& optimum, const std::string& name) {
  for (const auto& limit : optimum.found.assessment.limits) {
    if (limit.name == name) return limit.value;
  }
  return std::nan("");
}

std::size_t limits_of(const std::string& text) {
  return read_problem(text, "test.toml").constraints.size();
}

}  // namespace

TEST_CASE("the least acceleration of sine, constant and cosine is the parabola's, at the edge",
          "[law-rooms]") {
  const auto optimum =
      solved(law_problem("name = 'scca'", "[objective]\nminimize = 'C'\n",
                         {between("a", 0, 1), between("b", 0, 1), between("c", 0, 1)}));
  CHECK(optimum.found.assessment.verdict == Verdict::Certified);
  CHECK(optimum.found.assessment.objective.value == Approx(4).epsilon(1e-9));
  CHECK(std::abs(value_of_limit(optimum, "1 - a - b - c")) < 1e-9);
}

TEST_CASE("straight ramps without constant velocity have the least acceleration for their jerk",
          "[law-rooms]") {
  // Without constant velocity C = 2 / (1/2 - r) and D = C / r for ramps r: of D = 80 a quadratic.
  const double r = (0.5 - std::sqrt(0.25 - 8.0 / 80)) / 2;
  const auto optimum = solved(
      law_problem("name = 'trapezoidal-acceleration'",
                  "[objective]\nminimize = 'C'\n[[constraints]]\nresponse = 'D'\nupper = 80\n",
                  {between("ramp", 0.01, 0.5), between("constant", 0, 0.5)}));
  CHECK(optimum.found.assessment.verdict == Verdict::Certified);
  CHECK(optimum.found.assessment.objective.value == Approx(2 / (0.5 - r)).epsilon(1e-7));
}

TEST_CASE("the least jerk of an S-curve has neither constant acceleration nor constant velocity",
          "[law-rooms]") {
  for (const bool stated : {false, true}) {
    INFO(stated);
    auto variables =
        std::vector{between("B", 1.1, 3) + "\nstart = 1.9", between("C", 4, 20) + "\nstart = 7"};
    // A jerk that is stated must fit: 1/B + B/C + C/D = 1.
    const double start = 7 / (1 - 1 / 1.9 - 1.9 / 7);
    if (stated) variables.push_back(between("'D[1]'", 20, 200));
    const auto optimum = solved(
        law_problem("name = 's-curve'" + (stated ? fmt::format("\nD = [{:.9g}]", start) : ""),
                    "[objective]\nminimize = 'D'\n", variables));
    INFO(optimum.found.assessment.reason);
    CHECK(optimum.found.assessment.verdict == Verdict::Certified);
    CHECK(optimum.found.assessment.objective.value == Approx(32).epsilon(1e-6));
  }
}

TEST_CASE("harmonics that must make the stroke are held to it", "[law-rooms]") {
  const auto optimum =
      solved(law_problem("name = 'triple-harmonic'", "[objective]\nminimize = 'C'\n",
                         {between("h1", -20, 20), between("h2", -20, 20), between("h3", -20, 20)}));
  CHECK(optimum.found.assessment.verdict == Verdict::Certified);
  // Without the second harmonic, and with u = sin(2 pi x): (h1 + 3 h3) u - 4 h3 u^3, whose highest
  // value is inside, where u^2 = (h1 + 3 h3) / (12 h3), or at u = 1.
  double least = 1e9;
  for (int i = 1; i <= 200000; ++i) {
    const double h3 = 3.0 * i / 200000, h1 = 2 * std::numbers::pi - h3 / 3, sum = h1 + 3 * h3;
    const double u = std::min(1.0, std::sqrt(sum / (12 * h3)));
    least = std::min(least, std::max(std::abs(sum * u - 4 * h3 * u * u * u), std::abs(h1 - h3)));
  }
  CHECK(optimum.found.assessment.objective.value == Approx(least).epsilon(1e-6));
}

TEST_CASE("the angles of a program leave something for its last segment", "[law-rooms]") {
  const auto text = [](double most) {
    return fmt::format(
        "mechanism = 'disc-cam-flat'\n[program]\nsegments = ["
        "{{name = 'rise', angle = 90, law = 'cycloidal'}}, {{name = 'high', angle = 60}}, "
        "{{name = 'back', angle = 90, law = 'cycloidal'}}, {{name = 'low'}}]\n"
        "[variables.rise_angle]\nlower = 60\nupper = {}\n"
        "[variables.back_angle]\nlower = 60\nupper = {}\n"
        "[objective]\nminimize = 'peak acceleration'\n",
        most, most);
  };
  CHECK(limits_of(text(140)) + 1 == limits_of(text(200)));
  const auto optimum = solved(text(200));
  CHECK(optimum.found.assessment.verdict == Verdict::Certified);
  // Nothing is left for 'low', and rise and return share what 'high' leaves.
  CHECK(optimum.found.x[0] == Approx((300 - 1e-3) / 2).epsilon(1e-6));
  CHECK(optimum.found.x[1] == Approx((300 - 1e-3) / 2).epsilon(1e-6));
}

TEST_CASE("a room is a limit only where the bounds can break it, and for the law that has it",
          "[law-rooms]") {
  const std::string wanted = "[objective]\nminimize = 'B'\n";
  const std::vector small{between("a", 0, 0.3), between("b", 0, 0.3), between("c", 0, 0.4)};
  CHECK(limits_of(law_problem("name = 'scca'", wanted, small)) == 0);
  const std::vector one{between("a", 0, 0.6)};
  ProblemStatement fixed =
      read_problem(law_problem("name = 'scca'\nb = 0.2\nc = 0.1", wanted, one), "test.toml");
  CHECK(fixed.constraints.empty());
  set_value(fixed, "b=0.4");
  REQUIRE(fixed.constraints.size() == 1);
  CHECK(fixed.constraints.front().response.name == "1 - a - b - c");
  set_value(fixed, "b=0.1");
  CHECK(fixed.constraints.empty());

  const auto optimum = solved(
      "mechanism = 'law'\n[law]\nname = ['cycloidal', 'scca']\n[variables.'a']\nlower = 0\nupper = "
      "1\n"
      "[objective]\nminimize = 'C'\n");
  CHECK(optimum.found.assessment.verdict == Verdict::Certified);
  CHECK(value_of_limit(optimum, "scca: 1 - a - b - c") >= -1e-10);
}

TEST_CASE("choices that leave a law no room have no designs, and the others are searched",
          "[law-rooms]") {
  const std::string wanted = "[objective]\nminimize = 'C'\n";
  const auto of = [&](const std::string& a, const std::string& b) {
    return solved(law_problem("name = 'scca'", wanted,
                              {"a]\nvalues = [" + a + "]", "b]\nvalues = [" + b + "]",
                               between("c", 0, 1) + "\nstart = 0.2"}));
  };
  // 0.5 and 0.6 leave nothing; of the others the best has the most constant acceleration.
  const auto optimum = of("0.2, 0.5", "0.2, 0.6");
  CHECK(optimum.found.assessment.verdict == Verdict::Certified);
  CHECK(optimum.options.size() == 2);
  CHECK(optimum.found.assessment.objective.value ==
        Approx(of("0.2", "0.6").found.assessment.objective.value).epsilon(1e-9));
  // 0.5 and 0.4 leave 0.1, less than where c begins: it is searched from less.
  CHECK(of("0.2, 0.5", "0.4").found.assessment.verdict == Verdict::Certified);

  const auto angles = solved(
      "mechanism = 'disc-cam-flat'\n[program]\nsegments = ["
      "{name = 'rise', angle = 100, law = 'cycloidal'}, {name = 'back', angle = 100, law = "
      "'cycloidal'}, {name = 'low'}]\n[variables.rise_angle]\nvalues = [100, 200, 280]\n"
      "[objective]\nminimize = 'peak_torque'\n");
  CHECK(angles.found.assessment.verdict == Verdict::Certified);
  CHECK(angles.options.front() == 1);
}

TEST_CASE("a law that meets its limits only without its first phase is found",
          "[law-rooms][long]") {
  // Number 72328 of the adversarial problems, which was called infeasible: with a ramp, however
  // short, the jerk is limited by its length; without it the law begins with its acceleration.
  const std::string limits =
      "[objective]\nminimize = 'C'\n[[constraints]]\nresponse = 'B'\nupper = 1.5607258196977365\n"
      "[[constraints]]\nresponse = 'D'\nupper = 60.247988629589102\n"
      "[[constraints]]\nresponse = 'velocity'\nlower = 0\n";
  const auto optimum = solved(
      law_problem("name = 'scca'", limits,
                  {between("a", 0, 1) + "\nstart = 0.26409046377370776",
                   between("b", 0.030517578125, 0.7373046875) + "\nstart = 0.21179196779834353",
                   between("c", 0, 0.7001953125) + "\nstart = 0.28775786543003673"}));
  REQUIRE(optim::is_feasible(optimum.found.assessment));
  CHECK(optimum.found.x[0] == 0);
  CHECK(optimum.found.assessment.objective.value < 5.77);  // what the judge found
}

}  // namespace camlaw::problems::law_rooms_test
