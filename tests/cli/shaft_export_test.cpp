// SPDX-License-Identifier: MIT
// A shaft's flywheel and balancing cam, through the program's commands.
#include <Eigen/Core>
#include <cmath>
#include <numbers>

#include "problems/statement/parameters.h"
#include "tests/cli/dxf_reader.h"
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
  for (int folder_phase = 90; folder_phase <= 170; folder_phase += 40) {
    for (int stamp_phase = 180; stamp_phase <= 290; stamp_phase += 22) {
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
  const ParsedJson front = json_of({"pareto", file, "--points", "3", "--json"});
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
             Contains("shaft_angle [deg],displacement [mm]"));
}

namespace {

const std::string kGripper = testing::source("problems/shaft/gripper_path.toml");
const Words kPhases{"--set", "across.phase=40 deg", "--set", "lift.phase=-15.5 deg"};

Words of_gripper(const std::string& cam, Words more) {
  Words words{"export", kGripper, "--cam", cam};
  words.insert(words.end(), kPhases.begin(), kPhases.end());
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// A cam as its drawing has it: the places of its roller, where its keyway is, how it turns.
struct DrawnCam {
  std::vector<Eigen::Vector2d> roller;
  double keyway = 0;  ///< deg from x
  double sense = 0;   ///< 1: counterclockwise
};

DrawnCam drawn(const std::string& cam, const Words& more = {}) {
  const Folder folder;
  Words words = of_gripper(
      cam, {"--drawing", "--bore", "25 mm", "--keyway", "8 x 3.3 mm", "--out", folder / "cam.dxf"});
  words.insert(words.end(), more.begin(), more.end());
  run(words);
  const std::string text = read_by_ezdxf(folder / "cam.dxf");
  DrawnCam result;
  const auto sides = entities(text, "LINE SHAFT");
  REQUIRE(sides.size() == 3);
  const auto& bottom = sides[1];
  result.keyway = std::atan2(bottom[1] + bottom[3], bottom[0] + bottom[2]) * 180 / std::numbers::pi;
  result.sense = text.find("turns counterclockwise as drawn") != std::string::npos ? 1 : -1;
  CHECK_THAT(text, Contains("the cam's zero lies at shaft angle") && Contains("SHAFT_ZERO"));
  for (const Words& row : csv_of(done_unmet(
           of_gripper(cam, {"--format", "csv", "--curve", "pitch", "--tolerance", "0.0005 mm"})))) {
    if (row.size() > 4 && row[0] == "pitch curve") {
      result.roller.emplace_back(std::stod(row[2]), std::stod(row[3]));
    }
  }
  REQUIRE(result.roller.size() > 100);
  return result;
}

/// The height of the roller above the shaft on the frame's y axis: the cam is turned until its
/// keyway stands at an angle, deg, of the frame.
double height_at(const DrawnCam& cam, double keyway) {
  const double turn = (keyway - cam.keyway) * std::numbers::pi / 180;
  const double c = std::cos(turn), s = std::sin(turn);
  const auto turned = [&](const Eigen::Vector2d& p) {
    return Eigen::Vector2d(c * p.x() - s * p.y(), s * p.x() + c * p.y());
  };
  for (std::size_t i = 0; i + 1 < cam.roller.size(); ++i) {
    const Eigen::Vector2d a = turned(cam.roller[i]), b = turned(cam.roller[i + 1]);
    if (a.x() * b.x() > 0 || a.y() < 0) continue;
    return a.y() + (b.y() - a.y()) * a.x() / (a.x() - b.x());
  }
  return NAN;
}

/// The rows of a table: master and slave.
std::vector<std::pair<double, double>> table_of(const std::string& text) {
  std::vector<std::pair<double, double>> rows;
  for (const Words& row : csv_of(text)) {
    if (row.size() == 2 && std::isdigit(static_cast<unsigned char>(row[0].front()))) {
      rows.emplace_back(std::stod(row[0]), std::stod(row[1]));
    }
  }
  return rows;
}

}  // namespace

// SH9
TEST_CASE("two cams that are keyed to one shaft move their followers as on the shaft",
          "[program][shaft][export]") {
  for (const std::string cam : {"across", "lift"}) {
    INFO(cam);
    const DrawnCam made = drawn(cam);
    // What the file says of the cam at the shaft's angle, which knows nothing of drawings.
    const auto by_shaft = table_of(done_unmet(
        {"export", kGripper, "--set", kPhases[1], "--set", kPhases[3], "--slave",
         cam == "across" ? "path_x" : "path_y", "--format", "table", "--step", "5 deg"}));
    const double least = cam == "across" ? 80 : 70;  // base and roller
    REQUIRE(by_shaft.size() == 73);
    for (const auto& [angle, lift] : by_shaft) {
      INFO(angle);
      CHECK(height_at(made, 90 + made.sense * angle) - least == Approx(lift).margin(0.01));
    }
    // The table of the cam alone is over the same angle.
    const auto own =
        table_of(done_unmet(of_gripper(cam, {"--format", "table", "--step", "5 deg"})));
    REQUIRE(own.size() == 73);
    for (std::size_t i = 0; i < own.size(); ++i) {
      CHECK(own[i].second == Approx(by_shaft[i].second).margin(1e-6));
    }
  }
  // Keyed at its own zero the cam runs by its phase too early.
  const DrawnCam own = drawn("across", {"--zero", "cam"});
  const auto by_cam =
      table_of(done_unmet(of_gripper("across", {"--format", "table", "--zero", "cam"})));
  CHECK(height_at(own, 90 + own.sense * 60) - 80 == Approx(by_cam.at(60).second).margin(0.01));
}

TEST_CASE("every file of a cam on a shaft says where its zero lies", "[program][shaft][export]") {
  const Folder folder;
  const std::string words = "zero lies at shaft angle 40 deg";  // SVG escapes apostrophes
  for (const Words& more :
       {Words{"--format", "csv"}, Words{"--format", "dxf"}, Words{"--format", "svg"},
        Words{"--format", "json"}, Words{"--format", "inspection"},
        Words{"--format", "gcode", "--set", "across.cutter_radius=5 mm"},
        Words{"--format", "table"}, Words{"--format", "beckhoff-points"},
        Words{"--format", "lenze"}, Words{"--format", "codesys"}}) {
    INFO(more[1]);
    Words all = of_gripper("across", more);
    const std::string file = folder / ("cam." + more[1]);
    all.insert(all.end(), {"--out", file, "--json"});
    const ParsedJson place = json_of(all).at("on_shaft");
    std::string text = testing::read(file);
    std::replace(text.begin(), text.end(), '\n', ' ');
    CHECK_THAT(text, Contains(words));
    CHECK(place.at("cam") == "across");
    CHECK(place.at("phase_deg") == 40);
    CHECK(place.at("zero") == "shaft");
    // The follower goes round clockwise in the axes of a cam that turns counterclockwise.
    CHECK(place.at("shaft_zero_direction_deg").get<double>() == Approx(130));
  }
  CHECK_THAT(run(of_gripper("across", {"--format", "table", "--out", folder / "table"})).out,
             Contains(words));
  CHECK_THAT(done_unmet(of_gripper("across", {"--format", "table"})),
             Contains("shaft_angle [deg],displacement [mm]"));
  CHECK_THAT(done_unmet(of_gripper("across", {"--format", "table", "--zero", "cam"})),
             Contains("cam_angle [deg],displacement [mm]"));
  const ParsedJson file = ParsedJson::parse(done_unmet(of_gripper("across", {"--format", "json"})));
  CHECK(file.at("motion").at("master") == "shaft_angle [deg]");
  CHECK_THAT(failed(of_gripper("across", {"--format", "table", "--zero", "key"}), 2),
             Contains("use shaft or cam"));
  CHECK_THAT(failed(of_gripper("across", {"--format", "csv", "--zero", "cam"}), 2),
             Contains("--zero is for table"));
  CHECK_THAT(failed({"export", testing::source("problems/cams/roller_least_base.toml"), "--format",
                     "table", "--zero", "cam"},
                    2),
             Contains("several on one shaft"));
}

}  // namespace camlaw::cli::shaft_export_test
