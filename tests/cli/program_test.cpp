// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>

#include "kinematics/laws/catalogue.h"
#include "tests/cli/program_runner.h"
#include "tests/paths.h"

namespace camlaw::cli::program_test {

TEST_CASE("the program tells its version and its usage", "[program]") {
  CHECK_THAT(done({"--version"}), Contains("camlaw") && Contains("0.1.0"));
  CHECK_THAT(done({"--help"}),
             Contains("laws") && Contains("law") && Contains("study") && Contains("reproduce"));
  for (const char* command : {"laws", "law", "study", "reproduce"}) {
    CHECK_THAT(done({command, "--help"}), Contains("--json"));
  }
}

TEST_CASE("bad input ends with status 2 and one line that says what is accepted", "[program]") {
  struct Case {
    Words words;
    const char *says, *accepts;
  };
  const Case cases[] = {
      {{"lwas"}, "lwas", "laws"},
      {{"zigzag"}, "zigzag", "study"},
      {{"--frobnicate"}, "--frobnicate", "--help"},
      {{}, "a command is required", "'camlaw --help' lists them"},
      {{"laws", "--jsn"}, "--jsn", "--help"},
      {{"laws", "cubic"}, "cubic", "--help"},
      {{"laws", "--jsn", "--mrkdown"},
       "laws does not take '--jsn --mrkdown'",
       "did you mean --json"},
      {{"law", "cubic", "--param", "crossover=0.4", "deg"}, "'deg'", "blanks needs quotes"},
      {{"laws", "--json=3"}, "--json takes no value", "--help"},
      {{"law"}, "NAME", "--help"},
      {{"law", "modified-sin"}, "modified-sin", "modified-sine"},
      {{"law", "zzzzzz"}, "zzzzzz", "camlaw laws"},
      {{"law", "cubic", "--param"}, "--param", "--help"},
      {{"law", "cubic", "--param", "x=1"}, "'x'", "crossover"},
      {{"law", "cubic", "--param", "crossover"}, "crossover", "name=value"},
      {{"law", "cubic", "--param", "crossover=1.5"}, "crossover", "0.02 .. 0.98"},
      {{"law", "polynomial-5", "--param", "alpha=nan"}, "alpha", "-30 .. 30"},
      {{"law", "polynomial-5", "--param", "alpha=three"}, "alpha", "is not a number"},
      {{"law", "polynomial-5", "--param", "alpha=3 deg"}, "alpha", "a plain number is needed"},
      {{"law", "inclined-sinusoid", "--param", "angle=3 mm"}, "angle", "an angle is needed"},
      {{"law", "inclined-sinusoid", "--param", "angle=3 rad"}, "angle", "50 .. 130"},
      {{"law", "fourier", "--param", "a=0.1,,0.2"}, "a", "is not a number"},
      {{"law", "cubic", "--samples", "1"}, "--samples", "2"},
      {{"law", "cubic", "--samples", "many"}, "--samples", "many"},
      {{"study"}, "SYSTEM", "--help"},
      {{"study", "balancing-cam"}, "balancing-cam", "spine-cutter"},
      {{"study", "spine-cutter", "--set", "depht=1"}, "depht", "depth (h)"},
      {{"study", "spine-cutter", "--set", "h=1 deg"}, "depth", "a length is needed"},
      {{"study", "spine-cutter", "--set", "h=26 mm"}, "depth", "25 mm"},
      {{"study", "spine-cutter", "--set", "h=0.4.5mm"}, "depth", "a length is needed"},
      {{"reproduce", "die-presss"}, "die-presss", "spine-cutter"},
      {{"reproduce", "spine-cutter", "nothing"}, "nothing", "spine-cutter"},
  };
  for (const Case& bad : cases) {
    std::string line;
    for (const std::string& word : bad.words) line += " " + word;
    INFO("camlaw" << line);
    CHECK_THAT(failed(bad.words, 2), Contains(bad.says) && Contains(bad.accepts));
  }
}

TEST_CASE("a run that fails leaves no file and no folder", "[program]") {
  const Folder folder;
  std::ofstream(folder / "plain") << "not a folder";
  const std::string below = folder / "plain/x.csv";
  CHECK_THAT(failed({"law", "cubic", "--csv", below}, 1), Contains(below));
  CHECK_THAT(failed({"law", "cubic", "--csv", folder / "a.csv", "--svg", below}, 1),
             Contains(below));
  CHECK_THAT(failed({"study", "spine-cutter", "--out", folder / "plain"}, 2),
             Contains(folder / "plain"));
  failed({"law", "nothing", "--csv", folder / "a.csv"}, 2);
  failed({"law", "cubic", "--param", "crossover=2", "--csv", folder / "a.csv"}, 2);
  failed({"law", "cubic", "--csv", folder / "a.csv", "--bogus"}, 2);
  failed({"study", "spine-cutter", "--set", "h=30 mm", "--out", folder / "results"}, 2);
  CHECK(folder.content() == std::set<std::string>{"plain"});
  CHECK(read(folder / "plain") == "not a folder");
}

TEST_CASE("one place for table and picture is refused and nothing is written", "[program]") {
  const Folder folder;
  const Outcome outcome = run({"law", "cubic", "--csv", folder / "a", "--svg", folder / "a"});
  CHECK(outcome.status != 0);
  CHECK(folder.content().empty());
}

TEST_CASE("output that cannot be written is a failure", "[program]") {
  const std::string command = testing::program() + " laws --json >/dev/full 2>/dev/null";
  const int status = std::system(command.c_str());
  CHECK(WEXITSTATUS(status) == 1);
}

TEST_CASE("without standard error the exit status still tells", "[program]") {
  const auto status_of = [](const std::string& words) {
    const std::string command = testing::program() + " " + words;
    return WEXITSTATUS(std::system(command.c_str()));
  };
  CHECK(status_of("lwas 2>&-") == 2);
  CHECK(status_of("law nothing 2>&-") == 2);
  CHECK(status_of("law cubic --csv /dev/null/x 2>&-") == 1);
  CHECK(status_of("laws --json >&- 2>&-") == 1);
}

TEST_CASE("a file does not take the place of a closed stream", "[program]") {
  const Folder folder;
  const std::string command =
      testing::program() + " law cubic --csv " + (folder / "cubic.csv") + " --samples 2 >&- 2>&-";
  CHECK(WEXITSTATUS(std::system(command.c_str())) == 1);
  CHECK(read(folder / "cubic.csv") == "x,s,v,a,j\n0,0,0,6,-12\n1,1,0,-6,-12\n");
}

TEST_CASE("laws --json lists every law of the catalogue and of the reference table", "[program]") {
  const ParsedJson laws = json_of({"laws", "--json"});
  std::vector<std::string> names;
  for (const ParsedJson& law : laws) {
    names.push_back(law.at("name"));
    for (const char* key : {"aliases", "parameters", "C_v", "C_a_max", "C_a_min", "C_j_max",
                            "C_j_min", "C_Mdyn", "lambda", "ends", "continuity", "source"}) {
      INFO(names.back() << " " << key);
      CHECK(law.contains(key));
    }
  }
  CHECK(std::set<std::string>(names.begin(), names.end()).size() == names.size());
  CHECK(names.size() == catalogue().size());
  for (const auto& row : testing::read_table("problems/laws/motion_laws.csv")) {
    INFO(row.at("law"));
    CHECK(std::find(names.begin(), names.end(), row.at("law")) != names.end());
  }
}

TEST_CASE("laws lists them as a table", "[program]") {
  const std::string text = done({"laws"});
  for (const auto& family : catalogue()) CHECK_THAT(text, Contains("\n" + family.name + " "));
}

TEST_CASE("law takes parameters with units and lists", "[program]") {
  const auto angle = [](const std::string& text) {
    return json_of({"law", "inclined-sinusoid", "--param", "angle=" + text, "--json"});
  };
  const ParsedJson degrees = angle("82deg"), plain = angle("82"), radians = angle("1.43 rad");
  CHECK(degrees == plain);
  CHECK(degrees["parameters"][0]["value"].get<double>() == Approx(82).epsilon(1e-14));
  CHECK(radians["parameters"][0]["value"].get<double>() ==
        Approx(1.43 * 180 / std::numbers::pi).epsilon(1e-14));
  CHECK(angle("90 deg")["C_v"].get<double>() == Approx(2).epsilon(1e-12));  // the cycloid

  const ParsedJson list = json_of({"law", "fourier", "--param", "a=0.1,-0.05", "--json"});
  CHECK(list["parameters"][0]["value"] == ParsedJson{0.1, -0.05});
  CHECK(list == json_of({"law", "fourier a=0.1,-0.05", "--json"}));
  CHECK(list == json_of({"law", "fourier", "--param", "a=0.1, -0.05", "--json"}));
  const ParsedJson two =
      json_of({"law", "trapezoidal-velocity", "--param", "t1=0.2", "--param", "t2=0.3", "--json"});
  // Area 1 under the trapezoid: B (1 - t1 / 2 - t2 / 2) = 1.
  CHECK(two["C_v"].get<double>() == Approx(1 / 0.75).epsilon(1e-13));
}

TEST_CASE("law prints text with the peaks, and says where files went", "[program]") {
  CHECK_THAT(done({"law", "poly-3-4-5"}), Contains("poly-3-4-5") && Contains("C_v    ") &&
                                              Contains("1.875") && Contains("lambda"));
  const Folder folder;
  const std::string csv = folder / "new/curve.csv", svg = folder / "curve.svg";
  CHECK_THAT(done({"law", "cubic", "--csv", csv, "--svg", svg}), Contains(csv) && Contains(svg));
  CHECK(folder.content() == std::set<std::string>{"new", "new/curve.csv", "curve.svg"});
  check_svg(svg);
  CHECK(csv_of(read(csv)).size() == 362);  // 361 points and the header
}

TEST_CASE("the table of a law has its closed form's values", "[program]") {
  const Folder folder;
  done({"law", "cubic", "--samples", "11", "--csv", folder / "cubic.csv"});
  const CsvRows rows = csv_of(read(folder / "cubic.csv"));
  REQUIRE(rows.size() == 12);
  CHECK(rows[0] == Words{"x", "s", "v", "a", "j"});
  const ParsedJson json = json_of({"law", "cubic", "--samples", "11", "--json"});
  REQUIRE(json["samples"].size() == 11);
  for (std::size_t i = 0; i <= 10; ++i) {
    const double x = static_cast<double>(i) / 10;
    const std::map<std::string, double> expected{{"x", x},
                                                 {"s", x * x * (3 - 2 * x)},
                                                 {"v", 6 * x * (1 - x)},
                                                 {"a", 6 - 12 * x},
                                                 {"j", -12}};
    for (std::size_t k = 0; k < 5; ++k) {
      const double value = std::stod(rows[i + 1][k]);
      CHECK(value == Approx(expected.at(rows[0][k])).margin(1e-14));
      CHECK(json["samples"][i][rows[0][k]].get<double>() == value);
    }
  }
  CHECK_THAT(done({"law", "cubic", "--samples", "3"}), Contains("x,s,v,a,j\n0,0,0,6,-12\n"));
}

TEST_CASE("the study writes its files, and they agree", "[program][heavy]") {
  const Folder folder;
  const Words words{"study", "spine-cutter", "--set", "h=1.0 mm", "--set", "V=72 m/min"};
  Words with_files = words, as_json = words;
  with_files.insert(with_files.end(), {"--out", folder / "deep/results"});
  as_json.push_back("--json");
  const std::string text = done(with_files);
  CHECK(folder.content() ==
        std::set<std::string>{"deep", "deep/results", "deep/results/.camlaw.json",
                              "deep/results/fronts.csv", "deep/results/study.csv",
                              "deep/results/study.json", "deep/results/trade_off.svg",
                              "deep/results/motion.svg"});
  for (const char* name :
       {"fronts.csv", "study.csv", "study.json", "trade_off.svg", "motion.svg"}) {
    CHECK_THAT(text, Contains(folder / (std::string("deep/results/") + name)));
  }
  check_svg(folder / "deep/results/trade_off.svg");
  check_svg(folder / "deep/results/motion.svg");
  const std::string json = done(as_json);
  CHECK(json == read(folder / "deep/results/study.json"));

  const ParsedJson study = ParsedJson::parse(json);
  CHECK_THAT(text, Contains(study["recommendation"].get<std::string>()));
  CHECK(study["givens"][4]["value"].get<double>() == Approx(1.0).epsilon(1e-14));
  CHECK(study["givens"][3]["value"].get<double>() == Approx(1.2).epsilon(1e-14));
  const CsvRows csv = csv_of(read(folder / "deep/results/study.csv"));
  REQUIRE(csv.size() == study["rows"].size() + 1);
  for (std::size_t i = 1; i < csv.size(); ++i) {
    const ParsedJson& row = study["rows"][i - 1];
    REQUIRE(csv[i].size() == csv[0].size());
    for (std::size_t k = 0; k < csv[0].size(); ++k) {
      INFO(csv[i][0] << ", " << csv[0][k]);
      const ParsedJson& value = row.at(csv[0][k]);
      if (value.is_number()) {
        CHECK(std::stod(csv[i][k]) == value.get<double>());
      } else if (value.is_boolean()) {
        CHECK(csv[i][k] == (value.get<bool>() ? "1" : "0"));
      } else {
        CHECK(csv[i][k] == (value.is_null() ? "" : value.get<std::string>()));
      }
    }
  }
}

TEST_CASE("the cubic at the paper's depth has the paper's numbers", "[program]") {
  const ParsedJson study =
      json_of({"study", "spine-cutter", "--set", "h=1.0 mm", "--table", "--json"});
  for (const ParsedJson& row : study["rows"]) {
    if (row["law"] != "cubic") continue;
    CHECK(row["cam_radius_mm"].get<double>() == Approx(33.08).margin(0.005));
    CHECK(row["printed_inertia_force_N"].get<double>() == Approx(4.56).margin(0.005));
    CHECK(row["inertia_force_N"].get<double>() ==
          Approx(2 * row["printed_inertia_force_N"].get<double>()));
    return;
  }
  FAIL("no row for the cubic");
}

TEST_CASE("reproduce gives the verdict on every printed number", "[program][heavy]") {
  const ParsedJson all = json_of({"reproduce", "spine-cutter", "--json"});
  const ParsedJson both = json_of({"reproduce", "--json"});
  REQUIRE(all.size() == 1);
  const std::vector<const char*> systems{"spine-cutter",   "balancing-cam",    "die-press",
                                         "sheet-delivery", "signature-feeder", "motion-laws",
                                         "cam-shape"};
  REQUIRE(both.size() == systems.size());
  CHECK(both[0] == all[0]);
  for (std::size_t i = 0; i < systems.size(); ++i) {
    CHECK(both[i]["system"] == systems[i]);
    CHECK(both[i]["worsened"].empty());
  }
  const ParsedJson& system = all[0];
  CHECK(system["system"] == "spine-cutter");
  CHECK(system["reproduced"] == 13);
  CHECK(system["explained"] == 19);
  CHECK(system["unexplained"] == 0);
  CHECK(system["departures"].size() == 6);
  CHECK(system["equal_sets"].empty());
  REQUIRE(system["values"].size() == 32);
  std::map<std::string, int> verdicts;
  for (const ParsedJson& value : system["values"]) {
    for (const char* key : {"id", "quantity", "law", "condition", "place", "printed", "decimals",
                            "unit", "value", "explained_value", "verdict", "causes"}) {
      CHECK(value.contains(key));
    }
    ++verdicts[value["verdict"]];
  }
  CHECK(verdicts == std::map<std::string, int>{{"reproduced", 13}, {"explained", 19}});
  const std::string text = done({"reproduce"});
  CHECK_THAT(text, Contains("13 reproduced, 19 explained, 0 unexplained"));
  const std::string counts = text.substr(text.rfind("system "));
  for (const ParsedJson& one : both) {
    CHECK_THAT(counts, Contains(one["system"].get<std::string>()));
  }
}

TEST_CASE("two runs give the same bytes", "[program][long]") {
  const Folder folder;
  for (const char* out : {"1", "2"}) {
    done({"study", "spine-cutter", "--table", "--out", folder / out});
  }
  for (const char* name : {"study.csv", "study.json", "trade_off.svg", "motion.svg"}) {
    INFO(name);
    CHECK(read(folder / (std::string("1/") + name)) == read(folder / (std::string("2/") + name)));
  }
  for (const Words& words : {Words{"laws", "--json"}, Words{"law", "table", "--json"},
                             Words{"reproduce", "spine-cutter", "--json"}}) {
    CHECK(done(words) == done(words));
  }
}

}  // namespace camlaw::cli::program_test
