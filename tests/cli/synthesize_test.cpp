// SPDX-License-Identifier: MIT
// synthesize and law files, as a user runs them.
#include <cstdlib>

#include "tests/cli/program_runner.h"

namespace camlaw::cli::synthesize_test {
namespace {

const std::string kProblem =
    "title = \"a small one\"\nmechanism = \"law\"\n[law]\nname = \"free\"\n[free]\ndegree = 2\n"
    "knots = 14\n[objective]\nminimize = \"C_a\"\n[[constraints]]\nresponse = \"C_v\"\nupper = "
    "1.5\n";

std::string written(const Folder& folder, const std::string& name, const std::string& text) {
  const std::string path = folder / name;
  std::ofstream(path) << text;
  return path;
}

}  // namespace

TEST_CASE("synthesize finds the law, measures it and writes it", "[program]") {
  const Folder folder;
  const std::string file = written(folder, "small.toml", kProblem);
  const std::string text = done({"synthesize", file, "--out", folder / "out"});
  CHECK_THAT(text, Contains("certified optimum") &&
                       Contains("global: no design below 4.4999999: C_a is convex") &&
                       Contains("C_a = 4.5") && !Contains("coefficients[1]") &&
                       !Contains("coefficients[3] = ") && Contains("the best named law is") &&
                       Contains("the least for this C_v"));
  const ParsedJson result = ParsedJson::parse(read(folder / "out/result.json"));
  CHECK(result["variables"].size() == 13);
  CHECK(result["rulers"]["C_a"].get<double>() == Approx(4.5));
  CHECK(result["rulers"]["least_C_a_for_C_v"].get<double>() == Approx(4.5));
  // 1, 2, 1 thirds of constant acceleration, velocity, deceleration has a name.
  CHECK(result["rulers"]["best_named"]["objective"].get<double>() == Approx(4.5));
  const std::string name = result["law"].get<std::string>();
  CHECK(name.starts_with("b-spline degree=2"));
  for (const char* part : {"law.json", "law.csv", "law.svg", "cycle.svg"}) {
    CHECK(folder.content().contains(std::string("out/") + part));
  }
  // The law is one like any other: evaluated, put in a problem, to the last bit.
  const ParsedJson law = json_of({"law", folder / "out/law.json", "--json"});
  const ParsedJson stored = ParsedJson::parse(read(folder / "out/law.json"));
  CHECK(law["pieces"] == stored["pieces"]);
  CHECK(stored["provenance"]["problem"] == "small.toml");
  CHECK(stored["provenance"]["verdict"] == "certified optimum");
  CHECK(law["name"] == "law");
  const ParsedJson spline = json_of({"law", name, "--json"});
  CHECK(spline["pieces"] == stored["pieces"]);
  const std::string use =
      written(folder, "use.toml", "mechanism = \"law\"\n[law]\nname = \"out/law.json\"\n");
  CHECK(json_of({"evaluate", use, "--json"})["responses"]["C_a"]["value"].get<double>() ==
        Approx(4.5));
}

TEST_CASE("synthesize takes free laws alone, and ends as optimize does", "[program]") {
  const Folder folder;
  const std::string named =
      written(folder, "named.toml",
              "mechanism = \"law\"\n[law]\nname = \"polynomial-5\"\n[variables.alpha]\nlower = -5\n"
              "upper = 0\n[objective]\nminimize = \"C_a\"\n");
  CHECK_THAT(failed({"synthesize", named}, 2),
             Contains("named.toml: no law of the problem is free"));
  const std::string impossible = written(
      folder, "impossible.toml", kProblem + "[[constraints]]\nresponse = \"C_a\"\nupper = 4\n");
  const Outcome outcome = run({"synthesize", impossible, "--json"});
  CHECK(outcome.status == 3);
  CHECK(ParsedJson::parse(outcome.out)["verdict"] == "infeasible");
  CHECK_THAT(failed({"synthesize", folder / "none.toml"}, 2), Contains("none.toml"));
}

TEST_CASE("synthesize measures the free segments of a motion program", "[program]") {
  const Folder folder;
  const std::string cam = written(
      folder, "cam.toml",
      "mechanism = \"disc-cam-roller\"\n[program]\nsegments = [{name = \"rise\", angle = 120, "
      "law = \"free\"}, {name = \"high\", angle = 60}, {name = \"back\", angle = 120, law = "
      "\"cycloidal\"}, {name = \"low\"}]\n[free]\ndegree = 3\nknots = 7\n[objective]\nminimize = "
      "\"peak acceleration\"\nover = \"rise\"\n");
  CHECK_THAT(done({"synthesize", cam, "--out", folder / "out"}),
             Contains("segment rise") && !Contains("segment back") && Contains("lambda"));
  const ParsedJson result = ParsedJson::parse(read(folder / "out/result.json"));
  // Of eight even pieces of constant jerk the best is the trapezium with ramps of an eighth: 16
  // / 3.
  const double C = result["rulers"]["rise"]["C_a"];
  CHECK(C == Approx(16.0 / 3).epsilon(1e-6));
  const ParsedJson law = json_of({"law", folder / "out/rise.json", "--json"});
  CHECK(law["C_a_max"].get<double>() == Approx(C).epsilon(1e-9));
  const std::string none =
      written(folder, "none.toml",
              "mechanism = \"disc-cam-roller\"\n[program]\nsegments = [{name = \"rise\", angle = "
              "180, law = \"cycloidal\"}, {name = \"back\", law = \"cycloidal\"}]\n"
              "[variables.base_radius]\nlower = 20\nupper = 60\n[objective]\nminimize = "
              "\"base_radius\"\n");
  CHECK_THAT(failed({"synthesize", none}, 2),
             Contains("none.toml: no segment's law is free; write law = \"free\" in a segment"));
}

TEST_CASE("Laws of one's own folder are listed and known by name", "[program]") {
  const Folder folder;
  const std::string file = written(folder, "small.toml", kProblem);
  done({"synthesize", file, "--out", folder / "out"});
  fs::create_directory(folder / "own");
  fs::copy_file(folder / "out/law.json", folder / "own/thirds.json");
  setenv("CAMLAW_LAWS", (folder / "own").c_str(), 1);
  CHECK_THAT(done({"laws"}), Contains("thirds") && Contains("CAMLAW_LAWS"));
  const ParsedJson listed = json_of({"laws", "--json"});
  CHECK(listed.back()["name"] == "thirds");
  CHECK_THAT(done({"law", "thirds"}), Contains("a small one") && Contains("4.5"));
  CHECK_THAT(
      done({"check", written(folder, "p.toml", "mechanism = \"law\"\n[law]\nname = \"thirds\"\n")}),
      Contains("The motion law is thirds"));
  written(folder, "own/broken.json", "{");
  CHECK_THAT(failed({"laws"}, 2), Contains("broken.json: it is not valid JSON"));
  unsetenv("CAMLAW_LAWS");
  CHECK_THAT(failed({"law", "thirds"}, 2), Contains("there is no law 'thirds'"));
}

TEST_CASE("Many numbers of a list are said in one line", "[program]") {
  const Folder folder;
  std::string many = kProblem;
  many.replace(many.find("knots = 14"), 10, "knots = 40");
  const std::string file = written(folder, "many.toml", many);
  CHECK_THAT(done({"check", file}), Contains("Vary 39 numbers of coefficients between -1 and 2."));
  CHECK_THAT(done({"optimize", file}),
             Contains("coefficients: 39 numbers from") && !Contains("coefficients[1]"));
}

}  // namespace camlaw::cli::synthesize_test
