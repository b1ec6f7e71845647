// SPDX-License-Identifier: MIT
// pareto and front, as a user runs them.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <functional>
#include <numbers>
#include <thread>

#include "problems/results/recorded_design.h"
#include "tests/cli/program_runner.h"
#include "tests/optim/pareto/evenness.h"
#include "tests/paths.h"

namespace camlaw::cli::pareto_test {
namespace {

std::string shipped(const std::string& name) {
  return testing::source("problems/spine_cutter/") + name;
}

std::string written(const Folder& folder, const std::string& name, const std::string& text) {
  const std::string path = folder / name;
  std::ofstream(path) << text;
  return path;
}

/// The shipped problem with other text at some place.
std::string changed(const std::string& from, const std::string& to) {
  std::string text = read(shipped("front.toml"));
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("not there: " + from);
  return text.replace(at, from.size(), to);
}

/// Radius against force among two laws and two sizes.
std::string with_choices() {
  return changed("name = \"polynomial-5\"", "name = [\"polynomial-5\", \"modified-sine\"]") +
         "\n[variables.blades]\nvalues = [17, 21]\n";
}

Words pareto(const std::string& file, Words more = {}) {
  Words words{"pareto", file};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// A command of the shell, with the program as $0.
Outcome shell(const std::string& script, const Folder& folder) {
  const std::string out = folder / "shell.out", err = folder / "shell.err";
  const std::string command = "( " + script + " ) > '" + out + "' 2> '" + err + "'";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(out), read(err)};
}

const std::string kProgram = "'" + testing::program() + "'";

/// The program in a process group of its own, which gets a signal so many ms after it has begun its
/// study: it and all its workers at once, as a terminal or a service manager sends it.
Outcome of_group(Words words, const std::string& study, int ms, int signal) {
  const Folder folder;
  const std::string out = folder / "out", err = folder / "err";
  words.insert(words.begin(), testing::program());
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    setpgid(0, 0);
    dup2(open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
    dup2(open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  if (child < 0) throw std::runtime_error("no process");
  setpgid(child, child);
  if (has_made(child, study)) std::this_thread::sleep_for(std::chrono::milliseconds(ms));
  kill(-child, signal);
  int status = 0;
  waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(out), read(err)};
}

std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

TEST_CASE("pareto gives the front with every key", "[program]") {
  const ParsedJson result = json_of(pareto(shipped("front.toml"), {"--points", "12", "--json"}));
  for (const char* key : {"title",
                          "objectives",
                          "points",
                          "ideal",
                          "nadir",
                          "reference",
                          "hypervolume",
                          "hypervolume_at_most",
                          "limit_hypervolume",
                          "knee",
                          "complete",
                          "searches",
                          "evaluations",
                          "combinations",
                          "empty_combinations",
                          "failures",
                          "seed",
                          "finished",
                          "largest_gap",
                          "ideal_certified"}) {
    INFO(key);
    CHECK(result.contains(key));
  }
  REQUIRE(result["points"].size() >= 12);
  double last = 0;
  for (const ParsedJson& point : result["points"]) {
    for (const char* key : {"objectives", "variables", "law", "verdict", "reason", "global",
                            "slopes", "limits", "lambda", "solver"}) {
      INFO(key);
      CHECK(point.contains(key));
    }
    const double radius = point["objectives"]["minimum_cam_radius"],
                 alpha = point["variables"]["alpha"];
    CHECK(radius > last);
    last = radius;
    CHECK((alpha >= -10 && alpha <= 10));
    CHECK_THAT(point["law"].get<std::string>(), Contains("polynomial-5 alpha="));
    CHECK(point["verdict"] == "certified optimum");
    REQUIRE(point["slopes"].size() == 1);
    CHECK(point["slopes"][0]["of"] == "peak_inertia_force");
    CHECK(point["slopes"][0]["per"] == "minimum_cam_radius");
    const ParsedJson& slope =
        point["slopes"][0]["value"];  // none where the front goes on to one side
    const bool is_end = slope.is_null();
    CHECK((is_end || slope.get<double>() <= 0));
  }
  CHECK(result["complete"] == true);
  CHECK(result["failures"].empty());
  CHECK(result["combinations"] == 1);
  CHECK(result["hypervolume"] < result["hypervolume_at_most"]);
  CHECK(result["hypervolume_at_most"] < result["limit_hypervolume"]);
  CHECK(result["ideal"][0] == result["points"].front()["objectives"]["minimum_cam_radius"]);
  CHECK(result["nadir"][0] == result["points"].back()["objectives"]["minimum_cam_radius"]);
  const ParsedJson& knee = result["knee"];
  CHECK(knee["point"] < result["points"].size());
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(knee["factor_low"][i] <= 1);
    CHECK(knee["factor_high"][i] >= 1);
  }
  CHECK(knee["next"].size() == 2);
}

TEST_CASE("pareto tells people of the front", "[program]") {
  const std::string text = done(pareto(shipped("front.toml"), {"--points", "8"}));
  CHECK_THAT(text, Contains("Spine cutter: cam radius against inertia force") &&
                       Contains("minimum_cam_radius, mm") && Contains("slope") &&
                       Contains("certified optimum, global") && Contains("hypervolume") &&
                       Contains("no law exceeds") && Contains("knee: point") &&
                       Contains("points certified") && !Contains("nan"));
  CHECK(text.find("study") == std::string::npos);
}

TEST_CASE("the number of workers does not show", "[program][heavy]") {
  const Folder folder;
  const std::string torque = "\n[[objectives]]\nminimize = \"peak_drive_torque\"\n";
  for (const std::string& file :
       {shipped("front.toml"), written(folder, "choices.toml", with_choices()),
        written(folder, "three.toml", read(shipped("front.toml")) + torque),
        written(folder, "three_choices.toml", with_choices() + torque)}) {
    const std::string one = done(pareto(file, {"--points", "9", "--json", "--workers", "1"}));
    for (const char* workers : {"2", "5"}) {
      CHECK(done(pareto(file, {"--points", "9", "--json", "--workers", workers})) == one);
    }
  }
}

TEST_CASE("a study that was recorded is looked at again", "[program]") {
  const Folder folder;
  const std::string file = written(folder, "choices.toml", with_choices());
  const std::string db = folder / "s.db";
  const std::string json = done(pareto(file, {"--points", "9", "--json", "--db", db}));
  CHECK(done({"front", db, "--json"}) == json);
  CHECK(folder.content() == std::set<std::string>{"choices.toml", "s.db"});
  // Done already: resumed, it is the same.
  CHECK(done(pareto(file, {"--points", "9", "--json", "--db", db, "--resume"})) == json);
  CHECK_THAT(done({"front", db}), Contains("knee: point") && Contains("4 combinations"));
  const std::string again = failed(pareto(file, {"--db", db}), 2);
  CHECK_THAT(again, Contains(db) && Contains("exists already") && Contains("resume"));
}

TEST_CASE("a study goes on with more points, and the record knows", "[program]") {
  const Folder folder;
  const std::string db = folder / "s.db", file = shipped("front.toml");
  done(pareto(file, {"--points", "5", "--db", db}));
  const std::string more = done(pareto(file, {"--points", "11", "--json", "--db", db, "--resume"}));
  CHECK(ParsedJson::parse(more)["points"].size() >= 11);
  CHECK(done({"front", db, "--json"}) == more);
}

TEST_CASE("a study that goes on keeps its points and method unless told otherwise", "[program]") {
  const Folder folder;
  const std::string db = folder / "s.db", file = shipped("front.toml");
  const std::string first =
      done(pareto(file, {"--points", "5", "--method", "sweep", "--db", db, "--json"}));
  CHECK(done(pareto(file, {"--db", db, "--resume", "--json"})) == first);
  CHECK(done({"front", db, "--json"}) == first);
}

TEST_CASE("a study knows the law files of its problem", "[program]") {
  const Folder folder;
  done({"synthesize", testing::source("problems/free_law/quiet_rise.toml"), "--out",
        folder / "laws"});
  const std::string law = folder / "laws/law.json";
  const std::string file = written(folder, "mine.toml",
                                   "mechanism = 'law'\n[law]\nname = ['laws/law.json', "
                                   "'polynomial-5']\n[variables.alpha]\nlower = -10\nupper = "
                                   "10\nstart = -3\n[[objectives]]\nminimize = 'B'\n"
                                   "[[objectives]]\nminimize = 'C'\n");
  const std::string db = folder / "s.db";
  const Words words = pareto(file, {"--points", "5", "--db", db, "--json"});
  const std::string expected = done(words);
  CHECK(done({"front", db, "--json"}) == expected);
  // From anywhere: the study knows where the file was.
  CHECK(shell("cd / && " + kProgram + " front '" + db + "' --json", folder).out == expected);
  // Another law by the same name is noticed by a study that goes on.
  const std::string text = read(law);
  done({"synthesize", testing::source("problems/free_law/least_acceleration.toml"), "--out",
        folder / "others"});
  std::filesystem::copy_file(folder / "others/law.json", law,
                             std::filesystem::copy_options::overwrite_existing);
  REQUIRE(read(law) != text);
  CHECK(done({"front", db, "--json"}) == expected);  // it carries its own
  CHECK_THAT(failed(pareto(file, {"--db", db, "--resume"}), 2),
             Contains("cannot be resumed") && Contains("laws/law.json") && Contains("restore it"));
}

TEST_CASE("a study that is killed at any moment goes on to the same front", "[program]") {
  const Folder folder;
  const std::string file = written(folder, "choices.toml", with_choices());
  const Words how{"--points", "24", "--json", "--workers", "2"};
  const std::string expected = done(pareto(file, how));
  int interrupted = 0;
  for (const int ms : {2, 12, 30, 60, 100}) {
    INFO("after " << ms << " ms");
    const std::string db = folder / ("s" + std::to_string(ms) + ".db");
    Words words = pareto(file, how);
    words.insert(words.end(), {"--db", db});
    const Running running(words);
    std::this_thread::sleep_for(std::chrono::milliseconds(ms));
    kill(running.id(), SIGKILL);
    interrupted += running.wait().status != 0;
    if (fs::exists(db)) words.push_back("--resume");
    CHECK(done(words) == expected);
    CHECK(done({"front", db, "--json"}) == expected);
  }
  CHECK(interrupted > 1);
  for (const std::string& name : folder.content()) {
    INFO(name);
    // What a program was about to begin when it was killed is left, apart from all studies.
    CHECK((name.ends_with(".db") || name.ends_with(".toml") || name.starts_with(".camlaw-")));
  }
}

TEST_CASE("what a killed program has left beside a study is removed by the next one",
          "[program][study]") {
  const Folder folder;
  const std::string file = written(folder, "choices.toml", with_choices());
  const auto begun = [&](const std::string& name) {
    fs::create_directory(folder / name);
    std::ofstream(folder / (name + "/study.db")) << "begun";
  };
  const auto left = [&](const std::string& name) {
    begun(name);
    const auto before = fs::file_time_type::clock::now() - std::chrono::minutes(2);
    fs::last_write_time(folder / (name + "/study.db"), before);
    fs::last_write_time(folder / name, before);
  };
  left(".camlaw-aB3xY9"), left(".camlaw-held00"), left(".camlaw-notes"), left("camlaw-aB3xY9");
  begun(".camlaw-fresh0");  // of an earlier version, which holds no lock, perhaps
  left(".camlaw-backup");   // somebody's own
  written(folder, ".camlaw-backup/notes.txt", "mine");
  fs::last_write_time(folder / ".camlaw-backup",
                      fs::file_time_type::clock::now() - std::chrono::minutes(2));
  // One that a living process holds is that process's.
  const int held = open((folder / ".camlaw-held00").c_str(), O_RDONLY | O_DIRECTORY);
  REQUIRE(held >= 0);
  REQUIRE(flock(held, LOCK_EX) == 0);
  Words words = pareto(file, {"--points", "3", "--json"});
  words.insert(words.end(), {"--db", folder / "s.db"});
  done(words);
  CHECK(!fs::exists(folder / ".camlaw-aB3xY9"));
  CHECK(fs::exists(folder / ".camlaw-held00/study.db"));
  CHECK(fs::exists(folder / ".camlaw-notes/study.db"));
  CHECK(fs::exists(folder / ".camlaw-fresh0/study.db"));
  CHECK(fs::exists(folder / ".camlaw-backup/study.db"));
  CHECK(fs::exists(folder / "camlaw-aB3xY9/study.db"));
  close(held);
  words.push_back("--resume");
  done(words);
  CHECK(!fs::exists(folder / ".camlaw-held00"));
}

TEST_CASE("a study that is asked to end stops with what it has", "[program]") {
  const Folder folder;
  const std::string file = written(folder, "choices.toml", with_choices());
  const Words how{"--points", "40", "--json", "--workers", "2"};
  const std::string expected = done(pareto(file, how));
  for (const int signal : {SIGINT, SIGTERM}) {
    // Sooner each time, until it comes during the study: how fast a machine is does not matter.
    bool stopped = false;
    for (int attempt = 0; !stopped && attempt < 20; ++attempt) {
      const int ms = 64 >> attempt;
      INFO("signal " << signal << " after " << ms << " ms");
      const std::string db =
          folder / ("s" + std::to_string(signal) + "_" + std::to_string(attempt) + ".db");
      Words words = pareto(file, how);
      words.insert(words.end(), {"--db", db});
      const Outcome outcome = of_group(words, db, ms, signal);
      CHECK((outcome.status == 4 || outcome.status == 0));
      if (outcome.status != 4) continue;  // it had finished
      const ParsedJson part = ParsedJson::parse(outcome.out);
      CHECK(part["complete"] == false);
      CHECK(part["failures"].empty());
      stopped = true;
      words.push_back("--resume");
      CHECK(done(words) == expected);
    }
    CHECK(stopped);
  }
}

TEST_CASE("a full disk ends a study with one line, and later it goes on", "[program]") {
  const Folder folder;
  const std::string file = written(folder, "choices.toml", with_choices());
  const std::string expected = done(pareto(file, {"--points", "40", "--json"}));
  int begun = 0;
  for (const int blocks : {1, 100, 140}) {  // of 512 or 1024 bytes
    INFO(blocks << " blocks");
    const std::string db = folder / ("s" + std::to_string(blocks) + ".db");
    const Outcome outcome =
        shell("ulimit -f " + std::to_string(blocks) + "; trap '' XFSZ; exec " + kProgram +
                  " pareto '" + file + "' --points 40 --db '" + db + "'",
              folder);
    INFO(outcome.err);
    CHECK(outcome.status == 1);
    CHECK(lines(outcome.err) == 1);
    CHECK_THAT(outcome.err, Contains(db) && Contains("cannot be written"));
    Words again = pareto(file, {"--points", "40", "--json", "--db", db});
    if (fs::exists(db)) again.push_back("--resume");
    begun += fs::exists(db);
    CHECK(done(again) == expected);
  }
  CHECK(begun > 0);
}

TEST_CASE("where a study cannot be written it does not begin", "[program]") {
  const Folder folder;
  const std::string plain = written(folder, "plain", "mine");
  for (const std::string& db :
       {plain + "/s.db", std::string("/proc/s.db"), std::string("/dev/null/s.db")}) {
    CHECK_THAT(failed(pareto(shipped("front.toml"), {"--db", db}), 1), Contains(db));
  }
  CHECK_THAT(failed(pareto(shipped("front.toml"), {"--out", plain}), 2),
             Contains("--out needs a folder"));
  CHECK_THAT(failed(pareto(shipped("front.toml"), {"--db", plain}), 2), Contains("exists already"));
  for (const char* name : {"--db", "--out"}) {
    CHECK_THAT(failed(pareto(shipped("front.toml"), {name, ""}), 2), Contains("name"));
  }
  CHECK(read(plain) == "mine");
  CHECK(folder.content() == std::set<std::string>{"plain"});
}

TEST_CASE("only its own study is resumed", "[program]") {
  const Folder folder;
  const std::string db = folder / "s.db";
  done(pareto(shipped("front.toml"), {"--points", "4", "--db", db}));
  const std::string bytes = read(db);
  const std::string other = written(folder, "other.toml", changed("2.4 kg", "2.5 kg"));
  CHECK_THAT(failed(pareto(other, {"--db", db, "--resume"}), 2),
             Contains("cannot be resumed") && Contains("problem file"));
  CHECK(read(db) == bytes);
  CHECK_THAT(failed(pareto(other, {"--resume"}), 2), Contains("--resume") && Contains("--db"));
  const std::string text = written(folder, "text.db", "not a study\n");
  CHECK_THAT(failed(pareto(other, {"--db", text, "--resume"}), 2),
             Contains(text) && Contains("not a camlaw study"));
  CHECK_THAT(failed({"front", text}, 2), Contains(text) && Contains("not a camlaw study"));
  CHECK(read(text) == "not a study\n");
  CHECK_THAT(failed({"front", folder / "none.db"}, 2), Contains("no such study"));
  CHECK_THAT(failed({"front", folder / ""}, 2), Contains("no such study"));
  CHECK_THAT(failed({"front", shipped("front.toml")}, 2), Contains("not a camlaw study"));
}

TEST_CASE("a problem without designs has no front: status 3", "[program]") {
  const Folder folder;
  const std::string file = written(folder, "none.toml",
                                   read(shipped("front.toml")) +
                                       "\n[[constraints]]\nresponse = \"minimum_cam_radius\"\n"
                                       "upper = \"10 mm\"\n");
  const std::string db = folder / "s.db";
  const Outcome text = run(pareto(file, {"--db", db, "--out", folder / "out"}));
  CHECK(text.status == 3);
  CHECK(text.err.empty());
  CHECK_THAT(text.out, Contains("no design that meets every limit was found"));
  const Outcome json = run(pareto(file, {"--json"}));
  CHECK(json.status == 3);
  const ParsedJson result = ParsedJson::parse(json.out);
  CHECK(result["points"].empty());
  CHECK(result["knee"].is_null());
  CHECK(result["complete"] == true);
  const Outcome again = run({"front", db});
  CHECK(again.status == 3);
  CHECK_THAT(again.out, Contains("no design that meets every limit was found"));
  CHECK(run({"front", db, "--json"}).status == 3);
}

TEST_CASE("options that pareto cannot take are refused with their names", "[program]") {
  const Folder folder;
  const std::string file = shipped("front.toml");
  struct Case {
    Words options;
    std::string named;
  };
  for (const Case& c : std::vector<Case>{{{"--points", "1"}, "--points"},
                                         {{"--points", "0"}, "--points"},
                                         {{"--points", "-4"}, "--points"},
                                         {{"--points", "x"}, "--points"},
                                         {{"--points", "2.5"}, "--points"},
                                         {{"--points", ""}, "--points"},
                                         {{"--points", "1000000000"}, "--points"},
                                         {{"--workers", "0"}, "--workers"},
                                         {{"--workers", "many"}, "--workers"},
                                         {{"--workers", "100000"}, "--workers"},
                                         {{"--method", "foo"}, "--method"},
                                         {{"--method", ""}, "--method"},
                                         {{"--colour", "red"}, "--colour"}}) {
    INFO(c.options.back());
    Words words = pareto(file, c.options);
    words.insert(words.end(), {"--db", folder / "s.db", "--out", folder / "out"});
    CHECK_THAT(failed(words, 2), Contains(c.named));
  }
  CHECK(folder.content().empty());
  CHECK_THAT(failed({"pareto", folder / "none.toml"}, 2), Contains("none.toml"));
}

TEST_CASE("points of a front are chosen by knee, weights and number", "[program]") {
  const Folder folder;
  const std::string db = folder / "s.db";
  done(pareto(shipped("front.toml"), {"--points", "10", "--db", db}));
  const ParsedJson all = json_of({"front", db, "--json"});
  CHECK_FALSE(all.contains("chosen"));
  const ParsedJson result =
      json_of({"front", db, "--json", "--knee", "--weights", "1,0", "--point", "3"});
  const ParsedJson& chosen = result["chosen"];
  CHECK(chosen["knee"]["point"] == all["knee"]["point"]);
  CHECK(chosen["compromise"]["point"] == 0);
  CHECK(chosen["point"]["objectives"] == all["points"][2]["objectives"]);
  for (const auto& [name, point] : chosen.items()) CHECK(point["next"].size() == 2);
  const std::string last = std::to_string(all["points"].size());
  CHECK(json_of({"front", db, "--json", "--weights", "0,1"})["chosen"]["compromise"]["point"] ==
        all["points"].size() - 1);
  CHECK_THAT(done({"front", db, "--point", last}),
             Catch::Matchers::StartsWith("point " + last + ":") &&
                 Contains("at least 10 % better minimum_cam_radius: ") &&
                 Contains("the front does not reach that far") && Contains("alpha = "));
  CHECK_THAT(done({"front", db, "--knee"}), Contains("knee: point "));
  const std::string beyond = std::to_string(all["points"].size() + 1);
  for (const Words& options : std::vector<Words>{{"--point", "0"},
                                                 {"--point", beyond},
                                                 {"--point", "x"},
                                                 {"--point", "-1"},
                                                 {"--weights", "1"},
                                                 {"--weights", "1,1,1"},
                                                 {"--weights", "1,-1"},
                                                 {"--weights", "0,0"},
                                                 {"--weights", "1,"},
                                                 {"--weights", ""},
                                                 {"--weights", "a,b"},
                                                 {"--weights", "inf,1"},
                                                 {"--weights", "nan,1"}}) {
    INFO(options[1]);
    Words words{"front", db};
    words.insert(words.end(), options.begin(), options.end());
    CHECK_THAT(failed(words, 2), Contains(options[0].substr(2)));
  }
}

TEST_CASE("a point of a front becomes a result for reports and exports", "[program]") {
  const Folder folder;
  const std::string db = folder / "study.db", result = folder / "point.json";
  done(pareto(written(folder, "choices.toml", with_choices()), {"--points", "6", "--db", db}));
  const ParsedJson front = ParsedJson::parse(done({"front", db, "--json"}));
  REQUIRE(front["points"].size() >= 4);
  for (const std::size_t k : {std::size_t{0}, front["points"].size() - 1}) {
    const ParsedJson& point = front["points"][k];
    CAPTURE(point.dump());
    const std::string text =
        done({"front", db, "--point", std::to_string(k + 1), "--result", result});
    CHECK_THAT(text, Contains("wrote " + result) && Contains("next: camlaw export " + result));
    const problems::ReadDesign design = problems::read_design_file(result);
    CHECK(design.verdict == point["verdict"].get<std::string>());
    CHECK(design.statement.laws.front().name() == point["law"].get<std::string>());
    for (const auto& variable : design.statement.variables) {
      if (!point["variables"].contains(variable.name)) continue;
      CHECK(variable.start == point["variables"][variable.name].get<double>());
    }
    const ParsedJson motion = ParsedJson::parse(done({"export", result, "--format", "json"}));
    CHECK(motion.is_object());
  }
  CHECK_THAT(failed({"front", db, "--result", result}, 2), Contains("--knee"));
  CHECK_THAT(failed({"front", db, "--knee", "--point", "1", "--result", result}, 2),
             Contains("writes one design, but 2 are chosen; give one of"));
}

TEST_CASE("fewer than three points have no knee to choose", "[program]") {
  const Folder folder;
  const std::string db = folder / "s.db";
  const std::string file =
      written(folder, "two.toml",
              "mechanism = \"law\"\n[law]\nname = [\"cosine\", \"parabolic\"]\n"
              "[[objectives]]\nminimize = \"B\"\n[[objectives]]\nminimize = \"C\"\n");
  done(pareto(file, {"--db", db, "--out", folder / "out"}));
  check_svg(folder / "out/front.svg");
  const ParsedJson all = json_of({"front", db, "--json"});
  REQUIRE(all["points"].size() == 2);
  CHECK(all["knee"].is_null());
  CHECK_THAT(failed({"front", db, "--knee"}, 2), Contains("--knee"));
}

TEST_CASE("pareto and optimize name each other", "[program]") {
  CHECK_THAT(failed({"optimize", shipped("front.toml")}, 2), Contains("camlaw pareto"));
  CHECK_THAT(failed(pareto(shipped("least_force.toml")), 2), Contains("camlaw optimize"));
}

TEST_CASE("a front as a table and as a drawing", "[program]") {
  const Folder folder;
  const std::string file = written(folder, "choices.toml", with_choices());
  const std::string db = folder / "out/study.db";
  const std::string text = done(pareto(file, {"--points", "12", "--out", folder / "out"}));
  for (const char* name : {"front.json", "front.csv", "front.svg", "study.db"}) {
    INFO(name);
    CHECK(folder.content().contains(std::string("out/") + name));
    CHECK_THAT(text, Contains(name));
  }
  const ParsedJson json = ParsedJson::parse(read(folder / "out/front.json"));
  CHECK(json["format"] == "camlaw front 1");
  CHECK(json == json_of({"front", db, "--json"}));
  done({"front", db, "--csv", folder / "f.csv", "--svg", folder / "f.svg"});
  CHECK(read(folder / "f.csv") == read(folder / "out/front.csv"));
  CHECK(read(folder / "f.svg") == read(folder / "out/front.svg"));
  check_svg(folder / "f.svg");
  CHECK_THAT(read(folder / "f.svg"), Contains("no law is below") && Contains("knee"));
  const CsvRows rows = csv_of(read(folder / "f.csv"));
  REQUIRE(rows.size() == json["points"].size() + 1);
  const Words& header = rows.front();
  const auto column = [&](const std::string& name) {
    const auto at = std::find(header.begin(), header.end(), name);
    REQUIRE(at != header.end());
    return static_cast<std::size_t>(at - header.begin());
  };
  for (std::size_t k = 1; k < rows.size(); ++k) {
    REQUIRE(rows[k].size() == header.size());
    const ParsedJson& point = json["points"][k - 1];
    CHECK(rows[k][column("law")] == point["law"]);
    CHECK(rows[k][column("verdict")] == point["verdict"]);
    CHECK(std::stod(rows[k][column("minimum_cam_radius [mm]")]) ==
          point["objectives"]["minimum_cam_radius"].get<double>());
    CHECK(std::stod(rows[k][column("peak_inertia_force [N]")]) ==
          point["objectives"]["peak_inertia_force"].get<double>());
    CHECK(std::stod(rows[k][column("blades")]) == point["variables"]["blades"].get<double>());
    const std::string alpha = rows[k][column("alpha")];
    CHECK(alpha.empty() == !point["variables"].contains("alpha"));
  }
  CHECK_THAT(failed({"front", db, "--svg", folder / "choices.toml/f.svg"}, 1),
             Contains("cannot write"));
}

TEST_CASE("fronts of three objectives, and with one that is to be great", "[program][long]") {
  const Folder folder;
  const std::string three =
      written(folder, "three.toml",
              read(shipped("front.toml")) + "\n[[objectives]]\nminimize = \"peak_drive_torque\"\n");
  const ParsedJson result =
      json_of(pareto(three, {"--points", "8", "--json", "--out", folder / "three"}));
  CHECK(result["objectives"].size() == 3);
  CHECK(result["limit_hypervolume"].is_null());
  CHECK(result["hypervolume_at_most"].is_null());
  CHECK(result["points"].size() <= 8);
  CHECK(result["complete"] == (result["largest_gap"] <= 2.5));
  CHECK(result["finished"] == true);
  for (const ParsedJson& objective : result["objectives"]) CHECK(objective["tolerance"] > 0);
  for (const ParsedJson& point : result["points"]) CHECK(point["slopes"].size() == 2);
  check_svg(folder / "three/front.svg");
  const std::string great =
      written(folder, "great.toml",
              changed("minimize = \"peak_inertia_force\"", "maximize = \"lowest inertia_force\""));
  const ParsedJson other =
      json_of(pareto(great, {"--points", "8", "--json", "--out", folder / "great"}));
  CHECK(other["objectives"][1]["sense"] == "maximize");
  for (const ParsedJson& point : other["points"]) {
    CHECK(point["objectives"]["lowest inertia_force"].get<double>() < 0);
    // A smaller radius is paid for with a lower lowest force.
    const ParsedJson& slope = point["slopes"][0]["value"];
    CHECK((slope.is_null() || slope.get<double>() >= 0));
  }
  check_svg(folder / "great/front.svg");
  CHECK_THAT(done(pareto(three, {"--points", "5"})), Contains("slope 2") && Contains("slope 3"));
}

TEST_CASE("an objective's tolerance in the file decides which points differ", "[program]") {
  const Folder folder;
  const std::string file =
      written(folder, "coarse.toml",
              changed("minimize = \"minimum_cam_radius\"",
                      "minimize = \"minimum_cam_radius\"\ntolerance = \"0.5 mm\""));
  const ParsedJson coarse = json_of(pareto(file, {"--points", "60", "--json"}));
  const ParsedJson fine = json_of(pareto(shipped("front.toml"), {"--points", "60", "--json"}));
  CHECK(coarse["objectives"][0]["tolerance"] == 0.5);
  REQUIRE(coarse["points"].size() > 3);
  CHECK(coarse["points"].size() < fine["points"].size());
  for (std::size_t i = 1; i < coarse["points"].size(); ++i) {
    const auto radius = [&](std::size_t k) {
      return coarse["points"][k]["objectives"]["minimum_cam_radius"].get<double>();
    };
    CHECK(radius(i) - radius(i - 1) > 0.5);
  }
}

TEST_CASE("the roller's front of three objectives is even and complete", "[program][heavy]") {
  const std::string file = testing::source("problems/cams/roller_front.toml");
  const ParsedJson result = json_of(pareto(file, {"--points", "40", "--json"}));
  CHECK(result["complete"] == true);
  CHECK(result["largest_gap"] <= 2.5);
  std::vector<std::vector<double>> places;
  for (const ParsedJson& point : result["points"]) {
    std::vector<double> place;
    std::size_t i = 0;
    for (const auto& objective : result["objectives"]) {
      const double low = result["ideal"][i], high = result["nadir"][i];
      const double value = point["objectives"][objective["name"].get<std::string>()];
      place.push_back((value - low) / (high - low));
      ++i;
    }
    places.push_back(place);
  }
  REQUIRE(places.size() == 40);
  const optim::even_tests::Even even = optim::even_tests::evenness_of(places);
  CHECK(even.nearest <= 2.5);
  CHECK(even.crowded >= 0.25);
  // NSGA-II's best of five seeds with 40 designs of either law and 100 generations, 75 points on
  // the front, from this reference (benchmarks/README.md): 1442.8.
  std::vector<optim::Costs> costs;
  for (const ParsedJson& point : result["points"]) {
    costs.push_back({point["objectives"]["base_radius"], point["objectives"]["peak drive_torque"],
                     point["objectives"]["highest contact_stress"]});
  }
  CHECK(optim::hypervolume(costs, {85.5, 5.041360244661644, 207.76758228849005}) >= 0.995 * 1442.8);
}

TEST_CASE("a reference out of reach leaves the numbers numbers", "[program]") {
  const Folder folder;
  const std::string file =
      written(folder, "far.toml",
              changed("minimize = \"minimum_cam_radius\"",
                      "minimize = \"minimum_cam_radius\"\nreference = \"1 mm\"") +
                  "reference = \"1 N\"\n");
  const std::string text = done(pareto(file, {"--points", "4"}));
  CHECK_THAT(text, Contains("hypervolume 0 ") && !Contains("nan") && !Contains("inf"));
  const ParsedJson result = json_of(pareto(file, {"--points", "4", "--json"}));
  CHECK(result["hypervolume"] == 0);
  CHECK(result["reference"] == ParsedJson({1.0, 1.0}));
}

TEST_CASE("sizes alone, with no number that varies freely", "[program]") {
  const Folder folder;
  const std::string file = written(
      folder, "sizes.toml",
      "mechanism = \"spine-cutter\"\n[law]\nname = [\"cosine\", \"cycloidal\", \"poly-3-4-5\"]\n"
      "[variables.blades]\nvalues = [17, 21]\n"
      "[[objectives]]\nminimize = \"minimum_cam_radius\"\n"
      "[[objectives]]\nminimize = \"peak_drive_torque\"\n");
  const ParsedJson result = json_of(pareto(file, {"--json", "--out", folder / "out"}));
  CHECK(result["combinations"] == 6);
  CHECK(result["failures"].empty());
  REQUIRE_FALSE(result["points"].empty());
  CHECK_THAT(result["points"][0]["law"].get<std::string>(), Contains("cosine"));
  check_svg(folder / "out/front.svg");
  CHECK_THAT(done(pareto(file)), !Contains("nan"));
}

TEST_CASE("a model that dies is one of the failures", "[program]") {
  // The workers of a study can be killed by anyone: what is left is a study with a failure.
  const Folder folder;
  const std::string file = written(folder, "choices.toml", with_choices());
  // The search for leaks has a process of its own, which is not to be killed.
  const Outcome outcome = shell(
      "ASAN_OPTIONS=detect_leaks=0 " + kProgram + " pareto '" + file +
          "' --points 60 --workers 1 --json & child=$!; for i in 1 2 3 4 5 6 7 8 9 10; do sleep "
          "0.02; kill -KILL $(cat /proc/$child/task/$child/children) 2>&-; done; wait $child",
      folder);
  CHECK((outcome.status == 0 || outcome.status == 4));
  const ParsedJson result = ParsedJson::parse(outcome.out);
  CHECK(result["complete"] == true);
  for (const ParsedJson& failure : result["failures"]) {
    CHECK_THAT(failure["why"].get<std::string>(), Contains("killed by signal 9"));
  }
}

TEST_CASE("a study carries the table and the law that its problem names", "[program][lift_table]") {
  const Folder folder;
  std::string table = "angle [deg],lift [mm]\n";
  for (int i = 0; i < 72; ++i) {
    table += fmt::format("{},{:.4f}\n", 5 * i, 10 - 10 * std::cos(i * std::numbers::pi / 36));
  }
  const std::string lift = folder / "lift.csv", study = folder / "s.db";
  std::ofstream(lift) << table;
  const std::string file = folder / "front.toml";
  std::ofstream(file) << "mechanism = \"disc-cam-roller\"\n[program]\ntable = \"lift.csv\"\n"
                         "[variables.base_radius]\nlower = 20\nupper = 80\n[[objectives]]\n"
                         "minimize = \"base_radius\"\n[[objectives]]\nminimize = \"peak "
                         "pressure_angle\"\n";
  const ParsedJson front = ParsedJson::parse(
      done({"pareto", file, "--points", "3", "--workers", "2", "--db", study, "--json"}));
  fs::remove(lift);
  CHECK(ParsedJson::parse(done({"front", study, "--json"})).at("points") == front.at("points"));
  // A study that goes on reads the file that there is.
  CHECK_THAT(failed({"pareto", file, "--points", "3", "--db", study, "--resume"}, 2),
             Contains("lift.csv"));
}

TEST_CASE("a front as a table says of each point whether it can be built", "[program][buildable]") {
  const Folder folder;
  const std::string file = folder / "front.toml";
  std::ofstream(file) << "mechanism = \"disc-cam-flat\"\n[constants]\nbore_radius = \"30 mm\"\n"
                         "stroke = \"5 mm\"\n[program]\nsegments = [{name = \"up\", angle = 180, "
                         "law = \"cosine\"}, {name = \"down\", law = \"cosine\"}]\n"
                         "[variables.base_radius]\nlower = 31\nupper = 80\n[[objectives]]\n"
                         "minimize = \"base_radius\"\n[[objectives]]\n"
                         "maximize = \"least_profile_radius\"\n";
  const ParsedJson front =
      ParsedJson::parse(done({"pareto", file, "--points", "4", "--out", folder / "out", "--json"}));
  const CsvRows rows = csv_of(read(folder / "out/front.csv"));
  const Words& header = rows.front();
  const auto at = std::find(header.begin(), header.end(), "buildable");
  REQUIRE(at != header.end());
  REQUIRE(rows.size() == front["points"].size() + 1);
  // The wall is a quarter of the bore's radius from a base radius of 37.5 mm on.
  std::size_t thin = 0;
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const std::string& cell = rows[k][static_cast<std::size_t>(at - header.begin())];
    const ParsedJson& point = front["points"][k - 1];
    const bool fails = point["variables"]["base_radius"].get<double>() < 37.5;
    CHECK((cell == "fails: wall") == fails);
    CHECK(point["buildable"]["fails"] == (fails ? 1 : 0));
    CHECK((fails || cell.starts_with("not checked: ")));
    if (fails) ++thin;
  }
  CHECK((thin > 0 && thin < rows.size() - 1));
}

}  // namespace camlaw::cli::pareto_test
