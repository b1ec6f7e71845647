// SPDX-License-Identifier: MIT
// Studies and results that are not as they were written: what is damaged or wrong is named, and
// nothing of it is shown as certified.
#include <SQLiteCpp/SQLiteCpp.h>

#include <random>

#include "problems/results/judged_design.h"
#include "problems/results/recorded_design.h"
#include "problems/results/seal.h"
#include "tests/cli/program_runner.h"
#include "tests/flipped.h"
#include "tests/paths.h"

namespace camlaw::cli::damaged_records_test {
namespace {

using testing::flipped, testing::write;

const std::string kProblems = testing::source("problems/");
const std::string kCam = kProblems + "cams/roller_least_base.toml";

#ifdef CAMLAW_SANITIZED
constexpr int kFlips = 100;
#else
constexpr int kFlips = 1000;
#endif

/// What came of a file with a flipped bit.
struct Tally {
  int refused = 0, same = 0, named = 0, silent = 0;
};

/// A front with a limit.
std::string front_file(const Folder& folder) {
  const std::string path = folder / "front.toml";
  write(path, read(kProblems + "spine_cutter/front.toml") +
                  "\n[[constraints]]\nresponse = \"minimum_cam_radius\"\nupper = \"36 mm\"\n");
  return path;
}

std::string made_study(const Folder& folder) {
  const std::string path = folder / "s.db";
  const Words words{"pareto", front_file(folder), "--points", "6", "--db", path, "-q"};
  REQUIRE(run(words).status == 0);
  return path;
}

void change(const std::string& path, const std::string& sql) {
  SQLite::Database(path, SQLite::OPEN_READWRITE).exec(sql);
}

/// Makes of a study one of version 2, as earlier programs wrote it.
void make_older(const std::string& path) {
  change(path,
         "ALTER TABLE task DROP COLUMN checksum; ALTER TABLE setting DROP COLUMN checksum; "
         "PRAGMA user_version = 2");
}

constexpr const char* kLower =
    "UPDATE objective SET value = 0.99 * value, cost = 0.99 * cost "
    "WHERE design = 3 AND place = 1";

ParsedJson stored_result(const Folder& folder) {
  return json_of({"optimize", kCam, "--out", folder / "out", "--json"});
}

std::string stored(const Folder& folder, const ParsedJson& result) {
  const std::string path = folder / "result.json";
  write(path, result.dump(2));
  return path;
}

}  // namespace

TEST_CASE("no flipped bit of a result changes an answer silently") {
  const Folder folder;
  const std::string bytes = stored_result(folder).dump(2);
  const ParsedJson whole = ParsedJson::parse(bytes);
  const std::string program = whole["program"];
  std::mt19937_64 random(4);
  const auto without_time = [](ParsedJson result) {
    result.erase("wall_s");
    return result;
  };
  Tally tally;
  for (int i = 0; i < kFlips; ++i) {
    const std::string damaged = flipped(bytes, random);
    try {
      const problems::ReadDesign design = problems::read_result(damaged, "result.json");
      const bool named = !problems::record_notes(design, program).empty();
      ++(named                                                             ? tally.named
         : without_time(ParsedJson::parse(damaged)) == without_time(whole) ? tally.same
                                                                           : tally.silent);
    } catch (const std::invalid_argument& error) {
      CHECK_THAT(error.what(), Contains("result.json"));
      ++tally.refused;
    }
  }
  CAPTURE(tally.refused, tally.same, tally.named);
  CHECK(tally.silent == 0);
  // The time that a search took is in its result, so that other bits are flipped in each run.
  CHECK(tally.named > kFlips / 10);
  CHECK(tally.refused > kFlips / 20);
}

TEST_CASE("an edited task is named, does not count, and is solved again") {
  const Folder folder;
  const std::string path = made_study(folder);
  const std::string whole = done({"front", path}), bytes = read(path);
  for (const std::string& edit :
       {std::string(kLower), std::string("UPDATE variable SET value = 1000 WHERE design = 3"),
        std::string("UPDATE margin SET margin = margin + 1 WHERE design = 3"),
        std::string("UPDATE design SET is_global = 1 - is_global WHERE id = 3"),
        std::string("UPDATE design SET verdict = 'feasible' WHERE id = 3")}) {
    INFO(edit);
    write(path, bytes);
    change(path, edit);
    const Outcome front = run({"front", path});
    CHECK(front.status == 4);
    CHECK_THAT(front.out, Contains("task 3 is damaged") && Contains("--resume solves it again"));
    const ParsedJson json = ParsedJson::parse(run({"front", path, "--json"}).out);
    REQUIRE(json["record"]["faults"].size() == 1);
    CHECK(json["record"]["faults"][0]["task"] == 3);
    CHECK(json["finished"] == false);
    CHECK(json["points"].size() >= 4);  // the others are there
    CHECK(run({"report", path, "-o", folder / "p.html"}).status == 4);
    CHECK_THAT(read(folder / "p.html"), Contains("task 3 is damaged"));
    const Outcome again = run({"pareto", front_file(folder), "--db", path, "--resume"});
    CHECK(again.status == 0);
    CHECK_THAT(again.out, Contains("task 3 is damaged") && Contains("solved again"));
    CHECK(done({"front", path}) == whole);
  }
}

TEST_CASE("a study of an earlier version is judged anew, and what is wrong in it is named") {
  const Folder folder;
  const std::string path = made_study(folder);
  const ParsedJson whole = json_of({"front", path, "--json"});
  make_older(path);
  const ParsedJson older = json_of({"front", path, "--json"});
  CHECK_THAT(older["record"]["notes"].dump(), Contains("judged again"));
  REQUIRE(older["points"].size() == whole["points"].size());
  for (std::size_t i = 0; i < whole["points"].size(); ++i) {
    CHECK(older["points"][i]["verdict"] == whole["points"][i]["verdict"]);
    CHECK(older["points"][i]["objectives"] == whole["points"][i]["objectives"]);
  }
  // A word of it is believed as little as a number.
  change(path, "UPDATE design SET verdict = 'feasible'");
  CHECK(json_of({"front", path, "--json"})["points"][2]["verdict"] == "certified optimum");
  const std::string bytes = read(path);
  for (const std::string& edit :
       {std::string(kLower), std::string("UPDATE variable SET value = 1000 WHERE design = 3"),
        std::string("UPDATE margin SET margin = margin + 1 WHERE design = 3")}) {
    INFO(edit);
    write(path, bytes);
    change(path, edit);
    const Outcome front = run({"front", path});
    CHECK(front.status == 4);
    CHECK_THAT(front.out, Contains("task 3 is wrong"));
  }
  CHECK_THAT(failed({"pareto", front_file(folder), "--db", path, "--resume"}, 2),
             Contains("earlier version"));
}

TEST_CASE("what is said of resuming is what resuming does") {
  const Folder folder;
  const std::string path = made_study(folder);
  const Words resume{"pareto", front_file(folder), "--db", path, "--resume"};
  const std::string goes_on = "--resume continues it", again = "start it again";
  const auto forget = [&] {
    change(path, "DELETE FROM task WHERE id = (SELECT max(id) FROM task)");
  };
  forget();
  CHECK_THAT(run({"front", path}).out, Contains(goes_on) && !Contains(again));
  CHECK(run(resume).status == 0);
  forget();
  make_older(path);
  CHECK_THAT(run({"front", path}).out, !Contains("--resume") && Contains(again));
  failed(resume, 2);
}

TEST_CASE("a verdict that was forged with its checksum is judged by verify") {
  const Folder folder;
  ParsedJson forged = stored_result(folder);
  // Of the other sense every number stays what it was, and the design is the worst there is.
  std::string problem = forged["design"]["problem"];
  const std::string sense = "minimize";
  problem.replace(problem.find(sense), sense.size(), "maximize");
  forged["design"]["problem"] = problem;
  problems::Json sealed = problems::Json::parse(forged.dump());
  problems::seal(sealed);
  const Outcome outcome = run({"verify", stored(folder, ParsedJson::parse(sealed.dump()))});
  CHECK(outcome.status == 4);
  CHECK_THAT(outcome.out, Contains("the result says certified optimum; the design is feasible") &&
                              !Contains("record:"));
}

TEST_CASE("an edited result is wrong wherever it is shown") {
  const Folder folder;
  const ParsedJson whole = stored_result(folder);
  std::vector<std::pair<ParsedJson, std::string>> edits(4, {whole, ""});
  edits[0].first["objective"] = 0.99 * whole["objective"].get<double>();
  edits[0].second = "base_radius is stated as";
  edits[1].first["constraints"][1]["margin"] = 0.7;
  edits[1].second = "the margin of undercut is stated as 0.7";
  edits[2].first["constraints"][0]["bound"] = 31;
  edits[2].second = "the bound on pressure_angle";
  edits[3].first["design"]["variables"]["base_radius"] = 60;
  edits[3].second = "base_radius is shown as";
  const std::string page = folder / "page.html";
  for (const auto& [result, words] : edits) {
    INFO(words);
    const std::string path = stored(folder, result);
    for (const Words& command :
         {Words{"verify", path}, Words{"evaluate", path}, Words{"export", path, "--format", "csv"},
          Words{"report", path, "-o", page}}) {
      INFO(command.front());
      const Outcome outcome = run(command);
      CHECK(outcome.status == 4);
      CHECK_THAT(outcome.out + outcome.err,
                 Contains(words) && Contains("was changed after it was written"));
      CHECK_THAT(outcome.out, !Contains("certified optimum") || Contains("does not hold"));
    }
    CHECK_THAT(read(page), Contains("the result is wrong"));
  }
  ParsedJson outside = whole;
  outside["design"]["variables"]["base_radius"] = 500;
  CHECK_THAT(failed({"evaluate", stored(folder, outside)}, 2), Contains("outside the bounds"));
  ParsedJson bound = whole;
  bound["best_possible"] = 0.9 * whole["best_possible"].get<double>();
  CHECK_THAT(run({"verify", stored(folder, bound)}).out, Contains("the bound is"));
  const auto verified = [&](const ParsedJson& result) {
    return run({"verify", stored(folder, result)});
  };
  ParsedJson side = whole;
  side["constraints"][0]["side"] = "lower";
  CHECK(verified(side).status == 4);
  CHECK_THAT(verified(side).out, Contains("is stated as its lower bound"));
  ParsedJson twice = whole;
  twice["constraints"].push_back(twice["constraints"][0]);
  CHECK_THAT(verified(twice).out, Contains("is stated twice"));
  ParsedJson bare = whole;
  bare.erase("constraints");
  CHECK(verified(bare).status == 4);
  CHECK_THAT(verified(bare).out, Contains("the limits are not stated"));
  ParsedJson unit = whole;
  unit["units"]["base_radius"] = "m";
  CHECK_THAT(verified(unit).out, Contains("not judged: what else the changed result states") &&
                                     Contains("units") && Contains("buildable"));
  ParsedJson words = whole;
  words["verdict"] = "feasible";
  CHECK_THAT(run({"verify", stored(folder, words)}).out,
             Contains("was changed after it was written"));
}

TEST_CASE("a result stays of use where a note is edited or the layout changed") {
  const Folder folder;
  const ParsedJson whole = stored_result(folder);
  CHECK_THAT(run({"verify", folder / "out/result.json"}).out, !Contains("record:"));
  write(folder / "flat.json", whole.dump());  // without spaces, the keys in another order
  CHECK_THAT(done({"verify", folder / "flat.json"}), !Contains("record:"));
  ParsedJson noted = whole;
  noted["title"] = "for the second machine";
  const Outcome edited = run({"evaluate", stored(folder, noted)});
  CHECK(edited.status == 0);
  CHECK_THAT(edited.out, Contains("was changed after it was written"));
  CHECK(run({"verify", stored(folder, noted)}).status == 0);
  ParsedJson older = whole;
  older.erase("checksum");
  CHECK_THAT(done({"verify", stored(folder, older)}), Contains("has no checksum"));
  const Outcome table = run({"export", stored(folder, older), "--format", "json"});
  CHECK(table.status == 0);
  CHECK_THAT(table.err, Contains("has no checksum"));
  CHECK_THAT(table.out, Contains("judged again: certified optimum"));
}

TEST_CASE("a point of a front that became a result is verified like any other") {
  const Folder folder;
  const std::string path = made_study(folder), result = folder / "point.json";
  REQUIRE(run({"front", path, "--point", "3", "--result", result}).status == 0);
  CHECK_THAT(done({"verify", result}), Contains("the claim holds") && !Contains("record:"));
  ParsedJson edited = ParsedJson::parse(read(result));
  for (auto& [name, value] : edited["objectives"].items()) value = 0.99 * value.get<double>();
  const Outcome outcome = run({"verify", stored(folder, edited)});
  CHECK(outcome.status == 4);
  CHECK_THAT(outcome.out, Contains("is stated as") && Contains("does not hold"));
}

}  // namespace camlaw::cli::damaged_records_test
