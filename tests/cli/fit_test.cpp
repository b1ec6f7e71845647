// SPDX-License-Identifier: MIT
// The program's fit: what it answers and what it refuses.
#include <cmath>
#include <fstream>
#include <set>
#include <string>

#include "tests/cli/program_runner.h"

namespace camlaw::cli {
namespace {

std::string written(const Folder& folder, const std::string& name, const std::string& text) {
  const std::string path = folder / name;
  std::ofstream(path) << text;
  return path;
}

/// A 3-4-5 over 90 deg and 20 mm.
std::string rise() {
  std::string text = "angle [deg], lift [mm]\n";
  for (int i = 0; i <= 90; ++i) {
    const double u = i / 90.0;
    text += std::to_string(i) + ", " + std::to_string(20 * u * u * u * (10 - 15 * u + 6 * u * u)) +
            "\n";
  }
  return text;
}

}  // namespace

TEST_CASE("fit names the law behind samples, and writes its file", "[program]") {
  const Folder folder;
  const std::string data = written(folder, "rise.csv", rise());
  const Json result = Json::parse(done({"fit", data, "--law", "poly-3-4-5", "--json"}));
  for (const char* key : {"law", "parameters", "rms", "max_residual", "criterion", "ranking",
                          "identifiable", "trusted", "segments", "motions", "left_out"}) {
    INFO(key);
    CHECK(result.contains(key));
  }
  CHECK(result["law"] == "poly-3-4-5");
  for (const Json& p : result["parameters"]) {
    for (const char* key : {"name", "value", "low", "high"}) CHECK(p.contains(key));
    if (p["name"] == "stroke") CHECK(p["value"].get<double>() == Approx(20).epsilon(1e-4));
  }
  const std::string text = done({"fit", data, "--out", folder / "out"});
  CHECK_THAT(text, Contains("poly-3-4-5") && Contains("AICc") && Contains("wrote"));
  CHECK(folder.content() ==
        std::set<std::string>{"rise.csv", "out", "out/fit.json", "out/fit.svg", "out/law.json"});
  CHECK_THAT(done({"law", folder / "out/law.json"}), Contains("1.875"));
}

TEST_CASE("fit lists samples that lie far off, and what helps", "[program]") {
  const Folder folder;
  std::string text = "angle [deg], lift [mm]\n";
  for (int i = 0; i <= 180; ++i) {
    const double u = i / 180.0, noise = 0.01 * std::sin(37.3 * i * i);
    const double s = 20 * u * u * u * (10 - 15 * u + 6 * u * u) + noise;
    text += std::to_string(i / 2.0) + ", " + std::to_string(i % 18 == 5 ? 12 + s / 9 : s) + "\n";
  }
  const std::string data = written(folder, "far.csv", text);
  const Json plain = Json::parse(done({"fit", data, "--law", "poly-3-4-5", "--json"}));
  CHECK(plain["trusted"] == false);
  CHECK_THAT(plain["reason"].get<std::string>(), Contains("--loss"));
  const Json robust =
      Json::parse(done({"fit", data, "--law", "poly-3-4-5", "--loss", "cauchy", "--json"}));
  CHECK(robust["trusted"] == true);
  CHECK(robust["far_off"]["count"].get<int>() >= 8);
  CHECK(robust["far_off"]["samples"].size() == robust["far_off"]["count"]);
  for (const char* key : {"sigma", "degrees_of_freedom", "neighbour_correlation", "condition",
                          "free_directions", "max_residual_at", "residual_unit", "place_unit"}) {
    INFO(key);
    CHECK(robust.contains(key));
  }
  CHECK(robust["residual_unit"] == "mm");
  CHECK_THAT(done({"fit", data, "--law", "poly-3-4-5", "--loss", "cauchy"}),
             Contains("farther off than the") && Contains("degrees of freedom") &&
                 Contains("all numbers are determined"));
}

TEST_CASE("fit names the law behind printed constants", "[program]") {
  const Json result = Json::parse(
      done({"fit", "--constants", "B=1.6125, C=4.66", "--law", "polynomial-5", "--json"}));
  for (const char* key : {"law", "parameters", "rms", "max_residual", "criterion", "ranking",
                          "identifiable", "constants", "consistent"}) {
    INFO(key);
    CHECK(result.contains(key));
  }
  CHECK(result["law"] == "polynomial-5 alpha=-3");
  CHECK(result["parameters"][0]["value"] == -3);
  CHECK(result["identifiable"] == true);
  CHECK_THAT(done({"fit", "--constants", "B=1.6125, C=4.66", "--law", "polynomial-5"}),
             Contains("alpha") && Contains("agrees"));
}

TEST_CASE("fit says what printed constants tell and what they do not", "[program]") {
  struct Case {
    std::string constants, law, says;
  };
  for (const Case& c :
       std::vector<Case>{{"B=1.6125, C=4.66", "auto", "every constant agrees in all digits"},
                         {"B=1.6125, C=4.66", "auto", "the same motion: legendre"},
                         {"B=1.6, D=inf", "auto", "more constants or digits would tell"},
                         {"B=1.6", "trapezoidal-velocity", "does not determine t1, t2"},
                         {"B=1.6, C=6", "cubic", "B does not agree with the rest"},
                         {"B=1.6, C=5", "cubic", "no constant agrees"}}) {
    INFO(c.constants << " of " << c.law);
    CHECK_THAT(done({"fit", "--constants", c.constants, "--law", c.law}), Contains(c.says));
  }
}

TEST_CASE("fit refuses what it cannot take with one line", "[program]") {
  const Folder folder;
  const std::string good = written(folder, "good.csv", rise());
  std::string still = "angle [deg], lift [mm]\n";
  for (int i = 0; i < 50; ++i) still += std::to_string(i) + ", 3.5\n";
  struct Case {
    Words words;
    std::string says;
  };
  for (const Case& bad : std::vector<Case>{
           {{"fit"}, "--constants"},
           {{"fit", good, "--constants", "B=2"}, "--constants"},
           {{"fit", good, "--loss", "square"}, "none, huber, cauchy"},
           {{"fit", good, "--law", "polynomal-5"}, "polynomial-5"},
           {{"fit", folder / "none.csv"}, "none.csv"},
           {{"fit", written(folder, "empty.csv", "")}, "empty"},
           {{"fit", written(folder, "one.csv", "angle,lift\n1,2\n")}, "1 row"},
           {{"fit", written(folder, "text.csv", "angle,lift\n1,2\n2,high\n")}, "text.csv:3"},
           {{"fit", written(folder, "unit.csv", "angle [kg],lift [mm]\n1,2\n2,3\n")}, "'angle'"},
           {{"fit", written(folder, "still.csv", still)}, "still.csv"},
           {{"fit", "--constants", "B"}, "name=value"},
           {{"fit", "--constants", "B=2", "--loss", "huber"}, "--loss"},
           {{"fit", "--constants", "B=2", "--out", folder / "out"}, "--out"},
           {{"fit", good, "--mechanism", "press.toml"}, "--mechanism"},
           {{"fit", "--constants", "B=0.5, C=0.25"}, "no law"},
           {{"fit", "--constants", "radius=3"}, "radius"}}) {
    std::string line;
    for (const std::string& word : bad.words) line += " " + word;
    INFO("camlaw" << line);
    CHECK_THAT(failed(bad.words, 2), Contains(bad.says));
  }
}

}  // namespace camlaw::cli
