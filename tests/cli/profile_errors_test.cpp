// SPDX-License-Identifier: MIT
// 'camlaw tolerance' of errors of the profile, and what a search says of a reliability.
#include <fstream>

#include "tests/cli/program_runner.h"
#include "tests/paths.h"

namespace camlaw::cli::profile_errors_test {
namespace {

const std::string kFile = testing::source("problems/cams/roller_least_base.toml");

ParsedJson facts_of(Words words) {
  words.push_back("--json");
  return json_of(words);
}

}  // namespace

TEST_CASE("tolerance says what waves and chords do, and what must be held", "[program][profile]") {
  const ParsedJson facts =
      facts_of({"tolerance", kFile, "--waviness", "2 um", "--waves", "40", "--form", "0.01 mm",
                "--chord", "5 um", "--loss", "10 %"})["profile"];
  CHECK(facts["waviness"][0]["name"] == "peak acceleration");
  CHECK(facts["waviness"][0]["proved"] == true);
  const double drawn = facts["waviness"][0]["as_drawn"], worst = facts["waviness"][0]["worst"];
  CHECK(worst > 1.02 * drawn);
  CHECK(worst < 1.06 * drawn);
  CHECK(facts["form"].size() == 5);
  CHECK(facts["chords"].size() == 6);
  REQUIRE(facts["shop"].size() == 3);
  for (const ParsedJson& row : facts["shop"]) {
    CHECK(row["waves"] == 40);
    CHECK(double(row["amplitude"]) > 2);
  }
  CHECK(facts["shop"][0]["of"] == "peak acceleration");
  CHECK(facts["shop"][1]["of"] == "peak follower force");
  CHECK(facts["shop"][2]["of"] == "peak contact stress");
  CHECK(facts["shop"][2]["form"].is_number());
  // Without a number of waves a table of several.
  CHECK(facts_of({"tolerance", kFile, "--loss", "10 %"})["profile"]["shop"].size() == 18);
}

TEST_CASE("options for the profile take the place of the file's", "[program][profile]") {
  const std::string file = testing::source("problems/cams/tolerances.toml");
  const auto text =
      done({"tolerance", file, "--samples", "64", "--wavelength", "4 mm", "--workers", "1"});
  CHECK_THAT(text, Contains("waviness 2 um (4 mm each)"));
  CHECK_THAT(text, Contains("yield"));
}

TEST_CASE("options for the profile that exclude each other are refused", "[program][profile]") {
  const auto both =
      run({"tolerance", kFile, "--waviness", "2 um", "--waves", "40", "--wavelength", "4 mm"});
  CHECK(both.status == 2);
  CHECK_THAT(both.err, Contains("wavelength and waves are both stated; state one of them"));
  const auto chords = run({"tolerance", kFile, "--chord", "5 um", "--chord-step", "0.5 deg"});
  CHECK(chords.status == 2);
  CHECK_THAT(chords.err, Contains("chord and chord_step are both stated; state one of them"));
}

TEST_CASE("tolerance says what it lacks to tell of a profile", "[program][profile]") {
  CHECK_THAT(run({"tolerance", kFile, "--waviness", "2 um"}).err, Contains("state waves"));
  CHECK_THAT(run({"tolerance", kFile, "--loss", "-1"}).err, Contains("above 0"));
  CHECK_THAT(done({"tolerance", kFile, "--form", "0.02 mm"}),
             Contains("does not bound the acceleration"));
  const std::string conjugate = testing::source("problems/cams/conjugate_least_distance.toml");
  CHECK_THAT(run({"tolerance", conjugate, "--form", "0.02 mm"}).err, Contains("two profiles"));
}

TEST_CASE("optimize says which reliability is reached", "[program][variation]") {
  const std::string file = testing::source("problems/cams/robust_force.toml");
  const ParsedJson facts = facts_of({"optimize", file, "--starts", "1"});
  REQUIRE(facts["reliability"].size() == 1);
  const ParsedJson& own = facts["reliability"][0];
  CHECK(own["wanted"] == 0.98);
  CHECK(own["reach"] == "reached");
  CHECK(double(own["lower"]) >= 0.98);
  CHECK(double(own["lower"]) <= double(own["share"]));
  CHECK(double(own["upper"]) >= double(own["share"]));
  CHECK(facts["robust_objective"]["samples"] == 2048);
  CHECK(facts["verdict"] == "feasible");
}

TEST_CASE("fronts and sweeps refuse a reliability, which they do not judge",
          "[program][variation]") {
  const std::string file = testing::source("problems/cams/robust_force.toml");
  const Outcome swept = run({"sweep", file, "--set", "mass=1,1.5 kg"});
  CHECK(swept.status == 2);
  CHECK_THAT(swept.err, Contains("follower_force has a reliability") && Contains("a sweep") &&
                            Contains("camlaw tolerance"));
  std::string text = testing::read(file);
  const std::string one =
      "[objective]\nminimize = \"peak contact_force\"\nrobust = \"mean + 3 sigma\"\n";
  REQUIRE(text.find(one) != std::string::npos);
  text.replace(text.find(one), one.size(),
               "[[objectives]]\nminimize = \"peak contact_force\"\n"
               "[[objectives]]\nminimize = \"spring_rate\"\n");
  const Folder folder;
  std::ofstream(folder / "front.toml") << text;
  const Outcome front = run({"pareto", folder / "front.toml", "--points", "3"});
  CHECK(front.status == 2);
  CHECK_THAT(front.err, Contains("follower_force has a reliability") && Contains("a front"));
  // Without the reliability both are done.
  std::ofstream(folder / "front.toml") << text.substr(0, text.find("reliability = 0.98"));
  const Outcome brief = run(
      {"pareto", folder / "front.toml", "--points", "2", "--workers", "1", "--time-limit", "0.5"});
  CHECK((brief.status == 0 || brief.status == 4));
  text = testing::read(file);
  std::ofstream(folder / "one.toml")
      << text.erase(text.find("reliability = 0.98")) << "[solver]\nstarts = 1\n";
  CHECK(run({"sweep", folder / "one.toml", "--set", "mass=1,1.2 kg"}).status == 0);
}

TEST_CASE("a reliability that was not worked out is not called met, nor verified",
          "[program][variation]") {
  const std::string file = testing::source("problems/cams/robust_force.toml");
  const ParsedJson facts =
      ParsedJson::parse(run({"optimize", file, "--time-limit", "0.001", "--json"}).out);
  CHECK(facts["verdict"] != "feasible");
  for (const auto& limit : facts["constraints"]) CHECK(limit["met"] == false);
  const Folder folder;
  const std::string out = folder / "result";
  done({"optimize", file, "--starts", "1", "--out", out});
  CHECK_THAT(done({"verify", out + "/result.json"}), Contains("the claim holds"));
}

}  // namespace camlaw::cli::profile_errors_test
