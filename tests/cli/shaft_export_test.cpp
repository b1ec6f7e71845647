// SPDX-License-Identifier: MIT
// A shaft's flywheel and balancing cam, through the program's commands.
#include <cmath>

#include "problems/statement/parameters.h"
#include "tests/cli/program_runner.h"
#include "tests/paths.h"
#include "tests/problems/shaft_fixture.h"

namespace camlaw::cli::shaft_export_test {
namespace {

const std::string kFlywheel = testing::source("problems/shaft/flywheel.toml");

/// A number of a file's starts.
double value_of(const std::string& name, const std::string& file, const Words& settings = {}) {
  problems::ProblemStatement statement = problems::read_problem_file(file);
  problems::set_values(statement, settings);
  return problems::shaft_fixture::number_of(statement, name);
}

}  // namespace

TEST_CASE("the exported balancing cam makes the torque of its shaft constant",
          "[program][shaft][shaft-torque]") {
  const Folder folder;
  const std::string table = folder / "lift.csv", file = folder / "balanced.toml";
  done({"export", kFlywheel, "--format", "table", "--slave", "balancing_lift", "--step", "1 deg",
        "--out", table});
  std::string text = read(kFlywheel);
  text.erase(text.find("[objective]"));
  std::ofstream(file) << text << R"toml(
[cams.balance]
mechanism = "disc-cam-roller"
[cams.balance.constants]
base_radius = "90 mm"
roller_radius = "10 mm"
mass = "0 kg"
spring_rate = "12 N/mm"
spring_preload = "150 N"
[cams.balance.program]
table = "lift.csv"
smoothing = "none"
)toml";
  const double before = value_of("torque_ripple", kFlywheel);
  const double after = value_of("torque_ripple", file);
  CHECK(before > 30);
  CHECK(after < 1e-3 * before);
  const double mean = value_of("mean_torque", kFlywheel);
  CHECK(value_of("mean_torque", file) == Approx(mean).epsilon(1e-6));
  CHECK(value_of("torque_rms", file) == Approx(mean).epsilon(1e-3));
}

TEST_CASE("the smallest flywheel of a shaft is certified and its claim holds",
          "[program][shaft][shaft-torque]") {
  const Folder folder;
  const std::string out = folder / "flywheel";
  CHECK_THAT(done({"optimize", kFlywheel, "--out", out}), Contains("certified optimum"));
  CHECK_THAT(done({"verify", out + "/result.json"}), Contains("the claim holds"));
  const double least = json_of({"evaluate", out + "/result.json", "--json"})
                           .at("responses")
                           .at("flywheel_inertia")
                           .at("value");
  for (int folder_phase = 90; folder_phase <= 170; folder_phase += 16) {
    for (int stamp_phase = 180; stamp_phase <= 290; stamp_phase += 11) {
      const double other = value_of("flywheel_inertia", kFlywheel,
                                    {"folder.phase=" + std::to_string(folder_phase),
                                     "stamp.phase=" + std::to_string(stamp_phase)});
      CHECK(other >= least * (1 - 1e-9));
    }
  }
}

TEST_CASE("a front weighs the flywheel against the rms torque", "[program][shaft][shaft-torque]") {
  const Folder folder;
  const std::string file = folder / "front.toml";
  std::string text;
  for (const std::string cam : {"first", "second"}) {
    text += "[cams." + cam + "]\nmechanism = 'disc-cam-roller'\n[cams." + cam +
            ".constants]\nmass = 3\nspring_rate = 5\nspring_preload = 150\nload = 40\n";
    text += cam == "second" ? "phase = 140\n" : "";
    for (const std::string name : {"rise", "return"}) {
      text += "[[cams." + cam + ".program.segments]]\nname = '" + name +
              "'\nangle = 100\nlaw = 'cycloidal'\n";
    }
    text += "[[cams." + cam + ".program.segments]]\nname = 'wait'\n";
  }
  std::ofstream(file) << text << R"toml(
[variables.speed]
lower = 100
upper = 500
[[objectives]]
minimize = "flywheel_inertia"
[[objectives]]
minimize = "torque_rms"
)toml";
  const ParsedJson front = json_of({"pareto", file, "--points", "4", "--json"});
  REQUIRE(front.at("points").size() >= 3);
  for (const ParsedJson& point : front.at("points")) {
    CHECK(point.at("verdict") == "certified optimum");
  }
}

TEST_CASE("of several cams a curve of the shaft is exported without naming one",
          "[program][shaft][export]") {
  const auto refused = [](const std::string& slave) {
    return run({"export", kFlywheel, "--format", "table", "--slave", slave}).err;
  };
  CHECK_THAT(refused("stamp.displacement"),
             Contains("say which to export, such as --cam pusher") &&
                 Contains("a curve of the shaft itself, such as shaft_torque"));
  CHECK_THAT(done_unmet({"export", kFlywheel, "--format", "table", "--slave", "surplus_work"}),
             Contains("angle [deg],surplus_work [J]"));
  CHECK_THAT(done_unmet({"export", kFlywheel, "--cam", "stamp", "--format", "table"}),
             Contains("cam_angle [deg],displacement [mm]"));
}

}  // namespace camlaw::cli::shaft_export_test
