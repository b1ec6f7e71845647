// SPDX-License-Identifier: MIT
// The program's commands about mechanisms: listing, curves over the cycle, and stopping.
#include <csignal>
#include <thread>

#include "tests/cli/program_runner.h"
#include "tests/paths.h"

namespace camlaw::cli::mechanisms_test {
namespace {

const std::string kCam = testing::source("problems/cams/roller_least_base.toml");

}  // namespace

TEST_CASE("mechanisms are listed with what moves them", "[program]") {
  const std::string all = done({"mechanisms"});
  for (const char* name : {"spine-cutter", "disc-cam-roller", "disc-cam-flat",
                           "disc-cam-oscillating-roller", "end-cam", "law"}) {
    CHECK_THAT(all, Contains(name));
  }
  const std::string one = done({"mechanisms", "disc-cam-flat"});
  CHECK_THAT(one, Contains("base_radius") && Contains("profile_radius") && Contains("[program]"));
  const ParsedJson json = json_of({"mechanisms", "--json"});
  REQUIRE(json.size() >= 6);
  for (const ParsedJson& mechanism : json) {
    INFO(mechanism.at("name"));
    CHECK(!mechanism.at("responses").empty());
    for (const ParsedJson& parameter : mechanism.at("parameters")) {
      CHECK(parameter.at("lower") <= parameter.at("default"));
      CHECK(parameter.at("default") <= parameter.at("upper"));
    }
  }
  CHECK(json_of({"mechanisms", "end-cam", "--json"}).at("moved_by") == "program");
  CHECK_THAT(failed({"mechanisms", "disc-cam"}, 2), Contains("disc-cam-roller"));
}

TEST_CASE("evaluate writes every curve over the cycle", "[program]") {
  const Folder folder;
  const std::string csv = folder / "curves.csv", svg = folder / "curves.svg";
  const std::string text = done({"evaluate", kCam, "--curves", csv, "--svg", svg});
  CHECK_THAT(text, Contains("wrote " + csv) && Contains("wrote " + svg));
  check_svg(svg);
  const CsvRows table = csv_of(read(csv));
  REQUIRE(table.size() == 722);
  CHECK(table[0][0] == "cam_angle [deg]");
  CHECK(table[0][1] == "displacement [mm]");
  CHECK(table[161][0] == "80");
  CHECK(std::stod(table[161][1]) == Approx(30).epsilon(1e-12));  // the end of the rise
  CHECK(std::stod(table[81][1]) == Approx(15).epsilon(1e-12));   // half way
  CHECK(std::stod(table[721][1]) == Approx(0).margin(1e-12));
  for (const Words& row : table) CHECK(row.size() == table[0].size());
}

TEST_CASE("evaluate draws the cam's profile, and refuses what is not there", "[program]") {
  const Folder folder;
  const std::string svg = folder / "profile.svg", csv = folder / "none.csv";
  CHECK_THAT(done({"evaluate", kCam, "--profile", svg}), Contains("wrote " + svg));
  check_svg(svg);
  CHECK_THAT(read(svg), Contains("pitch curve") && Contains("cutter path"));
  const std::string problems = testing::source("problems/");
  const std::string geneva = problems + "geneva/fastest.toml";
  const std::string springs = problems + "springs/lightest_helical.toml";
  const std::string none = folder / "none.svg";
  CHECK_THAT(failed({"evaluate", geneva, "--profile", none, "--curves", csv}, 2),
             Contains("geneva has no profile"));
  CHECK_THAT(failed({"evaluate", springs, "--curves", csv}, 2),
             Contains("helical-spring has no curves"));
  CHECK_THAT(failed({"evaluate", springs, "--svg", none}, 2), Contains("has no curves"));
  CHECK_FALSE(fs::exists(none));
  CHECK_FALSE(fs::exists(csv));
}

TEST_CASE("what no law moves has a picture of its cycle, and none of a law", "[program]") {
  const Folder folder;
  const std::string geneva = testing::source("problems/geneva/fastest.toml");
  done({"optimize", geneva, "--out", folder / "out"});
  check_svg(folder / "out/cycle.svg");
  CHECK(fs::exists(folder / "out/result.json"));
  CHECK_FALSE(fs::exists(folder / "out/law.svg"));
  CHECK(ParsedJson::parse(read(folder / "out/result.json"))["law"].is_null());
}

TEST_CASE("a long search that is interrupted ends with the best verified design", "[program]") {
  const std::string file = testing::source("problems/spine_cutter/least_moment.toml");
  // Ever later, until some starts are done: how fast a machine is does not matter.
  double best = 0;
  for (std::chrono::milliseconds after(250); best == 0; after *= 2) {
    INFO("after " << after.count() << " ms");
    REQUIRE(after < std::chrono::minutes(10));
    const Running running({"optimize", file, "--starts", "100000", "--json"});
    std::this_thread::sleep_for(after);
    REQUIRE(kill(running.id(), SIGINT) == 0);
    const Outcome outcome = running.wait();
    if (outcome.out.empty()) continue;  // it had not begun to search
    const ParsedJson json = ParsedJson::parse(outcome.out);
    CHECK(json.at("starts") < 100000);
    CHECK_THAT(json.at("reason").get<std::string>(), Contains("stopped"));
    if (json.at("starts") < 5) continue;  // the third is the first that leads to the best
    CHECK(outcome.status == 0);
    CHECK(json.at("verdict") == "feasible");
    best = json.at("objective").get<double>();
  }
  CHECK(best == Approx(0.05123141247890022).epsilon(1e-6));
}

}  // namespace camlaw::cli::mechanisms_test
