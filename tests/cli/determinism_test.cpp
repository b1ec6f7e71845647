// SPDX-License-Identifier: MIT
// The same problem gives the same bytes, wherever and however the program runs.
#include <SQLiteCpp/SQLiteCpp.h>

#include <clocale>
#include <locale>

#include "optim/search/optimise.h"
#include "problems/law_files/law_file.h"
#include "problems/law_files/pieces_json.h"
#include "problems/statement/bind.h"
#include "tests/cli/shell.h"
#include "tests/paths.h"

#ifdef CAMLAW_SANITIZED
/// The C library keeps the words of LOCPATH for ever.
extern "C" const char* __lsan_default_suppressions() { return "leak:__argz_add_sep\n"; }
#endif

// Of the leak sanitizer, in programs that have it.
extern "C" {
void __lsan_disable() __attribute__((weak));  // NOLINT
void __lsan_enable() __attribute__((weak));   // NOLINT
}

namespace camlaw::cli::determinism_test {
namespace {

const std::string kProblems = testing::source("problems/");
const std::string kGerman = "de_DE.UTF-8";

/// Makes the locale in which 1.5 is 1,5, in a folder; false where the machine cannot.
bool make_german(const Folder& folder) {
  const std::string where = folder / kGerman;
  shell(folder, "localedef -i de_DE -f UTF-8 --no-archive '" + where + "' 2>/dev/null");
  const Outcome point =
      shell(folder, "LOCPATH='" + folder.path() + "' LC_ALL=" + kGerman + " locale decimal_point");
  return point.out == ",\n";
}

/// What stands before a command in a shell's line: the surroundings in which it must not matter.
std::vector<std::string> surroundings(const Folder& folder) {
  std::vector<std::string> result{
      "export LC_ALL=C;",
      "export LC_ALL=C.UTF-8;",
      "export LANG=tr_TR.UTF-8 LANGUAGE=tr;",  // whether it is there or not
      "export TZ=Pacific/Auckland;",
      "export HOME=/nowhere; umask 077;",
      "cd /;",
      "export COLUMNS=40 TERM=dumb NO_COLOR=1;",
      "taskset -c $(taskset -cp $$ | grep -o '[0-9]*$');",  // one processor, of those allowed
  };
  if (make_german(folder)) {
    result.push_back("export LOCPATH='" + folder.path() + "' LC_ALL=" + kGerman + ";");
  } else {
    WARN("no German locale can be made here (localedef, package locales): not tried");
  }
  return result;
}

/// A line that runs the program so, with another shell than the one of the test.
std::string line_of(const std::string& before, const std::string& command) {
  const bool is_prefix = before.starts_with("taskset");
  const std::string program = std::string("'") + testing::program() + "' " + command;
  return is_prefix ? before.substr(0, before.size() - 1) + " " + program
                   : "( " + before + " " + program + " )";
}

/// The rows of a study without their numbers, which tell the order in which they were done.
constexpr const char* kTasks = R"(
WITH numbers AS (
  SELECT design, 1 AS kind, place, name || quote(value) AS said FROM variable
  UNION ALL SELECT design, 2, place, name || quote(value) || quote(cost) || quote(weight)
    FROM objective
  UNION ALL SELECT design, 3, place, name || quote(margin) || quote(angle) || met || proved ||
    quote(price) FROM margin),
designs AS (
  SELECT task, id, verdict || reason || is_global || solver || (
    SELECT group_concat(said) FROM (
      SELECT said FROM numbers WHERE design = d.id ORDER BY kind, place)) AS said
  FROM design AS d)
SELECT text || part || infeasible || evaluations || failure || died || is_global || coalesce((
  SELECT group_concat(said) FROM (
    SELECT said FROM designs WHERE task = t.id ORDER BY id)), '')
FROM task AS t ORDER BY 1)";

Words tasks_of(const std::string& path) {
  const SQLite::Database base(path, SQLite::OPEN_READONLY);
  SQLite::Statement query(base, kTasks);
  Words result;
  while (query.executeStep()) result.push_back(query.getColumn(0).getString());
  return result;
}

/// Made without the leak sanitizer's eye, where there is one: the C library never frees its part.
std::locale german_locale() {
  if (__lsan_disable != nullptr) __lsan_disable();
  std::locale german(kGerman);
  if (__lsan_enable != nullptr) __lsan_enable();
  return german;
}

}  // namespace

TEST_CASE("a search gives the same bytes in every locale, folder, time zone and processor set",
          "[program]") {
  const Folder folder;
  const std::string out = folder / "out";
  const std::string command =
      "optimize '" + kProblems + "cams/roller_least_base.toml' --json --out '" + out + "'";
  std::map<std::string, std::string> expected;
  for (const std::string& before : surroundings(folder)) {
    INFO(before);
    const Outcome outcome = shell(folder, line_of(before, command));
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    std::map<std::string, std::string> bytes{{"printed", outcome.out}};
    for (const auto& entry : fs::directory_iterator(out)) {
      bytes[entry.path().filename().string()] = read(entry.path());
    }
    fs::remove_all(out);
    REQUIRE(bytes.contains("result.json"));
    if (expected.empty()) expected = bytes;
    CHECK(bytes == expected);
  }
}

TEST_CASE("a front gives the same bytes and the same study however many work on it",
          "[program][heavy]") {
  const Folder folder;
  const std::string out = folder / "out";
  const std::string command = "pareto '" + kProblems +
                              "spine_cutter/front.toml' --points 6 --out '" + out +
                              "' --json --workers ";
  std::vector<std::string> lines;
  for (const char* workers : {"1", "2", "4"}) lines.push_back(line_of("", command + workers));
  for (const std::string& before : surroundings(folder)) {
    lines.push_back(line_of(before, command + "2"));
  }
  std::string expected;
  Words tasks;
  for (const std::string& line : lines) {
    INFO(line);
    const Outcome outcome = shell(folder, line);
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    const std::string bytes = outcome.out + read(out + "/front.json") + read(out + "/front.csv") +
                              read(out + "/front.svg");
    const Words its = tasks_of(out + "/study.db");
    fs::remove_all(out);
    if (expected.empty()) expected = bytes, tasks = its;
    CHECK(bytes == expected);
    CHECK(its == tasks);
    CHECK(its.size() > 4);
  }
}

TEST_CASE("the library reads and writes numbers alike in a program with a locale of its own") {
  const Folder folder;
  if (!make_german(folder)) {
    WARN("no German locale can be made here (localedef, package locales): not tried");
    return;
  }
  const auto told = [] {
    const auto statement = problems::read_problem_file(kProblems + "cams/roller_least_base.toml");
    const problems::BoundProblem bound(statement);
    const optim::Optimum found = optim::optimise(bound.space());
    std::string text = problems::in_words(statement);
    for (const double x : found.found.x) text += ParsedJson(x).dump() + "\n";
    text += found.found.assessment.reason;
    const auto law_text = [](const Member& law) {
      return problems::law_file(law.law(), "t", nullptr).dump();
    };
    const std::string law = law_text(find_law("modified-sine"));
    CHECK(law_text(problems::read_law_text(law, "a.json")) == law);
    return text + law;
  };
  const std::string expected = told();
  setenv("LOCPATH", folder.path().c_str(), 1);
  REQUIRE(std::setlocale(LC_ALL, kGerman.c_str()) != nullptr);
  const std::locale before = std::locale::global(german_locale());
  const std::string found = told();
  std::locale::global(before);
  std::setlocale(LC_ALL, "C");
  unsetenv("LOCPATH");
  CHECK(found == expected);
}

}  // namespace camlaw::cli::determinism_test
