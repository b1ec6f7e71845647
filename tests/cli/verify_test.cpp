// SPDX-License-Identifier: MIT
// verify: a stored design and its claim, judged again.
#include <filesystem>

#include "tests/cli/program_runner.h"
#include "tests/paths.h"

namespace camlaw::cli::verify_test {
namespace {

const std::string kCam = testing::source("problems/cams/roller_least_base.toml");

std::string stored(const Folder& folder, const ParsedJson& result) {
  const std::string path = folder / "result.json";
  std::ofstream(path) << result.dump();
  return path;
}

/// What the search for a problem ends with, whatever that is.
ParsedJson ended(const Folder& folder, const std::string& toml) {
  const std::string file = folder / "problem.toml";
  std::ofstream(file) << toml;
  return ParsedJson::parse(run({"optimize", file, "--json"}).out);
}

}  // namespace

TEST_CASE("a claim of the program's own holds when it is judged again", "[program]") {
  const Folder folder;
  const ParsedJson result = json_of({"optimize", kCam, "--json"});
  const std::string path = stored(folder, result);
  const ParsedJson again = json_of({"verify", path, "--json"});
  CHECK(again["holds"] == true);
  CHECK(again["verdict"] == result["verdict"]);
  CHECK(again["objective"].get<double>() ==
        Approx(result["objective"].get<double>()).epsilon(1e-12));
  const Outcome text = run({"verify", path});
  CHECK(text.status == 0);
  CHECK(text.out.find("the claim holds") != std::string::npos);
}

TEST_CASE("a claim that was edited does not hold", "[program]") {
  const Folder folder;
  const ParsedJson result = json_of({"optimize", kCam, "--json"});
  ParsedJson better = result;
  better["objective"] = result["objective"].get<double>() - 1;
  ParsedJson moved = result;
  const double radius = result["variables"]["base_radius"].get<double>();
  moved["design"]["variables"]["base_radius"] = radius - 1;
  ParsedJson bigger = result;
  bigger["design"]["variables"]["base_radius"] = radius + 1;
  bigger["objective"] = radius + 1;
  for (const ParsedJson& edited : {better, moved, bigger}) {
    const Outcome outcome = run({"verify", stored(folder, edited)});
    INFO(outcome.out);
    CHECK(outcome.status == 4);
    CHECK(outcome.out.find("the claim does not hold") != std::string::npos);
  }
}

TEST_CASE("a claim about integer and listed variables alone is judged with them held",
          "[program]") {
  const Folder folder;
  const std::string file = folder / "whole.toml";
  std::ofstream(file) << R"(mechanism = "spine-cutter"
[law]
name = "cosine"
[variables.blades]
type = "integer"
lower = 10
upper = 24
start = 17
[objective]
minimize = "peak_inertia_force"
)";
  const ParsedJson result = json_of({"optimize", file, "--json"});
  REQUIRE(result["verdict"] == "certified optimum");
  const ParsedJson again = json_of({"verify", stored(folder, result), "--json"});
  CHECK(again["holds"] == true);
  CHECK(again["choices_held"] == true);
}

TEST_CASE("that no other choice is better is not judged without a search, and said so",
          "[program]") {
  const Folder folder;
  const std::string file = folder / "listed.toml";
  std::ofstream(file) << R"(mechanism = "disc-cam-roller"
program.segments = [
  { name = "rise", angle = "120 deg", law = "cycloidal" },
  { name = "high", angle = "60 deg" },
  { name = "back", angle = "120 deg", law = "cycloidal" },
  { name = "low" },
]
variables.base_radius = { values = ["30 mm", "40 mm", "50 mm"] }
variables.roller_radius = { values = ["8 mm", "10 mm"] }
objective.minimize = "base_radius"
constraints = [{ response = "pressure_angle", upper = "30 deg" }]
)";
  const ParsedJson result = json_of({"optimize", file, "--json"});
  REQUIRE(result["global"].is_string());
  const Outcome text = run({"verify", stored(folder, result)});
  CHECK(text.status == 0);
  CHECK_THAT(text.out, Contains("not judged: the result says that no better design exists"));
  ParsedJson larger = result;  // in the list, and not the least that is claimed
  larger["design"]["variables"]["base_radius"] = 40;
  CHECK(run({"verify", stored(folder, larger)}).status == 4);
}

TEST_CASE("limits that contradict one another do so by any weights", "[program]") {
  // A search weighs limits by their changes where it begins: at p = 0.1 that of p^4 hardly changes.
  const Folder folder;
  const ParsedJson result = ended(folder, R"toml([machine]
name = "powers"
[machine.parameters.p]
default = "0.1"
lower = 0.01
upper = 10
meaning = "a number"
[responses.fourth]
formula = "p^4"
meaning = "a power"
[responses.wave]
formula = "p * (1 + 0.2 * sin(p))"
meaning = "of no shape that a rule finds"
[variables.p]
lower = 0.05
upper = 10
start = 0.1
[objective]
minimize = "fourth"
[[constraints]]
response = "wave"
lower = 6
[[constraints]]
response = "fourth"
upper = 1
)toml");
  REQUIRE(result["verdict"] == "infeasible");
  REQUIRE(result["reason"] == "wave and fourth contradict one another");
  CHECK(json_of({"verify", stored(folder, result), "--json"})["holds"] == true);
}

namespace {

/// A spring that holds the roller on a fast cam, with a stress that it may not pass.
std::string stress_below(const std::string& most) {
  return R"toml(mechanism = "disc-cam-roller"
[constants]
stroke = "25 mm"
mass = "3 kg"
base_radius = "42 mm"
roller_radius = "12 mm"
speed = "320 rpm"
load = "0 N"
face_width = "14 mm"
[[program.segments]]
name = "rise"
angle = "90 deg"
law = "modified-sine"
[[program.segments]]
name = "high"
angle = "70 deg"
[[program.segments]]
name = "return"
angle = "110 deg"
law = "cycloidal"
[[program.segments]]
name = "low"
[variables.spring_preload]
lower = "0 N"
upper = "800 N"
start = "300 N"
[variables.spring_rate]
lower = "1 N/mm"
upper = "40 N/mm"
start = "20 N/mm"
[objective]
minimize = "peak_stress"
[[constraints]]
response = "follower_force"
lower = "20 N"
[[constraints]]
response = "contact_stress"
upper = ")toml" +
         most + "\"\n";
}

}  // namespace

TEST_CASE("limits contradict one another where a stress has no value beyond them", "[program]") {
  // The least peak of the stress with a force of 20 N everywhere is 234.5 MPa. Eased, this limit
  // would be met best where the roller leaves the cam, with no stress at all: a search for a design
  // beside that region once asked for one of the same limits again and again, without end.
  const Folder folder;
  const ParsedJson result = ended(folder, stress_below("100 MPa"));
  CHECK(result["verdict"] == "infeasible");
  CHECK(result["reason"] == "follower_force and contact_stress contradict one another");
  CHECK(json_of({"verify", stored(folder, result), "--json"})["holds"] == true);
}

TEST_CASE("a stress that a force within its limits allows is not called infeasible", "[program]") {
  const Folder folder;
  const ParsedJson result = ended(folder, stress_below("236 MPa"));
  CHECK(result["verdict"] == "certified optimum");
  CHECK(result["objective"].get<double>() == Approx(234.495).epsilon(1e-5));
}

TEST_CASE("of an objective that is not a number a result states none", "[program]") {
  const Folder folder;
  const ParsedJson result = ended(folder, R"toml([machine]
name = "roots"
[machine.parameters.p]
default = "1"
lower = -9
upper = 9
meaning = "a number"
[responses.height]
formula = "sqrt(p)"
meaning = "a number where p is above 0"
[responses.line]
formula = "p"
meaning = "the number"
[variables.p]
lower = -1
upper = 5
start = 2
[objective]
minimize = "height"
[[constraints]]
response = "line"
upper = -3
)toml");
  REQUIRE(result["verdict"] == "infeasible");
  REQUIRE(result["objective"].is_null());
  CHECK(json_of({"verify", stored(folder, result), "--json"})["holds"] == true);
}

TEST_CASE("a force of nothing but rounding at a rest bounds nothing", "[program]") {
  // Without preload the force is zero in the dwell: a law that ends a rounding below zero must not
  // exclude every design. 65 mm is better than 100.
  const Folder folder;
  const std::string file = folder / "rest.toml";
  std::ofstream(file) << R"(mechanism = "disc-cam-roller"
constants = { stroke = 30, roller_radius = 8, speed = 20, mass = 0.1, spring_preload = 0 }
program.segments = [
  { name = "rise", angle = "80 deg", law = "poly-3-4-5" },
  { name = "high", angle = "60 deg" },
  { name = "return", angle = "100 deg", law = "poly-3-4-5" },
  { name = "low" },
]
variables.base_radius = { lower = 10, upper = 120, start = 60 }
objective.minimize = "base_radius"
constraints = [
  { response = "pressure_angle", lower = "-40 deg", upper = "30 deg" },
  { response = "follower_force", lower = "0 N" },
]
)";
  ParsedJson result = json_of({"optimize", file, "--json"});
  CHECK(result["objective"].get<double>() < 65);
  CHECK(result["global"].is_string());
  result["design"]["variables"]["base_radius"] = 100;
  result["objective"] = 100;
  const Outcome outcome = run({"verify", stored(folder, result)});
  INFO(outcome.out);
  CHECK(outcome.status == 4);
  CHECK(outcome.out.find("a better design is known") != std::string::npos);
}

TEST_CASE("values that are set beside the file stay with the result", "[program]") {
  const Folder folder;
  const ParsedJson result = json_of({"optimize", kCam, "--set", "stroke=20 mm", "--json"});
  const std::string path = stored(folder, result);
  const ParsedJson design = json_of({"evaluate", path, "--json"});
  CHECK(design["constants"]["stroke"]["value"] == 20);
  CHECK(json_of({"verify", path, "--json"})["holds"] == true);
  CHECK(result["objective"].get<double>() <
        json_of({"optimize", kCam, "--json"})["objective"].get<double>() - 10);
  // The study of a front keeps them too, and does not go on with others.
  const std::string front = testing::source("problems/spine_cutter/front.toml");
  const std::string study = folder / "study.db";
  const auto pareto = [&](std::vector<std::string> more) {
    std::vector<std::string> line{"pareto", front, "--points", "4", "--db", study};
    line.insert(line.end(), more.begin(), more.end());
    return run(line);
  };
  CHECK(pareto({"--set", "stroke=30 mm"}).status == 0);
  CHECK(pareto({"--resume"}).status == 0);
  const Outcome other = pareto({"--resume", "--set", "stroke=31 mm"});
  CHECK(other.status == 2);
  CHECK(other.err.find("--set 'stroke=30 mm'") != std::string::npos);
}

TEST_CASE("'-' is standard input and standard output", "[program]") {
  const Outcome table = run({"evaluate", kCam, "--curves", "-"});
  CHECK(table.status == 0);
  CHECK(table.out.find("base_radius =") == std::string::npos);
  CHECK(table.out.find(',') < table.out.find('\n'));  // a header of columns comes first
  CHECK_FALSE(std::filesystem::exists("-"));
  CHECK(run({"evaluate", kCam, "--curves", "-", "--json"}).status == 2);
  CHECK(run({"evaluate", kCam, "--curves", "-", "--svg", "-"}).status == 2);
  CHECK(run({"optimize", kCam, "--out", "-"}).status == 2);
  const Outcome law = run({"law", "cycloidal", "--csv", "-"});
  CHECK(law.status == 0);
  CHECK(law.err.find("peak ") != std::string::npos);
}

TEST_CASE("a problem file claims nothing that could be verified", "[program]") {
  const Outcome outcome = run({"verify", kCam});
  CHECK(outcome.status == 2);
  CHECK(outcome.err.find("claims nothing") != std::string::npos);
}

}  // namespace camlaw::cli::verify_test
