// SPDX-License-Identifier: MIT
#include "problems/published/table/stated_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "kinematics/laws/catalogue.h"
#include "kinematics/peaks.h"
#include "numerics/formula/expression.h"
#include "optim/problem/deadline.h"
#include "problems/published/systems.h"
#include "problems/published/table/printed_text.h"
#include "problems/published/table/readout.h"
#include "tests/paths.h"
#include "tests/temporary_folder.h"

namespace camlaw::problems::stated_table_test {
namespace {

using Catch::Matchers::Contains;
constexpr double kPi = std::numbers::pi;

SystemReproduction reproduced(const std::string& toml) {
  return reproduce_table(read_stated_table(toml, "own.toml"), nullptr);
}

const ReproducedValue& value_of(const SystemReproduction& result, const std::string& id) {
  const auto found = std::find_if(result.values.begin(), result.values.end(),
                                  [&](const auto& v) { return v.printed.id == id; });
  REQUIRE(found != result.values.end());
  return *found;
}

/// A pendulum's period, 2 pi sqrt(l / g): no machine of the program.
const std::string kPendulum = R"toml(
title = "periods of pendulums"
[machine]
name = "pendulum"
[machine.parameters.length]
unit = "m"
default = 1
lower = 0
[machine.parameters.gravity]
unit = "m/s2"
default = 9.81
lower = 0
[responses.period]
formula = "2 * pi * sqrt(length / gravity)"
unit = "s"
)toml";

std::string pendulum_value(const std::string& length, const std::string& printed) {
  return "[[values]]\nid = \"" + length + "\"\nresponse = \"period\"\nset = \"length = " + length +
         "\"\nprinted = \"" + printed + "\"\n";
}

}  // namespace

TEST_CASE("a printed text is its digits, its decimals and its unit", "[stated-table]") {
  struct Print {
    const char* text;
    double value;
    int decimals;
    const char* unit;
  };
  for (const Print& print : {Print{"12.34 mm", 12.34, 2, "mm"}, Print{"-0.50", -0.5, 2, ""},
                             Print{"+7", 7, 0, ""}, Print{"1.20e-3 m", 1.2e-3, 5, "m"},
                             Print{"1.234e2 N", 123.4, 1, "N"}, Print{"48.78 1/s", 48.78, 2, "1/s"},
                             Print{" 3 N mm ", 3, 0, "N mm"}, Print{"5eV", 5, 0, "eV"}}) {
    INFO(print.text);
    const PrintedText read = read_printed_text(print.text);
    CHECK(read.number.value == print.value);
    CHECK(read.number.decimals == print.decimals);
    CHECK(read.unit == print.unit);
  }
  for (const char* text :
       {"", "mm", "1,5 mm", "1.2.3", "1.2e3", "1e400", ".", "-", "nan", "0.1234567890123456"}) {
    INFO(text);
    CHECK_THROWS_AS(read_printed_text(text), std::invalid_argument);
  }
}

TEST_CASE("a table of a machine of one's own is computed by its formula", "[stated-table]") {
  // 2 pi sqrt(1 / 9.81) = 2.00607, and of 2 m 2.83701.
  const auto result =
      reproduced(kPendulum + pendulum_value("1 m", "2.01 s") + pendulum_value("200 cm", "2837 ms") +
                 pendulum_value("3 m", "9.99 s"));
  CHECK(result.system == "own");
  CHECK(value_of(result, "1 m").verdict == optim::Finding::Reproduced);
  CHECK(value_of(result, "1 m").stated_value == Approx(2 * kPi / std::sqrt(9.81)).epsilon(1e-12));
  CHECK(value_of(result, "200 cm").verdict == optim::Finding::Reproduced);
  CHECK(value_of(result, "200 cm").stated_value ==
        Approx(2000 * kPi * std::sqrt(2 / 9.81)).epsilon(1e-12));
  CHECK(value_of(result, "3 m").verdict == optim::Finding::Unexplained);
  CHECK(worsened(result).empty());
}

TEST_CASE("the alternative behind a table is found, and no other", "[stated-table]") {
  const std::string hypothesis =
      "[hypotheses.gravity]\nstated = \"9.81\"\nset = \"gravity = {} m/s2\"\n"
      "alternatives = [9.8, \"1.5:0.01:1.8\", \"3.7:0.01:3.8\"]\n";
  // On the Moon, at 1.62: 4.93656, 6.98136, 8.55037.
  const auto result =
      reproduced(kPendulum + hypothesis + pendulum_value("1 m", "4.937 s") +
                 pendulum_value("2 m", "6.981 s") + pendulum_value("3 m", "8.550 s"));
  CHECK(result.explained == 3);
  CHECK(
      result.departures ==
      std::vector<std::string>{"gravity: 1.62 (stated 9.81), one of 43 tried, needed by 3 values"});
  CHECK(result.equals.empty());
}

TEST_CASE("what the source does not state is found among the alternatives, or left unknown",
          "[stated-table]") {
  const std::string value = pendulum_value("1 m", "2.006 s");
  const auto found = reproduced(kPendulum +
                                "[hypotheses.gravity]\nset = \"gravity={}\"\n"
                                "alternatives = [\"9:0.01:10\"]\n" +
                                value);
  CHECK(std::isnan(found.values[0].stated_value));
  CHECK(found.explained == 1);
  const auto unknown = reproduced(kPendulum +
                                  "[hypotheses.gravity]\nset = \"gravity={}\"\nrows = \"*\"\n"
                                  "alternatives = []\n[[implied]]\nparameter = \"gravity\"\n"
                                  "lower = \"1\"\nupper = \"20\"\n" +
                                  value);
  CHECK(unknown.unexplained == 1);
  CHECK_THAT(unknown.values[0].causes[0], Contains("gravity: not stated"));
  // (2 pi / 2.006)^2 = 9.8107
  CHECK_THAT(unknown.values[0].causes[1], Contains("gravity = 9.811 m/s2"));
}

TEST_CASE("a row keeps what it states itself", "[stated-table]") {
  const std::string hypothesis =
      "[hypotheses.length]\nstated = \"1 m\"\nset = \"length={}\"\nalternatives = [\"2 m\"]\n";
  const std::string bare =
      "[[values]]\nid = \"bare\"\nresponse = \"period\"\nprinted = \"2.837 s\"\n";
  const auto result = reproduced(kPendulum + hypothesis + bare + pendulum_value("1 m", "2.837 s"));
  CHECK(value_of(result, "bare").verdict == optim::Finding::Explained);
  CHECK(value_of(result, "1 m").verdict == optim::Finding::Unexplained);
}

TEST_CASE("peaks are read off grids and differences as by hand", "[stated-table]") {
  const Law<double> law = find_law("cycloidal").law();
  const auto formula = [](std::size_t which) {
    return Formula::record(5, [=](std::span<const Expression> u) { return u[which]; });
  };
  const Cycle once{"1", {{0, 1}}}, back{"deg", {{0, 180}, {180, 360, true}}};
  const std::vector<double> kWhole{0, 1};
  for (const int n : {5, 8, 20}) {
    double v = 0, a = 0, dv = 0, da = 0;
    const auto s = [&](int i) {
      const double x = std::clamp(i, 0, n) / static_cast<double>(n);
      return x - std::sin(2 * kPi * x) / (2 * kPi);
    };
    for (int i = 0; i <= n; ++i) {
      const double x = i / static_cast<double>(n);
      v = std::max(v, 1 - std::cos(2 * kPi * x));
      a = std::max(a, std::abs(2 * kPi * std::sin(2 * kPi * x)));
      dv = std::max(dv, (s(i + 1) - s(i - 1)) * n / 2);
      da = std::max(da, std::abs(s(i + 1) - 2 * s(i) + s(i - 1)) * n * n);
    }
    const auto off = [&](std::size_t which, Readout::Kind kind, const Cycle& cycle) {
      return read_off({formula(which), cycle}, {}, law, kWhole, optim::Part::Magnitude, {kind, n});
    };
    CHECK(off(1, Readout::Kind::Grid, once) == Approx(v).epsilon(1e-12));
    CHECK(off(2, Readout::Kind::Grid, once) == Approx(a).epsilon(1e-12));
    CHECK(off(2, Readout::Kind::Grid, back) == Approx(a).epsilon(1e-12));
    CHECK(off(1, Readout::Kind::Differences, once) == Approx(dv).epsilon(1e-12));
    CHECK(off(2, Readout::Kind::Differences, once) == Approx(da).epsilon(1e-12));
  }
  // The acceleration of the cosine falls from its end on: of four steps the first inner place
  // counts.
  CHECK(read_off({formula(2), once}, {}, find_law("cosine").law(), kWhole, optim::Part::Highest,
                 {Readout::Kind::InnerGrid, 4}) ==
        Approx(kPi * kPi / 2 * std::cos(kPi / 4)).epsilon(1e-12));
  CHECK(read_readout("grid of 9 steps without its ends").kind == Readout::Kind::InnerGrid);
  CHECK(read_readout("grid of 12 steps").steps == 12);
  CHECK(read_readout("differences on 360 steps").kind == Readout::Kind::Differences);
  for (const char* text : {"", "grid", "grid of steps", "grid of -3 steps", "grid of 1 steps",
                           "differences on 1e3 steps", "grid of 20 steps of"}) {
    INFO(text);
    CHECK_THROWS_AS(read_readout(text), std::invalid_argument);
  }
}

TEST_CASE("a curve is compared at a place of its cycle", "[stated-table]") {
  // Simple harmonic motion: half of the stroke is done at half of the rise.
  const auto result = reproduced(R"toml(
mechanism = "spine-cutter"
[[values]]
id = "half"
response = "displacement"
at = "90 deg"
law = "cosine"
set = ["stroke = 40 mm"]
printed = "20.00 mm"
[[values]]
id = "third"
response = "displacement"
at = "300 deg"
law = "cosine"
set = ["stroke = 40 mm"]
printed = "10.0 mm"
)toml");
  CHECK(result.reproduced == 2);
  CHECK(value_of(result, "third").stated_value == Approx(10).epsilon(1e-12));
}

TEST_CASE("a place that a curve does not have is refused", "[stated-table]") {
  const auto at = [](const std::string& place) {
    return "mechanism = \"spine-cutter\"\n[[values]]\nid = \"a\"\nresponse = \"displacement\"\n"
           "at = \"" +
           place + "\"\nlaw = \"cosine\"\nprinted = \"0.00 mm\"\n";
  };
  CHECK(reproduced(at("360 deg")).reproduced == 1);
  for (const char* place : {"-10 deg", "370 deg", "1000 deg"}) {
    INFO(place);
    CHECK_THROWS_WITH(reproduced(at(place)),
                      Contains("'a'.at") && Contains("is outside the cycle, 0 .. 360 deg"));
  }
}

namespace {

/// A rise of 80 deg, a return of 160 deg and a rest by a disc cam at 200 rpm, and one value of it.
std::string cam_value(const std::string& response, const std::string& printed) {
  return R"toml(
mechanism = "disc-cam-roller"
[constants]
stroke = "30 mm"
base_radius = "52 mm"
roller_radius = "8 mm"
speed = "200 rpm"
[program]
segments = [{name = "rise", angle = "80 deg", law = "cycloidal"},
            {name = "return", angle = "160 deg", law = "cycloidal"}, {name = "low"}]
[[values]]
id = "peak"
response = ")toml" +
         response + "\"\nprinted = \"" + printed + "\"\n";
}

}  // namespace

TEST_CASE("a grid has its steps in each segment of a program", "[stated-table]") {
  // v = h omega / beta (1 - cos 2 pi x) and its peak among i / 7; omega = 20 pi / 3.
  const double rate = 0.03 * (20 * kPi / 3) / (80 * kPi / 180);
  double grid = 0, differences = 0;
  const auto s = [](double x) { return x - std::sin(2 * kPi * x) / (2 * kPi); };
  for (int i = 1; i < 7; ++i) {
    grid = std::max(grid, rate * (1 - std::cos(2 * kPi * i / 7)));
    differences = std::max(differences, rate * (s((i + 1) / 7.0) - s((i - 1) / 7.0)) * 7 / 2);
  }
  for (const auto& [peaks, value] :
       {std::pair{"grid of {} steps", grid}, std::pair{"differences on {} steps", differences}}) {
    INFO(peaks);
    const auto result = reproduced(cam_value("highest velocity", fmt::format("{:.5f} m/s", value)) +
                                   "[hypotheses.grid]\nstated = \"exact\"\npeaks = \"" + peaks +
                                   "\"\nalternatives = [\"5:1:12\"]\n");
    CHECK(result.explained == 1);
    CHECK_THAT(result.departures.front(), Contains("grid: 7"));
  }
}

TEST_CASE("what a value implies is told in words that tell its ends apart", "[stated-table]") {
  const std::string speed =
      "[hypotheses.speed]\nstated = \"200 rpm\"\nset = \"speed={} rpm\"\n"
      "alternatives = [210]\n[[implied]]\nparameter = \"speed\"\nlower = \"";
  const std::string two =
      "[[values]]\nid = \"a\"\nresponse = \"highest acceleration\"\nprinted "
      "= \"95.426 m/s2\"\n";
  const std::string value = cam_value("highest velocity", "1.3501 m/s");
  const auto found = reproduced(value + two + speed + "100 rpm\"\nupper = \"400 rpm\"\n").values[0];
  CHECK_THAT(fmt::format("{}", fmt::join(found.causes, "; ")), Contains("needs 300.01 to 300.03"));
  const auto none = reproduced(value + two + speed + "100 rpm\"\nupper = \"250 rpm\"\n");
  CHECK_THAT(fmt::format("{}", fmt::join(none.values[0].causes, "; ")),
             Contains("no value of speed gives the printed value") && !Contains("valueed"));
}

TEST_CASE("digits may be cut off, and the wrong response may be printed", "[stated-table]") {
  const auto cut = reproduced(kPendulum +
                              "[hypotheses.digits]\nstated = \"rounded\"\ndigits = \"cut off\"\n"
                              "alternatives = [\"cut off\"]\n" +
                              pendulum_value("2 m", "2.83 s") + pendulum_value("1 m", "2.0 s"));
  CHECK(value_of(cut, "2 m").verdict == optim::Finding::Explained);
  CHECK(value_of(cut, "1 m").verdict == optim::Finding::Reproduced);
  const auto half =
      reproduced(kPendulum +
                 "[responses.swing]\nformula = \"period / 2\"\nunit = \"s\"\n"
                 "[hypotheses.time]\nstated = \"period\"\n"
                 "responses = { period = \"swing\" }\nalternatives = [\"a swing\"]\n" +
                 pendulum_value("2 m", "1.4185 s") + pendulum_value("3 m", "1.7373 s"));
  CHECK(half.explained == 2);
  CHECK(half.departures ==
        std::vector<std::string>{
            "time: a swing (stated period), one of 1 tried, needed by 2 values"});
}

TEST_CASE("a wrong table is refused with its file, line, row and key", "[stated-table]") {
  struct Wrong {
    std::string toml;
    std::vector<std::string> says;
  };
  const std::string good = pendulum_value("1 m", "2.01 s");
  const auto hypothesis = [&](const std::string& text) {
    return kPendulum + good + "[hypotheses.h]\n" + text;
  };
  const std::vector<Wrong> all{
      {"", {"own.toml", "no values"}},
      {"format = \"camlaw table 9\"\n" + kPendulum + good, {"format", "9"}},
      {kPendulum + "[objective]\nminimize = \"period\"\n" + good, {"objective", "unknown key"}},
      {kPendulum + pendulum_value("1 m", "2,01 s"), {"values[1] '1 m'.printed", "point"}},
      {kPendulum + pendulum_value("1 m", "2.01 kg"), {"values[1] '1 m'.printed", "kg"}},
      {kPendulum + pendulum_value("1 m", ""), {"values[1] '1 m'.printed: the text is empty"}},
      {kPendulum + pendulum_value("1 kg", "2.01 s"), {"values[1] '1 kg'.set", "kg"}},
      {kPendulum + good + good, {"values[2] '1 m'", "another value"}},
      {kPendulum + "[[values]]\nid = \"a\"\nresponse = \"period\"\nprinted = 2.01\n",
       {"'a'.printed", "quotes"}},
      {kPendulum + "[[values]]\nid = \"a\"\nresponse = \"perod\"\nprinted = \"2.01\"\n",
       {"own.toml:", "'a'.response", "period"}},
      {kPendulum + "[[values]]\nid = \"a\"\nresponse = \"period\"\n",
       {"'a'", "printed is missing"}},
      {kPendulum + "[[values]]\nresponse = \"period\"\n", {"values[1]", "id is missing"}},
      {kPendulum + "[[values]]\nid = \"a\"\nresponse = \"period\"\nprinted = \"2\"\nlaw = "
                   "\"cosine\"\n",
       {"'a'.law", "not moved by a law"}},
      {kPendulum + "[[values]]\nid = \"a\"\nresponse = \"period\"\nprinted = \"2\"\nat = \"3\"\n",
       {"'a'.at", "no place"}},
      {hypothesis("stated = \"a\"\nset = \"gravity={}\"\n"), {"hypotheses.h", "alternatives"}},
      {hypothesis("stated = \"a\"\nalternatives = [1]\n"), {"hypotheses.h", "changes nothing"}},
      {hypothesis("stated = \"a\"\nset = \"gravit={}\"\nalternatives = [1]\n"),
       {"hypotheses.h", "changes none"}},
      {hypothesis("stated = \"a\"\nset = \"length={}\"\nalternatives = [1]\n"),
       {"hypotheses.h", "changes none"}},
      {hypothesis("stated = \"a\"\nset = \"gravity={}\"\nalternatives = [-1]\n"),
       {"hypotheses.h", "gravity"}},
      {hypothesis("stated = \"a\"\nset = \"gravity={}\"\nalternatives = [\"1:-1:5\"]\n"),
       {"alternatives[1]", "range"}},
      {hypothesis("stated = \"a\"\nset = \"gravity={}\"\nalternatives = [\"8:0.3:9\"]\n"),
       {"alternatives[1]", "end at 8.9 and do not meet 9"}},
      {hypothesis("stated = \"a\"\nset = \"gravity={}\"\nalternatives = [\"0:1e-9:1\"]\n"),
       {"hypotheses.h"}},
      {hypothesis("stated = \"a\"\nset = \"gravity={}\"\nalternatives = [\"0:0.000001:1\"]\n"),
       {"alternatives[1]", "at most 10000"}},
      {hypothesis("stated = \"a\"\nset = \"gravity={}\"\nrows = [\"2*\"]\nalternatives = [1]\n"),
       {"hypotheses.h", "none of the values"}},
      {hypothesis("stated = \"a\"\npeaks = \"grid of {} steps\"\nalternatives = [1]\n"),
       {"peaks", "steps"}},
      {hypothesis("stated = \"a\"\ndigits = \"lost\"\nalternatives = [1]\n"),
       {"digits", "cut off"}},
      {hypothesis("stated = \"a\"\nset = \"gravity={}\"\nalternatives = [1]\n[hypotheses.i]\n"
                  "stated = \"b\"\nset = \"gravity={}\"\nalternatives = [2]\n"),
       {"hypotheses.i", "gravity", "hypotheses.h"}},
  };
  for (const Wrong& wrong : all) {
    INFO(wrong.toml);
    try {
      reproduced(wrong.toml);
      FAIL_CHECK("it is accepted");
    } catch (const std::invalid_argument& error) {
      for (const std::string& word : wrong.says) CHECK_THAT(error.what(), Contains(word));
    }
  }
}

TEST_CASE("a law is needed where a value follows one, and may stand for all", "[stated-table]") {
  const std::string value =
      "[[values]]\nid = \"a\"\nresponse = \"peak inertia_force\"\nprinted = \"3.75 N\"\n";
  CHECK_THROWS_WITH(reproduced("mechanism = \"spine-cutter\"\n" + value),
                    Contains("values[1] 'a'") && Contains("law"));
  const std::string all = "mechanism = \"spine-cutter\"\n[law]\nname = \"cosine\"\n";
  CHECK_NOTHROW(reproduced(all + value));
  CHECK_THROWS_WITH(reproduced(all + value + "law = \"cosin\"\n"), Contains("'a'.law"));
}

TEST_CASE("a file is found by its path, and a system by its name", "[stated-table]") {
  const testing::Folder folder;
  const std::string path = folder / "pendulum.toml";
  testing::write(path, kPendulum + pendulum_value("1 m", "2.01 s"));
  const ReproducibleSystem found = find_reproducible(path);
  CHECK(found.name == "pendulum");
  CHECK(found.files == std::vector<std::string>{path});
  CHECK(found.reproduce(nullptr).reproduced == 1);
  CHECK_THROWS_WITH(find_reproducible("pendulum"), Contains("spine-cutter") && Contains(".toml"));
  CHECK_THROWS_WITH(find_reproducible(folder / "nothing.toml"), Contains("nothing.toml"));
}

TEST_CASE("the table of motion laws agrees with the peaks of the laws", "[stated-table]") {
  const auto result = find_reproducible("motion-laws").reproduce(nullptr);
  for (const ReproducedValue& value : result.values) {
    INFO(value.printed.id);
    if (value.printed.quantity != "C_v" && value.printed.quantity != "C_a") continue;
    const auto peak = peaks(find_law(value.printed.law).law());
    CHECK(value.stated_value ==
          Approx(value.printed.quantity == "C_v" ? peak.max_velocity() : peak.max_acceleration())
              .epsilon(1e-10));
  }
}

TEST_CASE("a law that the source does not state leaves nothing to imply", "[stated-table]") {
  const auto result = reproduced(R"toml(
mechanism = "law"
[hypotheses.coefficient]
laws = { "a secret law" = "polynomial-7 A={}" }
alternatives = [1, 2]
[[implied]]
parameter = "period_ratio"
[[values]]
id = "a"
response = "C_a"
law = "a secret law"
printed = "1.234"
)toml");
  CHECK(result.unexplained == 1);
}

TEST_CASE("the documents' example comes out as they say", "[stated-table]") {
  const std::string page = testing::read(testing::source("docs/reproduction.md"));
  const std::string fence = "```toml\n";
  const auto start = page.find(fence) + fence.size();
  const auto result = reproduced(page.substr(start, page.find("```", start) - start));
  CHECK(value_of(result, "chord").verdict == optim::Finding::Reproduced);
  CHECK(value_of(result, "blades").verdict == optim::Finding::Explained);
  CHECK(result.departures ==
        std::vector<std::string>{
            "number of blades: 21 (stated 17), one of 21 tried, needed by 1 value"});
}

TEST_CASE("a table can be stopped", "[stated-table]") {
  const std::atomic<bool> stop{true};
  CHECK_THROWS_AS(find_reproducible("spine-cutter").reproduce(&stop), optim::Interrupted);
}

}  // namespace camlaw::problems::stated_table_test
