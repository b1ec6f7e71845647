// SPDX-License-Identifier: MIT
// Every output of every command against what the command reads: nothing is lost.
#include "tests/cli/program_runner.h"

namespace camlaw::cli {
namespace {

const std::string kProblem =
    "title = 't'\nmechanism = 'disc-cam-roller'\n"
    "[program]\nsegments = [{name = 'rise', angle = 90, law = 'law.json'},"
    "{name = 'back', law = 'cycloidal'}]\n"
    "[variables.base_radius]\nlower = '20 mm'\nupper = '60 mm'\n";
const std::string kOne = "[objective]\nminimize = 'base_radius'\n";
const std::string kTwo =
    "[[objectives]]\nminimize = 'base_radius'\n"
    "[[objectives]]\nminimize = 'peak_pressure_angle'\n";

/// A folder with one file of each kind that commands read.
void fill(const Folder& folder) {
  std::ofstream(folder / "one.toml") << kProblem << kOne;
  std::ofstream(folder / "two.toml") << kProblem << kTwo;
  done({"synthesize", CAMLAW_SOURCE_DIR "/problems/free_law/least_mean_square_jerk.toml", "--out",
        folder / "made"});
  fs::rename(folder / "made/law.json", folder / "law.json");
  done({"optimize", folder / "one.toml", "--out", folder / "made"});
  fs::rename(folder / "made/result.json", folder / "result.json");
  done({"pareto", folder / "two.toml", "--points", "4", "--db", folder / "s.db"});
  fs::remove_all(folder / "made");
}

std::map<std::string, std::string> bytes_of(const Folder& folder) {
  std::map<std::string, std::string> all;
  for (const std::string& name : folder.content()) all[name] = read(folder / name);
  return all;
}

/// A command, what of it is read, and the options that name an output.
struct Row {
  Words words;
  Words reads;
  Words options;
};

const std::vector<Row> kRows = {
    {{"evaluate", "one.toml"}, {"one.toml", "law.json"}, {"--curves", "--svg", "--profile"}},
    {{"evaluate", "result.json"}, {"result.json"}, {"--curves", "--svg", "--profile"}},
    {{"law", "law.json"}, {"law.json"}, {"--csv", "--svg"}},
    {{"front", "s.db", "--knee"}, {"s.db", "two.toml", "law.json"}, {"--csv", "--svg", "--result"}},
    {{"export", "one.toml", "--format", "csv"}, {"one.toml", "law.json"}, {"--out"}},
    {{"export", "result.json", "--format", "csv"}, {"result.json"}, {"--out"}},
};

}  // namespace

TEST_CASE("no output takes the place of an input, by whatever name or link", "[program]") {
  const Folder folder;
  fill(folder);
  const auto before = bytes_of(folder);
  REQUIRE(before.size() == 5);
  for (const Row& row : kRows) {
    for (const std::string& input : row.reads) {
      for (const std::string& option : row.options) {
        for (const char* how : {"same", "dotted", "symbolic", "hard"}) {
          std::string output = folder / input;
          if (how == std::string("dotted"))
            output =
                folder.path() + "/../" + fs::path(folder.path()).filename().string() + "/" + input;
          const std::string link = folder / "link";
          if (how == std::string("symbolic")) fs::create_symlink(input, link), output = link;
          if (how == std::string("hard")) fs::create_hard_link(folder / input, link), output = link;
          Words words = row.words;
          words[1] = folder / words[1];
          words.insert(words.end(), {option, output});
          INFO(row.words[0] << " " << row.words[1] << " " << option << " " << input << ", " << how);
          const Outcome outcome = run(words);
          CHECK(outcome.status == 2);
          CHECK_THAT(outcome.err, Contains("is an input of this run"));
          fs::remove(link);
          CHECK(bytes_of(folder) == before);
        }
      }
    }
  }
}

TEST_CASE("a folder of results takes no input's place and removes no file of another",
          "[program]") {
  const Folder folder;
  fill(folder);
  for (const auto& [command, problem, names] :
       std::vector<std::tuple<std::string, std::string, Words>>{
           {"optimize", "one.toml", {"result.json", "law.csv", "law.svg", "cycle.svg"}},
           {"pareto", "two.toml", {"front.json", "front.csv", "front.svg"}}}) {
    for (const std::string& name : names) {
      const std::string out = folder / "out";
      fs::create_directory(out);
      fs::create_hard_link(folder / problem, out + "/" + name);
      INFO(command << " " << name);
      CHECK_THAT(failed({command, folder / problem, "--out", out}, 2),
                 Contains("is an input of this run"));
      CHECK(read(out + "/" + name) == read(folder / problem));
      CHECK(fs::exists(folder / problem));
      fs::remove_all(out);
    }
  }
  // What no run has made stays, though a run makes files of that name: the answer has no curves.
  const std::string out = folder / "out";
  fs::create_directory(out);
  std::ofstream(out + "/law.svg") << "mine";
  const Outcome outcome =
      run({"optimize", CAMLAW_SOURCE_DIR "/problems/springs/fewest_discs.toml", "--out", out});
  INFO(outcome.out << outcome.err);
  CHECK(outcome.status == 0);
  CHECK(read(out + "/law.svg") == "mine");
}

}  // namespace camlaw::cli
