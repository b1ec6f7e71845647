// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <string>
#include <thread>

#include "cli/run_limits.h"
#include "cli/watched_run.h"
#include "optim/crew/child_process.h"
#include "optim/search/free_memory.h"
#include "optim/search/optimise.h"
#include "problems/statement/bind.h"
#include "tests/cli/program_runner.h"
#include "tests/paths.h"

// Models that are larger than a search can finish, inputs that are larger than anybody means: both
// end in bounded time and memory.
namespace camlaw::cli::limits_test {
namespace {

/// A free law whose knots move, or do not.
std::string free_law(int knots, bool moving) {
  return fmt::format(
      "mechanism = \"law\"\n[law]\nname = \"free\"\n[free]\nknots = {}\nmoving_knots = {}\n"
      "[objective]\nminimize = \"C\"\n[[constraints]]\nresponse = \"B\"\nupper = 1.6\n"
      "[[constraints]]\nresponse = \"D\"\nupper = 60\n",
      knots, moving);
}

/// A disc cam that goes to and fro by segments whose angles vary.
std::string segments(int count) {
  std::string text =
      "mechanism = \"disc-cam-roller\"\n[constants]\nstroke = \"20 mm\"\nroller_radius = \"3 "
      "mm\"\n";
  const double angle = 360.0 / count;
  for (int i = 0; i < count; ++i) {
    text += fmt::format("[[program.segments]]\nname = \"s{}\"\nlaw = \"cycloidal\"\nto = {}\n", i,
                        1 - i % 2);
    if (i + 1 < count) text += fmt::format("angle = {}\n", angle);
  }
  for (int i = 0; i + 1 < count; ++i) {
    text +=
        fmt::format("[variables.s{}_angle]\nlower = {}\nupper = {}\n", i, 0.8 * angle, 1.2 * angle);
  }
  return text +
         "[variables.base_radius]\nlower = 5\nupper = 5000\nstart = 1000\n[objective]\n"
         "minimize = \"base_radius\"\n[[constraints]]\nresponse = \"pressure_angle\"\n"
         "lower = -35\nupper = 30\n[[constraints]]\nresponse = \"undercut\"\nupper = 0.9\n";
}

/// A disc cam with many limits on one response.
std::string limits(int count, bool front = false) {
  std::string text =
      "mechanism = \"disc-cam-roller\"\n[constants]\nstroke = \"20 mm\"\nroller_radius = \"3 mm\"\n"
      "[[program.segments]]\nname = \"rise\"\nangle = 120\nlaw = \"modified-sine\"\n"
      "[[program.segments]]\nname = \"high\"\nangle = 40\n"
      "[[program.segments]]\nname = \"return\"\nangle = 120\nlaw = \"modified-sine\"\n"
      "[[program.segments]]\nname = \"low\"\n"
      "[variables.rise_angle]\nlower = 90\nupper = 150\n"
      "[variables.base_radius]\nlower = 5\nupper = 200\nstart = 60\n";
  text += front ? "[[objectives]]\nminimize = \"base_radius\"\n[[objectives]]\n"
                  "minimize = \"highest undercut\"\n"
                : "[objective]\nminimize = \"base_radius\"\n";
  for (int i = 0; i < count; ++i) {
    text +=
        fmt::format("[[constraints]]\nresponse = \"pressure_angle\"\nupper = {}\n", 30 + 1e-3 * i);
  }
  return text;
}

/// A cam that is made in series, with many limits that nearly all parts are to hold.
std::string reliable(int count) {
  std::string text = limits(0) + "[variation.base_radius]\nplus = 0.5\nminus = 0.5\n";
  for (int i = 0; i < count; ++i) {
    text += fmt::format(
        "[[constraints]]\nresponse = \"pressure_angle\"\nupper = {}\nfrom = {}\nto = {}\n"
        "reliability = 0.99\n",
        30 + 1e-3 * i, 0.1 * i, 120 + 0.1 * i);
  }
  return text;
}

std::string written(const Folder& folder, const std::string& text) {
  const std::string path = folder / "large.toml";
  std::ofstream(path) << text;
  return path;
}

double seconds_of(const std::function<void()>& work) {
  const auto began = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

/// Processes, but for this one, that have a word in their command line.
int processes_with(const std::string& word) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    std::ifstream file(entry.path() / "cmdline");
    std::string words;
    std::getline(file, words);
    count += words.find(word) != std::string::npos ? 1 : 0;
  }
  return count;
}

}  // namespace

TEST_CASE("large models keep a time limit, and leave no process behind", "[program][heavy]") {
  const auto [name, text] = GENERATE(table<std::string, std::string>({
      {"moving knots", free_law(200, true)},
      {"segments", segments(150)},
      {"limits", limits(2000)},
      {"reliabilities", reliable(150)},
  }));
  INFO(name);
  const Folder folder;
  const std::string path = written(folder, text);
  // What it takes to read the file and look at its start once, on this machine as busy as it is.
  const double unit = seconds_of([&] { run({"evaluate", path}); });
  constexpr double kLimit = 1;
  Outcome outcome;
  const double spent = seconds_of([&] {
    outcome = run({"optimize", path, "--time-limit", std::to_string(kLimit), "--starts", "1000"});
  });
  CHECK(spent < kLimit + 1 + 10 * unit);
  CHECK((outcome.status == 0 || outcome.status == 4));
  CHECK_THAT(outcome.out, Contains("the time limit of 1 s was reached"));
  CHECK(processes_with(folder / "") == 0);
}

TEST_CASE("a large search ends on a request, and with its parent", "[program][heavy]") {
  const Folder folder;
  const std::string path = written(folder, free_law(200, true));
  const double unit = seconds_of([&] { run({"evaluate", path}); });
  SECTION("a request to end: the best so far") {
    const Running program({"optimize", path, "--starts", "1000"});
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    kill(program.id(), SIGTERM);
    Outcome outcome;
    const double spent = seconds_of([&] { outcome = program.wait(); });
    CHECK(spent < 1 + 10 * unit);
    CHECK((outcome.status == 0 || outcome.status == 4));
    CHECK_THAT(outcome.out, Contains("stopped"));
  }
  SECTION("the parent is killed") {
    const Running program({"optimize", path, "--starts", "1000"});
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    kill(program.id(), SIGKILL);
    CHECK(program.wait().status != 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
  CHECK(processes_with(folder / "") == 0);
}

TEST_CASE("a watched search has the answer of the library, to the bit", "[program]") {
  const Folder folder;
  const std::string path = written(folder, free_law(100, false));
  const ParsedJson answer = json_of({"optimize", path, "--json", "--time-limit", "10 min"});
  const problems::BoundProblem bound(problems::read_problem_file(path));
  const optim::Optimum own = optim::optimise(bound.space());
  CHECK(answer["verdict"] == "certified optimum");
  CHECK(answer["objective"].get<double>() == own.found.assessment.objective.value);
}

TEST_CASE("pareto, synthesize and fit take a time limit", "[program][heavy]") {
  const Folder folder;
  SECTION("pareto: what is recorded stays") {
    const std::string path = written(folder, limits(1000, true)), db = folder / "study.db";
    const double unit = seconds_of([&] { run({"evaluate", path}); });
    Outcome outcome;
    const double spent = seconds_of([&] {
      outcome = run(
          {"pareto", path, "--time-limit", "1", "--points", "2000", "--db", db, "--workers", "1"});
    });
    CHECK(spent < 2 + 10 * unit);
    CHECK(outcome.status == 4);
    CHECK_THAT(outcome.out + outcome.err, Contains("--resume continues"));
    CHECK(processes_with(folder / "") == 0);
  }
  SECTION("synthesize") {
    const std::string path = written(folder, free_law(200, true));
    const double unit = seconds_of([&] { run({"evaluate", path}); });
    Outcome outcome;
    const double spent = seconds_of([&] {
      outcome = run({"synthesize", path, "--time-limit", "1", "--starts", "1000"});
    });
    CHECK(spent < 2 + 10 * unit);
    CHECK_THAT(outcome.out, Contains("the time limit of 1 s was reached"));
  }
  SECTION("fit") {
    const std::string cam = testing::source("problems/cams/worn_cam.csv");
    const Words words{"fit", cam, "--mechanism", "disc-cam-roller", "--set", "roller_radius=8 mm"};
    Words timed = words;
    timed.insert(timed.end(), {"--time-limit", "0.01"});
    // A fast machine has tried one law of each motion before it is asked to end.
    const Outcome outcome = run(timed);
    CHECK((outcome.status == 4 || outcome.status == 0));
    CHECK_THAT(outcome.status == 4 ? outcome.err : outcome.out,
               Contains(outcome.status == 4 ? "the time limit of 0.01 s was reached"
                                            : "the time limit left no time to try these laws: "));
    timed.back() = "10 min";
    CHECK(run(timed).out == run(words).out);
  }
}

TEST_CASE("an evaluation whose proofs take too long says what is left of them", "[program]") {
  // Of damping so low, with a margin that small, the proof takes minutes.
  const Folder folder;
  const std::string path = folder / "quiet.toml";
  std::string text = read(testing::source("problems/cams/elastic_valve.toml"));
  for (const char* stated : {"speed = \"900 rpm\"\n", "train_damping = 0.04\n"}) {
    text.erase(text.find(stated), std::string(stated).size());
  }
  const std::string bound = "lower = \"20 N\"";
  text.replace(text.find(bound), bound.size(), "lower = \"-900 N\"");
  std::ofstream(path) << text << "[ranges.speed]\nlower = '600 rpm'\nupper = '900 rpm'\n"
                      << "[ranges.train_damping]\nlower = 0.005\nupper = 0.015\n";
  const Words words{"evaluate", path, "--time-limit", "0.001"};
  const Outcome outcome = run(words);
  CHECK(outcome.status == 4);
  CHECK_THAT(outcome.out, Contains("not decided: lowest elastic_force from "));
  CHECK_THAT(outcome.out, Contains("proofs stopped early: the time limit of 0.001 s was reached"));
  Words as_json = words;
  as_json.push_back("--json");
  const ParsedJson answer = ParsedJson::parse(run(as_json).out);
  CHECK(answer.at("cut_short") == "the time limit of 0.001 s was reached");
  const auto& limit = answer.at("constraints")[0];
  CHECK(limit.at("met") == true);
  CHECK(limit.at("proved") == false);
  CHECK(limit.at("undecided").at("ranges").contains("speed"));
}

TEST_CASE("a fit without the time for every law says which it has not tried", "[program][heavy]") {
  const std::string cam = testing::source("problems/cams/worn_cam.csv");
  const Words words{"fit", cam, "--mechanism", "disc-cam-roller", "--json"};
  ParsedJson whole;
  const double all = seconds_of([&] { whole = ParsedJson::parse(run(words).out); });
  REQUIRE(whole.at("cam").at("departures").size() == 1);
  bool told = false;
  // How long it takes depends on what else the machine does: some of these leave laws untried.
  for (double part = 1.2; part > 0.1; part /= 1.4) {
    Words timed = words;
    timed.insert(timed.end(), {"--time-limit", std::to_string(part * all)});
    const Outcome outcome = run(timed);
    if (outcome.status == 4) continue;  // not even the first law of each motion
    REQUIRE(outcome.status == 0);
    const ParsedJson answer = ParsedJson::parse(outcome.out);
    for (std::size_t i = 0; i < answer.at("motions").size(); ++i) {
      const ParsedJson& motion = answer.at("motions")[i];
      INFO(part << " of the time, motion " << i);
      if (motion.at("untried").empty()) {  // then it is the answer of the whole fit
        CHECK(motion == whole.at("motions").at(i));
        continue;
      }
      told = true;
      CHECK_FALSE(motion.at("trusted").get<bool>());
      CHECK_THAT(motion.at("reason").get<std::string>(),
                 Contains("the time limit left no time to try these laws: ") &&
                     Contains(motion.at("untried").front().get<std::string>()));
      CHECK(answer.at("faults").empty());
    }
  }
  CHECK(told);
}

TEST_CASE("memory that a problem would take is refused by name", "[program]") {
  const Folder folder;
  const std::string path = written(folder, free_law(500, true));
  for (const char* command : {"optimize", "synthesize"}) {
    const std::string line = failed({command, path, "--memory", "20 MB"}, 2);
    CHECK_THAT(line, Contains("500 knots") && Contains("may use 20 MB"));
  }
  const auto refused = [&](const char* size) {
    return failed({"optimize", path, "--memory", size}, 2);
  };
  for (const char* size : {"4", "4 mm", "-1 GB", "0 GB", "nan GB", "GB", "", "4 GBB"}) {
    INFO(size);
    CHECK_THAT(refused(size), Contains("--memory") && Contains("\"4 GB\""));
  }
  CHECK(parse_memory("4 GB", "m") == 4e9);
  CHECK(parse_memory("2GiB", "m") == 2147483648.0);
  CHECK(parse_memory("0.5 MB", "m") == 5e5);
  CHECK(optim::free_memory() > 1e6);
}

TEST_CASE("what is too large to be meant is refused in little time and memory", "[program]") {
  const std::string cam =
      "mechanism = \"spine-cutter\"\n[law]\nname = \"{}\"\n[variables.{}]\nlower = \"20 "
      "{}\"\nupper "
      "= 100\n[objective]\nminimize = \"{}\"\n{}";
  const auto problem = [&](const std::string& law, const std::string& variable,
                           const std::string& unit, const std::string& sought,
                           const std::string& more) {
    return fmt::format(fmt::runtime(cam), law, variable, unit, sought, more);
  };
  const auto plain = [&](const std::string& more) {
    return problem("cosine", "cam_radius", "mm", "cam_radius", more);
  };
  const std::string megabyte(1'000'000, 'x');
  std::string numbers = "0";
  for (int i = 1; i < 100'000; ++i) numbers += fmt::format(", {}", i * 1e-5);
  std::string same;
  for (int i = 0; i < 100'000; ++i) {
    same += "[[constraints]]\nresponse = \"peak_inertia_force\"\nupper = 30\n";
  }
  const auto [name, text] = GENERATE_COPY(table<std::string, std::string>({
      {"a law's name", problem(megabyte, "cam_radius", "mm", "cam_radius", "")},
      {"a variable's name", problem("cosine", megabyte, "mm", "cam_radius", "")},
      {"a unit", problem("cosine", "cam_radius", megabyte, "cam_radius", "")},
      {"a response", problem("cosine", "cam_radius", "mm", megabyte, "")},
      {"a key", plain("[solver]\n" + megabyte + " = 1\n")},
      {"a solver", plain("[solver]\nname = \"" + megabyte + "\"\n")},
      {"a title", "title = \"" + megabyte + "\"\n" + plain("")},
      {"a mechanism", "mechanism = \"" + megabyte + "\"\n"},
      {"limits", plain(same)},
      {"segments", segments(10'000)},
      {"knots", "mechanism = \"law\"\n[law]\nname = \"free\"\n[free]\nknots = [" + numbers +
                    "]\n[objective]\nminimize = \"C\"\n"},
      {"coefficients", "mechanism = \"law\"\n[law]\nname = \"legendre\"\nc = [" + numbers +
                           "]\n[objective]\nminimize = \"C\"\n"},
      {"values",
       "mechanism = \"spine-cutter\"\n[law]\nname = \"cosine\"\n[variables.cam_radius]\n"
       "values = [" +
           numbers + "]\n[objective]\nminimize = \"cam_radius\"\n"},
  }));
  INFO(name);
  const Folder folder;
  const std::string path = written(folder, text);
  const Outcome least = run({"laws"}), outcome = run({"check", path});
  CHECK(outcome.status == 2);
  CHECK(outcome.out.empty());
  CHECK(outcome.err.size() < 1000 + path.size());
  CHECK_THAT(outcome.err, Contains("at most"));
  CHECK(outcome.worked < 2 + 20 * least.worked);
  CHECK(outcome.memory < least.memory + 40.0 * static_cast<double>(text.size()) + 5e7);
}

TEST_CASE("a law's samples as JSON are told one by one", "[program][heavy]") {
  const ParsedJson few = json_of({"law", "modified-sine", "--json", "--samples", "3"});
  REQUIRE(few["samples"].size() == 3);
  CHECK(few["samples"][1]["x"] == 0.5);
  CHECK(few["samples"][2]["s"] == 1);
  CHECK(few.contains("pieces"));
  const Outcome least = run({"law", "modified-sine", "--json"});
  const Outcome many = run({"law", "modified-sine", "--json", "--samples", "200000"});
  CHECK(many.status == 0);
  CHECK(many.out.size() > 20'000'000);
  CHECK(many.memory < least.memory + 4e7);
}

TEST_CASE("work that ends in time by itself is asked to end only behind its grace",
          "[cli][limits]") {
  if (!optim::has_one_thread()) return;  // then there is no child to be asked
  // A request that comes before the child can hear it waits.
  sigset_t request;
  sigemptyset(&request);
  sigaddset(&request, SIGTERM);
  REQUIRE(sigprocmask(SIG_BLOCK, &request, nullptr) == 0);
  const auto ended = [&request](double grace, std::chrono::milliseconds work) {
    // Of a long limit, most of which has passed: the child has 50 s to end where it is asked to.
    const Watch watch{.limit = 1000, .spent = 999.95, .grace = grace};
    return watched(watch, [&](const ChildTeller&) {
      std::signal(SIGTERM, [](int) { _exit(3); });
      sigprocmask(SIG_UNBLOCK, &request, nullptr);
      std::this_thread::sleep_for(work);
      return 7;
    });
  };
  using namespace std::chrono_literals;
  CHECK(std::get<int>(ended(0.1, 60s)) == 3);
  CHECK(std::get<int>(ended(60, 200ms)) == 7);
  sigprocmask(SIG_UNBLOCK, &request, nullptr);
}

}  // namespace camlaw::cli::limits_test
