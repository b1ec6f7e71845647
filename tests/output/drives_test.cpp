// SPDX-License-Identifier: MIT
// Motions as files for drives, read back by readers that were written from the makers'
// descriptions, and compared with the exact motion.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "output/answers/motion_export.h"
#include "output/export/drives/piecewise_motion.h"
#include "tests/output/drive_readers.h"
#include "tests/paths.h"

namespace camlaw::problems::drives_test {
namespace {

namespace fs = std::filesystem;
constexpr double kPi = std::numbers::pi;

using Catch::Contains;
using drive_readers::Cam;

std::vector<std::string> cam_files() {
  std::vector<std::string> names;
  for (const auto& file : fs::directory_iterator(testing::source("problems/cams"))) {
    if (file.path().extension() == ".toml") names.push_back(file.path().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string exported_file(const std::string& file, cli::ExportOptions options) {
  options.file = file;
  const cli::FormatRow& format = cli::format_of(options);
  cli::check_options(options, format);
  return cli::exported_text(options, format, {read_problem_file(file)}, {}).text;
}

/// "within 3.1e-05 mm of the exact motion, proved"
double stated_deviation(const std::string& text) {
  std::smatch found;
  REQUIRE(std::regex_search(text, found,
                            std::regex(R"(within ([0-9.e+-]+) \S+ of the exact motion, proved)")));
  return std::stod(found[1]);
}

/// How far a controller's motion is from the exact one at many places.
double departure(const Cam& cam, const ExportedMotion& motion, double per_place) {
  double worst = 0;
  for (std::size_t k = 0; k + 1 < motion.trace->breaks().size(); ++k) {
    constexpr int kLooks = 997;
    const double from = motion.trace->breaks()[k], to = motion.trace->breaks()[k + 1];
    for (int i = 0; i <= kLooks; ++i) {
      const auto place = optim::even_place(from, to, kLooks, i);
      worst = std::max(worst, std::abs(motion.at(place)[0] - cam.at(per_place * place.angle)));
    }
  }
  return worst;
}

struct Drive {
  const char* name;
  Cam (*reader)(const std::string&);
};
const std::vector<Drive> kDrives{{"beckhoff-points", drive_readers::beckhoff_points},
                                 {"beckhoff-motion", drive_readers::beckhoff_motion},
                                 {"codesys", drive_readers::codesys},
                                 {"lenze", drive_readers::lenze},
                                 {"rockwell", drive_readers::rockwell},
                                 {"siemens", drive_readers::siemens}};

}  // namespace

TEST_CASE("What a drive makes of its file is as near to the motion as the file says",
          "[exports][drives][heavy]") {
  for (const std::string& file : cam_files()) {
    const ProblemStatement statement = read_problem_file(file);
    const ExportedMotion motion = motion_of(statement, {}).value();
    for (const Drive& drive : kDrives) {
      INFO(file << " " << drive.name);
      cli::ExportOptions options;
      options.format = drive.name;
      if (std::string(drive.name) == "siemens") options.tolerance = "0.01 " + motion.unit;
      if (std::string(drive.name) == "siemens" && motion.trace->breaks().size() > 51) {
        CHECK_THROWS_WITH(exported_file(file, options), Contains("and the drive has 50"));
        continue;
      }
      const std::string text = exported_file(file, options);
      const double stated = stated_deviation(text);
      const double worst = departure(drive.reader(text), motion, 1);
      CHECK(worst <= stated);
      CHECK(worst >= 0.9 * stated - 3e-7);
      CHECK_THAT(text, Contains("not tested on a drive"));
    }
  }
}

TEST_CASE("Drives count the master in milliseconds or increments, and the slave in inches",
          "[exports][drives][heavy]") {
  const std::string file = testing::source("problems/cams/roller_least_base.toml");
  const ExportedMotion motion = motion_of(read_problem_file(file), {}, true).value();
  CHECK(motion.unit == "in");
  for (const Drive& drive : kDrives) {
    INFO(drive.name);
    cli::ExportOptions options;
    options.format = drive.name;
    options.unit = "inch";
    options.master = "ms", options.cycle = "0.5 s";
    if (std::string(drive.name) == "siemens") options.tolerance = "0.0005 in";
    const std::string in_time = exported_file(file, options);
    const Cam cam = drive.reader(in_time);
    CHECK(cam.points.back().x == 500);
    CHECK(departure(cam, motion, 500.0 / 360) <= stated_deviation(in_time));
    options.master = "increments", options.cycle = "65536";
    const std::string counted = exported_file(file, options);
    CHECK(drive.reader(counted).points.back().x == 65536);
    CHECK(departure(drive.reader(counted), motion, 65536.0 / 360) <= stated_deviation(counted));
  }
}

TEST_CASE("A cycle has a whole number of increments", "[exports][drives]") {
  const std::string file = testing::source("problems/cams/roller_least_base.toml");
  cli::ExportOptions options;
  options.format = "table";
  options.master = "increments";
  for (const char* cycle : {"1000.5", "0.25"}) {
    options.cycle = cycle;
    CHECK_THROWS_WITH(exported_file(file, options),
                      Contains(std::string("--cycle ") + cycle) && Contains("whole number"));
  }
  options.cycle = "1000";
  CHECK_THAT(exported_file(file, options), Contains("master [increments]") && Contains("1000"));
  options.master = "ms", options.cycle = "1000.5 ms";
  CHECK_THAT(exported_file(file, options), Contains("1000.5"));
}

TEST_CASE("A table in increments stands at whole increments, where its slave is exact",
          "[exports][drives]") {
  const std::string file = testing::source("problems/cams/roller_least_base.toml");
  const ExportedMotion motion = motion_of(read_problem_file(file), {}).value();
  const MasterUnit master{"master [increments]", 4095.0 / 360, true};
  const MotionTable table = table_of(motion, "60 deg", 9, master);
  CHECK(table.places == std::vector<double>{0, 683, 1365, 2048, 2730, 3413, 4095});
  CHECK(table.moved == Approx(0.5));
  for (std::size_t i = 0; i < table.places.size(); ++i) {
    const double exact = motion.at({table.places[i] * 360 / 4095, i == 6})[0];
    CHECK(table.values[i] == Approx(exact).margin(1e-8));
  }
  CHECK(table_of(motion, "60 deg", 9, {"master [increments]", 4096.0 * 3 / 360, true}).moved == 0);
  CHECK_THROWS_WITH(table_of(motion, {}, 9, {"master [increments]", 100.0 / 360, true}),
                    Contains("do not fit on the 100 increments"));
  cli::ExportOptions options;
  options.format = "table";
  options.master = "increments", options.cycle = "4095", options.step = "60 deg";
  CHECK_THAT(exported_file(file, options), !Contains("682.5") && Contains("683.000000,"));
}

namespace {

/// A slide that a program moves: `responses` are its own.
ProblemStatement slide(const std::string& responses) {
  return read_problem(R"toml(
title = "slide"
[machine]
name = "slide"
moved_by = "program"
[machine.parameters.stroke]
unit = "mm"
default = 50
)toml" + responses + R"toml(
[program]
segments = [{name = "a", angle = "100 deg", law = "cycloidal"}, {name = "b", angle = "60 deg"},
            {name = "c", law = "poly-3-4-5"}]
)toml",
                      "slide.toml");
}

}  // namespace

TEST_CASE("A program without a displacement of its own moves s over the cam's angle", "[drives]") {
  const ExportedMotion motion =
      motion_of(slide("[responses.speed]\nunit = \"mm\"\nformula = \"stroke * v\"\n"), {}).value();
  CHECK(motion.master == "cam_angle [deg]");
  CHECK(motion.place_unit == "deg");
  CHECK(motion.end() == 360);
  // x - sin(2 pi x) / (2 pi) over 100 deg, at a quarter of it.
  const auto at = motion.at({25});
  CHECK(at[0] == Approx(0.25 - 1 / (2 * kPi)).epsilon(1e-12));
  CHECK(at[1] == Approx(1 / 100.0).epsilon(1e-12));
  CHECK(at[2] == Approx(2 * kPi / 1e4).epsilon(1e-12));
  CHECK(std::abs(at[3]) < 1e-15);
  CHECK(motion.at({50})[3] == Approx(-4 * kPi * kPi / 1e6).epsilon(1e-12));
  // The enclosures hold values, first and half of second derivatives.
  const auto bounds = motion.trace->expand(20, 30);
  for (double place = 20; place <= 30; place += 0.5) {
    const auto f = motion.trace->at({place});
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(bounds[k].lower <= (k == 2 ? 0.5 : 1) * f[k]);
      CHECK(bounds[k].upper >= (k == 2 ? 0.5 : 1) * f[k]);
    }
  }
}

TEST_CASE("A displacement stated as a formula has the law's jerk", "[drives]") {
  const ExportedMotion motion =
      motion_of(slide("[responses.displacement]\nunit = \"mm\"\nformula = \"-stroke * s\"\n"), {})
          .value();
  CHECK(motion.at({50})[3] == Approx(50 * 4 * kPi * kPi / 1e6).epsilon(1e-12));
  // The square of s has another slope than the law.
  const ExportedMotion bent =
      motion_of(slide("[responses.displacement]\nunit = \"mm\"\nformula = \"stroke * s^2\"\n"), {})
          .value();
  CHECK(std::isnan(bent.at({50})[3]));
}

TEST_CASE("A slave in any unit of length is written in inches", "[drives]") {
  const auto statement = slide(
      "[responses.fine]\nunit = \"um\"\nformula = \"stroke * s\"\n"
      "[responses.part]\nunit = \"1\"\nformula = \"s\"\n");
  const ExportedMotion fine = motion_of(statement, "fine", true).value();
  CHECK(fine.unit == "in");
  CHECK(fine.at({50})[0] == Approx(25 / 25.4).epsilon(1e-12));
  CHECK(motion_of(statement, "part", true).value().unit == "1");
}

TEST_CASE("Derivatives that are rounding alone are written as 0", "[exports][drives]") {
  for (const char* name : {"cams/roller_least_base.toml", "cams/law_for_a_rise.toml",
                           "motions/old_cam.toml", "free_law/least_jerk.toml"}) {
    const std::string file = testing::source("problems/" + std::string(name));
    for (const Drive& drive : kDrives) {
      const std::string format = drive.name;
      if (format != "codesys" && format != "beckhoff-motion" && format != "rockwell") continue;
      INFO(name << " " << format);
      cli::ExportOptions options;
      options.format = format;
      const Cam cam = drive.reader(exported_file(file, options));
      const ExportedMotion motion = motion_of(read_problem_file(file), {}).value();
      double v = 0, a = 0;
      for (const auto& place : optim::even_places(motion.begin(), motion.end(), 999)) {
        v = std::max(v, std::abs(motion.at(place)[1]));
        a = std::max(a, std::abs(motion.at(place)[2]));
      }
      for (const double slope : {cam.start_slope, cam.end_slope}) {
        CHECK((slope == 0 || std::abs(slope) > 0.9e-13 * v));
      }
      for (const drive_readers::Point& point : cam.points) {
        CHECK((point.v == 0 || std::abs(point.v) > 0.9e-13 * v));
        CHECK((point.a == 0 || std::abs(point.a) > 0.9e-13 * a));
      }
    }
  }
}

TEST_CASE("Plain numbers have no unit in what a drive's file says", "[exports][drives]") {
  const std::string file = testing::source("problems/free_law/least_jerk.toml");
  for (const Drive& drive : kDrives) {
    if (std::string(drive.name) == "siemens") continue;  // the law has more pieces than it takes
    INFO(drive.name);
    cli::ExportOptions options;
    options.format = drive.name;
    const std::string text = exported_file(file, options);
    CHECK_THAT(text, Contains(" of the exact motion, proved") && !Contains(" [1]") &&
                         !Contains(" 1 of the exact"));
  }
  cli::ExportOptions options;
  options.format = "codesys";
  options.tolerance = "1e-12";
  CHECK_THROWS_WITH(exported_file(file, options),
                    Contains("is outside 1e-08 .. inf") && !Contains("inf 1"));
}

TEST_CASE("A wrong point of a drive's file is found", "[exports][drives]") {
  const auto statement = read_problem_file(testing::source("problems/cams/roller_least_base.toml"));
  const ExportedMotion motion = motion_of(statement, {}).value();
  const WrittenMotion written{motion};
  const QuinticMotion found = quintics_within(written, 1e-3, 9, 1000);
  CHECK(found.deviation.proved);
  CHECK(found.deviation.most <= 1e-3);
  std::vector<MotionKnot> knots = found.path.knots;
  knots[knots.size() / 2].s += 0.02;
  const MotionDeviation wrong = deviation_of(written, quintics_between(knots));
  CHECK(wrong.proved);
  CHECK(wrong.most >= 0.019);
  CHECK(wrong.most <= 0.022);
}

TEST_CASE("Quintics through a polynomial of degree 5 are that polynomial", "[exports][drives]") {
  const auto statement =
      read_problem("mechanism = 'follower-train'\n[law]\nname = 'poly-3-4-5'\n", "f.toml");
  const ExportedMotion motion = motion_of(statement, {}).value();
  const QuinticMotion found = quintics_within({motion}, 1e-6, 9, 50);
  CHECK(found.path.pieces.size() == 1);
  CHECK(found.deviation.proved);
  CHECK(found.deviation.most < 3e-9);
  const std::array<double, 6> law{0, 0, 0, 10, -15, 6};
  for (std::size_t i = 0; i < law.size(); ++i) {
    CHECK(found.path.pieces[0][i] == Approx(law[i]).margin(1e-9));
  }
}

TEST_CASE("Where the acceleration jumps quintics still stay within the tolerance",
          "[exports][drives][heavy]") {
  // The parabola's acceleration jumps from 4 to -4 in the middle, and a table has one of both.
  const auto statement =
      read_problem("mechanism = 'follower-train'\n[law]\nname = 'parabolic'\n", "f.toml");
  const ExportedMotion motion = motion_of(statement, {}).value();
  const QuinticMotion found = quintics_within({motion}, 1e-5, 9, 200);
  CHECK(found.deviation.proved);
  CHECK(found.deviation.most <= 1e-5);
  CHECK(found.path.pieces.size() > 2);
}

TEST_CASE("A motion that takes more polynomials than a drive has is refused", "[exports][drives]") {
  cli::ExportOptions options;
  options.format = "siemens";
  options.tolerance = "1e-7 mm";
  CHECK_THROWS_WITH(exported_file(testing::source("problems/cams/roller_least_base.toml"), options),
                    Contains("use a larger --tolerance"));
}

TEST_CASE("A table's derivatives are those of the law", "[exports][drives]") {
  const auto statement = read_problem(
      "mechanism = 'disc-cam-flat'\nconstants = {base_radius = '40 mm', stroke = '10 mm'}\n"
      "[program]\nmatched = 'displacement'\nsegments = ["
      "{name = 'rise', angle = 180, law = 'poly-3-4-5'},"
      "{name = 'return', law = 'poly-3-4-5'}]\n",
      "f.toml");
  const ExportedMotion motion = motion_of(statement, {}).value();
  const double cycle = 720;  // ms
  const MotionTable table = table_of(motion, "10 deg", 9, {"time [ms]", cycle / 360}, "svaj");
  REQUIRE(table.more.size() == 3);
  CHECK(table.more[0].heading == "v [mm / ms]");
  CHECK(table.more[2].heading == "j [mm / ms^3]");
  for (std::size_t i = 1; i < 18; ++i) {
    const double x = table.places[i] / (cycle / 2), per = 2 / cycle;
    const double s = 10 * x * x * x * (10 - 15 * x + 6 * x * x);
    const double v = 10 * 30 * x * x * (1 - x) * (1 - x) * per;
    const double a = 10 * 60 * x * (1 - x) * (1 - 2 * x) * per * per;
    const double j = 10 * 60 * (1 - 6 * x + 6 * x * x) * per * per * per;
    CHECK(table.values[i] == Approx(s).margin(1e-9));
    CHECK(table.more[0].values[i] == Approx(v).margin(1e-12));
    CHECK(table.more[1].values[i] == Approx(a).margin(1e-14));
    CHECK(table.more[2].values[i] == Approx(j).margin(1e-16));
  }
  const std::string text = table_text(table, TableStyle{4, ';', true});
  CHECK_THAT(text, Contains("\n20,0000;"));
  CHECK(text.find('.') == std::string::npos);
}

TEST_CASE("Options of tables and drives that do not go together are refused", "[exports][drives]") {
  const std::string file = testing::source("problems/cams/roller_least_base.toml");
  const auto refusal = [&](const char* format, auto set) {
    cli::ExportOptions options;
    options.format = format;
    set(options);
    try {
      exported_file(file, options);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  using O = cli::ExportOptions;
  CHECK_THAT(refusal("table", [](O& o) { o.master = "ms"; }), Contains("--cycle how long"));
  CHECK_THAT(refusal("table", [](O& o) { o.master = "turns"; }), Contains("use deg, ms"));
  CHECK_THAT(refusal("table", [](O& o) { o.cycle = "3"; }),
             Contains("--cycle is only for --master"));
  CHECK_THAT(refusal("table", [](O& o) { o.columns = "v,a"; }), Contains("begin with s"));
  CHECK_THAT(refusal("table", [](O& o) { o.columns = "s,s"; }), Contains("begin with s"));
  CHECK_THAT(refusal("table", [](O& o) { o.separator = "#"; }),
             Contains("use ',', ';', tab or space"));
  CHECK_THAT(refusal("table",
                     [](O& o) {
                       o.separator = ",";
                       o.decimal_comma = true;
                     }),
             Contains("with --decimal-comma"));
  CHECK_THAT(refusal("codesys", [](O& o) { o.step = "1 deg"; }), Contains("--step is for"));
  CHECK_THAT(refusal("lenze", [](O& o) { o.tolerance = "1 mm"; }), Contains("--tolerance is for"));
  CHECK_THAT(refusal("dxf", [](O& o) { o.master = "ms"; }), Contains("--master is for"));
  CHECK_THAT(refusal("dxf", [](O& o) { o.unit = "furlong"; }), Contains("mm or inch"));
}

}  // namespace camlaw::problems::drives_test
