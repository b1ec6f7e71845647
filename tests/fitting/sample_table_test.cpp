// SPDX-License-Identifier: MIT
// Tables as measuring machines write them, and texts that are none.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <sstream>
#include <tuple>

#include "fitting/cams/measured_cam.h"
#include "fitting/motions/motion_data.h"
#include "numerics/tables/assumed_units.h"
#include "numerics/tables/line_source.h"
#include "numerics/tables/table_layout.h"
#include "tests/problems/complaint.h"

namespace camlaw::problems::sample_table_test {
namespace {

using Catch::Contains;

std::string said(const std::string& text) {
  return testing::complaint([&] { motion_record(parse_samples(text, "t.csv")); });
}

/// A text in UTF-16 with its byte order mark; ASCII and Latin-1 only.
std::string utf16(const std::string& latin1, bool big) {
  std::string result = big ? "\xFE\xFF" : "\xFF\xFE";
  for (const char c : latin1) {
    if (big) result += '\0';
    result += c;
    if (!big) result += '\0';
  }
  return result;
}

}  // namespace

TEST_CASE("a step is recognised in the unit to which it was converted", "[samples]") {
  for (const auto& [unit, factor, decimals] :
       {std::tuple{"in", 25.4, 4}, std::tuple{"in", 25.4, 5}, std::tuple{"in", 25.4, 6},
        std::tuple{"in", 25.4, 12}, std::tuple{"m", 1000.0, 8}}) {
    INFO(unit << " with " << decimals << " decimals");
    std::string text = fmt::format("angle [deg], lift [{}]\n", unit);
    for (int i = 0; i <= 600; ++i) {
      const double rounded = 0.01 * std::round(100 * (7 - 7 * std::cos(i * 3.14159 / 600)));
      text += fmt::format("{}, {:.{}f}\n", 0.2 * i, rounded / factor, decimals);
    }
    const MotionSamples samples = motion_samples(parse_samples(text, "t.csv"));
    CHECK(samples.resolution == Approx(0.01).epsilon(1e-3));
  }
  // Values that are rounded to nothing else than their last digit.
  std::string text = "angle [deg], lift [in]\n";
  for (int i = 0; i <= 120; ++i) {
    text += fmt::format("{}, {:.5f}\n", i, 0.3 - 0.3 * std::cos(i * 3.14159 / 120));
  }
  CHECK(motion_samples(parse_samples(text, "t.csv")).resolution == Approx(25.4e-5));
}

TEST_CASE("commas that may part thousands are not guessed at", "[samples]") {
  CHECK_THAT(said("angle [deg];lift [um]\n0;0\n1;873\n2;1,077\n3;25,000\n4;25,000\n5;25,000\n"),
             Contains("t.csv:4") && Contains("'1,077'") && Contains("thousands"));
  // Decimal commas: a number below one, another count of decimals, or all with them.
  for (const char* rows : {"0;0\n1;0,873\n2;1,077\n3;25\n4;25\n", "0;0\n1;87\n2;1,07\n3;25\n4;25\n",
                           "0;0\n1;1,873\n2;2,077\n3;25,000\n4;25,000\n"}) {
    INFO(rows);
    const MotionSamples read =
        motion_samples(parse_samples("angle [deg];lift [mm]\n" + std::string(rows), "t.csv"));
    CHECK(read.value.back() == 25);
  }
}

TEST_CASE("a quote for inches is a unit, and a turn of radians without one is named", "[samples]") {
  const std::string rows = "\n0, 0\n1, 0.1\n2, 0.5\n3, 0.9\n4, 1\n";
  const MotionRecord inches = motion_record(parse_samples("angle [deg], lift [\"]" + rows, "t"));
  CHECK(inches.samples.unit == "mm");
  CHECK(inches.samples.value.back() == Approx(25.4));
  const MotionRecord plain = motion_record(
      parse_samples("angle, lift [mm]\n0, 0\n2, 0.1\n4, 0.5\n5, 0.9\n6.28, 1\n", "t"));
  REQUIRE(plain.notes.size() == 1);
  CHECK_THAT(plain.notes[0], Contains("'angle'") && Contains("[rad]"));
}

TEST_CASE("one table comes back however it is written", "[samples]") {
  const std::vector<double> places{0, 0.5, 1}, values{2, 3.25, 4};
  const std::vector<std::string> texts{
      "angle [deg], lift [mm]\n0, 2\n0.5, 3.25\n1, 4\n",
      "angle [deg], lift [mm]\r\n0, 2\r\n0.5, 3.25\r\n1, 4\r\n",
      "angle [deg], lift [mm]\r0, 2\r0.5, 3.25\r1, 4",
      "\xEF\xBB\xBF"
      "angle [deg];lift [mm]\n0;2\n0,5;3,25\n1;4\n",
      // Lines before the names, blanks around and between cells, a unit in Latin-1.
      "Messprotokoll 7\nPr\xFC"
      "fer: M. 12,5\n\nWinkel [\xB0]   Hub [mm]\n  0,0   2,00\n  0,5   3,25 \n  1,0   4,00\n",
      "Cam angle [deg] Lift [mm]\n0 2\n0.5 3.25\n1 4\n",
      "Date;1.2.2020;14;30\nangle;lift\ndeg;mm\n0;2\n0.5;3.25\n1;4\n",
      "Bench 3\nangle\tlift\n[deg]\t[mm]\n0\t2\n0.5\t3.25\n1\t4\n",
      "# bench 3, morning\n# angle [deg], lift [mm]\n0, 2\n0.5, 3.25\n1, 4\n",
      "angle [deg];lift [mm];\n0;2;\n0,5;3,25;\n1;4;\n",
      "angle [deg];lift [mm]\n0;2;\n0,5;3,25;\n1;4;\n",
      "angle_deg, lift_mm\n0, 2\n0.5, 3.25\n1, 4\n", "φ/°; s/mm\n0;2\n0,5;3,25\n1;4\n",
      "WINKEL in Grad; HUB in mm\n0;2\n0,5;3,25\n1;4\n",
      "КУТ [deg]; Переміщення [mm]\n0;2\n0,5;3,25\n1;4\n",
      "angle [deg], lift [mm]\n\"0\",\"2\"\n\"0,5\",\"3,25\"\n1,4\n",
      "Teil 5 7\nangle [deg], note, lift [mm]\n0, a, 2\n0.5, b, 3.25\n1, c, 4\n",
      utf16("Winkel\tHub\r\nGrad\tmm\r\n0\t2\r\n0,5\t3,25\r\n1\t4\r\n", false),
      utf16("Winkel [\xB0];Hub [mm]\n0;2\n0,5;3,25\n1;4\n", true)};
  for (const std::string& text : texts) {
    INFO(text);
    const MotionRecord record = motion_record(parse_samples(text, "t.csv"));
    CHECK(record.samples.place == places);
    CHECK(record.samples.value == values);
    CHECK(record.samples.place_unit == "deg");
    CHECK(record.samples.unit == "mm");
    CHECK(record.lines.size() == 3);
  }
}

TEST_CASE("rows know the lines that they stand on", "[samples]") {
  const SampleTable table =
      parse_samples("Protocol\r\n\r\nangle, lift\r\n0, 1\r\n# pause\r\n1,\r\n2, 3\r\n", "t");
  CHECK(table.lines == std::vector<std::uint32_t>{4, 6, 7});
  CHECK(numbers_of(table, {&table.columns[0], &table.columns[1]}).lines ==
        std::vector<std::uint32_t>{4, 7});
}

TEST_CASE("what is not a table says in one line what to change", "[samples]") {
  CHECK_THAT(said(std::string(100, '\0')), Contains("t.csv:1") && Contains("not text"));
  CHECK_THAT(said("angle,lift\n1,2\n" + std::string(kMostLineBytes + 1, '3')),
             Contains("t.csv:3") && Contains("longer than"));
  CHECK_THAT(said("Protocol\nDate 1.2.2020\n0 1.5\n1 2.5\n2 4\n"),
             Contains("t.csv:3") && Contains("names as many columns"));
  CHECK_THAT(said("cam angle lift\n0 1.5\n1 2.5\n"),
             Contains("t.csv:2") && Contains("names as many columns"));
  CHECK_THAT(said("angle,lift\n1,2,3\n2,3,4\n"), Contains("t.csv:2") && Contains("3 cells"));
  CHECK_THAT(said("angle,lift\n1,2\nmean;12\n"), Contains("t.csv:3") && Contains("1 cell,"));
  std::string wide = "a", row = "1";
  for (int i = 0; i < 1200; ++i) wide += fmt::format(",a{}", i), row += ",1";
  CHECK_THAT(said(wide + "\n" + row + "\n"), Contains("1201 columns"));
  std::string blank(1 << 16, '\n');
  CHECK_THAT(said(blank), Contains("empty"));
  std::string words;
  for (int i = 0; i < 1500; ++i) words += "some text\n";
  CHECK_THAT(said(words), Contains("one column"));
}

TEST_CASE("units that are not stated are taken where the values leave no doubt, and said",
          "[samples]") {
  SampleTable table = parse_samples("X;Y;Z\n1;2;3\n2;3;4\n", "t");
  CHECK_FALSE(shows_profile(table));
  const auto notes = assume_profile_units(table);
  CHECK(notes.size() == 2);
  CHECK_THAT(notes[0], Contains("'X'") && Contains("mm"));
  CHECK(shows_profile(table));
  SampleTable polar = parse_samples("Winkel;Radius\n0;40\n90;41\n350;40\n", "t");
  CHECK(shows_profile(polar));
  CHECK(assume_profile_units(polar).size() == 2);
  CHECK(polar.columns[0].unit == "deg");
  SampleTable doubtful = parse_samples("Winkel;Radius\n0;40\n3;41\n6;40\n", "t");
  CHECK_THAT(testing::complaint([&] { assume_profile_units(doubtful); }),
             Contains("'Winkel'") && Contains("[rad]"));
  const MotionRecord record = motion_record(parse_samples("angle,lift\n0,0\n90,1\n180,2\n", "t"));
  CHECK(record.samples.place_unit == "deg");
  CHECK(record.notes.size() == 1);
  CHECK(motion_record(parse_samples("angle,lift\n0,0\n1,1\n", "t")).notes.empty());
  CHECK(goes_round(parse_samples("x,y\n1,0\n0,1\n-1,0\n0,-1\n1,-0.1\n", "t")));
  CHECK_FALSE(goes_round(parse_samples("x,y\n1,0\n2,1\n3,2\n", "t")));
}

TEST_CASE("a column is what its heading says, however the unit is written", "[samples]") {
  const auto record = [](const std::string& header, const std::string& rows) {
    return motion_record(parse_samples(header + "\n" + rows, "t"));
  };
  const std::string rows = "0;0\n1;2\n2;3\n";
  for (const char* header :
       {"angle in deg;velocity in mm/deg", "angle_deg;velocity_mm/deg", "phi/deg;v/mm/deg",
        "angle [deg];speed [mm/deg]", "Winkel in Grad;Geschwindigkeit in mm/deg"}) {
    INFO(header);
    const MotionRecord found = record(header, rows);
    CHECK(found.samples.order == 1);
    CHECK(found.samples.unit == "mm/deg");
    CHECK(found.samples.value[1] == Approx(2));
    CHECK(found.samples.value[2] == Approx(3));
  }
  const MotionRecord timed = record("Zeit in ms;Weg_in", rows);
  CHECK(timed.samples.place_unit == "s");
  CHECK(timed.samples.place[2] == Approx(0.002));
  CHECK(timed.samples.unit == "mm");
  CHECK(timed.samples.value[1] == Approx(50.8));
  CHECK(record("time/ms;velocity [m/s]", rows).samples.value[1] == Approx(2000));
  CHECK(record("t_ms;acceleration in m/s2", rows).samples.order == 2);
  // What a column is taken for without a word on it is said.
  REQUIRE(record("angle [deg];probe", rows).notes.size() == 1);
  CHECK_THAT(record("angle [deg];probe", rows).notes[0],
             Contains("'probe'") && Contains("displacement"));
  CHECK_THAT(record("angle [deg];speed [mm/deg]", rows).notes.at(0), Contains("velocity"));
  const auto refused = [&](const std::string& header) {
    return testing::complaint([&] { record(header, rows); });
  };
  CHECK_THAT(refused("angle in deg;lift in thumbs"), Contains("'lift'") && Contains("'thumbs'"));
  CHECK_THAT(refused("time;velocity [m/s]"),
             Contains("'time' states no unit") && Contains("time [s]"));
}

TEST_CASE("names of columns give their units in several ways", "[samples]") {
  const auto named = [](const char* cell) {
    const ColumnName name = column_name(cell);
    return name.name + "|" + name.unit;
  };
  CHECK(named("lift [mm]") == "lift|mm");
  CHECK(named("lift(mm)") == "lift|mm");
  CHECK(named("Hub in mm") == "Hub|mm");
  CHECK(named("s/mm") == "s|mm");
  CHECK(named("cam_angle_deg") == "cam_angle|deg");
  // Of every quantity, not of lengths and angles alone.
  CHECK(named("velocity in mm/deg") == "velocity|mm/deg");
  CHECK(named("Geschwindigkeit in mm/s") == "Geschwindigkeit|mm/s");
  CHECK(named("acceleration in mm/deg^2") == "acceleration|mm/deg^2");
  CHECK(named("velocity_m/s") == "velocity|m/s");
  CHECK(named("velocity/mm/s") == "velocity|mm/s");
  CHECK(named("t/ms") == "t|ms");
  CHECK(named("Zeit in ms") == "Zeit|ms");
  CHECK(named("time_ms") == "time|ms");
  CHECK(named("lift_in") == "lift|in");
  CHECK(named("drive_torque in N m") == "drive_torque|N m");
  CHECK(named("drive_torque/Nm") == "drive_torque|Nm");
  CHECK(named("drive_torque_Nm") == "drive_torque|Nm");
  // A quantity in something that is no unit keeps that, to be refused with it.
  CHECK(named("lift in thumbs") == "lift|thumbs");
  CHECK(named("time_in") == "time_in|");
  CHECK(named("profile_x") == "profile_x|");
  CHECK(named("m/s") == "m/s|");
  // What may as well be a name stays one: a share of the stroke, a curve of a machine.
  CHECK(named("s/h") == "s/h|");
  CHECK(named("drive_torque") == "drive_torque|");
}

}  // namespace camlaw::problems::sample_table_test
