// SPDX-License-Identifier: MIT
// The program's fit of files as machines and people leave them.
#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <fstream>
#include <numbers>

#include "kinematics/laws/catalogue.h"
#include "tests/cli/program_runner.h"
#include "tests/random_numbers.h"

namespace camlaw::cli::fit_records_test {
namespace {

using testing::Random;

std::string written(const Folder& folder, const std::string& name, const std::string& text) {
  const std::string path = folder / name;
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

/// A modified sine over 120 deg and 20 mm, row 57 off by `by`, row 60 at another place.
std::string rise(double by, const std::string& place = "60") {
  const Law<double> law = find_law("modified-sine").law();
  Random random(4);
  std::string text = "angle [deg], lift [mm]\n";
  for (int i = 0; i <= 120; ++i) {
    const double s = 20 * law(i / 120.0).s + 0.002 * random.normal() + (i == 57 ? by : 0);
    text += fmt::format("{}, {:.4f}\n", i == 60 ? place : std::to_string(i), s);
  }
  return text;
}

}  // namespace

TEST_CASE("fit names rows that are off by their lines", "[program]") {
  const Folder folder;
  const std::string off = written(folder, "off.csv", rise(5));
  const ParsedJson found = json_of({"fit", off, "--law", "modified-sine", "--json"});
  CHECK(found["trusted"] == true);
  REQUIRE(found["outliers_in_value"].size() == 1);
  CHECK(found["outliers_in_value"][0]["line"] == 59);
  CHECK(found["outliers_in_value"][0]["distance"].get<double>() == Approx(5).margin(0.02));
  CHECK_THAT(done({"fit", off, "--law", "modified-sine"}), Contains("line 59 (57 deg) by 5 mm"));
  const std::string stray = written(folder, "stray.csv", rise(0, "1886131"));
  const ParsedJson without = json_of({"fit", stray, "--law", "modified-sine", "--json"});
  CHECK(without["trusted"] == true);
  REQUIRE(without["outliers_in_abscissa"].size() == 1);
  CHECK(without["outliers_in_abscissa"][0]["line"] == 62);
  CHECK_THAT(done({"fit", stray, "--law", "modified-sine"}), Contains("line 62 at 1886131 deg"));
}

TEST_CASE("fit bounds what it reads", "[program]") {
  const Folder folder;
  struct Case {
    std::string path, says;
  };
  // A child begins as large as the program that runs it, and sanitizers hold memory of their own.
  const Outcome least = run({"--version"});
  for (const Case& bad : std::vector<Case>{
           {"/dev/zero", "not text"},
           {written(folder, "header.csv", std::string(40'000'000, 'a') + "\n1,2\n"), "longer than"},
           {written(folder, "wide.csv",
                    [] {
                      std::string line = "1";
                      for (int i = 0; i < 100'000; ++i) line += ",1";
                      std::string names = "a";
                      for (int i = 0; i < 100'000; ++i) names += ",a";
                      return names + "\n" + line + "\n";
                    }()),
            "100001 columns"},
           {written(folder, "three.csv", "angle [deg], lift [mm]\n0,0\n1,2\n2,4\n"), "5 rows"}}) {
    INFO(bad.path);
    const Outcome outcome = run({"fit", bad.path});
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK_THAT(outcome.err, Contains(bad.says));
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK(outcome.worked < 5 + 20 * least.worked);
    CHECK(outcome.memory < least.memory + 1.5e8);
  }
}

TEST_CASE("fit prints nothing that was not computed", "[program][long]") {
  const Folder folder;
  for (const int rows : {5, 6, 7, 9}) {
    std::string text = "angle [deg], lift [mm]\n";
    for (int i = 0; i < rows; ++i) text += fmt::format("{}, {}\n", i, i * i);
    const std::string said = done({"fit", written(folder, "few.csv", text)});
    INFO(said);
    CHECK_THAT(said, !Contains("nan"));
  }
}

TEST_CASE("fit reads profiles without units and fits their centre", "[program][heavy]") {
  const Folder folder;
  // A knife's cam: the profile's radius at the angle -phi is the base radius and the lift.
  const Law<double> law = find_law("cycloidal").law();
  const auto lift = [&](double phi) {
    return phi < 60    ? 0
           : phi < 170 ? 20 * law((phi - 60) / 110).s
           : phi < 220 ? 20
           : phi < 330 ? 20 * (1 - law((phi - 220) / 110).s)
                       : 0;
  };
  Random random(5);
  std::string xyz = "Messprotokoll; M\xE4rz\r\n\r\nX;Y;Z\r\n", polar = "Winkel;Radius\n";
  for (int i = 0; i < 360; ++i) {
    const double angle = -i * std::numbers::pi / 180, r = 50 + lift(i) + 0.002 * random.normal();
    const std::complex<double> p = std::polar(r, angle) + std::polar(0.17, 0.7);
    std::string row = fmt::format("{:.5f};{:.5f};0,0\r\n", p.real(), p.imag());
    std::replace(row.begin(), row.end(), '.', ',');
    xyz += row;
    polar += fmt::format("{};{:.5f}\n", 360 - i, r);
  }
  const std::string path = written(folder, "xyz.csv", xyz);
  const Words words{"fit",   path,        "--mechanism", "disc-cam-knife-edge",
                    "--law", "cycloidal", "--json"};
  const ParsedJson plain = json_of(words);
  CHECK(plain["notes"].size() == 2);
  CHECK(plain["trusted"] == false);
  CHECK_THAT(plain["reason"].get<std::string>(), Contains("once per turn"));
  Words with_centre = words;
  with_centre.insert(with_centre.end(), {"--shift", "centre"});
  const ParsedJson centred = json_of(with_centre);
  CHECK(centred["trusted"] == true);
  CHECK(centred["centre"]["x"].get<double>() == Approx(0.17 * std::cos(0.7)).margin(0.003));
  CHECK(centred["centre"]["y"].get<double>() == Approx(0.17 * std::sin(0.7)).margin(0.003));
  CHECK(centred["cam"]["departures"].empty());
  CHECK_THAT(failed({"fit", path}, 2), Contains("--mechanism") && Contains("cam's profile"));
  const ParsedJson round = json_of({"fit", written(folder, "polar.csv", polar), "--mechanism",
                                    "disc-cam-knife-edge", "--law", "cycloidal", "--json"});
  CHECK(round["trusted"] == true);
  CHECK(round["notes"].size() == 2);
  CHECK_THAT(failed({"fit", path, "--mechanism", "disc-cam-knife-edge", "--shift", "place"}, 2),
             Contains("--shift centre"));
}

}  // namespace camlaw::cli::fit_records_test
