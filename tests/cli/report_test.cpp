// SPDX-License-Identifier: MIT
// report and reproduce --report, as a user runs them. What a browser makes of the pages is looked
// at by tests/report/open_reports.py.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "tests/cli/report_pages.h"

namespace camlaw::cli::report_test {
namespace {

/// A page that loads nothing: no address but those that readers are told.
void check_whole(const std::string& page) {
  CHECK_THAT(page, Catch::Matchers::StartsWith("<!DOCTYPE html>"));
  CHECK_THAT(page, Contains("default-src 'none'"));
  CHECK(count_of(page, " src=") == 0);
  CHECK(count_of(page, "@import") == 0);
  CHECK(count_of(page, "<link ") == 1);
  CHECK_THAT(page, Contains("<link rel=\"icon\" href=\"data:,\">"));
  CHECK(page.size() < 3'000'000);
}

TEST_CASE("a report of a problem file says verdict, margins and how to search",
          "[cli][report][long]") {
  const Folder folder;
  const std::string page = page_of(shipped("spine_cutter/least_radius.toml"), folder);
  check_whole(page);
  CHECK_THAT(page, Contains("Least cam radius of the spine cutter"));
  CHECK_THAT(page, Contains("To search: camlaw optimize"));
  CHECK_THAT(page, Contains("meets its limits"));
  // The margin that evaluate has.
  const ParsedJson said =
      json_of({"evaluate", shipped("spine_cutter/least_radius.toml"), "--json"});
  const double margin = said["constraints"][0]["margin"];
  CHECK_THAT(page, Contains(std::to_string(margin).substr(0, 4)));
  const ParsedJson data = data_of(page);
  const std::size_t angle = panel_of(data, "cam_pressure_angle");
  CHECK(data["panels"][angle]["limits"] == ParsedJson({30.0, -30.0}));
  CHECK(data["designs"].size() == 1);
  // The greatest pressure angle of the curve is that of the table.
  double highest = 0;
  for (const ParsedJson& y : data["designs"][0]["lines"][angle]["y"]) {
    highest = std::max(highest, y.get<double>());
  }
  CHECK(highest == Approx(30 - margin).epsilon(1e-4));
}

TEST_CASE("a report shows the errors of the profile that a file states", "[cli][report]") {
  const Folder folder;
  // Of a cam that varies in nothing else, whose page is made soon.
  const std::string tolerances = read(shipped("cams/tolerances.toml")), path = folder / "cam.toml";
  std::ofstream(path) << read(shipped("cams/roller_least_base.toml"))
                      << tolerances.substr(tolerances.find("[profile]"));
  const std::string page = page_of(path, folder);
  check_whole(page);
  CHECK_THAT(page, Contains(">Errors of the profile</"));
  // The numbers of 'camlaw tolerance'.
  const ParsedJson facts = json_of({"tolerance", path, "--json"})["profile"];
  REQUIRE(facts["waviness"].size() > 3);
  for (const ParsedJson& effect : facts["waviness"]) {
    const std::string name = effect["name"];
    CHECK_THAT(page, Contains(">" + name + "</td>"));
  }
  const double amplitude = facts["shop"][0]["amplitude"];
  CHECK_THAT(page, Contains(fmt::format(">{:.4g}</td>", amplitude)));
  CHECK_THAT(page, Contains("the tolerance the shop must hold"));
  CHECK_THAT(page_of(shipped("cams/roller_least_base.toml"), folder),
             !Contains("Errors of the profile"));
}

TEST_CASE("a report of a result judges its design again", "[cli][report]") {
  const Folder folder;
  done({"optimize", shipped("spine_cutter/least_radius.toml"), "--out", folder / "out"});
  const std::string page = page_of(folder / "out/result.json", folder);
  check_whole(page);
  CHECK_THAT(page, Contains("<span class=\"badge good\">certified optimum</span>"));
  CHECK_THAT(page, Contains("cam radius <b>33.07973\u00a0mm</b>"));
  // What easing the limit buys stands in the result too.
  const ParsedJson result = ParsedJson::parse(read(folder / "out/result.json"));
  const double price = result["constraints"][0]["multiplier"];
  CHECK_THAT(page, Contains(">price</th>"));
  CHECK_THAT(page, Contains(std::to_string(price).substr(0, 4)));
  CHECK_THAT(page, Contains("<dt>seed</dt>"));
}

TEST_CASE("values whose integers nobody searched are not called an optimum", "[cli][report]") {
  const Folder folder;
  const std::string own = page_of(shipped("balancing_cam/fewest_springs.toml"), folder);
  CHECK(count_of(own, "certified optimum") == 0);
  CHECK_THAT(own, Contains("meets its limits"));
}

TEST_CASE("a drawn roller stands where its own triangle puts it", "[cli][report]") {
  const Folder folder;
  const std::string page = page_of(shipped("cams/roller_least_base.toml"), folder);
  check_whole(page);
  // base_radius 60 and roller_radius 8, in line with the cam: its middle is 68 mm above it.
  CHECK_THAT(page, Contains("<circle class=\"roller\" cx=\"0.000\" cy=\"68.000\" r=\"8.000\"/>"));
  CHECK_THAT(page, Contains("data-motion=\"turn cycle 0 1 0 0 0\""));
}

TEST_CASE("a report of a study has every point with its curves", "[cli][report]") {
  const Folder folder;
  const std::string study = folder / "study.db";
  done({"pareto", shipped("spine_cutter/front.toml"), "--points", "12", "--db", study});
  const std::string page = page_of(study, folder);
  check_whole(page);
  const ParsedJson data = data_of(page), front = json_of({"front", study, "--json"});
  REQUIRE(data["designs"].size() == front["points"].size());
  const std::size_t force = panel_of(data, "inertia_force");
  for (std::size_t i = 0; i < front["points"].size(); ++i) {
    const ParsedJson& design = data["designs"][i];
    const double peak = front["points"][i]["objectives"]["peak_inertia_force"];
    CHECK(design["objectives"][1].get<double>() == Approx(peak).epsilon(1e-5));
    double highest = 0;
    for (const ParsedJson& y : design["lines"][force]["y"]) {
      highest = std::max(highest, std::abs(y.get<double>()));
    }
    CHECK(highest == Approx(peak).epsilon(0.01));  // drawn from some tens of samples
  }
}

TEST_CASE("the same input and time make the same report to the last byte", "[cli][report]") {
  const Folder folder;
  setenv("SOURCE_DATE_EPOCH", "86400", 1);
  const std::string first = page_of(shipped("cams/flat_least_base.toml"), folder);
  const std::string second = page_of(shipped("cams/flat_least_base.toml"), folder);
  unsetenv("SOURCE_DATE_EPOCH");
  CHECK(first == second);
  CHECK_THAT(first, Contains("1970-01-02 00:00:00 UTC"));
}

TEST_CASE("text of a problem file stays text in its report", "[cli][report][long]") {
  const Folder folder;
  std::string text = read(shipped("spine_cutter/least_radius.toml"));
  const std::string title = "Least cam radius of the spine cutter";
  text.replace(text.find(title), title.size(), "</script><script>alert(1)</script> & <b>");
  std::ofstream(folder / "odd.toml") << text;
  const std::string page = page_of(folder / "odd.toml", folder);
  CHECK(count_of(page, "alert(1)") > 0);
  CHECK(count_of(page, "<script>alert(1)") == 0);
  CHECK(count_of(page, "<script") == count_of(page, "</script>"));
}

const std::string kCertified = "<span class=\"badge good\">certified optimum</span>";

/// The sheet delivery with the laws of the list.
std::string delivery(const std::string& laws) {
  return "mechanism = 'sheet-delivery'\n[law]\nname = " + laws +
         "\n[variables.guide_ratio]\nlower = 0.1\nupper = 2\nstart = 0.4\n"
         "[variables.rod_angle_max]\nlower = '10 deg'\nupper = '75 deg'\nstart = '60 deg'\n"
         "[objective]\nmaximize = 'lowest efficiency'\n"
         "[[constraints]]\nresponse = 'slow_down'\nlower = 0.2\n";
}

TEST_CASE("a design of one of several laws is not called an optimum among them", "[cli][report]") {
  const Folder folder;
  const std::string several = delivery("['cycloidal', 'cosine']");
  std::ofstream(folder / "one.toml") << delivery("'cycloidal'");
  done({"optimize", folder / "one.toml", "--out", folder / "one"});
  CHECK_THAT(page_of(folder / "one/result.json", folder), Contains(kCertified));
  // A search of both laws that was stopped at the first, and so has not seen the better one.
  ParsedJson result = ParsedJson::parse(read(folder / "one/result.json"));
  result["verdict"] = "feasible";
  result["design"]["problem"] = several;
  result["design"]["law"] = "cycloidal";
  std::ofstream(folder / "stopped.json") << sealed(result);
  const std::string page = page_of(folder / "stopped.json", folder);
  CHECK(count_of(page, kCertified) == 0);
  CHECK_THAT(page, Contains("<span class=\"badge plain\">feasible</span>"));
  CHECK_THAT(section_of(page, "problem"), Contains("cosine"));
}

TEST_CASE("a page says the problem of a result as the problem was asked", "[cli][report][long]") {
  const Folder folder;
  const std::string problem = shipped("cams/roller_least_base.toml");
  done({"optimize", problem, "--out", folder / "out"});
  const std::string asked = section_of(page_of(problem, folder), "problem");
  CHECK_THAT(asked, Contains("60 mm"));  // where the search begins
  CHECK(section_of(page_of(folder / "out/result.json", folder), "problem") == asked);
}

TEST_CASE("the program of a result is that of its design", "[cli][report][long]") {
  const Folder folder;
  done({"optimize", shipped("cams/end_rise_share.toml"), "--out", folder / "out"});
  const std::string page = page_of(folder / "out/result.json", folder);
  CHECK_THAT(section_of(page, "problem"), Contains("rise 120 deg by"));  // as it was asked
  CHECK_THAT(section_of(page, "values"),
             Contains("rise 140 deg by") && !Contains("rise 120 deg by"));
  // Rise and return are as steep: each side of the limit has a row of its own.
  const std::string limits = section_of(page, "limits");
  CHECK_THAT(limits, Contains("\u2264 30") && Contains("\u2265 \u221230"));
  CHECK(count_of(limits, "<tr") == 4);  // with the title's and that of the undercut
}

TEST_CASE("a report of an infeasible result says which limit cannot be met",
          "[cli][report][long]") {
  const Folder folder;
  std::string text = read(shipped("cams/end_rise_share.toml"));
  text += "[[constraints]]\nresponse = \"radius\"\nupper = \"6 mm\"\n";
  std::ofstream(folder / "tight.toml") << text;
  CHECK(run({"optimize", folder / "tight.toml", "--out", folder / "out"}).status == 3);
  const ParsedJson result = ParsedJson::parse(read(folder / "out/result.json"));
  REQUIRE(result["verdict"] == "infeasible");
  const std::string page = page_of(folder / "out/result.json", folder);
  CHECK_THAT(page,
             Contains("The search said: infeasible: " + result["reason"].get<std::string>() + "."));
  CHECK(count_of(section_of(page, "limits"), ">blamed</span>") == result["blamed"].size());
}

TEST_CASE("a recorded verdict that the page finds untrue is not a badge", "[cli][report][long]") {
  const Folder folder;
  done({"optimize", shipped("cams/roller_least_base.toml"), "--out", folder / "out"});
  const ParsedJson result = ParsedJson::parse(read(folder / "out/result.json"));
  const auto page_at = [&](double share, const std::string& verdict) {
    ParsedJson changed = result;
    ParsedJson& radius = changed["design"]["variables"]["base_radius"];
    radius = share * radius.get<double>();
    changed["verdict"] = verdict;
    std::ofstream(folder / "changed.json") << sealed(changed);
    const std::string page = folder / "changed.html";
    // What the result says of its numbers is evaluated again, and named where it differs.
    const Outcome outcome = run({"report", folder / "changed.json", "-o", page});
    CHECK(outcome.status == (share == 1 ? 0 : 4));
    CHECK(outcome.err.empty() == (share == 1));
    return read(page);
  };
  const std::string optimum = page_at(1, "certified optimum");
  CHECK_THAT(optimum, Contains(kCertified) && !Contains("options held"));
  // Whatever it claims of itself, a result whose numbers are not those of its design is wrong.
  const std::string wrong = "<span class=\"badge bad\">the result is wrong</span>";
  for (const auto& [share, verdict] : {std::pair{1.02, "certified optimum"},
                                       {1.02, "infeasible"},
                                       {0.97, "certified optimum"},
                                       {0.97, "feasible"}}) {
    INFO(share << " " << verdict);
    const std::string page = page_at(share, verdict);
    CHECK_THAT(page, Contains(wrong) && Contains("but evaluates to"));
    // The pressure angle is at its limit: what rounding leaves of its margin is 0.
    CHECK_THAT(page, Contains("the margin of pressure_angle is stated as 0 deg"));
    CHECK_THAT(page, !Contains(kCertified) && !Contains(">" + std::string(verdict) + "</span>"));
  }
}

TEST_CASE("the report of a front of many points keeps the curve that its picture follows",
          "[cli][report]") {
  const Folder folder;
  std::ofstream(folder / "geneva.toml")
      << "mechanism = 'geneva'\n[constants]\ncentre_distance = '200 mm'\npin_radius = '10 mm'\n"
         "slots = 6\n[variables.speed]\nlower = '10 rpm'\nupper = '200 rpm'\nstart = '50 rpm'\n"
         "[[objectives]]\nmaximize = 'speed'\n[[objectives]]\nminimize = 'peak_acceleration'\n";
  const std::string study = folder / "study.db";
  done({"pareto", folder / "geneva.toml", "--points", "180", "--db", study});
  const std::string page = page_of(study, folder);
  const ParsedJson data = data_of(page);
  REQUIRE(data["designs"].size() *
              data_of(page_of(folder / "geneva.toml", folder))["panels"].size() >
          1200);
  const std::string scene = data["designs"][0]["scene"];
  CHECK_THAT(scene, Contains("data-motion=\"turn wheel_angle "));
  CHECK_NOTHROW(panel_of(data, "wheel_angle"));
  CHECK(data["designs"].size() * data["panels"].size() <= 1200);
}

TEST_CASE("a report has a plot of every curve with values, and of no other", "[cli][report]") {
  const Folder folder;
  for (const char* name : {"groove_least_stress", "end_rise_share", "roller_least_base"}) {
    INFO(name);
    const std::string page = page_of(shipped("cams/" + std::string(name) + ".toml"), folder);
    const ParsedJson data = data_of(page);
    for (std::size_t i = 0; i < data["panels"].size(); ++i) {
      const ParsedJson& y = data["designs"][0]["lines"][i]["y"];
      INFO(data["panels"][i]["id"]);
      CHECK(std::any_of(y.begin(), y.end(),
                        [](const ParsedJson& value) { return value.is_number(); }));
    }
    CHECK(count_of(page, "; - ") == 0);
    CHECK_NOTHROW(panel_of(data, "contact_stress"));
  }
}

TEST_CASE("what is 0 but for rounding is shown as 0 among tolerances", "[cli][report]") {
  const Folder folder;
  for (const char* name : {"flat_least_base", "knife_edge_convex_base"}) {
    INFO(name);
    const std::string out = folder / name;
    done({"optimize", shipped("cams/" + std::string(name) + ".toml"), "--out", out});
    const std::string text = section_of(page_of(out + "/result.json", folder), "sensitivity");
    CHECK_THAT(text, Contains("<td>margin of "));
    for (const char* rounding : {"e-11", "e-12", "e-13", "e-14", "e-15", "e-16"}) {
      CHECK(count_of(text, rounding) == 0);
    }
  }
}

TEST_CASE("a report does not go over its own input", "[cli][report]") {
  const Folder folder;
  const std::string path = folder / "p.TOML", text = read(shipped("cams/flat_least_base.toml"));
  std::ofstream(path) << text;
  CHECK_THAT(failed({"report", path, "-o", path}, 2), Contains("is an input of this run"));
  CHECK(read(path) == text);
  check_whole(page_of(path, folder));
}

TEST_CASE("reports of what cannot be reported on are refused", "[cli][report]") {
  const Folder folder;
  const std::string page = folder / "page.html";
  std::ofstream(page) << "<html></html>";
  CHECK_THAT(failed({"report", page}, 2),
             Contains("page.html: this is a page") && Contains("made from a problem file (.toml)"));
  CHECK(read(page) == "<html></html>");
  CHECK_THAT(failed({"report", folder / "none.toml"}, 2), Contains("none.toml"));
  CHECK_THAT(failed({"report", folder / "law.csv"}, 2), Contains(".toml"));
  CHECK_THAT(failed({"report", shipped("cams/roller_least_base.toml"), "-o", folder / "x.pdf"}, 2),
             Contains("whose name ends in .html or .htm"));
  std::string text = read(shipped("cams/roller_least_base.toml"));
  text.replace(text.find("stroke = "), 0, "offset = \"100 mm\"\n");
  std::ofstream(folder / "odd.toml") << text;
  CHECK_THAT(failed({"report", folder / "odd.toml"}, 2), Contains("offset = 100 mm"));
  std::ofstream(folder / "no.db") << "no study";
  CHECK_THAT(failed({"report", folder / "no.db"}, 2), Contains("no.db"));
  CHECK_THAT(
      failed({"report", shipped("spine_cutter/least_radius.toml"), "-o", "/proc/no/page.html"}, 1),
      Contains("/proc/no"));
  CHECK(folder.content() == std::set<std::string>{"no.db", "odd.toml", "page.html"});
}

TEST_CASE("reproduce writes its tables beside the printed ones as a page", "[cli][report]") {
  const Folder folder;
  const std::string path = folder / "tables.html";
  const ParsedJson said = json_of({"reproduce", "spine-cutter", "--report", path, "--json"});
  const std::string page = read(path);
  check_whole(page);
  CHECK(count_of(page, ">explained</span>") == said[0]["explained"].get<std::size_t>());
  CHECK(count_of(page, ">reproduced</span>") == said[0]["reproduced"].get<std::size_t>());
  CHECK_THAT(page, Contains("<span class=\"badge plain\">0 unexplained</span>"));
  CHECK_THAT(page, Contains("published values of one system, computed again"));
  CHECK_THAT(failed({"reproduce", "cam-shape", "--n", "10", "--report", path}, 2),
             Contains("--report"));
}

TEST_CASE("reports open in a browser without a fault, at either width", "[cli][report][heavy]") {
  if (std::system("command -v chromedriver >/dev/null") != 0) {
    WARN("there is no chromedriver; reports were not opened");
    return;
  }
  const Folder folder;
  std::string pages;
  const auto add = [&](const Words& words, const std::string& name) {
    Words all = words;
    all.push_back(folder / name);
    done(all);
    pages += " '" + folder / name + "'";
  };
  for (const char* problem :
       {"cams/roller_least_base", "cams/knife_edge_convex_base", "cams/flat_least_base",
        "cams/conjugate_least_distance", "cams/leading_least_base",
        "cams/oscillating_flat_least_base", "cams/oscillating_end_least_radius",
        "cams/linear_least_travel", "cams/groove_least_stress", "spine_cutter/least_radius",
        "geneva/fastest", "springs/fewest_discs", "balancing_cam/fewest_springs",
        "signature_feeder/least_acceleration", "free_law/least_acceleration", "shaft/gripper_path",
        "servo_axis/pick_and_place"}) {
    add({"report", shipped(problem + std::string(".toml")), "-o"},
        std::filesystem::path(problem).filename().string() + ".html");
  }
  for (const char* front : {"spine_cutter/front", "cams/roller_front"}) {
    const std::string study = folder / std::filesystem::path(front).filename().string() + ".db";
    done({"pareto", shipped(front + std::string(".toml")), "--points", "10", "--db", study});
    add({"report", study, "-o"}, std::filesystem::path(study).stem().string() + "_study.html");
  }
  add({"report", shipped("cams/roller_least_base.toml"), shipped("cams/flat_least_base.toml"),
       shipped("cams/end_rise_share.toml"), shipped("spine_cutter/least_radius.toml"), "-o"},
      "comparison.html");
  add({"reproduce", "spine-cutter", "die-press", "--report"}, "reproduction.html");
  const std::string said = folder / "said.txt";
  const std::string command = "python3 '" + testing::source("tests/report/open_reports.py") + "'" +
                              pages + " > '" + said + "' 2>&1";
  const int status = std::system(command.c_str());
  INFO(read(said));
  CHECK(status == 0);
}

}  // namespace
}  // namespace camlaw::cli::report_test
