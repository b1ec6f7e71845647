// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <numbers>
#include <random>

#include "kinematics/peaks.h"
#include "kinematics/program/table_motion.h"
#include "problems/statement/bind.h"
#include "problems/statement/parameters.h"
#include "problems/statement/statement.h"
#include "tests/problems/complaint.h"
#include "tests/temporary_folder.h"

/// A lift table as the motion of a cam.
namespace camlaw::problems::lift_table_test {

using Catch::Contains, testing::complaint;

namespace {

ProblemStatement with_table(const std::string& table, const std::string& program = "",
                            const std::string& rest = "") {
  HeldFiles files;
  files.tables["lift.csv"] = table;
  return read_problem(
      "mechanism = 'disc-cam-roller'\n[program]\ntable = 'lift.csv'\n" + program + "\n" + rest,
      "f.toml", std::move(files));
}

/// Its joints lie on rows of half degrees.
ProblemStatement program(const std::string& rest = "") {
  return read_problem(
      "mechanism = 'disc-cam-roller'\n[program]\nsegments = [{name = 'up', angle = 130, to = '24 "
      "mm', law = 'joining', points = [{angle = 60, to = '9 mm'}]}, {name = 'down', angle = 120, "
      "to = '3 mm', law = 'joining'}, {name = 'on', to = '0 mm', law = 'joining'}]\n" +
          rest,
      "f.toml");
}

std::string table_of(const ProblemStatement& problem, double step, double first, int digits,
                     double noise = 0) {
  const Law<double> law = problem.laws.front().law();
  std::mt19937 random(1);
  std::normal_distribution<double> error(0, noise);
  std::string text = "angle [deg];lift [mm]\n";
  for (double angle = first; angle < 360; angle += step) {
    const double lift = 24 * law(angle / 360).s + (noise > 0 ? error(random) : 0);
    text += fmt::format("{:.3f};{:.{}f}\n", angle, lift, digits);
  }
  return text;
}

}  // namespace

TEST_CASE("a stroke that the motion gives is not called a default", "[lift_table]") {
  const std::string words = in_words(with_table(table_of(program(), 1, 0, 4)));
  CHECK_THAT(words, Contains("It has stroke = ") && Contains(" mm (from the motion)"));
  CHECK_THAT(words.substr(words.find("By default")), !Contains("stroke = "));
}

TEST_CASE("a lift table made from a program gives the program's responses", "[lift_table]") {
  const auto sizes = [](double base, double preload) {
    return fmt::format(
        "[constants]\nbase_radius = {}\nspring_rate = 5\nspring_preload = {}\nspeed = 200\n", base,
        preload);
  };
  const ProblemStatement stated = program(sizes(40, 50));
  for (const double first : {0.0, 0.5}) {
    // The table's lift counts from its lowest row, which lies a little below the program's zero.
    double lowest = 0;
    const Law<double> law = stated.laws.front().law();
    for (double angle = first; angle < 360; angle += 0.5) {
      lowest = std::min(lowest, 24 * law(angle / 360).s);
    }
    const ProblemStatement table =
        with_table(table_of(stated, 0.5, first, 13), "smoothing = 'none'",
                   sizes(40 + lowest, 50 + 5 * lowest));
    const auto expected = evaluate(stated), found = evaluate(table);
    REQUIRE(expected.size() == found.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      INFO(found[i].name);
      if (std::isnan(expected[i].highest) || std::isnan(expected[i].value)) {
        CHECK((std::isnan(found[i].highest) || std::isnan(found[i].value)));
        continue;
      }
      const bool is_left = found[i].name == "guide_overhang";
      const double shift = found[i].name == "displacement" ? lowest : is_left ? -lowest : 0;
      const double slack = 1e-6 * std::abs(expected[i].highest - expected[i].lowest);
      CHECK(found[i].value == Approx(expected[i].value).epsilon(1e-6));
      CHECK(found[i].highest + shift == Approx(expected[i].highest).margin(slack));
      CHECK(found[i].lowest + shift == Approx(expected[i].lowest).margin(slack));
    }
  }
}

TEST_CASE("a table is smoothed as it is stated, and says by how much", "[lift_table]") {
  constexpr double kNoise = 0.002;  // mm
  const std::string table = table_of(program(), 1, 0, 6, kNoise);
  const ProblemStatement by_length = with_table(table, "smoothing = '0.003 mm'");
  CHECK_THAT(in_words(by_length), Contains("it is 0.003 mm from them (root mean square)"));
  const Law<double> exact = program().laws.front().law();
  const Law<double> smooth = with_table(table).laws.front().law();
  const Law<double> rough = with_table(table, "smoothing = 'none'").laws.front().law();
  double of_smooth = 0, of_rough = 0, most = 0;
  for (int i = 0; i < 720; ++i) {
    const double a = exact((i + 0.5) / 720).a;
    of_smooth = std::max(of_smooth, std::abs(smooth((i + 0.5) / 720).a - a));
    of_rough = std::max(of_rough, std::abs(rough((i + 0.5) / 720).a - a));
    most = std::max(most, std::abs(a));
  }
  CHECK(of_smooth < 0.2 * most);
  CHECK(of_rough > most);
}

TEST_CASE("a smoothed table has no jumps, however many rows it has", "[lift_table]") {
  for (const double step : {2.0, 0.5, 0.05}) {
    INFO(step << " deg");
    // Rests between the moves: there the spline's coefficients are nearly 0.
    std::string table = "angle [deg];lift [mm]\n";
    for (int i = 0; i < static_cast<int>(360 / step); ++i) {
      const double angle = i * step, t = std::clamp((angle - 60) / 120, 0.0, 1.0),
                   back = std::clamp((angle - 220) / 100, 0.0, 1.0);
      const auto rise = [](double u) { return u * u * u * (10 - 15 * u + 6 * u * u); };
      table += fmt::format("{};{:.3f}\n", angle, 28 * (rise(t) - rise(back)));
    }
    const auto peak = peaks(with_table(table).laws.front().law());
    CHECK(std::isfinite(peak.max_jerk()));
    // 28 mm in a third and in 100 deg of the turn: 5.77 (360 / 100)^2.
    CHECK(peak.max_acceleration() == Approx(5.7735 * 12.96).epsilon(0.03));
  }
}

TEST_CASE("a table is read as people have written it", "[lift_table]") {
  const std::string good = table_of(program(), 1, 0, 9);
  std::string shifted = good;
  shifted.replace(shifted.find("\n0.000;"), 7, "\n-1e-15;");
  const auto lift = [](const ProblemStatement& problem) {
    return problem.laws.front().law()(0.3).s;
  };
  CHECK(lift(with_table(shifted)) == Approx(lift(with_table(good))).epsilon(1e-9));
  CHECK(lift(with_table(good + "360.000;0.000000000\n")) ==
        Approx(lift(with_table(good))).epsilon(1e-6));
  // Latin-1 becomes UTF-8, which a result can carry.
  const testing::Folder folder;
  std::string latin = good;
  latin.replace(latin.find("[deg]"), 5, "[\xb0]");
  std::ofstream(folder / "lift.csv") << latin;
  std::ofstream(folder / "cam.toml")
      << "mechanism = 'disc-cam-roller'\n[program]\ntable = 'lift.csv'\n";
  const ProblemStatement read = read_problem_file(folder / "cam.toml");
  CHECK_THAT(read.files.tables.at("lift.csv"), Contains("[\xc2\xb0]"));
  CHECK(lift(read) == Approx(lift(with_table(good))).epsilon(1e-9));
}

TEST_CASE("a table is smoothed as little as is stated", "[lift_table]") {
  // Rows with an error of 1/400: half as many spans as rows stay about 0.0018 away at least.
  constexpr int kRows = 40;
  std::mt19937 random(3);
  std::vector<double> x, s;
  for (int i = 0; i < kRows; ++i) {
    x.push_back(i / static_cast<double>(kRows));
    const double error = random() % 2 == 0 ? 0.0025 : -0.0025;
    s.push_back(0.5 - 0.5 * std::cos(2 * std::numbers::pi * x.back()) + error);
  }
  double before = 1e9;  // the greatest acceleration: it falls as the spline may be farther away
  for (const double wanted : {1e-5, 1e-4, 5e-4, 1e-3, 2e-3, 2.4e-3}) {
    INFO(wanted);
    const TableMotion motion = table_motion(x, s, {TableSmoothing::Kind::Deviation, wanted});
    CHECK(motion.deviation == Approx(wanted).epsilon(1e-6));
    const double acceleration = peaks(motion.law).max_acceleration();
    CHECK(acceleration < before);
    before = acceleration;
  }
}

TEST_CASE("tables that are no motion are refused in words", "[lift_table]") {
  const std::string good = table_of(program(), 1, 0, 6);
  CHECK_THAT(complaint([&] { with_table(good, "", "[constants]\nstroke = 20\n"); }),
             Contains("f.toml:6: constants.stroke: the table's lift already gives the stroke"));
  CHECK_THAT(complaint([&] { with_table("angle [deg];lift [mm]\n0;1\n10;2\n20;3\n"); }),
             Contains("program.table: there are no rows from 20 to 360 deg"));
  CHECK_THAT(complaint([&] { with_table("angle [deg];lift [mm]\n0;1\nabc;2\n20;3\n"); }),
             Contains("program.table: lift.csv:3: 'abc'"));
  CHECK_THAT(complaint([&] { with_table("angle [deg];lift [kg]\n0;1\n10;2\n20;3\n"); }),
             Contains("column 'lift' is in 'kg'"));
  CHECK_THAT(complaint([&] { with_table(good, "smoothing = 'some'"); }),
             Contains("write \"none\", \"auto\""));
  CHECK_THAT(complaint([&] { with_table(good, "smoothing = '90 mm'"); }),
             Contains("program.smoothing: no smoothing spline is exactly that far from the rows"));
  // The distances that it calls possible are.
  const std::string words = complaint([&] { with_table(good, "smoothing = '90 mm'"); });
  const double least = std::stod(words.substr(words.find("are from ") + 9));
  const double range = 24;
  CHECK(least < 1e-6);
  CHECK_NOTHROW(with_table(good, fmt::format("smoothing = '{} mm'", 1e-6 * range)));
  CHECK_THAT(complaint([&] { with_table(good, "segments = []"); }), Contains("segments"));
  std::string rising = "angle [deg];lift [mm]\n", plain = "angle;lift\n";
  for (int i = 0; i <= 36; ++i) {
    rising += fmt::format("{};{}\n", 10 * i, i);
    plain += fmt::format("{};{}\n", 10 * i, 10 + 5 * std::cos(std::numbers::pi * i / 18));
  }
  CHECK_THAT(
      complaint([&] { with_table(rising); }),
      Contains("at 0 deg the lift is 0 mm and 36 mm; give one turn of a motion that returns"));
  CHECK_THAT(complaint([&] { with_table(plain); }),
             Contains("its lift has no unit") && Contains("\"lift [mm]\""));
  CHECK(complaint([&] { with_table(plain, "", "[constants]\nstroke = 20\n"); }) == "accepted");
  CHECK_THAT(complaint([&] {
               ProblemStatement table = with_table(good);
               set_value(table, "stroke=44 mm");
             }),
             Contains("stroke: the motion is stated in mm"));
  // 5 deg apart and called rad, the rows run over 56 turns.
  std::string radians = table_of(program(), 5, 0, 6);
  radians.replace(radians.find("deg"), 3, "rad");
  CHECK_THAT(complaint([&] { with_table(radians); }),
             Contains("its angles run from 0 to 20340 deg, over 56.5 turns"));
  CHECK_THAT(complaint([] {
               read_problem("mechanism = 'disc-cam-roller'\n[program]\ntable = 'none.csv'\n",
                            "f.toml");
             }),
             Contains("none.csv"));
}

TEST_CASE("a slip in a table is named, a row without a number counted", "[lift_table]") {
  const std::string good = table_of(program(), 5, 0, 6);
  const std::size_t row = good.find("\n100.000;") + 9;
  const std::size_t length = good.find('\n', row) - row;
  std::string slipped = good, lacking = good;
  slipped.replace(row, length, "32.5");
  lacking.replace(row, length, "");
  CHECK_THAT(complaint([&] { with_table(slipped); }),
             Contains("the row at 100 deg, 32.5 mm, is far off the curve through its neighbours"));
  CHECK(complaint([&] { with_table(slipped, "smoothing = 'none'"); }) == "accepted");
  CHECK_THAT(in_words(with_table(lacking)), Contains("71 rows (1 row without a number left out)"));
  CHECK_THAT(in_words(with_table(good)), !Contains("left out"));
  // Neither is noise a slip, nor a rise in as few rows as are taken.
  CHECK(complaint([&] { with_table(table_of(program(), 5, 0, 6, 0.3)); }) == "accepted");
  CHECK(complaint([&] { with_table(table_of(program(), 29, 0, 6)); }) == "accepted");
}

}  // namespace camlaw::problems::lift_table_test
