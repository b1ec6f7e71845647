// SPDX-License-Identifier: MIT
// Every output of every command against what the command reads: nothing is lost. Which outputs
// there are the program's own help tells, so that none is forgotten.
#include <algorithm>
#include <cstdlib>

#include "cli/commands.h"
#include "tests/cli/command_help.h"
#include "tests/cli/shell.h"
#include "tests/paths.h"

namespace camlaw::cli::inputs_test {
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
const std::string kSpring =
    "title = 't'\nmechanism = 'disc-cam-roller'\n"
    "[program]\nsegments = [{name = 'rise', angle = 90, law = 'law.json'},"
    "{name = 'back', law = 'cycloidal'}]\n"
    "[variables.mass]\nlower = '0.1 kg'\nupper = '9 kg'\n";

/// A folder with one file of each kind that commands read.
void fill(const Folder& folder) {
  const std::string problems = testing::source("problems/");
  testing::write(folder / "one.toml", kProblem + kOne);
  testing::write(folder / "two.toml", kProblem + kTwo);
  testing::write(folder / "spring.toml", kSpring);
  fs::copy_file(problems + "free_law/least_mean_square_jerk.toml", folder / "free.toml");
  // A cam with fewer rows is fitted sooner.
  std::ofstream cam(folder / "cam.csv");
  const auto rows = lines_after(read(problems + "cams/worn_cam.csv"), "");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i % 4 == 0 || rows[i].find_first_of("#[") != std::string::npos) cam << rows[i] << "\n";
  }
  cam.close();
  fs::copy_file(testing::source("tests/fuzz/corpus/samples/motion.csv"), folder / "motion.csv");
  done({"synthesize", folder / "free.toml", "--out", folder / "made"});
  fs::rename(folder / "made/law.json", folder / "law.json");
  fs::remove_all(folder / "made");
  done({"optimize", folder / "one.toml", "--out", folder / "made"});
  fs::rename(folder / "made/result.json", folder / "result.json");
  done({"pareto", folder / "two.toml", "--points", "4", "--db", folder / "s.db"});
  done({"evaluate", folder / "spring.toml", "--set", "mass=2 kg", "--curves", folder / "all.csv"});
  // Of all curves the torque alone, as one records it.
  std::ofstream torque(folder / "torque.csv");
  const CsvRows all = csv_of(read(folder / "all.csv"));
  const auto at =
      std::find_if(all[0].begin(), all[0].end(),
                   [](const std::string& name) { return name.starts_with("drive_torque"); }) -
      all[0].begin();
  torque << "angle [deg],drive_torque [N m]\n";
  for (std::size_t i = 1; i < all.size(); i += 4) torque << all[i][0] << "," << all[i][at] << "\n";
  fs::remove_all(folder / "made");
  fs::remove(folder / "all.csv");
}

std::map<std::string, std::string> bytes_of(const Folder& folder) {
  std::map<std::string, std::string> all;
  for (const std::string& name : folder.content()) {
    if (fs::is_regular_file(folder / name)) all[name] = read(folder / name);
  }
  return all;
}

/// A command and what it reads.
struct Run {
  Words words;
  Words reads;
};

/// At least one for each command that has outputs; no inputs: it reads none.
const std::vector<Run> kRuns = {
    {{"evaluate", "one.toml"}, {"one.toml", "law.json"}},
    {{"evaluate", "result.json"}, {"result.json", "one.toml", "law.json"}},
    {{"law", "law.json"}, {"law.json"}},
    {{"front", "s.db", "--knee"}, {"s.db", "two.toml", "law.json"}},
    {{"export", "one.toml", "--format", "csv"}, {"one.toml", "law.json"}},
    {{"export", "result.json", "--format", "csv"}, {"result.json", "one.toml", "law.json"}},
    {{"report", "one.toml"}, {"one.toml", "law.json"}},
    {{"report", "result.json"}, {"result.json", "one.toml", "law.json"}},
    {{"report", "s.db"}, {"s.db", "two.toml", "law.json"}},
    {{"optimize", "one.toml"}, {"one.toml", "law.json"}},
    {{"synthesize", "free.toml"}, {"free.toml"}},
    {{"pareto", "two.toml", "--points", "4"}, {"two.toml", "law.json"}},
    {{"pareto", "two.toml", "--points", "4", "--db", "s.db", "--resume"},
     {"two.toml", "law.json", "s.db"}},
    {{"sweep", "one.toml", "--evaluate", "--set", "base_radius=30,40 mm"},
     {"one.toml", "law.json"}},
    {{"tolerance", "one.toml", "--tolerance", "base_radius=0.1 mm", "--samples", "64"},
     {"one.toml", "law.json"}},
    {{"fit", "motion.csv", "--law", "law.json"}, {"motion.csv", "law.json"}},
    {{"fit", "torque.csv", "--mechanism", "spring.toml", "--response", "drive_torque"},
     {"torque.csv", "spring.toml", "law.json"}},
    {{"fit", "cam.csv", "--mechanism", "one.toml", "--law", "cycloidal"},
     {"cam.csv", "one.toml", "law.json"}},
    {{"new", "geneva"}, {}},
    {{"examples", "roller_least_base"}, {}},
    {{"study"}, {}},
    {{"reproduce"}, {}},
};

/// Runs the program in a folder; its output is kept elsewhere.
Outcome run_in(const Folder& folder, const Words& words) {
  const Folder elsewhere;
  std::string line = "cd '" + folder.path() + "'; camlaw";
  for (const std::string& word : words) line += " '" + word + "'";
  return shell(elsewhere, line);
}

Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Runs a command that must leave all that is there as it is, and says that it does.
void check_refused(const Folder& folder, const Words& words, const std::string& says) {
  const auto before = bytes_of(folder);
  std::string line;
  for (const std::string& word : words) line += " " + word;
  INFO("camlaw" << line);
  const Outcome outcome = run_in(folder, words);
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Contains(says));
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  CHECK(bytes_of(folder) == before);
}

/// An option that names a file, against an input by each of its names.
void check_file_option(const Folder& folder, const Run& run, const std::string& option) {
  const std::string ending = run.words[0] == "report" ? ".html" : ".out";
  // A new study takes the place of no file whatever.
  const std::string says = option == "--db" ? "exists already" : "needs another name";
  for (const std::string& input : run.reads) {
    // Of a page's name the ending may be what is refused first.
    const std::string by_name = run.words[0] == "report" ? "" : says;
    for (const std::string& name : {input, "./" + input, folder / input}) {
      check_refused(folder, with(run.words, {option, name}), by_name);
    }
    const std::string link = folder / ("link" + ending);
    fs::create_symlink(input, link);
    check_refused(folder, with(run.words, {option, "link" + ending}), says);
    fs::remove(link);
    fs::create_hard_link(folder / input, link);
    check_refused(folder, with(run.words, {option, link}), says);
    fs::remove(link);
  }
}

/// What a run writes into a folder.
std::set<std::string> written(const Folder& folder, const Run& run, const std::string& option) {
  const Outcome outcome = run_in(folder, with(run.words, {option, "first"}));
  INFO(run.words[0] << ": " << outcome.err);
  REQUIRE(outcome.status == 0);
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder / "first")) {
    names.insert(entry.path().filename().string());
  }
  fs::remove_all(folder / "first");
  return names;
}

/// An option that names a folder, where an input stands by the name of each file written there.
void check_folder_option(const Folder& folder, const Run& run, const std::string& option) {
  const auto names = written(folder, run, option);
  REQUIRE_FALSE(names.empty());
  for (const std::string& input : run.reads) {
    for (const std::string& name : names) {
      const std::string says = name == "study.db" ? "exists already" : "needs another name";
      const std::string out = folder / "out";
      fs::create_directory(out);
      fs::create_symlink("../" + input, out + "/" + name);
      check_refused(folder, with(run.words, {option, "out"}), says);
      fs::remove(out + "/" + name);
      fs::create_hard_link(folder / input, out + "/" + name);
      check_refused(folder, with(run.words, {option, out}), says);
      fs::remove_all(out);
    }
  }
}

}  // namespace

TEST_CASE("no output takes the place of an input, by whatever name or link", "[program][heavy]") {
  const Folder folder;
  fill(folder);
  for (const std::string& command : commands()) {
    const auto outputs = outputs_of(command);
    INFO(command);
    const bool is_known = std::any_of(kRuns.begin(), kRuns.end(),
                                      [&](const Run& run) { return run.words[0] == command; });
    CHECK(is_known == !outputs.empty());
    for (const Run& run : kRuns) {
      if (run.words[0] != command || run.reads.empty()) continue;
      for (const auto& [option, takes] : outputs) {
        if (std::find(run.words.begin(), run.words.end(), option) != run.words.end()) continue;
        takes == "FILE" ? check_file_option(folder, run, option)
                        : check_folder_option(folder, run, option);
      }
    }
  }
}

TEST_CASE("every option but a switch says what it takes", "[program]") {
  for (const Command& command : camlaw_program().commands) {
    for (const Option& option : command.options) {
      INFO(command.name << " " << option.names << " " << option.takes);
      CHECK(option.is_switch() == option.takes.empty());
      CHECK_FALSE(option.help.empty());
    }
  }
}

TEST_CASE("laws of one's own folder are inputs where they are read by name", "[program]") {
  const Folder folder;
  fill(folder);
  fs::create_directory(folder / "laws");
  fs::copy_file(folder / "law.json", folder / "laws/mine.json");
  fs::copy_file(folder / "law.json", folder / "laws/law.json");
  setenv("CAMLAW_LAWS", (folder / "laws").c_str(), 1);
  const std::string says = "needs another name";
  check_refused(folder, {"law", "mine", "--csv", "laws/mine.json"}, says);
  std::string problem = kProblem + kOne;
  problem.replace(problem.find("law.json"), 8, "mine");
  testing::write(folder / "own.toml", problem);
  check_refused(folder, {"evaluate", "own.toml", "--curves", "laws/mine.json"}, says);
  check_refused(folder, {"fit", "motion.csv", "--law", "law", "--out", "laws"}, says);
  check_refused(folder, {"fit", "motion.csv", "--out", "laws"}, says);  // tries them all
  unsetenv("CAMLAW_LAWS");
}

TEST_CASE("a folder of results loses no file of another", "[program]") {
  // What no run has made stays, though a run makes files of that name: the answer has no curves.
  const Folder folder;
  const std::string out = folder / "out";
  fs::create_directory(out);
  testing::write(out + "/law.svg", "mine");
  const Outcome outcome =
      run({"optimize", testing::source("problems/springs/fewest_discs.toml"), "--out", out});
  INFO(outcome.out << outcome.err);
  CHECK(outcome.status == 0);
  CHECK(read(out + "/law.svg") == "mine");
}

TEST_CASE("a file that may not grow is named, and nothing of it stays", "[program]") {
  const Folder folder;
  const Outcome outcome = shell(folder, "ulimit -f 1; camlaw law cycloidal --csv law.csv");
  CHECK(outcome.status == 1);
  CHECK_THAT(outcome.err, Contains("cannot write 'law.csv': File too large"));
  CHECK(folder.content() == std::set<std::string>{"line.sh", "out.txt", "err.txt"});
}

}  // namespace camlaw::cli::inputs_test
