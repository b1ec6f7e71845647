// SPDX-License-Identifier: MIT
// What the problem inside a result was read from, against the outputs that are made of the result.
#include "kinematics/laws/catalogue.h"
#include "problems/law_files/law_file.h"
#include "tests/cli/shell.h"

namespace camlaw::cli::result_inputs_test {
namespace {

const std::string kTable = [] {
  std::string rows = "angle [deg], lift [mm]\n";
  for (int degree = 0; degree < 360; degree += 5) {
    const double way = degree < 180 ? degree / 180.0 : 2 - degree / 180.0;
    const double lift = 20 * way * way * way * (10 - 15 * way + 6 * way * way);
    rows += std::to_string(degree) + ", " + std::to_string(lift) + "\n";
  }
  return rows;
}();

const std::string kProblem =
    "mechanism = 'disc-cam-roller'\n[constants]\nspeed = '200 rpm'\n"
    "[program]\ntable = 'lift.csv'\n"
    "[parts.roller]\ncatalogue = 'rollers.csv'\n"
    "[variables.base_radius]\nlower = '20 mm'\nupper = '80 mm'\n"
    "[objective]\nminimize = 'base_radius'\n"
    "[[constraints]]\nresponse = 'pressure_angle'\nlower = '-25 deg'\nupper = '25 deg'\n";

const std::string kLawProblem =
    "mechanism = 'disc-cam-roller'\n"
    "[program]\nsegments = [{name = 'rise', angle = 120, law = 'mine.json'},"
    "{name = 'back', law = 'cycloidal'}]\n"
    "[variables.base_radius]\nlower = '20 mm'\nupper = '80 mm'\n"
    "[objective]\nminimize = 'base_radius'\n"
    "[[constraints]]\nresponse = 'pressure_angle'\nlower = '-30 deg'\nupper = '30 deg'\n";

/// A folder with two problems, what they read, and a result of each.
void fill(const Folder& folder) {
  testing::write(folder / "lift.csv", kTable);
  testing::write(folder / "rollers.csv", "name, roller_radius [mm]\nr8, 8\nr10, 10\n");
  testing::write(folder / "tab.toml", kProblem);
  testing::write(folder / "laws.toml", kLawProblem);
  testing::write(folder / "mine.json",
                 problems::law_text(find_law("modified-sine crossover=0.4").law(), "mine"));
  done({"optimize", folder / "tab.toml", "--out", folder / "t"});
  done({"optimize", folder / "laws.toml", "--out", folder / "l"});
}

/// Every way in which a command writes a file that is named, of a result.
std::vector<Words> writers(const std::string& result) {
  return {{"evaluate", result, "--curves"},
          {"evaluate", result, "--svg"},
          {"evaluate", result, "--profile"},
          {"export", result, "--format", "table", "--out"},
          {"export", result, "--format", "dxf", "--out"}};
}

/// That none of them replaces a file.
void check_kept(const std::string& result, const std::string& file) {
  const std::string before = read(file);
  for (Words words : writers(result)) {
    words.push_back(file);
    INFO(words[0] << " " << words[words.size() - 2] << " " << file);
    const Outcome outcome = run(words);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.err, Contains("is an input of this run"));
    CHECK(read(file) == before);
  }
}

}  // namespace

TEST_CASE("no output of a result replaces what its problem was read from", "[program]") {
  const Folder folder;
  fill(folder);
  const std::string table = folder / "t/result.json", law = folder / "l/result.json";
  check_kept(table, folder / "lift.csv");
  check_kept(table, folder / "rollers.csv");
  check_kept(law, folder / "mine.json");
  // What was changed since is known by its place.
  testing::write(folder / "lift.csv", kTable + "# mine\n");
  check_kept(table, folder / "lift.csv");
  // Other files are written.
  done({"evaluate", table, "--curves", folder / "t/lift.csv"});
  done({"evaluate", table, "--curves", folder / "t/lift.csv"});
}

TEST_CASE("what a result's problem was read from is known where it was moved to", "[program]") {
  const Folder folder;
  fill(folder);
  const Folder other;
  fs::copy(folder.path(), other / "moved", fs::copy_options::recursive);
  fs::remove_all(folder / "t");
  testing::write(other / "moved/lift.csv", kTable + "# mine\n");  // beside the problem
  check_kept(other / "moved/t/result.json", other / "moved/lift.csv");
  fs::rename(other / "moved/rollers.csv", other / "alone.csv");  // by what it holds
  check_kept(other / "moved/t/result.json", other / "alone.csv");
  fs::rename(other / "moved/mine.json", other / "alone.json");
  check_kept(other / "moved/l/result.json", other / "alone.json");
}

TEST_CASE("a search that begins at a result replaces none of its inputs", "[program]") {
  const Folder folder;
  fill(folder);
  fs::create_directory(folder / "out");
  fs::create_hard_link(folder / "lift.csv", folder / "out/law.csv");
  std::string other = kLawProblem;
  other.replace(other.find("mine.json"), 9, "cycloidal");
  testing::write(folder / "plain.toml", other);
  CHECK_THAT(failed({"optimize", folder / "plain.toml", "--start", folder / "t/result.json",
                     "--out", folder / "out"},
                    2),
             Contains("is an input of this run"));
  CHECK(read(folder / "lift.csv") == kTable);
}

TEST_CASE("a search replaces its own earlier result and no other's", "[program]") {
  const Folder folder;
  fill(folder);
  const std::string result = folder / "l/result.json";
  const std::string before = read(result);
  const Words other{"optimize", folder / "tab.toml", "--out", folder / "l"};
  CHECK_THAT(failed(other, 2), Contains("l/result.json' is the result of another problem, ") &&
                                   Contains("laws.toml"));
  CHECK(read(result) == before);
  // The same problem, changed or set otherwise, writes where it wrote.
  done({"optimize", folder / "laws.toml", "--set", "stroke=22 mm", "--out", folder / "l"});
  testing::write(folder / "laws.toml", "title = 'changed'\n" + kLawProblem);
  done({"optimize", folder / "laws.toml", "--out", folder / "l"});
  CHECK(json_of({"evaluate", result, "--json"})["title"] == "changed");
  // So it does from where it was moved to, with what it had written.
  fs::create_directory(folder / "new");
  fs::rename(folder / "laws.toml", folder / "new/laws.toml");
  fs::copy(folder / "mine.json", folder / "new/mine.json");
  done({"optimize", folder / "new/laws.toml", "--out", folder / "l"});
  // A file that no search wrote stays.
  testing::write(result, "{\"mine\": 1}");
  CHECK_THAT(failed({"optimize", folder / "new/laws.toml", "--out", folder / "l"}, 2),
             Contains("is not a camlaw result, and it would be replaced"));
  CHECK(read(result) == "{\"mine\": 1}");
}

TEST_CASE("synthesize replaces no law of another origin", "[program]") {
  const Folder folder;
  testing::write(folder / "f.toml",
                 "mechanism = 'law'\n[law]\nname = 'free'\n[free]\ndegree = 5\nknots = 12\n"
                 "[objective]\nminimize = 'mean_square_jerk'\n");
  fs::create_directory(folder / "out");
  const std::string law = problems::law_text(find_law("modified-sine crossover=0.4").law(), "mine");
  testing::write(folder / "out/law.json", law);
  const Words words{"synthesize", folder / "f.toml", "--out", folder / "out"};
  CHECK_THAT(failed(words, 2), Contains("is not a law found for this problem"));
  CHECK(read(folder / "out/law.json") == law);
  fs::remove(folder / "out/law.json");
  done(words);
  done(words);
}

}  // namespace camlaw::cli::result_inputs_test
