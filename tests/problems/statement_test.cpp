// SPDX-License-Identifier: MIT
#include "problems/statement/statement.h"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <string>

#include "problems/statement/bind.h"
#include "tests/paths.h"
#include "tests/temporary_folder.h"

namespace camlaw::problems::statement_test {
namespace {

using Catch::Matchers::Contains, Catch::Matchers::StartsWith;

const std::string kComplete = R"(
title = "Least cam radius of the spine cutter"
mechanism = "spine-cutter"

[constants]
stroke = "4.5 cm"
mass = 2.5

[law]
name = "polynomial-5"
crossover = 0.45

[variables.alpha]
lower = -10
upper = 0
start = -3
scale = 1
[variables.z]
lower = 10
upper = 30
type = "integer"
[variables.cutter_diameter]
values = ["40 mm", "50 mm", "63 mm"]
[variables.cam_radius]
lower = 20
upper = "10 cm"
start = 60

[objective]
minimize = "cam_radius"
tolerance = "0.01 mm"

[[constraints]]
response = "cam_pressure_angle"
upper = "30 deg"
tolerance = "0.01 deg"
[[constraints]]
response = "peak inertia_force"
upper = 20
[[constraints]]
response = "blades_in_contact"
equals = 1

[solver]
name = "ipopt"
starts = 10
seed = 3
time_limit = "1 min"
)";

ProblemStatement read(const std::string& rest, const std::string& law = "polynomial-5") {
  return read_problem("mechanism = 'spine-cutter'\nlaw.name = '" + law + "'\n" + rest, "f.toml");
}

double constant(const ProblemStatement& problem, const char* name) {
  return problem.constants.at(problem.mechanism->parameter(name));
}

std::vector<double> argument(const Member& law, const char* name) {
  return law.arguments.list(law.family->parameter(name));
}

/// The error for an assignment, or "accepted".
std::string complaint(ProblemStatement problem, const std::string& assignment) {
  try {
    set_value(problem, assignment);
    return "accepted";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

/// A problem file that goes when the test does.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& text) : path_(folder_ / "statement.toml") {
    std::ofstream(path_, std::ios::binary) << text;
  }
  const std::string& path() const { return path_; }

 private:
  camlaw::testing::Folder folder_;
  std::string path_;
};

}  // namespace

TEST_CASE("a complete file is read to its numbers, in the listed units", "[statement]") {
  const ProblemStatement p = read_problem(kComplete, "f.toml");
  CHECK(p.title == "Least cam radius of the spine cutter");
  REQUIRE(p.mechanism != nullptr);
  CHECK(p.mechanism->name == "spine-cutter");
  CHECK(constant(p, "stroke") == Approx(45).epsilon(1e-14));
  CHECK(constant(p, "mass") == 2.5);
  CHECK(constant(p, "depth") == Approx(0.4).epsilon(1e-14));  // the default
  REQUIRE(p.laws.size() == 1);
  CHECK(p.laws[0].family->name == "polynomial-5");
  CHECK(argument(p.laws[0], "crossover") == std::vector{0.45});
  REQUIRE(p.objectives.size() == 1);
  CHECK(p.objectives.front().response.name == "cam_radius");
  CHECK(p.objectives.front().sense == optim::Sense::Minimize);
  CHECK(p.objectives.front().tolerance == 0.01);
  CHECK(p.solver.name == "ipopt");
  CHECK(p.solver.starts == 10);
  CHECK(p.solver.seed == 3u);
  CHECK(p.solver.time_limit == 60.0);
}

TEST_CASE("variables come in the order of the file, with bounds, starts and kinds", "[statement]") {
  const ProblemStatement p = read_problem(kComplete, "f.toml");
  REQUIRE(p.variables.size() == 4);
  const VariableStatement &alpha = p.variables[0], &blades = p.variables[1],
                          &diameter = p.variables[2], &radius = p.variables[3];
  CHECK(alpha.name == "alpha");
  CHECK(alpha.of_law);
  CHECK(alpha.law_parameter == "alpha");
  CHECK(alpha.lower == -10);
  CHECK(alpha.upper == 0);
  CHECK(alpha.start == -3);
  CHECK(alpha.scale == 1.0);
  CHECK_FALSE(alpha.integer);
  CHECK(blades.name == "blades");  // found by its symbol
  CHECK_FALSE(blades.of_law);
  CHECK(blades.parameter == p.mechanism->parameter("blades"));
  CHECK(blades.integer);
  CHECK(blades.start == 17);  // the default
  CHECK_FALSE(blades.scale);
  CHECK(diameter.unit == "mm");
  CHECK(diameter.values == std::vector<double>{40, 50, 63});
  CHECK(diameter.lower == 40);
  CHECK(diameter.upper == 63);
  CHECK(diameter.start == 50);
  CHECK(radius.upper == Approx(100).epsilon(1e-14));
  CHECK(radius.start == 60);
}

TEST_CASE("constants and laws hold the starts of what varies", "[statement]") {
  const ProblemStatement p = read_problem(kComplete, "f.toml");
  CHECK(argument(p.laws[0], "alpha") == std::vector{-3.0});
  CHECK(constant(p, "cam_radius") == 60);
  CHECK(constant(p, "blades") == 17);
}

TEST_CASE("constraints know their response, its part and the bounds", "[statement]") {
  const ProblemStatement p = read_problem(kComplete, "f.toml");
  REQUIRE(p.constraints.size() == 3);
  const ConstraintStatement &angle = p.constraints[0], &force = p.constraints[1],
                            &contact = p.constraints[2];
  CHECK(angle.response.part == optim::Part::Value);
  CHECK(angle.response.response->curve);
  CHECK_FALSE(angle.lower);
  CHECK(angle.upper == 30.0);
  CHECK(angle.tolerance == 0.01);
  CHECK(force.response.part == optim::Part::Magnitude);
  CHECK(force.response.response->name == "inertia_force");
  CHECK(contact.lower == 1.0);
  CHECK(contact.upper == 1.0);
  CHECK_FALSE(contact.tolerance);
}

TEST_CASE("a start that is not given is the present value, else the middle", "[statement]") {
  const char* alpha = "[variables.alpha]\nlower = -10\nupper = -4";
  CHECK(read(alpha, "polynomial-5 alpha=-5").variables[0].start == -5);
  CHECK(read(alpha, "polynomial-5 alpha=-3").variables[0].start == -7);
  CHECK(read("[variables.stroke]\nlower = 30\nupper = 50").variables[0].start == Approx(40));
  CHECK(read("[variables.stroke]\nlower = 50\nupper = 60").variables[0].start == 55);
  CHECK(read("[variables.blades]\ntype = 'integer'\nlower = 20\nupper = 25").variables[0].start ==
        22);
  CHECK(read("[variables.stroke]\nvalues = [30, 60]").variables[0].start == 30);
  CHECK(read("[variables.stroke]\nvalues = [30, 60]\nstart = '6 cm'").variables[0].start == 60);
}

TEST_CASE("a list parameter varies whole, its length from the start", "[statement]") {
  const ProblemStatement p = read(
      "[variables.c]\nstart = [-1.8, 0.2, 0, 0]\nlower = -20\nupper = [20, 10, 5, 2]\nscale = 2",
      "legendre");
  REQUIRE(p.variables.size() == 4);
  CHECK(p.variables[1].name == "c[2]");
  CHECK(p.variables[1].law_parameter == "c");
  CHECK(p.variables[1].element == 1);
  CHECK(p.variables[1].lower == -20);
  CHECK(p.variables[1].upper == 10);
  CHECK(p.variables[1].start == 0.2);
  CHECK(p.variables[3].scale == 2.0);
  CHECK(argument(p.laws[0], "c") == std::vector{-1.8, 0.2, 0.0, 0.0});
}

TEST_CASE("one element of a list varies, the others stay", "[statement]") {
  const ProblemStatement p =
      read("law.c = [-1, 2, 3]\n[variables.'c[2]']\nlower = 0\nupper = 5", "legendre");
  REQUIRE(p.variables.size() == 1);
  CHECK(p.variables[0].name == "c[2]");
  CHECK(p.variables[0].element == 1);
  CHECK(p.variables[0].start == 2);
  CHECK(argument(p.laws[0], "c") == std::vector{-1.0, 2.0, 3.0});
}

TEST_CASE("one law of several is chosen, and a variable need not be in all", "[statement]") {
  const ProblemStatement p = read_problem(
      "mechanism = 'spine-cutter'\n[law]\n"
      "name = ['cosine', 'polynomial-5 alpha=-3', 'inclined-sinusoid angle=1.5rad']\n"
      "crossover = 0.4\n[variables.alpha]\nlower = -5\nupper = 0",
      "f.toml");
  REQUIRE(p.laws.size() == 3);
  CHECK(argument(p.laws[0], "crossover") == std::vector{0.4});
  CHECK(argument(p.laws[1], "alpha") == std::vector{-3.0});
  CHECK(argument(p.laws[2], "angle").front() == Approx(1.5 * 180 / std::numbers::pi));
  REQUIRE(p.variables.size() == 1);
  CHECK(p.variables[0].start == -3);
}

TEST_CASE("a parameter that shapes the law varies in steps of 1 or among values", "[statement]") {
  const ProblemStatement p =
      read("[variables.'exponents[3]']\nvalues = [5, 5.5, 6]\nstart = 5.5", "stoddart");
  CHECK(p.variables[0].values == std::vector{5.0, 5.5, 6.0});
  CHECK(p.variables[0].start == 5.5);
  CHECK(read("[variables.'exponents[3]']\ntype = 'integer'\nlower = 5\nupper = 7", "stoddart")
            .variables[0]
            .integer);
}

TEST_CASE("law and machine tell apart what both have", "[statement]") {
  const std::string bounds = "lower = 0.1\nupper = 1\n";
  const std::string table = "table x=0,0.5,1 s=0,0.5,1 v=0.1,0.2,0.3";
  const ProblemStatement p = read("[variables.'law.v[2]']\n" + bounds + "[variables.machine.V]\n" +
                                      bounds + "[variables.machine.v]\nlower = 20\nupper = 40",
                                  table);
  REQUIRE(p.variables.size() == 3);
  CHECK(p.variables[0].name == "law.v[2]");
  CHECK(p.variables[0].of_law);
  CHECK(p.variables[1].name == "block_speed");
  CHECK(p.variables[2].name == "pressure_angle");
  ProblemStatement set = p;
  set_value(set, "law.v[2]=0.3");
  CHECK(set.variables[0].start == 0.3);
}

TEST_CASE("a value a rounding of units beside a bound is the bound", "[statement]") {
  const ProblemStatement p =
      read("[variables.stroke]\nlower = '0.041 m'\nupper = 41.3\nstart = '4.13 cm'");
  CHECK(p.variables[0].start == 41.3);
}

TEST_CASE("a file without objective, variables and constraints is a design", "[statement]") {
  const ProblemStatement p = read("");
  CHECK(p.variables.empty());
  CHECK(p.objectives.empty());
  CHECK(p.constraints.empty());
}

TEST_CASE("a problem is read from a file, which its errors name", "[statement]") {
  const TemporaryFile good(kComplete);
  CHECK(read_problem_file(good.path()).variables.size() == 4);
  const TemporaryFile bad("mechanism = 'spine-cutter'\nlaw = 3");
  CHECK_THROWS_WITH(read_problem_file(bad.path()), StartsWith(bad.path() + ":2: law: "));
}

TEST_CASE("the examples of docs/problem-files.md can be read", "[statement]") {
  std::ifstream file(testing::source("docs/problem-files.md"));
  const std::string page(std::istreambuf_iterator<char>(file), {});
  const std::string fence = "```toml\n";
  std::vector<ProblemStatement> read;
  for (std::size_t at = page.find(fence); at != std::string::npos; at = page.find(fence, at + 1)) {
    const std::size_t start = at + fence.size();
    const std::string example = page.substr(start, page.find("```", start) - start);
    if (example.starts_with("title")) read.push_back(read_problem(example, "docs"));
  }
  REQUIRE(read.size() == 2);
  CHECK(read[0].variables.size() == 4);
  CHECK(read[0].constraints.size() == 3);
  CHECK(read[1].laws.size() == 2);
  CHECK(read[1].variables.front().law_parameter == "rise_angle");
}

TEST_CASE("a file that is too large is refused, not read", "[statement]") {
  CHECK_THROWS_WITH(read_problem_file("/dev/zero"), Contains("larger than 16 MiB"));
  const TemporaryFile large("#" + std::string(16U << 20U, 'x'));
  CHECK_THROWS_WITH(read_problem_file(large.path()), StartsWith(large.path() + ": it is larger"));
}

TEST_CASE("a solver may be auto, in any case", "[statement]") {
  CHECK(read("[solver]\nname = 'auto'").solver.name == "auto");
  CHECK(read("[solver]\nname = 'SLSQP'").solver.name == "slsqp");
}

TEST_CASE("a solver's own options are read, whichever solver is asked for",
          "[statement][solvers]") {
  const ProblemStatement p = read(
      "[solver]\nname = 'slsqp'\nseed = 3\n[solver.ipopt]\nmu_strategy = 'adaptive'\n"
      "max_soc = 2\nmu_init = 1\n[solver.crs2]\n");
  CHECK(p.solver.name == "slsqp");
  const std::int64_t one = 1, two = 2;
  const optim::NativeOptions ipopt{{"mu_strategy", "adaptive"}, {"max_soc", two}, {"mu_init", one}};
  CHECK(p.solver.native.at("ipopt") == ipopt);
  CHECK(p.solver.native.at("crs2").empty());
  const std::string words = in_words(p);
  CHECK(words.find("Solve with slsqp, with seed 3.\n"
                   "Run ipopt with max_soc = 2, mu_init = 1, mu_strategy = adaptive.\n") !=
        std::string::npos);
  CHECK(words.find("crs2") == std::string::npos);
}

TEST_CASE("a problem without objective or with too many combinations is not bound", "[statement]") {
  const auto refused = [](const ProblemStatement& problem) {
    try {
      BoundProblem(problem).space();
      return std::string("accepted");
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
  };
  const std::string varies = "[variables.stroke]\nlower = 10\nupper = 60\n";
  CHECK_THAT(refused(read(varies)), StartsWith("f.toml: ") && Contains("no objective"));
  const std::string objective = "[objective]\nminimize = 'peak_inertia_force'\n";
  CHECK_THAT(refused(read(objective)),
             StartsWith("f.toml: ") && Contains("no variables") && Contains("camlaw evaluate"));
  std::string values = "values = [1";
  for (int i = 2; i <= 400; ++i) values.append(",").append(std::to_string(i));
  values += "]\n";
  const std::string stroke = objective + "[variables.stroke]\n" + values;
  CHECK(refused(read(stroke)) == "accepted");
  const ProblemStatement both = read(stroke + "[variables.mass]\n" + values);
  CHECK_THAT(refused(both), StartsWith("f.toml: ") && Contains("160000") && Contains("100000"));
  CHECK_THAT(in_words(both), Contains("Choose stroke among 400 values from 1 to 400 mm, "));
}

TEST_CASE("limits on one response are told apart by a number", "[statement]") {
  const ProblemStatement p = read(
      "[[constraints]]\nresponse = 'peak inertia_force'\nupper = 20\n"
      "[[constraints]]\nresponse = 'peak inertia_force'\nupper = 1");
  const auto limits = standing(p);
  REQUIRE(limits.size() == 2);
  CHECK(limits[0].name == "peak inertia_force");
  CHECK(limits[1].name == "peak inertia_force (2)");
}

TEST_CASE("a limit on a largest size is told from the side that was written", "[statement]") {
  // Highest first: s'' of this law falls lower than it rises.
  const ProblemStatement p = read_problem(
      "mechanism = 'law'\nlaw.name = 'polynomial-5'\nlaw.alpha = -3\nlaw.crossover = 0.6\n"
      "[[constraints]]\nresponse = 'C'\nupper = 3",
      "f.toml");
  const auto limits = standing(p);
  REQUIRE(limits.size() == 1);
  CHECK(limits[0].is_upper);
  CHECK(limits[0].bound == 3);
  CHECK(limits[0].value > 3);
  CHECK_FALSE(limits[0].met);
}

TEST_CASE("what cannot be read as a file is named with the cause", "[statement]") {
  CHECK_THROWS_WITH(read_problem_file("/no/such.toml"),
                    StartsWith("/no/such.toml: ") && Contains("No such file"));
  const std::string directory = std::filesystem::temp_directory_path().string();
  CHECK_THROWS_WITH(read_problem_file(directory), Contains("is a directory"));
  const TemporaryFile empty("");
  CHECK_THROWS_WITH(read_problem_file(empty.path()), Contains("is empty"));
}

TEST_CASE("set_value sets starts, constants and fixed parameters of the law", "[statement]") {
  ProblemStatement p = read_problem(kComplete, "f.toml");
  set_value(p, "alpha=-5");
  set_value(p, " z = 21 ");
  set_value(p, "cutter_diameter = 0.063 m");
  set_value(p, "S_f=30 mm");
  set_value(p, "crossover=0.5");
  CHECK(p.variables[0].start == -5);
  CHECK(argument(p.laws[0], "alpha") == std::vector{-5.0});
  CHECK(p.variables[1].start == 21);
  CHECK(p.variables[2].start == 63);
  CHECK(constant(p, "stroke") == Approx(30));
  CHECK(argument(p.laws[0], "crossover") == std::vector{0.5});
}

TEST_CASE("set_value sets lists whole and by element", "[statement]") {
  ProblemStatement fixed = read("", "legendre");
  set_value(fixed, "c = 1, 2, 3");
  CHECK(argument(fixed.laws[0], "c") == std::vector{1.0, 2.0, 3.0});
  ProblemStatement varied = read("[variables.c]\nlower = -5\nupper = 5", "legendre");
  set_value(varied, "c=1,2");
  set_value(varied, "c[2]=3");
  CHECK(varied.variables[0].start == 1);
  CHECK(varied.variables[1].start == 3);
  CHECK_THAT(complaint(varied, "c=1,2,3"), Contains("c: 3 values") && Contains("has 2"));
}

TEST_CASE("set_value refuses what the problem does not allow", "[statement]") {
  const ProblemStatement p = read_problem(kComplete, "f.toml");
  const auto refused = [&](const char* assignment) { return complaint(p, assignment); };
  CHECK_THAT(refused("alpha=3"), Contains("alpha: 3 is outside the bounds -10 .. 0"));
  CHECK_THAT(refused("blades=17.5"), Contains("blades: 17.5 is not an integer"));
  CHECK_THAT(refused("cutter_diameter=45"), Contains("45 mm is not one of 40, 50 and 63 mm"));
  CHECK_THAT(refused("stroke=-1"), Contains("stroke: -1 mm is outside 0.001 .. 10000 mm"));
  CHECK_THAT(refused("stroke=30 deg"), Contains("stroke") && Contains("a length is needed"));
  CHECK_THAT(refused("mass=nan"), Contains("mass: nan kg is outside"));
  CHECK_THAT(refused("crossover=2"), Contains("crossover: 2 is outside 0.02 .. 0.98"));
  CHECK_THAT(refused("strok=3"), Contains("'strok'") && Contains("did you mean stroke"));
  CHECK_THAT(refused("alpha[1]=3"), Contains("single number"));
  CHECK_THAT(refused("alpha"), Contains("'alpha' sets nothing; write name=value"));
  CHECK_THAT(refused("=3"), Contains("sets nothing"));
  CHECK_THAT(complaint(read("", "stoddart"), "exponents=3,3,4"), Contains("stoddart"));
}

TEST_CASE("a refused value leaves the problem as it was", "[statement]") {
  ProblemStatement p = read("", "legendre c=1,2");
  CHECK_THROWS(set_value(p, "c=3,4,5000"));
  CHECK(argument(p.laws[0], "c") == std::vector{1.0, 2.0});
}

TEST_CASE("values that are possible together only are set together", "[statement]") {
  // h1 / (2 pi) + h2 / (4 pi) + h3 / (6 pi) must be 1.
  ProblemStatement p = read_problem(R"(
mechanism = "law"
law.name = "triple-harmonic"
)",
                                    "three.toml");
  const double pi = std::numbers::pi;
  const std::vector<std::string> together{fmt::format("h1={:.17g}", pi),
                                          fmt::format("h2={:.17g}", 1.0),
                                          fmt::format("h3={:.17g}", 6 * pi * (0.5 - 0.25 / pi))};
  for (const std::string& one : together) CHECK_THROWS_AS(set_value(p, one), std::invalid_argument);
  set_values(p, together);
  CHECK(p.laws.front().arguments.list(0).front() == Approx(pi));
  CHECK_THROWS_AS(set_values(p, std::vector<std::string>{"h1=2", "h4=1"}), std::invalid_argument);
  CHECK(p.laws.front().arguments.list(0).front() == Approx(pi));
}

TEST_CASE("a problem reads back in sentences", "[statement]") {
  const std::string words = in_words(read_problem(kComplete, "f.toml"));
  CHECK_THAT(words, StartsWith("Least cam radius of the spine cutter\n"));
  CHECK_THAT(words, Contains("The mechanism is spine-cutter: "));
  CHECK_THAT(words,
             Contains("It has stroke = 45 mm and mass = 2.5 kg.\n") &&
                 Contains("By default, as the file does not state them, it has block_speed = "));
  CHECK_THAT(words, !Contains("blades = ") && !Contains("cam_radius = "));
  CHECK_THAT(words, Contains("The motion law is polynomial-5 (crossover = 0.45).\n"));
  CHECK_THAT(words, Contains("Vary alpha between -10 and 0, starting at -3.\n"));
  CHECK_THAT(words, Contains("Vary blades in steps of 1 between 10 and 30, starting at 17.\n"));
  CHECK_THAT(words,
             Contains("Choose cutter_diameter among 40, 50 and 63 mm, starting at 50 mm.\n"));
  CHECK_THAT(words, Contains("Find the least cam_radius (mm) (tolerance 0.01 mm).\n"));
  CHECK_THAT(words, Contains("cam_pressure_angle must be at most 30 deg over the whole cycle "
                             "(tolerance 0.01 deg).\n"));
  CHECK_THAT(words, Contains("peak inertia_force must be at most 20 N.\n"));
  CHECK_THAT(words, Contains("blades_in_contact must be equal to 1.\n"));
  CHECK_THAT(words, Contains("Solve with ipopt, from 10 starts, with seed 3, for at most 60 s.\n"));
}

TEST_CASE("a sentence about a free law ends with its words", "[statement]") {
  const std::string path = testing::source("problems/free_law/least_acceleration_at_jerk.toml");
  CHECK_THAT(in_words(read_problem_file(path)), Contains("100 knots, C2.\n"));
}

TEST_CASE("the sentences tell laws apart and what of them stays", "[statement]") {
  const ProblemStatement p = read_problem(
      "mechanism = 'spine-cutter'\nlaw.name = ['cosine', 'legendre c=1,2']\n"
      "[variables.'c[1]']\nlower = -3\nupper = 3\n[objective]\nmaximize = 'lowest inertia_force'\n"
      "[[constraints]]\nresponse = 'inertia_force'\nlower = -20\nupper = 20",
      "f.toml");
  const std::string words = in_words(p);
  CHECK_THAT(words,
             Contains("Choose the motion law among cosine and legendre (c = [varies, 2]).\n"));
  CHECK_THAT(words, Contains("Vary c[1] (of legendre) between -3 and 3, starting at 1.\n"));
  CHECK_THAT(words, Contains("Find the greatest lowest inertia_force (N).\n"));
  CHECK_THAT(words, Contains("inertia_force must be between -20 and 20 N over the whole cycle.\n"));
  CHECK_THAT(in_words(read("")), Contains("There is no objective.\n"));
}

}  // namespace camlaw::problems::statement_test
