// SPDX-License-Identifier: MIT
// What studies of fronts and sweeps say and refuse: files that changed, lost tasks, ends of fronts,
// columns of sweeps.
#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <filesystem>

#include "tests/cli/program_runner.h"
#include "tests/flipped.h"
#include "tests/paths.h"

namespace camlaw::cli::study_answers_test {
namespace {

using testing::write;

const std::string kCams = testing::source("problems/cams/");
const std::string kLeastBase = kCams + "roller_least_base.toml";
const std::string kFront = testing::source("problems/spine_cutter/front.toml");

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("not there: " + from);
  return text.replace(at, from.size(), to);
}

void change(const std::string& path, const std::string& sql) {
  SQLite::Database(path, SQLite::OPEN_READWRITE).exec(sql);
}

/// A catalogue's copy beside the problem file that names it, with other text in that.
std::string catalogue_problem(const Folder& folder, const std::string& name,
                              const std::string& more) {
  const std::string catalogue = "iko_c_lube_cam_followers.csv";
  write(folder / catalogue, read(kCams + catalogue));
  std::string text = read(kCams + "roller_from_catalogue.toml");
  const std::size_t choose = text.find("choose = ["),
                    end = text.find('\n', text.find("start = ", choose));
  text.replace(choose, end - choose,
               "choose = [\"CF 12 WBUUR/SG\", \"CF 16 WBUUR/SG\"]\nstart = \"CF 16 WBUUR/SG\"");
  write(folder / name, text + more);
  return folder / name;
}

/// Two variables from 0 to 10 and two objectives.
std::string plane_problem(const Folder& folder, const std::string& first,
                          const std::string& second) {
  std::string text = "[machine]\nname = 'plane'\n";
  for (const char* name : {"xx", "yy"}) {
    text += fmt::format("[machine.parameters.{}]\nunit = '1'\ndefault = 3\nlower = 0\nupper = 10\n",
                        name);
  }
  text += fmt::format("[responses.f1]\nformula = '{}'\n[responses.f2]\nformula = '{}'\n", first,
                      second);
  for (const char* name : {"xx", "yy"}) {
    text += fmt::format("[variables.{}]\nlower = 0\nupper = 10\nstart = 3\n", name);
  }
  const std::string path = folder / "plane.toml";
  write(path, text + "[[objectives]]\nminimize = 'f1'\n[[objectives]]\nminimize = 'f2'\n");
  return path;
}

}  // namespace

TEST_CASE("a study does not go on with another catalogue", "[program][sweep]") {
  const Folder folder;
  const std::string more =
      "\n[[objectives]]\nminimize = \"cam_mass\"\n"
      "[[objectives]]\nminimize = \"highest contact_stress\"\n";
  const std::string one = catalogue_problem(folder, "one.toml", "");
  std::string text = read(one);
  text = replaced(text, "[objective]\nminimize = \"cam_mass\"\n", "");
  const std::string two = folder / "two.toml";
  write(two, text + more);
  const Words front{"pareto", two, "--points", "4", "--db", folder / "front.db", "-q"};
  const Words swept{"sweep", one, "--set", "speed=200,240 rpm", "--db", folder / "sweep.db", "-q"};
  const std::string catalogue = folder / "iko_c_lube_cam_followers.csv", kept = read(catalogue);
  for (Words words : {front, swept}) {
    REQUIRE(run(words).status == 0);
    words.push_back("--resume");
    CHECK(run(words).status == 0);
    const std::string study = read(words[5]);
    std::string other = kept;
    const std::size_t row = other.find("CF 12 WBUUR"),
                      digit = other.find_first_of("123456789", row + 20);
    other[digit] = other[digit] == '9' ? '8' : static_cast<char>(other[digit] + 1);
    write(catalogue, other);
    CHECK_THAT(failed(words, 2), Contains("cannot be resumed") &&
                                     Contains("'iko_c_lube_cam_followers.csv' is not as it was") &&
                                     Contains("restore it"));
    CHECK(read(words[5]) == study);  // it does not take the other one down
    write(catalogue, kept);
    CHECK(run(words).status == 0);
  }
}

TEST_CASE("a sweep over law files keeps them, and does not go on with others", "[program][sweep]") {
  const Folder folder;
  const auto write_law = [&](const std::string& path, const char* problem) {
    const std::string out = folder / problem + ".out";
    done({"synthesize", testing::source("problems/free_law/") + problem, "--out", out, "-q"});
    write(path, read(out + "/law.json"));
  };
  write_law(folder / "a.json", "least_jerk.toml");
  write_law(folder / "b.json", "least_mean_square_jerk.toml");
  const std::string problem = folder / "cam.toml", db = folder / "s.db";
  write(problem, read(kLeastBase));
  const std::string laws = "law=" + (folder / "a.json") + "," + (folder / "b.json");
  const Words words{"sweep", problem, "--set", laws, "--db", db, "-q"};
  REQUIRE(run(words).status == 0);
  Words resumed = words;
  resumed.push_back("--resume");
  CHECK(run(resumed).status == 0);
  const std::string kept = read(folder / "a.json");
  write(folder / "a.json", read(folder / "b.json"));
  CHECK_THAT(failed(resumed, 2), Contains("a.json' is not as it was"));
  fs::remove(folder / "a.json");
  CHECK(run({"report", db, "-o", folder / "map.html"}).status == 0);  // it carries its own
}

TEST_CASE("the end of a front is the better design, certified or not", "[program]") {
  const Folder folder;
  const auto front = [&](const char* first, const char* second) {
    return json_of({"pareto", plane_problem(folder, first, second), "--points", "2", "--method",
                    "sweep", "--json"});
  };
  struct Case {
    const char *first, *second;
    double f1, f2;  // the least first objective, and the least second one there
  };
  for (const Case& c : {Case{"max(xx-2,yy-3)", "(xx-8)^2+(yy-9)^2", -2, 128},
                        Case{"max(max(xx-2,yy-3),1)", "(xx-8)^2+(yy-9)^2", 1, 50},
                        Case{"max(xx-2,0)+0.001*yy", "(xx-8)^2+(10-yy)*0.5", 0, 41},
                        Case{"max(xx-2,0)+0.001*yy", "max(8-xx,0)+(10-yy)*0.5", 0, 11}}) {
    INFO(c.first << ", " << c.second);
    const ParsedJson json = front(c.first, c.second);
    const ParsedJson& end = json["points"][0];
    CHECK_THAT(end["objectives"]["f1"].get<double>(), Catch::Matchers::WithinAbs(c.f1, 2e-4));
    CHECK_THAT(end["objectives"]["f2"].get<double>(), Catch::Matchers::WithinAbs(c.f2, 0.1));
  }
}

TEST_CASE("a lost task is named, the other designs are shown, and it is searched again",
          "[program]") {
  const Folder folder;
  const std::string db = folder / "s.db";
  const Words words{"pareto", kFront, "--points", "8", "--db", db, "-q"};
  REQUIRE(run(words).status == 0);
  const ParsedJson whole = json_of({"front", db, "--json"});
  const std::string bytes = read(db);
  for (const char* also : {"", "; DELETE FROM design WHERE task = 4"}) {
    INFO(also);
    write(db, bytes);
    change(db, std::string("DELETE FROM task WHERE id = 4") + also);
    const Outcome shown = run({"front", db, "--json"});
    CHECK(shown.status == 4);
    const ParsedJson json = ParsedJson::parse(shown.out);
    REQUIRE(json["record"]["faults"].size() == 1);
    CHECK(json["record"]["faults"][0]["task"] == 4);
    CHECK(json["record"]["faults"][0]["what"] == "lost");
    CHECK(json["points"].size() >= whole["points"].size() - 1);
    CHECK_THAT(run({"front", db}).out,
               Contains("task 4 is lost: its row is missing; --resume solves it again"));
    Words resumed = words;
    resumed.push_back("--resume");
    CHECK(run(resumed).status == 0);
    CHECK(json_of({"front", db, "--json"}) == whole);
    CHECK(SQLite::Database(db).execAndGet("SELECT max(id) - count(*) FROM task").getInt() == 0);
  }
}

TEST_CASE("a front that is not finished has the exit status 4", "[program]") {
  const Folder folder;
  const std::string db = folder / "s.db";
  REQUIRE(run({"pareto", kFront, "--points", "8", "--db", db, "-q"}).status == 0);
  change(db, "DELETE FROM task WHERE id > 5; DELETE FROM design WHERE task > 5");
  const Outcome cut = run({"front", db});
  CHECK(cut.status == 4);
  CHECK_THAT(cut.out, Contains("the study is not finished") && !Contains("is lost"));
  CHECK(run({"front", db, "--point", "1"}).status == 4);
  CHECK(run({"report", db, "-o", folder / "page.html"}).status == 4);
  change(db, "DELETE FROM task; DELETE FROM design");
  const Outcome empty = run({"front", db});
  CHECK(empty.status == 4);
  CHECK_THAT(empty.out, Contains("no design was found before the study was stopped") &&
                            !Contains("meets every limit"));
}

TEST_CASE("a study is not begun by resuming it", "[program]") {
  const Folder folder;
  const std::string db = folder / "nothere.db";
  CHECK_THAT(failed({"pareto", kFront, "--db", db, "--resume"}, 2),
             Contains("--resume: there is no study") && Contains("leave out --resume"));
  CHECK(!fs::exists(db));
}

TEST_CASE("what is better by a tenth is a design of the front", "[program]") {
  const Folder folder;
  const std::string file = folder / "next.toml", db = folder / "s.db";
  write(file,
        "[machine]\nname = 'next'\n[machine.parameters.kk]\nunit = '1'\ndefault = 0\nlower = 0\n"
        "upper = 12\n[responses.f1]\nformula = '1+kk'\n[responses.f2]\n"
        "formula = '(kk-3)^2*(kk+1)+1'\n[variables.kk]\nvalues = [0, 1, 2]\nstart = 0\n"
        "[[objectives]]\nminimize = 'f1'\n[[objectives]]\nminimize = 'f2'\n");
  REQUIRE(run({"pareto", file, "--db", db, "-q"}).status == 0);
  const ParsedJson next =
      json_of({"front", db, "--point", "2", "--json"})["chosen"]["point"]["next"];
  REQUIRE(next.size() == 2);
  CHECK(next[0]["point"] == 0);
  CHECK(next[0]["better_value"] == 1);
  CHECK(next[0]["value"] == 10);
  CHECK(next[1]["point"] == 2);
  CHECK(next[1]["better_value"] == 4);
  CHECK(next[1]["value"] == 3);
  CHECK_THAT(done({"front", db, "--point", "2"}),
             Contains("at least 10 % better f1: the nearest such point is 1, 1 instead of 2, with "
                      "f2 10 instead of 9") &&
                 !Contains("9.2"));
  CHECK(json_of({"front", db, "--point", "1", "--json"})["chosen"]["point"]["next"][0]["point"] ==
        nullptr);
}

TEST_CASE("small slopes keep their digits", "[program]") {
  const Folder folder;
  const std::string file = plane_problem(folder, "xx", "1e-6*(10-xx)^2+1e-6*yy");
  const std::string text = done({"pareto", file, "--points", "5", "--method", "sweep"});
  CHECK_THAT(text, Contains("e-0") && !Contains("0.0000"));
}

TEST_CASE("a study where a design is wanted says what to do", "[program]") {
  const Folder folder;
  const std::string db = folder / "s.db";
  REQUIRE(run({"pareto", kFront, "--points", "4", "--db", db, "-q"}).status == 0);
  CHECK_THAT(failed({"tolerance", db}, 2), Contains("a study needs --point"));
  for (const Words& words : std::vector<Words>{{"evaluate", db},
                                               {"optimize", db},
                                               {"check", db},
                                               {"verify", db},
                                               {"pareto", db},
                                               {"sweep", db, "--set", "speed=1,2 rpm"},
                                               {"synthesize", db},
                                               {"optimize", kLeastBase, "--start", db}}) {
    INFO(words[0]);
    CHECK_THAT(failed(words, 2), Contains("it is a study") && Contains("--point N --result FILE"));
  }
}

TEST_CASE("a mechanism without a law is not said to have one", "[program]") {
  const std::string spring = testing::source("problems/springs/lightest_helical.toml");
  CHECK_THAT(failed({"optimize", spring, "--set", "rate.equals=25 N/mm"}, 2),
             Contains("helical-spring has no parameter 'rate.equals'; it accepts wire_diameter") &&
                 !Contains("constant-velocity"));
  CHECK_THAT(failed({"optimize", spring, "--set", "law.alpha=3"}, 2),
             Contains("helical-spring has no law"));
}

TEST_CASE("a sweep says where its searches began, and that a variable's start is swept",
          "[program][sweep]") {
  const Folder folder;
  const ParsedJson starts =
      json_of({"sweep", kLeastBase, "--set", "base_radius=50,60 mm", "--json"});
  CHECK(starts["only_start_swept"] == ParsedJson::parse("[\"base_radius\"]"));
  CHECK(starts["combinations"][0]["start of base_radius [mm]"] == 50);
  CHECK(starts["combinations"][0].contains("base_radius [mm]"));
  CHECK_THAT(done({"sweep", kLeastBase, "--set", "base_radius=50,60 mm"}),
             Contains("base_radius is a variable of the search: only its start is swept") &&
                 Contains("start of base_radius [mm]"));
  const ParsedJson evaluated =
      json_of({"sweep", kLeastBase, "--set", "base_radius=50,60 mm", "--evaluate", "--json"});
  CHECK(evaluated["only_start_swept"].empty());
  CHECK(evaluated["combinations"][0]["base_radius [mm]"] == 50);
  const Words warm{"sweep", kLeastBase, "--set", "stroke=20,22,24 mm"};
  CHECK_THAT(done(warm), Contains("began at a neighbour's design") && Contains("--cold"));
  CHECK_THAT(done({"sweep", kLeastBase, "--set", "stroke=20,22,24 mm", "--cold"}),
             !Contains("neighbour"));
  // With choices of their own all are searched as single runs.
  const std::string choices = catalogue_problem(folder, "choices.toml", "");
  const ParsedJson own = json_of({"sweep", choices, "--set", "speed=200,220,240 rpm", "--json"});
  for (const ParsedJson& row : own["combinations"]) CHECK(row["start"] == "own");
}

TEST_CASE("a sweep has a best, or says that there is none", "[program][sweep]") {
  const Outcome none = run({"sweep", kLeastBase, "--set", "stroke=20,22 mm", "--set",
                            "pressure_angle.upper=0.001 deg", "--json"});
  CHECK(none.status != 0);
  CHECK(ParsedJson::parse(none.out).at("best") == nullptr);
  const std::string text =
      done({"sweep", kLeastBase, "--evaluate", "--set", "base_radius=20,30,120 mm"});
  CHECK_THAT(text, Contains("1 meets every limit") && Contains("2 violate a limit"));
}

TEST_CASE("a name is not set and swept at once", "[program][sweep]") {
  for (const Words& more : std::vector<Words>{
           {"--set", "stroke=20 mm", "--set", "stroke=22,24 mm"},
           {"--set", "stroke=22,24 mm", "--set", "stroke=20 mm"},
           {"--set", "stroke=20 mm", "--sample", "sobol 4", "--over", "stroke=20:30 mm"}}) {
    Words words{"sweep", kLeastBase};
    words.insert(words.end(), more.begin(), more.end());
    CHECK_THAT(failed(words, 2), Contains("stroke is set to one value and swept"));
  }
}

}  // namespace camlaw::cli::study_answers_test
