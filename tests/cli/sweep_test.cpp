// SPDX-License-Identifier: MIT
// sweep, as a user runs it.
#include <fmt/format.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "tests/cli/program_runner.h"
#include "tests/paths.h"

namespace camlaw::cli::sweep_test {
namespace {

const std::string kProblem = testing::source("problems/cams/roller_least_base.toml");

Words sweep(Words more) {
  Words words{
      "sweep", kProblem, "--set", "stroke=20:2:40 mm", "--set", "law=cycloidal,modified-sine"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// What a sweep says, without the name of its study.
std::string told(const ParsedJson& json) { return json.at("combinations").dump(); }

}  // namespace

TEST_CASE("a sweep gives every combination in JSON and CSV", "[program][sweep]") {
  const Folder folder;
  const ParsedJson json = json_of(sweep({"--json", "--out", folder / "out"}));
  REQUIRE(json.at("combinations").size() == 22);
  CHECK(json.at("count") == 22);
  CHECK(json.at("finished") == true);
  CHECK(json.at("best_by_law").size() == 2);
  const CsvRows rows = csv_of(read(folder / "out/sweep.csv"));
  REQUIRE(rows.size() == 23);
  const auto& header = rows.front();
  const auto column = [&](const std::string& name) {
    const auto found = std::find(header.begin(), header.end(), name);
    REQUIRE(found != header.end());
    return static_cast<std::size_t>(found - header.begin());
  };
  const std::size_t stroke = column("stroke [mm]"), law = column("law"),
                    radius = column("base_radius [mm]");
  column("design base_radius [mm]");
  column("margin of pressure_angle [deg]");
  for (std::size_t i = 0; i < 22; ++i) {
    const ParsedJson& row = json.at("combinations")[i];
    CHECK(row.at("verdict") == "certified optimum");
    CHECK(std::stod(rows[i + 1][stroke]) == row.at("stroke [mm]").get<double>());
    CHECK(rows[i + 1][law] == row.at("law"));
    CHECK(std::stod(rows[i + 1][radius]) == row.at("base_radius [mm]").get<double>());
  }
  // The same as a single run, where the search began as one does.
  const ParsedJson single =
      json_of({"optimize", kProblem, "--set", "stroke=20 mm", "--set", "law=cycloidal", "--json"});
  CHECK(single.at("objective") == json.at("combinations")[0].at("base_radius [mm]"));
}

TEST_CASE("a sweep that is killed goes on where it stood, with any number of workers",
          "[program][sweep]") {
  const Folder folder;
  const std::string whole = told(json_of(sweep({"--json", "--workers", "1"})));
  const std::string study = folder / "study.db";
  {
    const Running running(sweep({"--json", "--workers", "2", "--db", study}));
    REQUIRE(has_made(running.id(), study));
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    kill(running.id(), SIGKILL);
    running.wait();
  }
  CHECK(told(json_of(sweep({"--json", "--workers", "2", "--db", study, "--resume"}))) == whole);
  CHECK(told(json_of(sweep({"--json", "--db", study, "--resume"}))) == whole);
  CHECK(told(json_of({"sweep", kProblem, "--json", "--db", study, "--resume"})) == whole);
  CHECK_THAT(
      failed({"sweep", kProblem, "--set", "stroke=20:2:30 mm", "--db", study, "--resume"}, 2),
      Contains("another sweep"));
  CHECK_THAT(failed({"front", study}, 2), Contains("camlaw report"));
  const std::string page = folder / "map.html";
  done({"report", study, "-o", page});
  CHECK_THAT(read(page), Contains("sweep-map") && Contains("\"law\""));
}

TEST_CASE("a sweep ends in time with what it has", "[program][sweep]") {
  // Of 2001 designs: in ever more time, until it is enough for one.
  ParsedJson json;
  for (double limit = 0.25; !json.contains("designs") || json.at("designs") == 0; limit *= 2) {
    INFO(limit << " s");
    REQUIRE(limit < 600);
    const Folder folder;
    const Outcome outcome =
        run({"sweep", kProblem, "--set", "stroke=20:0.01:40 mm", "--cold", "--time-limit",
             fmt::format("{} s", limit), "--workers", "1", "--json", "--db", folder / "study.db"});
    REQUIRE(outcome.status == 4);
    json = ParsedJson::parse(outcome.out);
    CHECK(json.at("finished") == false);
    CHECK(json.at("combinations").back().at("verdict") == "not done");
  }
}

TEST_CASE("samples are asked for with quotes or without", "[program][sweep]") {
  const auto rows = [](const Words& sample) {
    Words words{"sweep", kProblem, "--evaluate", "--over", "base_radius=45:60 mm", "--json"};
    words.insert(words.end(), sample.begin(), sample.end());
    return json_of(words).at("combinations");
  };
  const ParsedJson quoted = rows({"--sample", "sobol 3"});
  CHECK(quoted.size() == 3);
  CHECK(rows({"--sample", "sobol", "3"}) == quoted);
  CHECK(rows({"--sample=sobol", "3"}) == quoted);
  CHECK(rows({"--sample", "lhs", "4", "--seed", "2"}).size() == 4);
  CHECK(json_of({"sweep", "--evaluate", "--over", "base_radius=45:60 mm", "--json", "--sample",
                 "sobol", "3", kProblem})
            .at("combinations") == quoted);
  CHECK_THAT(failed({"sweep", kProblem, "--sample", "sobol"}, 2), Contains("write sobol 64"));
}

TEST_CASE("an end of a range that the file lacks is swept beside the other", "[program][sweep]") {
  const ParsedJson rows =
      json_of({"sweep", kProblem, "--evaluate", "--set", "ranges.speed.lower=100 rpm", "--set",
               "ranges.speed.upper=200:50:300 rpm", "--json"})
          .at("combinations");
  CHECK(rows.size() == 3);
}

TEST_CASE("a swept number without a unit is headed by that of its parameter", "[program][sweep]") {
  const ParsedJson json =
      json_of({"sweep", kProblem, "--evaluate", "--set", "stroke=20,22", "--json"});
  REQUIRE(json.at("combinations").size() == 2);
  CHECK(json.at("combinations")[1].at("stroke [mm]") == 22);
  const std::string text = done({"sweep", kProblem, "--evaluate", "--set", "stroke=20,22"});
  CHECK_THAT(text, Contains("stroke [mm]"));
}

TEST_CASE("what a sweep cannot run through is refused in a line", "[program][sweep]") {
  CHECK_THAT(failed({"sweep", kProblem}, 2), Contains("nothing is swept"));
  CHECK_THAT(failed({"sweep", kProblem, "--over", "base_radius=30:60 mm"}, 2),
             Contains("--sample"));
  CHECK_THAT(failed({"sweep", kProblem, "--sample", "sobol 8"}, 2), Contains("--over"));
  CHECK_THAT(failed({"sweep", kProblem, "--set", "stroke=20:2:40 mm", "--resume"}, 2),
             Contains("--db"));
  CHECK_THAT(failed({"sweep", kProblem, "--set", "stroke=20:7:40 mm"}, 2),
             Contains("steps of 7 from 20 end at 34"));
  CHECK_THAT(failed({"sweep", kProblem, "--set", "stroke=20:2:40 mm", "--out", kProblem}, 2),
             Contains("--out needs a folder; " + kProblem + " is a file"));
  for (const char* option : {"--out", "--db"}) {
    CHECK_THAT(failed({"sweep", kProblem, "--set", "stroke=20:2:40 mm", option, "x.parquet"}, 2),
               Contains(option) && Contains("camlaw.Sweep.load"));
  }
}

TEST_CASE("a long reason stands below the table, once", "[program][sweep]") {
  const Words words{"sweep", kProblem, "--set", "stroke=20,2000,3000 mm"};
  const std::string text = done(words), reason = "contradict one another";
  const std::size_t at = text.find(reason);
  REQUIRE(at != std::string::npos);
  CHECK(text.find(reason, at + 1) == std::string::npos);
  CHECK_THAT(text, Contains("see (a)") && Contains("\n(a) ") && !Contains("(b)"));
  Words as_json = words;
  as_json.emplace_back("--json");
  const ParsedJson rows = json_of(as_json).at("combinations");
  const auto has_reason = [&](const ParsedJson& row) {
    return row.at("reason").get<std::string>().find(reason) != std::string::npos;
  };
  CHECK(std::count_if(rows.begin(), rows.end(), has_reason) == 2);
}

TEST_CASE("a sweep does not begin a study that it is to go on with", "[program][sweep]") {
  const Folder folder;
  const std::string study = folder / "study.db";
  CHECK_THAT(failed(sweep({"--resume", "--db", study}), 2), Contains("there is no study"));
  CHECK(!fs::exists(study));
}

TEST_CASE("a study goes on from the start that it began at, and from no other",
          "[program][sweep]") {
  const Folder folder;
  const std::string cutter = testing::source("problems/spine_cutter/");
  const auto write_start = [](const std::string& path, Words words) {
    words.push_back("--json");
    std::ofstream(path) << json_of(words).dump();
  };
  const std::string says = "did not begin at the design of ";
  const auto resumed = [](Words words, const Words& more) {
    words.push_back("--resume");
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  const Words swept{"sweep", kProblem, "--set", "stroke=20,22 mm"};
  const Words of_front{"pareto", cutter + "front.toml", "--points", "3", "--set", "mass=2.5 kg"};
  const std::string one = folder / "one.json", two = folder / "two.json";
  for (const auto& [words, begins, other] :
       {std::tuple{swept, kProblem, "stroke=20 mm"},
        std::tuple{of_front, cutter + "least_radius.toml", "alpha=-2"}}) {
    INFO(words[0]);
    write_start(one, {"optimize", begins});
    write_start(two, {"optimize", begins, "--set", other});
    Words plain = words, begun = words;
    const std::string db = folder / words[0] + ".db", begun_db = folder / words[0] + "_begun.db";
    plain.insert(plain.end(), {"--db", db});
    begun.insert(begun.end(), {"--start", one, "--db", begun_db});
    done(plain);
    CHECK_THAT(failed({words[0], words[1], "--resume", "--db", db, "--start", one}, 2),
               Contains(says + one));
    done(begun);
    CHECK_THAT(failed({words[0], words[1], "--resume", "--db", begun_db, "--start", two}, 2),
               Contains(says + two));
    done({words[0], words[1], "--resume", "--db", begun_db, "--start", one});
    done({words[0], words[1], "--resume", "--db", begun_db});
    done(resumed(begun, {}));
  }
  const std::string nothing = failed({"sweep", kProblem, "--start", one}, 2);
  CHECK_THAT(nothing, Contains("nothing is swept; write") && !Contains("base_radius"));
}

}  // namespace camlaw::cli::sweep_test
