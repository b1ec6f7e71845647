// SPDX-License-Identifier: MIT
// A study whose program ends, or whose disk fails, at the n-th change of a file: nothing is lost
// that was on the disk, and the study goes on to the same front.
#include <algorithm>

#include "tests/cli/shell.h"

namespace camlaw::cli::crash_points_test {
namespace {

constexpr const char* kStudy =
    "problems/spine_cutter/front.toml --points 4 --db study.db --workers 1 --json";

/// The environment in which the n-th call of a kind fails.
std::string failing(const std::string& kind, long at, const std::string& as) {
  return "CAMLAW_FAIL=" + kind + " CAMLAW_FAIL_AT=" + std::to_string(at) + " CAMLAW_FAIL_AS=" + as +
         " CAMLAW_FAIL_COUNT=count LD_PRELOAD='" CAMLAW_FAIL_LIBRARY "' ";
}

/// The largest number of calls that a process of the command made.
long calls_of(const Folder& folder, const std::string& kind, const std::string& command) {
  REQUIRE(shell(folder, failing(kind, 0, "kill") + command).status == 0);
  long most = 0;
  for (const std::string& line : lines_after(read(folder / "count"), "")) {
    most = std::max(most, std::stol(line));
  }
  fs::remove(folder / "count");
  return most;
}

void remove_study(const Folder& folder) {
  for (const char* name : {"study.db", "study.db-wal", "study.db-shm", "study.db-journal"}) {
    fs::remove(folder / name);
  }
}

/// What a front says of its points; how the search went is another matter.
ParsedJson points_of(const Outcome& outcome) {
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  return ParsedJson::parse(outcome.out).at("points");
}

/// One line of ours on standard error, and no crash.
void check_complaint(const Outcome& outcome) {
  INFO(outcome.err);
  CHECK((outcome.status == 1 || outcome.status == 2));
  CHECK(outcome.err.starts_with("camlaw: "));
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
}

/// The study at hand, whatever became of it, is read without a crash and goes on to the front.
void check_goes_on(const Folder& folder, const ParsedJson& front) {
  const Outcome seen = shell(folder, "camlaw front study.db --json");
  CHECK(seen.status <= 4);  // 4: the study is not finished
  if (seen.status == 1 || seen.status == 2) check_complaint(seen);
  const std::string again = std::string("camlaw pareto ") + kStudy;
  Outcome resumed = shell(folder, again + " --resume");
  if (resumed.status == 2) {  // ended before there was a study
    check_complaint(resumed);
    remove_study(folder);
    resumed = shell(folder, again);
  }
  CHECK(points_of(resumed) == front);
}

void check_crash_points(const std::string& as, long step) {
  const ProjectFolder folder;
  const std::string command = std::string("camlaw pareto ") + kStudy;
  const ParsedJson front = points_of(shell(folder, command));
  remove_study(folder);
  const long calls = calls_of(folder, "files", command);
  REQUIRE(calls > 50);
  for (long at = 1; at <= calls; at += step) {
    remove_study(folder);
    INFO("call " << at << " of " << calls << " ends with " << as);
    const Outcome ended = shell(folder, failing("files", at, as) + command);
    if (as != "kill" && ended.status != 0) check_complaint(ended);
    check_goes_on(folder, front);
  }
}

/// Where an allocation fails a command does without, ends with one line of ours, or is ended by a
/// library that cannot do without (udunits asserts or exits); it never gives another answer, and a
/// file that it writes is whole or not there.
void check_memory(long step) {
  const ProjectFolder folder;
  const std::string command =
      "camlaw optimize problems/spine_cutter/least_radius.toml --out found >said";
  const long calls = calls_of(folder, "memory", command);
  const ParsedJson whole = ParsedJson::parse(read(folder / "found/result.json"));
  const long before_main = calls_of(folder, "memory", "camlaw --version >said");
  REQUIRE(calls > 2 * before_main);
  for (long at = before_main; at <= calls; at += step) {
    fs::remove_all(folder / "found");
    INFO("allocation " << at << " of " << calls << " fails");
    const Outcome ended = shell(folder, failing("memory", at, "kill") + command);
    const bool written = fs::exists(folder / "found/result.json");
    CHECK((ended.status != 0 || written));
    if (!written) continue;
    const ParsedJson said = ParsedJson::parse(read(folder / "found/result.json"));
    // A method that failed may have been made up for by another: the design is the same.
    if (said.at("verdict") != whole.at("verdict")) continue;  // such as feasible, not certified
    CHECK(said.at("objective").get<double>() ==
          Approx(whole.at("objective").get<double>()).epsilon(1e-6));
  }
}

}  // namespace

TEST_CASE("a killed study is read and goes on, wherever it was killed", "[faults][heavy]") {
  check_crash_points("kill", 4);
}
TEST_CASE("a study outlives a disk that fails", "[faults][heavy]") { check_crash_points("EIO", 9); }
TEST_CASE("a study outlives a disk that is full", "[faults][heavy]") {
  check_crash_points("ENOSPC", 9);
}
TEST_CASE("a failed allocation leaves no half of a file", "[faults][heavy]") { check_memory(997); }

TEST_CASE("a study outlives a kill, a failure and a full disk at every call", "[faults][.long]") {
  for (const char* as : {"kill", "EIO", "ENOSPC"}) check_crash_points(as, 1);
}
TEST_CASE("a failed allocation leaves no half of a file, at every tenth", "[faults][.long]") {
  check_memory(10);
}

}  // namespace camlaw::cli::crash_points_test
