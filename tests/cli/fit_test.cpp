// SPDX-License-Identifier: MIT
// The program's fit: what it answers and what it refuses.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <set>
#include <string>

#include "kinematics/laws/catalogue.h"
#include "tests/cli/program_runner.h"
#include "tests/paths.h"
#include "tests/random_numbers.h"

namespace camlaw::cli::fit_test {
namespace {

using testing::Random;

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

/// A whole turn with a cycloidal rise over 90 deg, a dwell, a return over 90 deg and a dwell.
std::string turn_of_lift(const std::string& lift, double stroke) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const auto cycloid = [](double u) { return u - std::sin(kTurn * u) / kTurn; };
  std::string text = "angle [deg], " + lift + "\n";
  for (int i = 0; i < 360; i += 3) {
    const double s = i < 90    ? cycloid(i / 90.0)
                     : i < 180 ? 1
                     : i < 270 ? 1 - cycloid((i - 180) / 90.0)
                               : 0;
    text += fmt::format("{}, {:.5f}\n", i, stroke * s);
  }
  return text;
}

}  // namespace

TEST_CASE("fit names the law behind samples, and writes its file", "[program]") {
  const Folder folder;
  const std::string data = written(folder, "rise.csv", rise());
  const ParsedJson result = ParsedJson::parse(done({"fit", data, "--law", "poly-3-4-5", "--json"}));
  for (const char* key : {"law", "parameters", "rms", "max_residual", "criterion", "ranking",
                          "identifiable", "trusted", "segments", "motions", "left_out"}) {
    INFO(key);
    CHECK(result.contains(key));
  }
  CHECK(result["law"] == "poly-3-4-5");
  for (const ParsedJson& p : result["parameters"]) {
    for (const char* key : {"name", "value", "low", "high"}) CHECK(p.contains(key));
    if (p["name"] == "stroke") CHECK(p["value"].get<double>() == Approx(20).epsilon(1e-4));
  }
  const std::string text = done({"fit", data, "--out", folder / "out"});
  CHECK_THAT(text, Contains("poly-3-4-5") && Contains("probability") && Contains("wrote"));
  CHECK(folder.content() == std::set<std::string>{"rise.csv", "out", "out/.camlaw.json",
                                                  "out/fit.json", "out/fit.svg", "out/law.json"});
  CHECK_THAT(done({"law", folder / "out/law.json"}), Contains("1.875"));
}

TEST_CASE("fit writes the program of a lift, for the machine that is named", "[program]") {
  const Folder folder;
  const std::string data = written(folder, "lift.csv", turn_of_lift("lift [mm]", 24));
  const Words common{"fit", data, "--law", "cycloidal"};
  const auto with = [&](Words more) {
    Words words = common;
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  const std::string usual = done(with({"--out", folder / "usual"}));
  CHECK_THAT(usual, Contains("program.toml takes disc-cam-roller with its default sizes") &&
                        Contains("next: camlaw evaluate ") && Contains("usual/program.toml"));
  const std::string flat = done(with(
      {"--mechanism", "disc-cam-flat", "--set", "base_radius=55 mm", "--out", folder / "flat"}));
  CHECK_THAT(flat, !Contains("default sizes"));
  const ParsedJson found =
      ParsedJson::parse(done({"evaluate", folder / "flat/program.toml", "--json"}));
  const ParsedJson& lift = found.at("responses").at("displacement");
  CHECK(lift.at("highest").get<double>() == Approx(24).margin(1e-3));
  CHECK(lift.at("lowest").get<double>() == Approx(0).margin(1e-3));
  CHECK_THAT(read(folder / "flat/program.toml"),
             Contains("base_radius = \"55 mm\"") && Contains("law = \"cycloidal\""));
  // The lift of an arm is an angle, and a machine with another stroke is refused.
  CHECK_THAT(failed(with({"--mechanism", "disc-cam-oscillating-roller"}), 2),
             Contains("the lift is in mm, and the swing of disc-cam-oscillating-roller is in deg"));
  CHECK_THAT(failed(with({"--mechanism", "geneva"}), 2),
             Contains("geneva does not follow a program"));
  CHECK_THAT(failed({"fit", data, "--mechanism", "disc-cam-rolller"}, 2),
             Contains("neither a mechanism nor a problem file 'disc-cam-rolller'; did you mean "
                      "disc-cam-roller"));
}

TEST_CASE("fit says what a record with --mechanism may be called", "[program]") {
  const Folder folder;
  const std::string data = written(folder, "force.csv", turn_of_lift("push [N]", 24));
  const std::string said = failed({"fit", data, "--mechanism", "disc-cam-roller"}, 2);
  CHECK_THAT(said, Contains("no column has the name of a curve of disc-cam-roller, such as ") &&
                       Contains("'camlaw mechanisms disc-cam-roller'") && Contains("call it lift"));
  CHECK(said.size() < 500);  // not every curve that there is
}

TEST_CASE("fit has one line for one motion, whatever its names", "[program]") {
  const Folder folder;
  const ParsedJson result =
      ParsedJson::parse(done({"fit", written(folder, "rise.csv", rise()), "--json"}));
  CHECK(result["law"] == "poly-3-4-5");
  const ParsedJson& ranking = result["ranking"];
  const ParsedJson& first = ranking[0];
  CHECK(first["law"] == "poly-3-4-5");
  CHECK(std::count(first["same_motion"].begin(), first["same_motion"].end(),
                   "stoddart exponents=3,4,5") == 1);
  double belief = 0;
  for (const ParsedJson& law : ranking) {
    CHECK(law["law"] != "stoddart exponents=3,4,5");
    belief += law["belief"].get<double>();
  }
  CHECK(belief == Approx(1));
}

TEST_CASE("fit names angles as the record has them", "[program]") {
  // The return goes on over the end of the record: from 300 to 30 deg.
  const Folder folder;
  testing::Random random(3);
  std::string text = "angle [deg], lift [mm]\n";
  const auto poly = [](double u) { return u * u * u * (10 - 15 * u + 6 * u * u); };
  for (int i = 0; i < 360; ++i) {
    const double u = i < 30 ? (i + 60) / 90.0 : (i - 300) / 90.0;
    const double lift = i < 30 || i >= 300 ? 1 - poly(u)
                        : i < 90           ? 0
                        : i < 200          ? poly((i - 90) / 110.0)
                                           : 1;
    text += fmt::format("{}, {}\n", i, 20 * lift + 0.01 * random.normal());
  }
  const ParsedJson result = ParsedJson::parse(
      done({"fit", written(folder, "cycle.csv", text), "--law", "poly-3-4-5", "--json"}));
  REQUIRE(result["motions"].size() == 2);
  for (const ParsedJson& motion : result["motions"]) {
    CHECK(motion["max_residual_at"].get<double>() >= 0);
    CHECK(motion["max_residual_at"].get<double>() < 360);
  }
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
  const ParsedJson plain = ParsedJson::parse(done({"fit", data, "--law", "poly-3-4-5", "--json"}));
  CHECK(plain["trusted"] == false);
  CHECK_THAT(plain["reason"].get<std::string>(), Contains("--loss"));
  const ParsedJson robust =
      ParsedJson::parse(done({"fit", data, "--law", "poly-3-4-5", "--loss", "cauchy", "--json"}));
  CHECK(robust["trusted"] == true);
  CHECK(robust["outliers"]["count"].get<int>() >= 8);
  CHECK(robust["outliers"]["samples"].size() == robust["outliers"]["count"]);
  for (const char* key : {"sigma", "degrees_of_freedom", "neighbour_correlation", "condition",
                          "free_directions", "max_residual_at", "residual_unit", "abscissa_unit"}) {
    INFO(key);
    CHECK(robust.contains(key));
  }
  CHECK(robust["residual_unit"] == "mm");
  CHECK_THAT(done({"fit", data, "--law", "poly-3-4-5", "--loss", "cauchy"}),
             Contains("lie farther from the law than the") && Contains("degrees of freedom") &&
                 Contains("all numbers are determined"));
}

TEST_CASE("fit names the law behind printed constants", "[program]") {
  const ParsedJson result = ParsedJson::parse(
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
                         {"B=1.6, D=inf", "auto", "more constants or digits would decide"},
                         {"B=1.6", "trapezoidal-velocity", "do not determine t1, t2"},
                         {"B=1.6, C=6", "cubic", "B does not agree with the rest"},
                         {"B=1.6, C=5", "cubic", "no constant agrees"}}) {
    INFO(c.constants << " of " << c.law);
    CHECK_THAT(done({"fit", "--constants", c.constants, "--law", c.law}), Contains(c.says));
  }
}

TEST_CASE("fit claims no more of printed constants than it has found", "[program]") {
  // No law has a peak velocity below one: that is a search's word, not a proof.
  const std::string text =
      done({"fit", "--constants", "C_v=1.9, C_a=2.0", "--law", "polynomial-5"});
  CHECK_THAT(text, Contains("no values of this law that print all of them were found"));
  CHECK_THAT(failed({"fit", "--constants", "C_v=0.5", "--law", "elliptic"}, 2),
             Contains("no coefficients were found with which this law has any of these constants"));
}

TEST_CASE("a law says which of its derivatives jumps", "[program]") {
  CHECK_THAT(done({"law", "b-spline degree=1 knots=0.5 coefficients=0,0.3,1"}),
             Contains("velocity jumps; between"));
  CHECK_THAT(done({"law", "parabolic"}), Contains("acceleration jumps; between"));
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
           {{"fit", good, "--loss", "square"}, "none, huber or cauchy"},
           {{"fit", good, "--law", "polynomal-5"}, "polynomial-5"},
           {{"fit", folder / "none.csv"}, "none.csv"},
           {{"fit", written(folder, "empty.csv", "")}, "empty"},
           {{"fit", written(folder, "one.csv", "angle,lift\n1,2\n")}, "1 row"},
           {{"fit", written(folder, "text.csv", "angle,lift\n1,2\n2,high\n")}, "text.csv:3"},
           {{"fit", written(folder, "unit.csv", "angle [kg],lift [mm]\n1,2\n2,3\n")}, "'angle'"},
           {{"fit", written(folder, "still.csv", still)}, "3.5 throughout"},
           {{"fit", "--constants", "C_v"}, "name=value"},
           {{"fit", "--constants", "B=2", "--loss", "huber"}, "--loss"},
           {{"fit", "--constants", "B=2", "--out", folder / "out"}, "--out"},
           {{"fit", good, "--mechanism", "press.toml"}, "press.toml"},
           {{"fit", "--constants", "B=0.5, C=0.25"}, "no law"},
           {{"fit", "--constants", "radius=3"}, "radius"}}) {
    std::string line;
    for (const std::string& word : bad.words) line += " " + word;
    INFO("camlaw" << line);
    CHECK_THAT(failed(bad.words, 2), Contains(bad.says));
  }
}

TEST_CASE("fit reads a worn cam and writes the program that it was cut for", "[program][heavy]") {
  const Folder folder;
  const std::string data = testing::source("problems/cams/worn_cam.csv");
  const Words words{
      "fit",   data,          "--mechanism", "disc-cam-roller", "--set", "roller_radius=8 mm",
      "--out", folder / "out"};
  const std::string text = done(words);
  CHECK_THAT(text, Contains("as where it is worn") && Contains("lie off the profile"));
  CHECK(folder.content() == std::set<std::string>{"out", "out/.camlaw.json", "out/fit.json",
                                                  "out/fit.svg", "out/law.json",
                                                  "out/program.toml"});
  check_svg(folder / "out/fit.svg");
  const ParsedJson found = ParsedJson::parse(read(folder / "out/fit.json"));
  CHECK(found["format"] == "camlaw fit 1");
  CHECK_THAT(read(folder / "out/program.toml"), Contains("\nformat = \"camlaw problem 1\"\n"));
  CHECK(found["cam"]["departures"].size() == 1);
  CHECK(found["cam"]["outlying"].size() >= 2);
  // What the file of the cam says: cycloidal over 80 deg, 60 at rest, modified sine over 100.
  CHECK_THAT(read(folder / "out/program.toml"), Contains("cycloidal") && Contains("modified-sine"));
  const ParsedJson again = json_of({"evaluate", folder / "out/program.toml", "--json"});
  CHECK(again["constants"]["stroke"]["value"].get<double>() == Approx(30).margin(0.01));
  CHECK(again["constants"]["base_radius"]["value"].get<double>() == Approx(60).margin(0.01));
  CHECK_THAT(failed({"fit", data}, 2), Contains("--mechanism") && Contains("disc-cam-roller"));
  // Once the user has edited the program, no other fit removes it.
  const std::string edited = read(folder / "out/program.toml") + "# my edits\n";
  testing::write(folder / "out/program.toml", edited);
  CHECK_THAT(failed({"fit", written(folder, "rise.csv", rise()), "--out", folder / "out"}, 2),
             Contains("out/program.toml' was changed since camlaw wrote it"));
  CHECK(read(folder / "out/program.toml") == edited);
}

TEST_CASE("fit replaces its own files, and none that somebody changed or made", "[program]") {
  const Folder folder;
  const std::string data = written(folder, "rise.csv", rise());
  const Words words{"fit", data, "--law", "poly-3-4-5", "--out", folder / "out", "-q"};
  done(words);
  done(words);
  const std::string law = read(folder / "out/law.json"), fit = read(folder / "out/fit.json");
  testing::write(folder / "out/law.json", law + "\n");
  const std::string why = failed(words, 2);
  CHECK_THAT(why, Contains("out/law.json' was changed since camlaw wrote it") &&
                      Contains("choose another folder for --out, or move it away"));
  CHECK_THAT(why, !Contains("rise.csv: "));
  CHECK(read(folder / "out/law.json") == law + "\n");
  CHECK(read(folder / "out/fit.json") == fit);
  for (const char* name : {"fit.json", "fit.svg", "law.json"}) {
    const std::string own = folder / (std::string("of_") + name);
    fs::create_directory(own);
    testing::write(own + "/" + name, "mine");
    CHECK_THAT(failed({"fit", data, "--law", "poly-3-4-5", "--out", own}, 2),
               Contains(name) && Contains("is not in the list of files that camlaw wrote there"));
    CHECK(read(own + "/" + name) == "mine");
    CHECK(std::distance(fs::directory_iterator(own), {}) == 1);
  }
}

TEST_CASE("fit finds a machine's sizes from a recorded torque", "[program]") {
  const Folder folder;
  const std::string base = testing::source("problems/cams/recorded_torque");
  const ParsedJson found = json_of({"fit", base + ".csv", "--mechanism", base + ".toml", "--json"});
  CHECK(found["trusted"] == true);
  CHECK(found["identifiable"] == true);
  // The sizes that the table was made with stand at its head; intervals of 95 %.
  const std::map<std::string, double> made{
      {"mass", 2.4}, {"spring_rate", 8}, {"guide_friction", 0.12}};
  REQUIRE(found["parameters"].size() == made.size());
  for (const ParsedJson& p : found["parameters"]) {
    const double value = made.at(p["name"]), deviation = p["standard_deviation"];
    CHECK(std::abs(p["value"].get<double>() - value) < 3 * deviation);
    CHECK(deviation < 0.02 * value);
  }
  done({"fit", base + ".csv", "--mechanism", base + ".toml", "--out", folder / "out"});
  CHECK(folder.content() ==
        std::set<std::string>{"out", "out/.camlaw.json", "out/fit.json", "out/fit.svg"});
  check_svg(folder / "out/fit.svg");
  for (const auto& [words, says] : std::vector<std::pair<Words, std::string>>{
           {{"--mechanism", base + ".toml", "--response", "drive_power"}, "'drive_power'"},
           {{"--mechanism", base + ".toml", "--shift", "time"}, "place"},
           {{"--mechanism", "disc-cam-flat"}, "[variables]"},
           {{"--mechanism", base + ".toml", "--law", "cycloidal"}, "--law"},
           {{"--shift", "place"}, "--mechanism"}}) {
    Words all{"fit", base + ".csv"};
    all.insert(all.end(), words.begin(), words.end());
    CHECK_THAT(failed(all, 2), Contains(says));
  }
  CHECK_THAT(failed({"fit", base + ".csv", "--mechanism", base + ".toml", "--set", "foo=3"}, 2),
             !Contains("or laws"));
  CHECK_THAT(done({"fit", base + ".csv", "--mechanism", base + ".toml", "--set", "speed=500 rpm"}),
             Contains(".toml --set 'speed=500 rpm' --set 'mass="));
}

TEST_CASE("fit neither removes nor writes over what it reads", "[program]") {
  const Folder folder;
  const std::string base = testing::source("problems/cams/recorded_torque");
  const std::string machine = written(folder, "program.toml", testing::read(base + ".toml")),
                    mine = testing::read(machine);
  for (int run = 0; run < 2; ++run) {  // the second finds a fit.json of an earlier one
    done({"fit", base + ".csv", "--mechanism", machine, "--out", folder.path()});
    CHECK(read(machine) == mine);
  }
  // What is no earlier run's stays.
  const std::string other = folder / "other";
  fs::create_directory(other);
  written(folder, "other/law.json", "mine");
  done({"fit", base + ".csv", "--mechanism", machine, "--out", other});
  CHECK(read(other + "/law.json") == "mine");
  const std::string cam = testing::source("problems/cams/worn_cam.csv");
  const std::string roller = written(
      folder, "program.toml", "mechanism = 'disc-cam-roller'\n[constants]\nroller_radius='8 mm'\n");
  CHECK_THAT(
      failed({"fit", cam, "--mechanism", roller, "--law", "cycloidal", "--out", folder.path()}, 2),
      Contains("program.toml"));
  CHECK(read(roller).starts_with("mechanism"));
}

TEST_CASE("fit takes repeated angles, in any order and from several sweeps", "[program]") {
  const Folder folder;
  const Law<double> law = find_law("cycloidal").law();
  Random random(8);
  std::vector<std::string> rows;
  for (int sweep = 0; sweep < 3; ++sweep) {
    for (int i = 0; i < 360; i += 2) {  // rest, rise from 60 to 180, rest, return from 240 to 330
      const double s = i < 60    ? 0
                       : i < 180 ? law((i - 60) / 120.0).s
                       : i < 240 ? 1
                       : i < 330 ? 1 - law((i - 240) / 90.0).s
                                 : 0;
      rows.push_back(fmt::format("{}, {:.5f}\n", i, 25 * s + 0.01 * random.normal()));
    }
  }
  std::reverse(rows.begin() + 100, rows.end());
  std::string text = "angle [deg], lift [mm]\n";
  for (const std::string& row : rows) text += row;
  const ParsedJson found =
      json_of({"fit", written(folder, "sweeps.csv", text), "--law", "cycloidal", "--json"});
  CHECK(found["trusted"] == true);
  REQUIRE(found["motions"].size() == 2);
  for (const ParsedJson& motion : found["motions"]) {
    const bool rises = motion["to"].get<double>() > motion["from"].get<double>();
    CHECK(motion["begin"].get<double>() == Approx(rises ? 60 : 240).margin(0.3));
    CHECK(motion["end"].get<double>() == Approx(rises ? 180 : 330).margin(0.3));
  }
}

TEST_CASE("fit does not tell laws apart beyond the digits of the table", "[program][heavy]") {
  const Folder folder;
  std::string text = "angle [deg], lift [mm]\n";
  for (int i = 0; i <= 80; ++i) {  // to a tenth of a millimetre
    const double u = i / 80.0;
    text += fmt::format("{}, {:.1f}\n", 200 + i, 20 * u * u * u * (10 - 15 * u + 6 * u * u));
  }
  const ParsedJson found = json_of({"fit", written(folder, "tenths.csv", text), "--json"});
  // The right law or a word that others do as well; never another law without a word.
  const bool is_right = found["law"] == "poly-3-4-5";
  const std::string reason = found["reason"];
  CHECK((is_right || reason.find("poly-3-4-5") != std::string::npos));
  // The same with the law named: nothing speaks against it.
  const ParsedJson named = json_of({"fit", folder / "tenths.csv", "--law", "poly-3-4-5", "--json"});
  CHECK(named["trusted"] == true);
}

TEST_CASE("fit trusts no law that leaves a curve, however much noise lies over it",
          "[program][long]") {
  const Folder folder;
  Random random(5);
  std::string text = "angle [deg], lift [mm]\n";
  for (int i = 0; i <= 400; ++i) {
    const double u = i / 400.0;
    const double s = u * u * u * (10 - 15 * u + 6 * u * u);
    text += fmt::format("{}, {:.4f}\n", 90 * u, 20 * s + 0.06 * random.normal());
  }
  const std::string data = written(folder, "noisy.csv", text);
  CHECK(json_of({"fit", data, "--law", "cycloidal", "--json"})["trusted"] == false);
  CHECK(json_of({"fit", data, "--law", "poly-3-4-5", "--json"})["trusted"] == true);
  // Velocities give a stroke in the displacement's unit; too few samples, or none of a motion, say
  // so.
  std::string velocity = "angle [deg], velocity [mm/deg]\n", noise = "angle [deg], lift [mm]\n";
  for (int i = 0; i <= 90; ++i) {
    const double u = i / 90.0;
    velocity += fmt::format("{}, {:.6f}\n", i, 20.0 / 90 * 30 * u * u * (1 - u) * (1 - u));
  }
  for (int i = 0; i < 12; ++i) noise += fmt::format("{}, {:.4f}\n", i, random.normal());
  const ParsedJson moved =
      json_of({"fit", written(folder, "velocity.csv", velocity), "--law", "poly-3-4-5", "--json"});
  for (const ParsedJson& p : moved["parameters"]) {
    if (p["name"] == "stroke") CHECK(p["unit"] == "mm");
  }
  CHECK(json_of({"fit", written(folder, "few.csv", "angle,lift\n0,0\n1,1\n2,5\n3,9\n4,10\n"),
                 "--json"})["trusted"] == false);
  CHECK(json_of({"fit", written(folder, "noise.csv", noise), "--json"})["trusted"] == false);
}

TEST_CASE("a million rows are fitted within ten times the memory of their file",
          "[program][heavy]") {
  const Folder folder;
  const std::string path = folder / "big.csv";
  {
    std::ofstream file(path);
    file << "angle [deg], lift [mm]\n";
    Random random(3);
    constexpr int kRows = 1000000;
    for (int i = 0; i < kRows; ++i) {
      const double u = i / (kRows - 1.0);
      const double s = u * u * u * (10 - 15 * u + 6 * u * u);
      file << fmt::format("{:.6f},{:.6f}\n", 90 * u, 20 * s + 0.05 * random.normal());
    }
  }
  const Outcome outcome = run({"fit", path, "--law", "poly-3-4-5", "--json"});
  REQUIRE(outcome.status == 0);
  CHECK(outcome.memory < 10.0 * static_cast<double>(fs::file_size(path)));
  const ParsedJson found = ParsedJson::parse(outcome.out);
  for (const ParsedJson& p : found["parameters"]) {
    if (p["name"] == "stroke") CHECK(p["value"].get<double>() == Approx(20).margin(0.001));
    if (p["name"] == "end") CHECK(p["value"].get<double>() == Approx(90).margin(0.005));
  }
  CHECK(found["trusted"] == true);
}

}  // namespace camlaw::cli::fit_test
